"""Cells and heads as people write them: powers of ten, units behind a comma, the line that names the separator."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from coursework.grading.reading.files.kinds import real_kind
from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import Room
from coursework.grading.reading.numbers import looks_numeric, plain_text, printed
from coursework.grading.reading.table.headers import _without_unit, read_head
from coursework.grading.reading.table.layout import _joined, _lies
from coursework.grading.reading.table.units import unit_of_column


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("1.5·10⁻³", "1.5e-3"), ("1,5×10-3", "1,5e-3"), ("2*10^-4", "2e-4"), ("2·10^(-4)", "2e-4"), ("110", "110"),
        ("12 rad", "12"), ('="1.5"', "1.5"), ("'3", "3"), ("−3,5", "-3,5"),
        ("-3.0205*", "-3.0205"), ("3.02(1)", "3.02"), ("3.02 ± 0.01", "3.02"), ("≈3.02", "3.02"), ("3.02 рад/с", "3.02"),
        ("3,02;", "3,02"), ("**-3.02**", "-3.02"), ("3.02 ✓", "3.02"), ("$3{,}02$", "3,02"), ("(3.02)", "3.02"),
        ("3.02¹", "3.02"), ("3.02 (N = 2)", "3.02"), ("3.02 ← check", "3.02"), ("2.5 s^-1", "2.5"),
        ("1.5·10^-3*", "1.5e-3"), ("1 234,5 м/с", "1 234,5"),
    ],
)  # fmt: skip
def test_a_number_without_what_is_around_it(text: str, plain: str) -> None:
    assert plain_text(text) == plain


@pytest.mark.parametrize(
    "text", ["3.02 m2", "<0.001", "01.05.2024", "1.май", "0,05,0,35", "2 of 3", "31 variant", "[a] 1", "w1", "1:30"]
)
def test_what_is_more_than_a_number_is_none(text: str) -> None:
    assert plain_text(text) == text and not looks_numeric(text)


@pytest.mark.parametrize("sign", [";", ",", "\t", "|"])
@pytest.mark.parametrize("more", ["", ";;", " "])
def test_the_separator_that_a_file_names_is_taken(sign: str, more: str) -> None:
    """A line of numbers with commas may be read in two ways, were it not said; the line itself stays one, and empty."""
    found = split(f"sep={sign}{more}\nt{sign}w1\n0{sign}1.5\n", Room(600, 40))
    assert found is not None and found.separator == {"\t": "tab"}.get(sign, sign)
    assert found.rows == ((), ("t", "w1"), ("0", "1.5"))


def test_blanks_within_numbers_part_no_cells_where_tabs_do() -> None:
    """Blanks or tabs: either way each cell is a number in three columns at least."""
    found = split("t\ts\tF\n0\t1 234,5\t7 890,1\n0,1\t1 235,5\t7 891,1\n0,2\t1 236,5\t7 892,1\n", Room(600, 40))
    assert found is not None and found.separator == "tab" and found.rows[1] == ("0", "1 234,5", "7 890,1")


@pytest.mark.parametrize(
    ("heads", "width", "joined"),
    [
        (["t", "s", "phi1", "rad"], 2, ["t, s", "phi1, rad"]), (["t", "s", "phi1", "rad", ""], 2, ["t, s", "phi1, rad"]),
        (["a", "b", ""], 2, ["a", "b"]), (["s", "t", "w1"], 2, ["s", "t", "w1"]),
    ],
)  # fmt: skip
def test_a_unit_that_a_comma_cut_off_goes_back_to_its_head(heads: list[str], width: int, joined: list[str]) -> None:
    assert _joined(heads, width) == joined


@pytest.mark.parametrize(
    ("head", "parts"),
    [
        ("w1(tk)", ("w1", "")), ("w1[t]", ("w1", "")), ("w1(rad/s)", ("w1", "1/s")), ("phi1,rad", ("phi1", "rad")),
        ("phi1 in deg", ("phi1", "deg")), ("x/mm", ("x", "mm")), ("phi1°", ("phi1", "deg")), ("w1(t), rad/s", ("w1", "1/s")),
        ("v(q)", ("v(q)", "")),
    ],
)  # fmt: skip
def test_a_head_and_its_unit(head: str, parts: tuple[str, str]) -> None:
    assert _without_unit(head) == parts


@pytest.mark.parametrize(
    ("unit", "head", "meant"), [("1/s", "deg", "deg/s"), ("1/s", "rad", "1/s"), ("rad", "deg", "deg"), ("m", "mm", "mm")]
)
def test_the_unit_that_a_head_says_counts(unit: str, head: str, meant: str) -> None:
    assert unit_of_column(SimpleNamespace(unit=unit, values=[1.0, 2.0]), head, [5.0, 10.0]) == meant


def test_pictures_are_known_by_their_first_bytes() -> None:
    assert real_kind(b"\0\0\0\x18ftypheic") == real_kind(b"\0\0\0\x18ftypmif1") == "HEIC"
    assert (real_kind(b"RIFF\0\0\0\0WEBP"), real_kind(b"RIFF\0\0\0\0WAVE")) == ("WebP", "")


@pytest.mark.parametrize(("rows", "lies"), [
    (["0 0.1 0.2", "1 5 7", "4 4 9"], True),  # three moments are enough
    (["t 0 0.1 0.2", "w 1 5 7", "u 4 4 9"], True), (["1 0 0.1 0.2", "2 1 5 7", "3 4 4 9"], False),  # 1 2 3 goes down
    (["0 0.1", "1 5", "4 4"], False),  # two are none
    (["0 0.1 0.2", "1 5 7"], False), (["0 0.1 0.2", "1 5 7", "4 4 9", "1 1 2", "3 1 3"], True),
    (["0 0.1 0.2", "1 5 7", "4 4 9", "1 1 2", "3 1 3", "3 1 3"], False),  # two rows more than columns of the task, not three
    (["0 0.1 0.2", "0.1 5 7", "0.2 4 9"], False), (["9 0.1 0.2 0.3", "7 0 1 7", "6 1 4 9", "8 2 5 3"], False),  # or down
    (["0 0.1 0.7", "1 5 7", "4 4 9"], False), (["20 3 1", "0 0.1 0.2", "4 4 9"], True), (["20 3 1", "4 4 9", "0 0.1 0.2"], False),
])  # fmt: skip
def test_a_table_without_heads_lies_where_the_time_runs_along_one_of_its_first_rows(rows: list[str], lies: bool) -> None:
    cells = [[printed(cell, ".") for cell in row.split()] for row in rows]
    assert _lies(cells, [list(column) for column in zip(*cells, strict=True)], 3) is lies


@pytest.mark.parametrize("head", [
    "w2", "ω2", "omega_2", "w2z", "wz2", "ω_2z", "omega_z2", "dphi2/dt", "dφ2dt", "phi2dot", "φdot2", "dotphi2", "W2",
])  # fmt: skip
def test_an_angular_velocity_by_any_of_its_names(head: str) -> None:
    found = read_head(head, (("phi2", "rad"), ("w2", "1/s"), ("w3", "1/s"), ("u2", "m/s")))
    assert found.candidates == ("w2",)
