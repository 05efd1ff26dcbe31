"""Where a motion under forces goes through a change point, or ends at one: its links could go on there otherwise.

Enters: the rows of the motion, a way to it between them, the flow.  Leaves: times.  Used by `scene/motor_scene.py`.
The flow knows the rate of the free coordinate as 1, which is enough for a motion by one of them: it is the time of the flow.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.motion import Motion
from coursework.motion.singular.change_point import branches_at, nearest_change_point
from coursework.motion.singular.scaled_flow import Flow
from coursework.system.arrays import Array

SINGLE = "single"  # a change point at which one motion only goes on
_SETTLED = 1e-10  # share of a step
_ROWS = 5  # whose positions and rates give the motion up to a step ahead, as a polynomial: to 1e-10 of it
_NEWTON = 6


def first_crossing(flow: Flow, rows: Motion, exact_at: Callable[[Array], Motion]) -> float | None:
    """Return the first time (s) at which a determinant changes its sign and another motion begins; None if there is none.

    Of each block the first change is looked at.
    """
    if _free(flow) is None:
        return None
    signs = np.sign(rows.determinants)
    found = []
    for block, changes in enumerate((signs[1:] * signs[:-1] < 0).T):
        if not changes.any():
            continue
        row = int(np.argmax(changes))

        def determinant(time: float, block: int = block) -> float:
            there = exact_at(np.array([time]))
            return float(there.determinants[0, block]) if len(there.t) else np.nan

        times = float(rows.t[row]), float(rows.t[row + 1])
        ends = float(rows.determinants[row, block]), float(rows.determinants[row + 1, block])
        if (time := crossing(determinant, times, ends, _SETTLED)) is not None:
            position = exact_at(np.array([time])).coordinates[0]
            if len(branches_at(flow, block, 0.0, position.tolist()) or ()) > 1:
                found.append(time)
    return min(found, default=None)


def _free(flow: Flow) -> int | None:
    """Return the place of the free coordinate, None if others are free or driven too."""
    known = flow.equations.variant.known_rates
    return flow.equations.variant.rates.index(known[0]) if len(known) == 1 else None


def crossing_ahead(flow: Flow, rows: Motion) -> tuple[float, int] | None:
    """Return when (s) rows that end before a change point reach it, and how many motions meet there; None if it is not found."""
    free, names = _free(flow), flow.equations.variant.rates
    if free is None or len(rows.t) < _ROWS:
        return None
    rates = np.array([rows.velocities[-1, rows.velocity_names.index(name)] for name in names])
    block, step = int(np.argmin(np.abs(rows.scaled[-1]))), rows.step
    if not rates[free]:
        return None
    found = nearest_change_point(
        flow, 0.0, rows.coordinates[-1], block, rates / rates[free], 2 * step * float(np.abs(rates).max())
    )
    if found is None:
        return None
    x = np.arange(1 - _ROWS, 1)
    powers = np.arange(2 * _ROWS)
    slopes = powers * x[:, None].astype(float) ** np.maximum(powers - 1, 0)
    known = [rows.coordinates[-_ROWS:, free], step * rows.velocities[-_ROWS:, rows.velocity_names.index(names[free])]]
    way = np.polynomial.Polynomial(np.linalg.solve(np.vstack([x[:, None] ** powers, slopes]), np.concatenate(known)))
    ahead = 0.0
    for _ in range(_NEWTON):
        ahead -= float((way(ahead) - found[1][free]) / way.deriv()(ahead))
    if not 0 <= ahead <= 1:
        return None
    return float(rows.t[-1]) + ahead * step, len(branches_at(flow, block, 0.0, found[1].tolist()) or ())
