"""A table printed with few digits that is, as a whole, what one cause makes: it is restored with all digits of that cause.

Enters: marked cells, the claims.  Leaves: `AsMade`.  Used by `grade.py`, `questions.py`.
With few digits each step may be within Euler's tolerance, although the whole table was made by another rule.
The points are then computed with all digits, so that the same fault costs the same with any number of digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.by_rows import marked
from coursework.grading.marking.table.causes.claims import Claim, Family, TableUnderTest
from coursework.grading.marking.table.causes.misconceptions import NAMED, TIE, Misconception, is_one_thing, looked_for
from coursework.grading.marking.table.causes.own_equations import OWN
from coursework.grading.marking.table.causes.printed_otherwise import printed_otherwise
from coursework.grading.marking.table.cells import Cells, alike
from coursework.grading.marking.table.explained import share_of
from coursework.grading.marking.table.points import TablePoints
from coursework.grading.marking.table.untold import FINEST
from coursework.grading.marking.table.ways import StudentTable, near
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen

# A cause must make at least _MOST of a table, _MORE more of it than agrees with the task, and _OF_REST of what does not: a slip
# that is carried on leaves the key too, and other causes come near by chance.  To be named, a cause must make still more.
_MOST, _MORE, _OF_REST = 0.7, 0.05, 0.6

# A last place larger by up to this factor counts as fine enough: one decimal in degrees (0.0017 rad) as three in radians.
# From the second factor on, what a whole table was made with is looked for: the decimals asked do not show each cell of it.
_FEWER, _AS_ASKED = 2.0, 0.5


@frozen
class AsMade:
    """The `student`'s table with all digits in cells that agree with the cause or the task; the cause if it is `named`.

    `families` make the claims of the cause and its ties, of whatever table.
    """

    student: StudentTable
    named: Misconception | None
    families: tuple[Family, ...]

    def claims(self, key: Key, missing: Flags) -> list[Claim]:
        """Return what the families say about the table, and whether one column is only printed so.

        A cell that was `missing` (n, m + r) before the digits were put in would be missing in the right table too.
        """
        printed = TableUnderTest(key, self.student)
        handed_in = TableUnderTest(key, replace(self.student, values=np.where(missing, np.nan, self.student.values)))
        of_families = (replace(claim, family=family) for family in self.families for claim in family(printed))
        return [*printed_otherwise(handed_in), *of_families]


def as_made(key: Key, cells: Cells, told: Callable[[StudentTable], Iterable[Claim]]) -> AsMade | None:
    """Return the table as a cause makes it, None if none that is `told` makes most of it, clearly more than the key."""
    by = _AS_ASKED if looked_for(key, cells, cells.marks.size) else _FEWER
    if not fewer_decimals(key, cells, by):
        return None
    spoken = cells.judged
    right = alike(key, cells.student, key.table)
    by_key = share_of(right & spoken, spoken)
    least = max(_MOST, by_key + max(_MORE, _OF_REST * (1.0 - by_key)))
    made: dict[str, tuple[float, Array, Claim]] = {}
    for claim in told(cells.student) if by_key < 1.0 - _MORE else ():
        if claim.table is None or claim.code == OWN or not _may_be(cells, claim, spoken, right):
            continue
        table = claim.table()
        same = alike(key, cells.student, table)
        share = share_of(same & spoken, spoken)
        # A cell put right does not count against a cause that makes more than agrees with the task.
        left = spoken & ~same & ~right
        is_most = share > by_key and share_of(spoken & ~left, spoken) >= least and left.sum() <= cells.wrong.sum()
        if is_most and (claim.code not in made or share > made[claim.code][0]):
            made[claim.code] = share, table, claim
    if not made:
        return None
    best = max(share for share, *_ in made.values())
    first, *others = [code for code, (share, *_) in made.items() if share >= best - TIE]
    ties = [code for code in others if is_one_thing(code, made[code][2].names)]
    share, table, claim = made[first]
    same = alike(key, cells.student, table)
    values = np.where(same, table, np.where(right, key.table, cells.student.values))  # cells with the task's value were put right
    units = np.where(same | right, FINEST, cells.student.units)
    named = Misconception(first, share, by_key, tuple(ties), claim.names) if share >= NAMED else None
    families = dict.fromkeys(family for code in (first, *ties) if (family := made[code][2].family))
    return AsMade(replace(cells.student, values=values, units=units), named, tuple(families))


def untold_points(cells: Cells, points: TablePoints, made: Cells, carried: float) -> TablePoints:
    """Return the points of a table `made` with all digits; what is right only in print is among what does not count.

    A cell too coarse to be shown earns nothing in a right table, so it earns nothing here; `carried` is as in `table_points`.
    """
    right, fine = cells.right, made.right
    assert points.uncounted is not None
    counts = fine & ~points.uncounted
    lost = np.where(made.carried, carried, 1.0)[counts & cells.missing].sum() / max(points.cells, 1)
    uncounted = right & ~counts
    shut = {"untold": int(uncounted.sum())} if uncounted.any() else {}
    return replace(points, share=max(points.share - float(lost), 0.0), shut=shut, uncounted=uncounted)


def _may_be(cells: Cells, claim: Claim, spoken: Flags, right: Flags) -> bool:
    """Return whether most cells about which a claim speaks agree with it or the task: only then its whole table is computed."""
    says = spoken & np.isfinite(claim.expected)
    return share_of((near(cells.student.values, claim.expected, claim.tolerance) | right) & says, says) >= _MOST


def fewer_decimals(key: Key, cells: Cells, by: float = _FEWER) -> int:
    """Return how many cells are shown, but with last places larger `by` this factor than those of the decimals asked for."""
    with np.errstate(invalid="ignore"):
        return int((~cells.missing & (cells.student.units > by * 10.0**-key.least_decimals)).sum())


def only_coarse(key: Key, cells: Cells) -> int:
    """Return how many cells have too few decimals while hardly any is wrong, if nobody told how few a class may hand in.

    A class is told the same number for all; alone, of two variants one may need more. What the cells show is right all the same.
    """
    coarse = cells.too_coarse & cells.counted
    if key.accepted_decimals is not None or not coarse.any():
        return 0
    told = marked(replace(key, accepted_decimals=0), cells.student)
    is_shown = not (told.too_coarse & coarse).any() and not looked_for(key, told, int(told.counted.sum()))
    return int(coarse.sum()) if is_shown else 0
