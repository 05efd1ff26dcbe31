"""Where an equation of a table divides by zero: a row that says x/0, or a denominator that passes zero between two rows.

Enters: `Evidence`.  Leaves: `Division`s.  Used by `advice.py`, `conditioning.py`, `equations.py`, `check.py`.
A motion goes on there only if what is divided is zero too.  Beside such a point a small error of an angle becomes a large one of
the velocity, whatever the scheme, and no determinant shows it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from coursework.equations.algebra.calculus import divisors
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.system import compile_values
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.motion.integration.crossing import crossing
from coursework.results.checks.evidence import Evidence
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.made import as_read

# A double has sixteen digits; six are more than any table of the coursework shows.
DIGITS, FEWEST = 16.0, 6.0
_SETTLED = 1e-9  # share of a step: more digits of the time than are shown


@frozen
class Division:
    """An `equation` divides by `by`, which is zero at the `time` between the `row` (from 1) and the next.

    `digits`: those of sixteen that are left in that row.  `is_own`: a coordinate whose rate the equation gives stands in it, so
    that many motions may meet there, and it does not tell which one goes on.
    """

    equation: str
    by: str
    time: float
    row: int
    digits: float
    is_own: bool


def divisions(evidence: Evidence) -> Sequence[Division]:
    """Return for each denominator of the equations solved where it is zero, if it is or passes it."""
    return evidence.once("divisions", lambda: _found(evidence), of_rows=True)


def _found(evidence: Evidence) -> list[Division]:
    motion, equations = evidence.motion, evidence.equations
    used = [equation for equation in equations.equations if equation.name in evidence.used]
    pairs = equations.once(("divisors", *(one.name for one in used)), lambda: _divisors(used, equations))
    if not pairs:
        return []
    own = {one.name for one in used if _gives_own(one, equations)}
    at_one, at_all = compile_values(equations, [by for _, by in pairs])
    values = at_all(motion.t, *motion.coordinates.T)
    open_rows = np.ones(len(motion.t), dtype=bool)
    for passage in evidence.passages:  # there the limit is known, and nothing is solved
        open_rows &= ~passage.is_at(motion.t)
    found = []
    for place, ((name, by), each) in enumerate(zip(pairs, values, strict=True)):
        sizes = np.broadcast_to(np.asarray(each, dtype=float), motion.t.shape)
        shares = np.abs(sizes) / max(float(np.max(np.abs(sizes), initial=0.0)), np.finfo(float).tiny)
        row = int(np.argmin(np.where(open_rows, shares, 1.0)))
        digits = float(np.clip(DIGITS + np.log10(max(shares[row], 10.0**-DIGITS)), 0.0, DIGITS))
        time, states = float(motion.t[row]), np.column_stack([motion.t, motion.coordinates])
        if digits >= FEWEST:
            signs = np.flatnonzero((sizes[1:] * sizes[:-1] < 0) & open_rows[1:] & open_rows[:-1])
            shares_of = ((int(k), _zero(lambda *state, i=place: at_one(*state)[i], states[k : k + 2])) for k in signs)
            passed = next(((k, share) for k, share in shares_of if share is not None), None)
            if passed is None:
                continue
            row = passed[0]
            time = float(motion.t[row] + passed[1] * (motion.t[row + 1] - motion.t[row]))
        found.append(Division(name, as_read(as_formula(by, equations.order)), time, row + 1, digits, name in own))
    return found


def _gives_own(equation: VelocityEquation, equations: VelocityEquations) -> bool:
    """Return whether a coordinate stands in an equation from which its own rate follows."""
    own = {symbol(one.name) for one in equations.variant.coordinates if one.rate in equation.coefficients}
    return any(not own.isdisjoint(part.free_symbols) for part in equation.parts)


def _zero(value: Callable[..., float], states: Array) -> float | None:
    """Return at which share of the way between two `states` (time, then position) a value is zero; None if it passes a pole."""

    def at(share: float) -> float:
        return float(value(*(states[0] + share * (states[1] - states[0])).tolist()))

    ends = at(0.0), at(1.0)
    share = crossing(at, (0.0, 1.0), ends, _SETTLED)
    return share if share is not None and abs(at(share)) < min(map(abs, ends)) else None


def _divisors(used: Sequence[VelocityEquation], equations: VelocityEquations) -> list[tuple[str, Expression]]:
    """Return the names of equations, each with what it divides by and what depends on the position."""
    moving = {symbol(one.name) for one in equations.variant.coordinates}
    parts = ((one.name, part) for one in used for part in one.parts)
    every = dict.fromkeys((name, by) for name, part in parts for by in divisors(part))
    return [(name, by) for name, by in every if not moving.isdisjoint(by.free_symbols)]
