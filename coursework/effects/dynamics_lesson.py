"""What a step costs when forces move a mechanism: schemes beside each other, error of the rates against slopes, energy gained.

Enters: equations of motion, the start, the exact rows.  Leaves: `Row`s.
Used by `report/sections/dynamics.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.effects.dynamics import Dynamics, FreeMotion
from coursework.effects.equations_of_motion import EquationsOfMotion
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import COMPARED, title_of
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Time

PARTS = (1, 4, 16)  # of the step
MOST_SLOPES = 20_000  # altogether: a quarter of a second


@frozen
class Row:
    """A scheme with so many `slopes`: its largest `error` of a free rate, and the energy (J) it has more than the motion."""

    title: str
    slopes: int
    error: float
    gained: float


def lesson(equations: EquationsOfMotion, begin: tuple[Sequence[float], Sequence[float]], time: Time, exact: Motion) -> list[Row]:
    """Return the rows; `begin` are all coordinates and the free state at t = 0.  None for a long table."""
    steps = len(exact.t) - 1
    if steps < 1 or steps * sum(PARTS) * sum(one.slopes for one in COMPARED) > 12 * MOST_SLOPES:
        return []
    places, state = begin
    count = len(equations.free)
    true = [exact.column(exact.velocity_names[place]) for place in equations.free]
    energy = _energy(equations, exact.t, exact.coordinates, np.column_stack(true))
    found = []
    for scheme in COMPARED:
        for parts in PARTS:
            if steps * parts * scheme.slopes > MOST_SLOPES:
                continue
            made: FreeMotion = Dynamics(equations, list(places)).rows(scheme, state, time.step / parts, steps * parts)
            rows = slice(None, None, parts)
            if made.ended or len(made.t) <= steps * parts:
                found.append(Row(title_of(scheme), made.slopes, float("inf"), float("inf")))
                continue
            error = max(float(np.abs(made.rates[rows, k] - true[k]).max()) for k in range(count))
            own = _energy(equations, made.t[rows], made.coordinates[rows], made.rates[rows])
            found.append(Row(title_of(scheme), made.slopes, error, float(own[-1] - energy[-1])))
    return found


def _energy(equations: EquationsOfMotion, t: Array, q: Array, v: Array) -> Array:
    found = equations.table(t, *q.T, *v.T)
    last = len(found) - equations.determinants
    return np.asarray(np.broadcast_to(found[last - 2] + found[last - 1], t.shape))
