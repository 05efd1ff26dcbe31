"""What the names of the tool are called in a listing: as on the page, and each of them once."""

from __future__ import annotations

import pytest

from coursework.takeaway.listing.syntax import Names, syntax_of

SHOWN = {
    "_det0": "D1", "_det11": "D12", "_acc2": "acc3", "_rate_phi1": "dphi1", "_closed_phi1": "phi1_closed",
    "_end0_VMx": "VMx_end1", "_table_F_0": "value_F", "_table_F_1": "slope_F",
    "d1_2": "dr_dphi", "d0_1": "dt_dr", "v_w3": "w3", "v_e_": "e_", "t": "t", "phi": "phi", "dphi": "dphi", "d": "d", "dd": "dd",
    "rd": "rd", "_m3": "m3", "_u2_w1": "u2_w1", "_kept": "kept", "_step_n": "step", "_": "x", "_own": "own_",
}  # fmt: skip


@pytest.mark.parametrize("name", SHOWN)
def test_a_name_of_the_tool_is_called_as_on_the_page(name: str) -> None:
    assert Names(syntax_of("python"), ("t", "r", "phi"))[name] == SHOWN[name]


def test_names_that_would_be_alike_are_told_apart_and_kept() -> None:
    """Pascal takes r and R for one name; words of a language are nobody's."""
    for language, second in (("python", "R"), ("pascal", "R_")):
        names = Names(syntax_of(language), ())
        assert [names[one] for one in ("r", "R", "r", "R")] == ["r", second, "r", second]
        assert names["begin" if language == "pascal" else "lambda"].endswith("_")
        assert names.own("h", "h", "step") == "h" == names.own("h", "other")
        assert names.own("k", "r", "R", "k") == "k" and names.own("n", "r", "h") == "h_"
