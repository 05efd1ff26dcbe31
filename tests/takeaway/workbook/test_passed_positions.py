"""The workbook of a motion that passes a position where its formulas would divide by nothing."""

import pytest

from coursework.takeaway.workbook.book import workbook_of
from tests.hard.scenes import solve
from tests.motion.singular.test_passages import BY_GROUPS, past_its_pivot
from tests.takeaway.workbook.evaluated import Evaluated
from tests.takeaway.workbook.test_workbook import off, table


def test_a_position_passed_through_has_its_velocities_where_a_formula_would_divide_by_nothing():
    run = solve(past_its_pivot(BY_GROUPS, 0.1, end=0.6), "euler", ("table",))
    _, rows = table(run)
    at = run.motion.names.index("w")
    assert len(run.scene.search.passages) == 1 and rows[5, 0] == 0.5 and rows[5, 1 + at] == pytest.approx(0.5, abs=1e-6)
    assert off(Evaluated(workbook_of(run, "en")).rows("Euler", *rows.shape), rows) < 1e-9
