"""Numbers whose further digits were cut off instead of rounded: toward zero, or downwards as floors are.

Enters: marked cells.  Leaves: the table marked with half a unit of the last place put back, None if nothing was cut off.
Used by `grade.py`.
A number that was cut off lies up to a whole unit of its last place from the true one, always on the same side.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.by_rows import marked
from coursework.grading.marking.table.causes.misconceptions import FEWEST, FEWEST_SHARE
from coursework.grading.marking.table.cells import Cells, alike
from coursework.grading.marking.table.ways import ANGLES, KEY, put_right
from coursework.system.arrays import Array, Flags

# A wrong cell is a near miss up to so many tolerances; few of the near misses are this part of those on the side of what was cut
# off; the parts of the right cells that lie on that side if digits were cut off, where few cells missed and where many did: of
# rounded ones about half do.
_NEAR, _FEW, _MOST, _MORE = 2.0, 0.25, 0.75, 0.55


def with_the_rest(key: Key, cells: Cells) -> Cells | None:
    """Return the table marked with what was cut off put back, except in cells that agree with the key as they are printed.

    Wrong cells must miss the key, or the velocity at their own angles, by little and on the side of what was cut off, few on the
    other, and few may stay wrong: more than slips can explain, or as many in a table right but for slips. More of the right cells
    must lie on that side than rounded ones do. Steps tell nothing: both of their rows were cut off.
    """
    student, slips = cells.student, max(FEWEST, FEWEST_SHARE * cells.marks.size)
    ways = [cells.way(KEY), cells.way(ANGLES)]
    expected, tolerance = np.array([way.expected for way in ways]), np.array([way.tolerance for way in ways])

    def on(side: Array, which: Flags, most: Array) -> Flags:
        off = side * (expected - student.values)
        return np.asarray((which & (off > 0) & (off <= most)).any(axis=0))

    put = put_right(alike(key, student, key.table))  # right cells count for what they may have been
    found = []
    toward_zero = np.where(student.values == 0, np.sign(key.table), np.sign(student.values))
    for side in (toward_zero, np.ones_like(toward_zero)):
        missed, other = (on(by, cells.wrong, _NEAR * tolerance) for by in (side, -side))
        few_of_them = _FEW * (missed | put).sum()
        if not missed.any() or other.sum() > few_of_them:
            continue
        lies, opposite = (on(by, ~cells.wrong, student.units).sum() for by in (side, -side))
        few = missed.sum() <= slips
        if lies <= (_MOST if few else _MORE) * (lies + opposite):
            continue
        values = np.where(alike(key, student, key.table), student.values, student.values + side * student.units / 2)
        made = marked(key, replace(student, values=values))
        if (made.wrong & missed).sum() <= few_of_them and not (few and made.wrong.sum() > slips):
            found.append(made)
    return min(found, key=lambda made: int(made.wrong.sum()), default=None)
