"""An embedded pair with step size control: Dormand and Prince 5(4).  For twelve digits use `order_eight.py`.

Enters: a vector field of time and position.  Leaves: the states at given times.  Used by `singular` and the accuracy study.
Source: J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math. 6 (1980).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache

import numpy as np

from coursework.equations.codegen.programs import Bound, build
from coursework.system.arrays import Array

Field = Callable[..., Sequence[float]]

_NODES = (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0)
_ROWS: tuple[dict[int, float], ...] = (
    {},
    {0: 1 / 5},
    {0: 3 / 40, 1: 9 / 40},
    {0: 44 / 45, 1: -56 / 15, 2: 32 / 9},
    {0: 19372 / 6561, 1: -25360 / 2187, 2: 64448 / 6561, 3: -212 / 729},
    {0: 9017 / 3168, 1: -355 / 33, 2: 46732 / 5247, 3: 49 / 176, 4: -5103 / 18656},
    {0: 35 / 384, 2: 500 / 1113, 3: 125 / 192, 4: -2187 / 6784, 5: 11 / 84},
)
_ERROR = {0: 71 / 57600, 2: -71 / 16695, 3: 71 / 1920, 4: -17253 / 339200, 5: 22 / 525, 6: -1 / 40}
SLOPES = 6  # new slopes in each step: its last slope is the first of the next step


@cache
def _written_out(size: int) -> Callable[..., tuple[list[float], list[float], list[float]]]:
    """Return a function of (field, at, length, *state, *slope) that gives the state after a step, its error and its slope."""
    parts = range(size)
    lines = [f"def step(field, at, length, {listed('y', parts)}, {listed('k0_', parts)}):"]
    for stage, (node, row) in enumerate(zip(_NODES[1:], _ROWS[1:], strict=True), start=1):
        lines += [f"    p{part} = y{part} + length * ({weighed(row, part)})" for part in parts]
        lines.append(f"    {listed(f'k{stage}_', parts)}, *_ = field(at + {node!r} * length, {listed('p', parts)})")
    error = ", ".join(f"length * ({weighed(_ERROR, part)})" for part in parts)
    lines.append(f"    return [{listed('p', parts)}], [{error}], [{listed('k6_', parts)}]")
    return build("\n".join(lines), "step", Bound((), {}, {}))


def listed(name: str, parts: Sequence[int]) -> str:
    """Return names for the parts of a state, separated by commas."""
    return ", ".join(f"{name}{part}" for part in parts)


def weighed(weights: Mapping[int, float], part: int) -> str:
    """Return the formula for the weighted sum of the slopes in one part of the state."""
    return " + ".join(f"{weight!r} * k{stage}_{part}" for stage, weight in weights.items())


def next_length(length: float, ratio: float, order: int = 5) -> float:
    """Return the next step length from the ratio error/tolerance of the last step, for a pair of order `order`."""
    return float(length * min(4.0, max(0.2, 0.85 * max(ratio, 1e-10) ** (-1 / order))))


def integrate_adaptive(
    field: Field, state: Array, times: Array, tolerance: float, sizes: Sequence[float] = ()
) -> tuple[Array, int]:
    """Return the states at `times` (n, m) and the number of slopes; each time is the end of a step, without interpolation.

    `field(t, *state)` gives the slopes (m,); further values after them are ignored.  `sizes` (m,) are what counts as 1 of each
    part of the state, else 1.  Raises `ArithmeticError` if the state grows beyond all bounds.
    """
    goals, now = times.tolist(), state.tolist()
    step, (*slope,) = _written_out(len(now)), field(goals[0], *now)[: len(now)]
    count, units = 1, sizes or [1.0] * len(now)
    at, length = goals[0], (goals[-1] - goals[0]) / 100
    rows = [now]
    for goal in goals[1:]:
        while at < goal:
            last = at + length >= goal * (1 - 1e-14)
            taken = goal - at if last else length
            after, error, following = step(field, at, taken, *now, *slope)
            count += SLOPES
            shares = [abs(off) / (tolerance * (one + abs(y))) for off, y, one in zip(error, now, units, strict=True)]
            ratio = math.inf if math.isnan(sum(shares)) else max(shares)
            if ratio <= 1.0:
                at, now, slope = (goal if last else at + taken), after, following
            if not last or ratio > 1.0:
                length = next_length(taken, ratio)
            if at + length == at:
                raise ArithmeticError
        rows.append(now)
    return np.array(rows), count
