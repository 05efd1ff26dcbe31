"""How far position equations are open, as lengths and angles: equations of squares of lengths too.

Enters: a `Closure`, positions.  Leaves: residuals in m and rad.  Used by `drift.py` and `beginning.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.equations.reduction.system import compile_values
from coursework.motion.geometry.closure import Closure
from coursework.system.arrays import Array, as_columns
from coursework.variant.record.held import POWERS

_DEGREES = {unit: degree for degree, unit in POWERS.items()}


def gaps(closure: Closure, times: Array, q: Array, targets: Array) -> Array:
    """Return the residuals (n, k) at times (n,) and positions (n, m) in m or rad.

    An equation between products of k lengths, P = Q, is open by the difference of their k-th roots: x^2 + y^2 - r^2 by the
    length that (x, y) is too far from the origin.
    """
    residual, _ = closure.residual(times, q, targets)
    for place, position in enumerate(closure.equations.positions):
        if position.unit in _DEGREES:
            terms = as_columns(compile_values(closure.equations, position.expression.terms)[1](times, *q.T), times.shape)
            sides = np.column_stack([terms, -targets[..., place] + np.zeros(len(times))])
            left, right = (np.maximum(sign * sides, 0.0).sum(axis=1) for sign in (1, -1))
            degree = _DEGREES[position.unit]
            residual[:, place] = left ** (1 / degree) - right ** (1 / degree)
    return residual
