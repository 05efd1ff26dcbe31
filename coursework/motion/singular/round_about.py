"""Whether a crank can be turned right round: then no law of its drive meets a dead point, however long the run.

Enters: the determinant-scaled flow of a scene, the start.  Leaves: a bool.  Used by `way_to_motion.py`.

With one drive, the positions of a mechanism follow from the crank's angle alone.  So the flow is followed with the drive frozen
at one time: the crank turns at constant speed until everything is back.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import TIME, symbol
from coursework.motion.geometry.drives.drive import drive_values
from coursework.motion.singular.event import GivenUp, NotFollowed
from coursework.motion.singular.scaled_flow import Flow
from coursework.motion.singular.search import TOLERANCE, is_back
from coursework.motion.singular.walk import Walk

_LOOKS = 64  # number of times at which the drive is evaluated to find one at which it is fast


def goes_round(flow: Flow, start: Sequence[float]) -> bool:
    """Return whether everything is back after one or two turns of the only crank, without a dead or change point on the way."""
    variant = flow.equations.variant
    angles = {coordinate.rate for coordinate in variant.coordinates if coordinate.unit == "rad"}
    if len(variant.drive) != 1 or variant.drive[0].name not in angles or not _knows_no_time(flow.equations):
        return False
    times = np.linspace(0.0, variant.time.end, _LOOKS)
    rates = np.nan_to_num(np.abs(drive_values(flow.equations, [variant.drive[0].name], times)[:, 0]), posinf=0.0)
    fast = int(np.argmax(rates))
    if not rates[fast]:
        return False
    turn = 2 * np.pi / float(rates[fast])
    walk = Walk(_held(flow, float(times[fast])), np.array([*start, 0.0]), 2 * turn, np.zeros(0), TOLERANCE)
    try:
        for goal in (turn, 2 * turn):
            if walk.at_start() or walk.until(goal) or walk.passages:
                return False
            if is_back(flow, walk.state[:-1], start):
                return True
    except (GivenUp, NotFollowed):
        pass
    return False


def _knows_no_time(equations: VelocityEquations) -> bool:
    """Return whether time occurs only in the law of the drive, and there is no table."""
    drive = {symbol(law.name) for law in equations.variant.drive}
    others = [definition for name, definition in equations.symbols.definitions.items() if name not in drive]
    written = [part for equation in equations.equations for part in equation.parts]
    return not equations.tables and not any(part.has(TIME) for part in (*others, *written))


def _held(flow: Flow, time: float) -> Flow:
    """Return the flow with the drive frozen at its value at one time (s)."""
    scalar, compiled = flow.system.scalar, flow.compile_clock

    def clock(block: int) -> Callable[..., tuple[float, ...]]:
        moving = compiled(block)
        return lambda pace, *state: moving(pace, *state[:-1], time)

    system = replace(flow.system, scalar=lambda t, *q: scalar(time, *q))
    return replace(flow, system=system, compile_clock=clock, clocks={})
