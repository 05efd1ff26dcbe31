"""What a legend says of the cells of a sheet, and what the formulas in cells mean by it."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.systems.cells import _columns, _formula, _pairs, with_cells_named

MEANS = {"r": "r", "phi": "phi", "w": "w"}.get  # a length and two columns of the table


@pytest.mark.parametrize(("line", "pairs"), [
    ("B1 = r", "B1:r"), ("r: B1", "B1:r"), ("B1 is r", "B1:r"), ("B1 = r, C5 = phi", "B1:r C5:phi"), ("column B: phi", "B:phi"),
    ("A1:C1 = r, phi, w", "A1:r B1:phi C1:w"), ("A1:A3 = r, phi, w", "A1:r A2:phi A3:w"), ("A1:D1 = r, phi, w", ""),
    ("A1:C1 = r, phi, q", ""), ("B1 = r*phi", ""), ("B1 = q", ""), ("$B$1 = r", "B1:r"), ("B1 = r " + "x" * 600, ""),
])  # fmt: skip
def test_a_legend_names_cells_and_columns(line: str, pairs: str) -> None:
    assert " ".join(map(":".join, _pairs(line, MEANS))) == pairs


@pytest.mark.parametrize(("piece", "formula"), [
    ("F5: w = $B$1*COS(C5)", ("F5", "w", "$B$1*COS(C5)")), ("F5: =SIN(C5)", ("F5", "", "SIN(C5)")),
    ("w (F5) = B1*2", ("F5", "w", "B1*2")),
    ("F5: w = 2*3", ("F5", "w", "2*3")), ("F5 = (2*3)", ("F5", "", "(2*3)")), ("F5 = 2*3", None), ("F5", None),
    ("F5 = B1 = B2*2", None),
])  # fmt: skip
def test_a_formula_has_a_cell_and_a_name_a_reference_or_a_call(piece: str, formula: tuple[str, str, str] | None) -> None:
    assert _formula(piece) == formula


@pytest.mark.parametrize(("cells", "columns"), [
    ({"B4": "w"}, {}), ({"A1": "phi", "B1": "w"}, {"A": "phi", "B": "w"}), ({"A": "phi", "B2": "w"}, {"A": "phi"}),
    ({"A1": "phi", "B2": "w"}, {}),
])  # fmt: skip
def test_a_row_of_names_names_columns(cells: dict[str, str], columns: dict[str, str]) -> None:
    assert _columns(cells) == columns


@pytest.mark.parametrize(("text", "named"), [
    ("B1 = r\nC5 = phi\nw (F5) = B1*COS(C5)", "\n\nw = r*COS(phi)"), ("A1:A3 = r, phi, w\nA4: =A1*COS(A2)", "\nA4 = r*COS(phi)"),
    ("A2 = phi, B2 = w\nC3: =B3*SIN(A3)\nC4: =$B$2*SIN(A4)", "\nC3 = w*SIN(phi)\nC4 = w*SIN(phi)"),
    # too few references; names that mean nothing here
    ("B1 = r\nB2 = phi", "B1 = r\nB2 = phi"), ("B1 = x, C5 = y\nF5: = B1*C5", "B1 = x, C5 = y\nF5: = B1*C5"),
])  # fmt: skip
def test_formulas_in_cells_by_the_names_of_a_legend(text: str, named: str) -> None:
    assert with_cells_named(text, MEANS, frozenset({"r"})) == named
