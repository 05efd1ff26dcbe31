"""Numbers whose further digits were cut off instead of rounded: toward zero, or downwards as floors are.

Enters: marked cells.  Leaves: the table marked with half a unit of the last place put back, None if nothing was cut off.
Used by `grade.py`.
A number that was cut off lies up to a whole unit of its last place from the true one, always on the same side.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.by_rows import marked
from coursework.grading.marking.table.causes.misconceptions import FEWEST, FEWEST_SHARE
from coursework.grading.marking.table.cells import Cells, alike
from coursework.grading.marking.table.ways import Way, near
from coursework.system.arrays import Array, Flags


def with_the_rest(key: Key, cells: Cells) -> Cells | None:
    """Return the table marked with what was cut off put back, except in cells that agree with the key as they are printed.

    More cells must be right with it, and no more than slips wrong: a table made by another rule is not explained so. Nor may more
    than slips agree with the key with the opposite of it: a cell put right is none of these, and no other cell becomes one.
    """
    slips = max(FEWEST, FEWEST_SHARE * cells.marks.size)
    student = cells.student
    toward_zero = np.where(student.values == 0, np.sign(key.table), np.sign(student.values))
    found: list[tuple[int, Array]] = []
    for side in (toward_zero, np.ones_like(toward_zero)):
        rest = side * student.units / 2
        put_right, opposite = _right(cells, rest, cells.ways), _right(cells, -rest, cells.ways[:1])
        if put_right.any() and opposite.sum() <= slips:
            found.append((int(put_right.sum()) - int(opposite.sum()), rest))
    if not found:
        return None
    _, rest = max(found, key=lambda one: one[0])
    values = np.where(alike(key, student, key.table), student.values, student.values + rest)
    made = marked(key, replace(student, values=values))
    return made if made.wrong.sum() <= slips else None


def _right(cells: Cells, rest: Array, ways: Sequence[Way]) -> Flags:
    """Return which wrong cells are right in one of the ways once the `rest` (n, m + r) is put back."""
    values = cells.student.values + rest
    return np.asarray(np.any([near(values, way.expected, way.tolerance) for way in ways], axis=0) & cells.wrong)
