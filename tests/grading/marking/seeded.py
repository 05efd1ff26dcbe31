"""A seeded class of variant 31 with known slips and misconceptions, and how much of it the marks find.

python -m tests.grading.marking.seeded 200      prints the figures; a short class is in the suite

Everything is made from formulas written out in `students.py`; nothing of the tool makes what it is judged by.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import numpy as np

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes.misconceptions import looked_for
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.grading.marking.table.first_wrong import first_wrong
from coursework.grading.marking.table.points import table_points
from tests.grading.marking import students
from tests.grading.marking.told import found_in

SEED = 1995


@dataclass
class Figures:
    """How many there were, how many were found; `blamed` cells of tables with one slip, `false` alarms on right tables."""

    slips: int = 0
    first_found: int = 0
    one_blamed: int = 0
    misconceptions: int = 0
    named: int = 0
    without_ground: int = 0
    right: int = 0
    false_alarms: int = 0


def figures(count: int, decimals: tuple[int, ...] = (3, 4, 5)) -> Figures:
    """Grade the tables of a class; a third right, a third with one slip, a third with a misconception."""
    key = key_of(coursework.load("31"))
    rng = np.random.default_rng(SEED)
    found = Figures()
    codes = list(students.MISCONCEPTIONS)
    for number in range(count):
        digits = int(rng.choice(decimals))
        if number % 3 == 0:
            table, truth = students.table(), ""
        elif number % 3 == 1:
            table, truth = visible_slip(rng, digits)
        else:
            truth = codes[number // 3 % len(codes)]
            table = students.MISCONCEPTIONS[truth]()
        cells = mark_cells(key, StudentTable(np.round(table, digits), np.full(table.shape, 10.0**-digits)))
        points = table_points(key, cells)
        named = found_in(key, cells).named if looked_for(key, cells, points.cells) else None
        count_one(found, truth, cells, named, first_wrong(key, cells), key)
    return found


def visible_slip(rng, digits):
    """A slip that changes the printed cell by five units of its last place at least: what is not printed is no slip."""
    while True:
        row, column = int(rng.integers(1, 24)), int(rng.integers(0, 4))
        factor = float(rng.choice([0.9, 1.1, -1.0, 2.0, 1.03]))
        if abs((factor - 1) * students.table()[row, 3 + column]) >= 5 * 10.0**-digits:
            return students.slip(row, column, factor), (row, 3 + column)


def count_one(found, truth, cells, named, first, key):
    if truth == "":
        found.right += 1
        found.false_alarms += bool(cells.wrong.any()) or named is not None
    elif isinstance(truth, tuple):
        found.slips += 1
        found.first_found += first is not None and (first.row - 1, key.names.index(first.column)) == truth
        found.one_blamed += int(cells.wrong.sum()) == 1
        found.without_ground += named is not None
    else:
        found.misconceptions += 1
        found.named += named is not None and truth in (named.code, *named.ties)
        found.without_ground += named is not None and truth not in (named.code, *named.ties)


if __name__ == "__main__":
    for wanted in ((3, 4, 5), (2,)):
        made = figures(int(sys.argv[1]) if len(sys.argv) > 1 else 200, wanted)
        print(f"decimals {wanted}: first wrong cell {made.first_found} of {made.slips}, one cell blamed {made.one_blamed},")
        print(f"  misconceptions with ties {made.named} of {made.misconceptions}, without ground {made.without_ground},")
        print(f"  false alarms {made.false_alarms} of {made.right} right tables")
