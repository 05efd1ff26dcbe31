"""Figures: the same bytes, no date, labels that are never parsed, curves that can be told apart without colour."""

from __future__ import annotations

import re
from types import ModuleType

import numpy as np
import pytest

from coursework.report.figures import STYLES, Curve, label_text, sparse, time_plot, true_to_scale
from coursework.report.symbols import symbol

T = np.linspace(0, 0.48, 25)


def plot(
    name: str = "plot-1", *, y_label: str = "angle, rad", stop_label: str = "", stop: float | None = None, count: int = 3
) -> str:
    curves = [Curve(symbol(f"phi{i}"), T, np.sin(9 * T + i), T, np.sin(9 * T + i + 0.05)) for i in range(1, count + 1)]
    return time_plot(name, curves, x_label="time t, s", y_label=y_label, thin_label="exact", stop=stop, stop_label=stop_label)


def test_no_date_no_metadata_and_its_size_in_mm() -> None:
    svg = plot()
    assert svg.startswith("<svg")
    assert "metadata" not in svg
    assert not re.search(r"20\d\d-\d\d", svg)
    assert 'width="170mm"' in svg
    assert plot() == svg
    assert plot("plot-2") != svg


@pytest.mark.parametrize("text", ["$x_$", "$\\frac{$", "$5 and $6", "<b>&"])
def test_labels_are_text(text: str) -> None:
    svg = plot(y_label=text, stop=0.3, stop_label=text)
    shown = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    assert svg.count(shown) == 2


def test_curves_differ_in_dashes_or_marks() -> None:
    assert len({(str(dashes), mark) for _, dashes, mark in STYLES}) == len(STYLES)
    assert len({mark for _, _, mark in STYLES}) == len(STYLES)


def test_fewer_curves_leave_nothing_of_the_sheet_before() -> None:
    few = plot(count=1)
    plot(count=6, stop=0.2, stop_label="dead point")
    assert plot(count=1) == few
    assert "dead point" not in few


def test_symbols_without_a_unicode_subscript_are_set_by_our_own_table() -> None:
    assert label_text(symbol("w3")) == "ω₃"
    assert label_text(symbol("VMx")) == r"$V_{\mathrm{Mx}}$"
    assert "$" not in label_text(symbol("speed"))


def test_constant_and_single_points_have_room() -> None:
    one = Curve(symbol("w1"), np.zeros(1), np.ones(1))
    flat = Curve(symbol("w2"), T, np.zeros(25))
    for curves in ([one], [flat]):
        assert "<svg" in time_plot("x", curves, x_label="t", y_label="y", thin_label="")


def test_long_curves_are_thinned_with_their_last_point() -> None:
    values = np.arange(100_000.0)
    kept = sparse(values, 2000)
    assert len(kept) <= 2001
    assert kept[-1] == values[-1]
    assert sparse(np.zeros(0), 10).size == 0


def test_a_drawing_to_scale_names_its_size() -> None:
    figure = true_to_scale('<?xml?><svg width="170mm" height="110mm" viewBox="0 0 170 110"></svg>', "alt", [])
    assert (figure.width, figure.height, figure.exact) == (170.0, 110.0, True)
    with pytest.raises(ValueError, match="in mm"):
        true_to_scale('<svg width="100%" height="50"></svg>', "alt", [])


def test_rc_settings_of_the_user_neither_change_nor_matter(stand_in: ModuleType) -> None:
    import matplotlib

    before = dict(matplotlib.rcParams)
    svg = plot()
    assert dict(matplotlib.rcParams) == before
    with matplotlib.rc_context({"font.size": 30, "lines.linewidth": 9, "svg.fonttype": "path"}):
        assert plot() == svg
