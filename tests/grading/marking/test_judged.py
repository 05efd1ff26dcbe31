"""How the steps and the arithmetic of a table are judged, just inside and just outside."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking import verdicts
from coursework.grading.marking.reasons.table import shut
from coursework.grading.marking.table_marks import TableMarks


@pytest.mark.parametrize(
    ("wrong", "cells", "named", "judged"),
    [(0, 50, None, "right"), (2, 50, None, "slip"), (3, 50, None, "unknown"), (3, 150, None, "slip"), (4, 199, None, "unknown"),
     (4, 200, None, "slip"), (2, 50, "euler", "unknown"), (0, 50, "euler", "right")],
)  # fmt: skip
def test_two_cells_or_a_fiftieth_are_slips(wrong, cells, named, judged):
    table = SimpleNamespace(
        cells=SimpleNamespace(wrong=np.arange(cells) < wrong), misconception=named, points=SimpleNamespace(cells=cells)
    )
    assert verdicts._arithmetic(table) == judged


@pytest.mark.parametrize(
    ("rows", "held", "spoken", "judged"),
    [(3, 93, 100, "right"), (3, 92, 100, "wrong"), (2, 100, 100, "unknown"), (3, 0, 0, "unknown"), (3, 0, 1, "wrong")],
)
def test_steps_are_eulers_where_93_of_a_hundred_are(monkeypatch, rows, held, spoken, judged):
    monkeypatch.setattr(verdicts, "euler_steps", lambda *_: (held, spoken))
    values = np.where(np.arange(5)[:, None] < rows, 1.0, np.nan) * np.ones(2)
    cells = SimpleNamespace(student=SimpleNamespace(values=values))
    assert verdicts._integration(SimpleNamespace(coordinates=("a", "b"), m=2), cells) == judged


def test_right_cells_that_do_not_count_are_told_where_cells_count():
    marked = SimpleNamespace(earned=SimpleNamespace(shut={"motion": 3}, rule="cells"))
    assert shut(marked) == {"motion": 3}
    marked.earned.rule = "misconception"
    assert shut(marked) == {}


@pytest.mark.parametrize(("right", "asked"), [((9, 10), ""), ((10, 8), "which?")])
def test_nine_right_cells_of_ten_answer_whose_a_column_is(right, asked):
    """The first of three columns is named by its head, so that nobody asks."""
    columns = [SimpleNamespace(name=name, by="head" if name == "a" else "position") for name in "abc"]
    shown = np.ones((10, 3), dtype=bool)
    cells = SimpleNamespace(judged=shown, right=np.arange(10)[:, None] < [0, *right])
    marks = SimpleNamespace(table=SimpleNamespace(columns=columns, asked="which?"), cells=cells)
    assert (TableMarks.open_question(marks, ("a", "b", "c")) or "") == asked


@pytest.mark.parametrize(("rows", "held", "spoken", "judged"), [
    (2, 1, 1, "unknown"), (3, 1, 1, "right"), (3, 0, 0, "unknown"), (3, 93, 100, "right"), (3, 92, 100, "wrong"),
])  # fmt: skip
def test_the_steps_of_three_rows_are_judged(rows, held, spoken, judged, monkeypatch):
    monkeypatch.setattr(verdicts, "euler_steps", lambda *_: (held, spoken))
    values = np.where(np.arange(5)[:, None] < rows, 1.0, np.nan)
    cells = SimpleNamespace(student=SimpleNamespace(values=values))
    assert verdicts._integration(SimpleNamespace(coordinates=("phi",), m=1), cells) == judged
