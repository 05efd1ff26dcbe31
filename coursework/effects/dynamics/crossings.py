"""Where a motion under forces goes through a change point, or ends at one: its links could go on there otherwise.

Enters: the rows of the motion, a way to it between them, the flow.  Leaves: times.  Used by `scene/motor_scene.py`.
The flow knows the rate of the free coordinate as 1, which is enough for a motion by one of them: it is the time of the flow.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.effects.dynamics.why_ended import CHANGE, LIMIT
from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.motion import Motion
from coursework.motion.singular.change_point import branches_at, nearest_change_point
from coursework.motion.singular.scaled_flow import Flow
from coursework.motion.singular.walk import MISSED
from coursework.system.arrays import Array

SINGLE = "single"  # a change point at which one motion only goes on
_SETTLED = 1e-10  # share of a step
_MOST = 4  # changes of sign of a determinant that are looked at
_TIMES = 5  # whose positions and rates give the motion a little ahead, as a polynomial
_CLOSER = (1, 8, 64, 256)  # parts of a step between those times: the change point is found to the third power of how far it is
_AGREED = 1e-9  # share of the time: two that differ by less need no closer look
_NEWTON = 6


def first_crossing(flow: Flow, rows: Motion, exact_at: Callable[[Array], Motion]) -> float | None:
    """Return the first time (s) at which a determinant changes its sign and another motion begins; None if there is none.

    Of each block the first few changes are looked at.
    """
    if _free(flow) is None:
        return None
    signs = np.sign(rows.determinants)
    found = []
    for block, changes in enumerate((signs[1:] * signs[:-1] < 0).T):
        for row in np.flatnonzero(changes)[:_MOST].tolist():
            if (crossed := _crossed(flow, rows, exact_at, block, row)) is not None and crossed[1] > 1:
                found.append(crossed[0])
                break
    return min(found, default=None)


def _crossed(
    flow: Flow, rows: Motion, exact_at: Callable[[Array], Motion], block: int, row: int
) -> tuple[float, int] | None:  # fmt: skip
    """Return when (s) the determinant of a block is zero after a row, and how many motions meet there; None if not found."""
    tried = list[float]()

    def determinant(time: float) -> float:
        tried.append(time)
        there = exact_at(np.array([time]))
        return float(there.determinants[0, block]) if len(there.t) else np.nan

    times = float(rows.t[row]), float(rows.t[row + 1])
    ends = float(rows.determinants[row, block]), float(rows.determinants[row + 1, block])
    time = crossing(determinant, times, ends, _SETTLED)
    if time is None:  # the motion was not found so close to it
        found = _reached(flow, exact_at, block, tried[-1], rows.step)
        return None if found is None else found[:2]
    return time, _count(flow, block, exact_at(np.array([time])).coordinates[0])


def ended_at(flow: Flow, rows: Motion, exact_at: Callable[[Array], Motion], about: float) -> tuple[float, str]:
    """Return when (s) rows that end near a change point, `about` a time, reach it, and how: `CHANGE`, `SINGLE` or `LIMIT`."""
    if not len(rows.t):
        return about, CHANGE
    found = _reached(flow, exact_at, int(np.argmin(np.abs(rows.scaled[-1]))), about, rows.step)
    if found is None:
        return about, CHANGE
    time, count, missed = found
    # A motion that misses it by more ends at a limit: were there a way past it, it would be followed.
    return (about, LIMIT) if missed > MISSED else (time, SINGLE if count == 1 else CHANGE)


def _free(flow: Flow) -> int | None:
    """Return the place of the free coordinate, None if others are free or driven too."""
    known = flow.equations.variant.known_rates
    return flow.equations.variant.rates.index(known[0]) if len(known) == 1 else None


def _count(flow: Flow, block: int, position: Array) -> int:
    """Return how many motions meet at a change point, 0 if that is not known."""
    return len(branches_at(flow, block, 0.0, position.tolist()) or ())


def _reached(
    flow: Flow, exact_at: Callable[[Array], Motion], block: int, about: float, step: float
) -> tuple[float, int, float] | None:  # fmt: skip
    """Return what `_crossed` does, and by what share the motion surely misses it; the motion is known before it only.

    It is `about` a time (s).  What is missed is told to the fourth power of how far it is looked for.
    """
    free, names, found, missed = _free(flow), flow.equations.variant.rates, None, 0.0
    if free is None:
        return None
    x = np.arange(1 - _TIMES, 1)
    powers = np.arange(2 * _TIMES)
    slopes = powers * x[:, None].astype(float) ** np.maximum(powers - 1, 0)
    for parts in _CLOSER:
        apart = min(step, about / (_TIMES + 1)) / parts
        before = exact_at(np.asarray(about + (x - 1) * apart))
        if len(before.t) < _TIMES:
            break
        rates = np.array([before.velocities[:, before.velocity_names.index(name)] for name in names]).T
        if not rates[-1, free]:
            break
        within = 2 * apart * float(np.abs(rates[-1] / flow.units).max())
        there = nearest_change_point(flow, 0.0, before.coordinates[-1], block, rates[-1] / rates[-1, free], within)
        if there is None:
            break
        missed = max(missed, there[2] - within**4)
        known = [before.coordinates[:, free], apart * rates[:, free]]
        way = np.polynomial.Polynomial(np.linalg.solve(np.vstack([x[:, None] ** powers, slopes]), np.concatenate(known)))
        ahead = 0.0
        for _ in range(_NEWTON):
            ahead -= float((way(ahead) - there[1][free]) / way.deriv()(ahead))
        if not 0 <= ahead <= 2:
            break
        looked, about = about, float(before.t[-1]) + ahead * apart
        found = about, there[1]
        if abs(about - looked) <= _AGREED * about:
            break
    return None if found is None else (found[0], _count(flow, block, found[1]), missed)
