"""Where an equation of a table divides by zero: a row that says 0/0, or a denominator that passes zero between two rows.

Enters: `Evidence`, the equations that were solved.  Leaves: a `Division`.  Used by `conditioning.py`.
A motion goes on there only if what is divided is zero too.  Beside such a point a small error of an angle becomes a large one of
the velocity, whatever the scheme, and no determinant shows it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.equations.algebra.calculus import divisors
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.system import compile_values
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.results.checks.evidence import Evidence
from coursework.system.frozen import frozen
from coursework.variant.formula.made import as_read

# A double has sixteen digits; six are more than any table of the coursework shows.
DIGITS, FEWEST = 16.0, 6.0


@frozen
class Division:
    """An `equation` divides by `by`, which is zero at the `time` between the `row` (from 1) and the next.

    `digits`: those of sixteen that are left in that row.
    """

    equation: str
    by: str
    time: float
    row: int
    digits: float


def division(evidence: Evidence, used: Sequence[VelocityEquation]) -> Division | None:
    """Return where the denominator with the fewest digits is zero, None if none is or passes it."""
    motion, equations = evidence.motion, evidence.equations
    pairs = equations.once(("divisors", *(one.name for one in used)), lambda: _divisors(used, equations))
    if not pairs:
        return None
    values = compile_values(equations, [by for _, by in pairs])[1](motion.t, *motion.coordinates.T)
    open_rows = np.ones(len(motion.t), dtype=bool)
    for passage in evidence.passages:  # there the limit is known, and nothing is solved
        open_rows &= ~passage.is_at(motion.t)
    found = []
    for (name, by), each in zip(pairs, values, strict=True):
        sizes = np.broadcast_to(np.asarray(each, dtype=float), motion.t.shape)
        shares = np.abs(sizes) / max(float(np.max(np.abs(sizes), initial=0.0)), np.finfo(float).tiny)
        row = int(np.argmin(np.where(open_rows, shares, 1.0)))
        digits = float(np.clip(DIGITS + np.log10(max(shares[row], 10.0**-DIGITS)), 0.0, DIGITS))
        crossed = np.flatnonzero((sizes[1:] * sizes[:-1] < 0) & open_rows[1:] & open_rows[:-1])
        time = float(motion.t[row])
        if len(crossed) and digits >= FEWEST:
            row = int(crossed[0])
            time = float(motion.t[row] + (motion.t[row + 1] - motion.t[row]) * sizes[row] / (sizes[row] - sizes[row + 1]))
        if len(crossed) or digits < FEWEST:
            found.append(Division(name, as_read(as_formula(by, equations.order)), time, row + 1, digits))
    return min(found, key=lambda one: one.digits, default=None)


def _divisors(used: Sequence[VelocityEquation], equations: VelocityEquations) -> list[tuple[str, Expression]]:
    """Return the names of equations, each with what it divides by and what depends on the position."""
    moving = {symbol(one.name) for one in equations.variant.coordinates}
    parts = ((one.name, part) for one in used for part in one.parts)
    every = dict.fromkeys((name, by) for name, part in parts for by in divisors(part))
    return [(name, by) for name, by in every if not moving.isdisjoint(by.free_symbols)]
