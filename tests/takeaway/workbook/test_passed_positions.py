"""The workbook of a motion that passes a position where its formulas would divide by nothing, or whose scheme leaves it."""

import pytest

import coursework
from coursework.takeaway.workbook.book import workbook_of
from tests.hard.scenes import solve
from tests.motion.singular.test_passages import BY_GROUPS, past_its_pivot
from tests.takeaway.workbook.evaluated import Evaluated, opened
from tests.takeaway.workbook.test_workbook import off, table


def test_a_position_passed_through_has_its_velocities_where_a_formula_would_divide_by_nothing():
    run = solve(past_its_pivot(BY_GROUPS, 0.1, end=0.6), "euler", ("table",))
    _, rows = table(run)
    at = run.motion.names.index("w")
    assert len(run.scene.search.passages) == 1 and rows[5, 0] == 0.5 and rows[5, 1 + at] == pytest.approx(0.5, abs=1e-6)
    assert off(Evaluated(workbook_of(run, "en")).rows("Euler", *rows.shape), rows) < 1e-9


def test_a_table_that_its_scheme_leaves_early_is_held_against_as_many_rows_of_the_motion():
    run = coursework.solve(coursework.load("31").with_data(given={"alpha": 1.9}), step=0.08, quantities=["table"])
    assert (len(run.motion.t), len(run.scene.exact.t)) == (3, 7)
    sheet = opened(workbook_of(run, "en")).book["Exact"]
    (place,) = (cell.column for cell in sheet[1] if cell.value == "Δphi1")
    assert [sheet.cell(row, place).value is not None for row in range(2, 9)] == [True, True, True, False, True, False, False]
