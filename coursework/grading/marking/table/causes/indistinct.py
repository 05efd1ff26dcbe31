"""Which hypotheses the printed digits cannot tell from Euler's rules: these are never named.

Enters: a `Key`, the units of the last places in each column.  Leaves: codes.  Used by `grade.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.hypotheses import claims
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.explained import euler_cells, share_of
from coursework.grading.marking.table.ways import StudentTable
from coursework.system.arrays import Array

# If Euler's rules explain this part of a hypothesis's own table, the printed digits cannot tell the two apart.
ALIKE = 0.98
_ROUND_OFF = 1e-9


def indistinct(key: Key, units: Array, confusions: Mapping[str, float] | None = None) -> tuple[str, ...]:
    """Return the hypotheses that columns printed with `units` (m + r,) cannot tell from Euler's rules; NaN: no such column.

    Each hypothesis is applied to the right table; if it expects values within Euler's tolerance, its own table would pass as
    right.  A hypothesis that expects nothing different from Euler's rules is left out.
    """
    right = mark_cells(key, StudentTable(key.table, np.broadcast_to(units, key.table.shape)))
    allowed = np.fmax.reduce([way.tolerance for way in right.ways])
    nothing = _ROUND_OFF * np.maximum(1.0, key.ranges)
    spoken = ~right.missing
    found: dict[str, float] = {}
    differs: set[str] = set()
    for claim in claims(TableUnderTest(key, right.student, closely=False), confusions or {}, {}):
        if claim.student is not None:
            differs.add(claim.code)
            alike = share_of(*euler_cells(mark_cells(key, claim.student)))
        else:
            apart = np.abs(claim.expected - key.table)
            if np.any(apart > nothing):
                differs.add(claim.code)
            alike = 1.0 - share_of((apart > allowed) & spoken, spoken)
        found[claim.code] = min(alike, found.get(claim.code, 1.0))
    return tuple(code for code, alike in found.items() if alike >= ALIKE and code in differs)
