"""A table printed with few digits that is, as a whole, what one cause makes: with all the digits that cause gives it.

Enters: marked cells, the claims.  Leaves: `AsMade`.  Used by `grade.py`.
With few digits each step may lie within what they leave open of Euler's, and the table still be made by another rule from its
first row to its last.  What it earns is then worked out with all digits: the same fault costs the same with any.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim
from coursework.grading.marking.table.causes.misconceptions import NAMED, TIE, Misconception, is_one_thing
from coursework.grading.marking.table.causes.own_equations import OWN
from coursework.grading.marking.table.cells import Cells, alike
from coursework.grading.marking.table.points import TablePoints, share_of
from coursework.grading.marking.table.untold import FINEST
from coursework.grading.marking.table.ways import StudentTable, near
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen

# Of a table the part that a cause must make, how much more than the task does, how much of what the task does not: a slip that
# is carried on leaves the key too, and other causes come nearer by chance.  Fewer cells than name a cause: no single one decides.
_MOST, _MORE, _OF_REST = 0.7, 0.05, 0.6


@frozen
class AsMade:
    """The `student`'s table with all digits where it is what the cause makes or the task has; what is `named` by it."""

    student: StudentTable
    named: Misconception | None


def as_made(key: Key, cells: Cells, claims: Iterable[Claim]) -> AsMade | None:
    """Return the table that a cause makes, where that is most of the one printed and the key's is less; else None."""
    spoken = cells.counted & ~cells.missing
    right = alike(key, cells.student, key.table)
    by_key = share_of(right & spoken, spoken)
    least = max(_MOST, by_key + max(_MORE, _OF_REST * (1.0 - by_key)))
    made: dict[str, tuple[float, Array, tuple[str, ...]]] = {}
    for claim in claims if by_key < 1.0 - _MORE else ():
        if claim.table is None or claim.code == OWN or not _may_be(cells, claim, spoken, right):
            continue
        table = claim.table()
        same = alike(key, cells.student, table)
        share = share_of(same & spoken, spoken)
        # A cell put right is none against a cause that makes more than the task does.
        left = spoken & ~same & ~right
        is_most = share > by_key and share_of(spoken & ~left, spoken) >= least and left.sum() <= cells.wrong.sum()
        if is_most and (claim.code not in made or share > made[claim.code][0]):
            made[claim.code] = share, table, claim.names
    if not made:
        return None
    best = max(share for share, *_ in made.values())
    first, *others = [code for code, (share, *_) in made.items() if share >= best - TIE]
    ties = [code for code in others if is_one_thing(code, made[code][2])]
    share, table, names = made[first]
    same = alike(key, cells.student, table)
    values = np.where(same, table, np.where(right, key.table, cells.student.values))  # others may be put right
    units = np.where(same | right, FINEST, cells.student.units)
    named = Misconception(first, share, by_key, tuple(ties), names) if share >= NAMED else None
    return AsMade(replace(cells.student, values=values, units=units), named)


def untold_points(cells: Cells, points: TablePoints, made: Cells) -> TablePoints:
    """Return the points of a table `made` with all digits, with what is right in print only among what does not count."""
    right, fine = (~one.wrong & ~one.missing & one.counted for one in (cells, made))
    assert points.uncounted is not None
    uncounted = right & ~(fine & ~points.uncounted)
    return replace(points, shut={"untold": int(uncounted.sum())} if uncounted.any() else {}, uncounted=uncounted)


def _may_be(cells: Cells, claim: Claim, spoken: Flags, right: Flags) -> bool:
    """Return whether a claim holds, or the task, in most cells of which it says anything: only then its whole table is made."""
    says = spoken & np.isfinite(claim.expected)
    return share_of((near(cells.student.values, claim.expected, claim.tolerance) | right) & says, says) >= _MOST
