"""The claims that explain most of a table, held against the whole of it: what they explained before cells were put right counts.

A table made with other velocities or another step is marked as if these were the task's.
Enters: `Claim`s, a `Key`, marked cells.  Leaves: the claims to look at, which cells each explains.  Used by `misconceptions.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.causes.hypotheses import ROUNDED_OMEGA
from coursework.grading.marking.table.cells import Cells, alike, mark_cells
from coursework.grading.marking.table.ways import KEY, near
from coursework.system.arrays import Array, Flags

# For so many of the hypotheses that explain most the whole table is computed.
_CLOSER, _READ_OFF = 3, 2


@dataclass(frozen=True, eq=False, kw_only=True)
class _MisreadKey(Key):
    """The key of a table made with the velocities `made_with` (t, q) and with steps that are `part` of those of the `task`."""

    made_with: Callable[[Array, Array], Array]
    part: float
    task: Key

    def velocities_at(self, t: Array, q: Array, data: Mapping[str, float] | None = None) -> Array:
        """Return the velocities (n, r) with which the table was made."""
        return self.made_with(t, q)

    @property
    def stride(self) -> float:
        """Return the step with which the table was made, s."""
        return self.part * self.step

    @property
    def blocks(self) -> tuple[tuple[str, ...], ...]:
        """Return one block with all velocities: an order of solution exists only for the task."""
        return (self.velocities,)

    @cached_property
    def coarsest(self) -> Array:
        """Return the coarsest digits that count as shown: the task decides them, whatever the table was made with."""
        return self.task.coarsest


def closer(held: Mapping[str, tuple[int, Claim, Flags]]) -> list[tuple[str, Claim, Flags]]:
    """Return the claims to hold against the whole table: of most cells, data read off, which a column put right hides, and
    velocities rounded: nearly the task's, they explain fewer cells than many a cause that is worth less.
    """
    by_count = sorted(held.items(), key=lambda found: -found[1][0])
    rest = by_count[_CLOSER:]
    data = [found for found in rest if found[1][1].is_read_off][:_READ_OFF]
    rounded = [found for found in rest if found[0].startswith(ROUNDED_OMEGA)]
    return [(code, claim, holds) for code, (_, claim, holds) in (*by_count[:_CLOSER], *data, *rounded)]


def as_it_was(key: Key, cells: Cells, claim: Claim) -> Flags:
    """Return which cells a claim explains by its whole table, or by the values that stood there before cells were put right."""
    if claim.velocities_at is not None:
        return _by_its_own_rules(key, cells, claim)
    values = cells.student.values
    with np.errstate(invalid="ignore"):
        put = (cells.marks == KEY) & (np.abs(values - claim.expected) > claim.tolerance)
    was = np.where(put, claim.expected, values if cells.before is None else cells.before.values)
    none = np.zeros(values.shape, dtype=bool)
    whole = none if claim.table is None else alike(key, cells.student, claim.table())
    if claim.family is None or np.array_equal(was, values, equal_nan=True):
        return whole
    before = TableUnderTest(key, replace(cells.student, values=was))
    found = [near(values, one.expected, one.tolerance) for one in claim.family(before) if one.code == claim.code]
    best = max(found, key=np.count_nonzero, default=none)
    if np.isnan(claim.expected[:, : before.m]).all():
        units = before.w_units[:, : before.m]
        best[:, : before.m] |= near(values[:, : before.m], *before.steps(key.step * before.w, key.step * units))
    return best | whole


def _by_its_own_rules(key: Key, cells: Cells, claim: Claim) -> Flags:
    """Return which cells are right if the velocities of a claim are taken for the task's, slips being marked as in any table.

    A cell with the task's value had the claim's before it was put right; what follows from the earlier value is right too.
    """
    assert claim.velocities_at is not None and claim.table is not None
    own = _MisreadKey(key.variant, key.model, key.table, made_with=claim.velocities_at, part=claim.part, task=key)
    table = claim.table()
    made = mark_cells(own, cells.student, table)
    right = ~made.wrong & ~made.missing
    put = alike(key, cells.student, key.table) & ~alike(key, cells.student, table)
    if not put.any():
        return right
    before = mark_cells(own, replace(cells.student, values=np.where(put, table, cells.student.values)), table)
    return right | (~before.wrong & ~before.missing & ~put)
