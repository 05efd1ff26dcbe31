"""The rows of many data sets by one scheme, all sets in one step, watched as closely as in `march`.

Enters: a `Model`, prepared `Sets`, a scheme, the times.  Leaves: tables (n, rows, columns) and which of them are good.
Used by `many.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.integration.integrate import WIDEST_STEP
from coursework.motion.schemes import Scheme
from coursework.scene.model.model import Model
from coursework.scene.model.sets import Sets
from coursework.scene.model.watch import slopes, stacked
from coursework.system.arrays import Array, Flags


def rows_of(model: Model, sets: Sets, scheme: Scheme, times: Array) -> tuple[Array, Flags]:
    """Return the rows at `times` (t = i h), and for which sets (n,) the scheme stepped over nothing and stayed finite."""
    q, numbers = sets.begin, sets.numbers
    m, k = len(q), len(model.velocities)
    step = float(times[1] - times[0])  # no table has fewer rows than two
    guarded = model.angles_in_determinants
    table = np.empty((len(times), m + k, q.shape[1]))
    good = np.ones(q.shape[1], dtype=bool)
    before: Array | None = None
    with np.errstate(all="ignore"):
        for index, t in enumerate(times.tolist()):
            row, values = table[index], model.program(t, *q, *numbers)
            row[:m] = q
            for place, value in enumerate(values[:k], start=m):
                row[place] = value
            determinants = stacked(values[k:], q[:1])
            if before is not None:
                good &= (determinants * before > 0).all(axis=0)
            before = determinants
            if index + 1 < len(times):
                moved = scheme.step(slopes(model, numbers, (index + 1) * step), t, q, step, row[m : 2 * m])
                if guarded:
                    good &= (np.abs(moved[guarded] - q[guarded]) <= WIDEST_STEP).all(axis=0)
                q = moved
        good &= np.isfinite(table).all(axis=(0, 1))
    return table.transpose(2, 0, 1), good
