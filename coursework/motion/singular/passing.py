"""Whether a motion goes on through a change point: whether there is only one, and the flow on both sides.

Enters: the flow, an event, the way that led to it.  Leaves: a `Passage`, or None if the motion ends there.
Used by `walk.py`.

The flow comes to rest where a determinant and the demand of the drive vanish together, so it cannot be followed through.  If only
one set of velocities is possible there, the motion has a second derivative too: a jump of `_JUMP` past the point errs by its
third power, and the error in the singular block decays after it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.geometry.closure import compile_closure
from coursework.motion.integration.adaptive import integrate_adaptive
from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.passage import FLANKS, Passage, State
from coursework.motion.singular.change_point import branches_at
from coursework.motion.singular.event import Event
from coursework.motion.singular.scaled_flow import Flow
from coursework.system.arrays import Array

# The determinant at the inner flanks, and where the walk goes on from a simple and a double zero, relative to its largest value.
_FLANK, _JUMP = 1e-2, (1e-6, 1e-8)
# A determinant that changes by less than this share of its largest value in the whole run shows no change of sign.
_FLAT = 1e-3
# The determinant at a flank must agree with its slope within this factor; else another singular position is near.
_STRAIGHT = 2.0
_SMALLEST = 1e-5
_NUDGE = 1e-6
_TOLERANCE = 1e-13
# Positions of a closure better conditioned than this are its only ones nearby; shares of the run within which an event is sought.
_REGULAR, _ASTRAY = 1e6, (1e-4, 1e-3, 1e-2)


def passage_at(flow: Flow, event: Event, way: Sequence[Array], end: float, within: tuple[float, float]) -> Passage | None:
    """Return the passage through a change point, None if two motions meet or the continuation is unknown.

    `way` holds the states (position, then t) of the walk up to the event; `end` (s) is that of the run; `within` are the times
    (s) between which the drive keeps its formula.
    """
    if event.kind != "change point" or len(event.together) > 1:
        return None
    event = _by_closure(flow, event, end)
    branches = branches_at(flow, event.block, event.time, event.position.tolist(), end) or ()
    if len(branches) != 1 or set(branches[0]) != set(flow.system.unknowns):
        return None
    middle = _state(flow, event.time, event.position, branches[0], event.block)
    moving = np.array([middle.velocities[name] for name in flow.equations.variant.rates])
    order, growth = _growth(flow, event, moving, end)
    if not order:
        return None
    flank = (_FLANK / abs(growth)) ** (1 / order)
    while flank > _SMALLEST * end:
        try:
            if found := _flanked(flow, middle, moving, way, flank, (order, growth), event.block, within):
                return found
        except (ArithmeticError, ValueError, OutsideTable):
            pass
        flank /= 4
    return None


def _by_closure(flow: Flow, event: Event, end: float) -> Event:
    """Return the event where position equations place it, if they leave no choice there; else as it is.

    Where a factor of a whole equation vanishes, the equation is solvable at any time and so does not tell when.
    """
    closure = compile_closure(flow.equations, flow.begin)
    if closure is None or not closure.complete:
        return event
    guess = event.position.copy()

    def position_at(time: float) -> Array | None:
        kept, known = (each[-1] for each in closure.targets(np.array([0.0, time])))
        guess[list(closure.driven)] = known
        return closure.newton(time, guess, kept)

    def determinant(time: float) -> float:
        found = position_at(time)
        return math.nan if found is None else flow.scaled(time, found.tolist())[event.block]

    slopes = closure.residual(event.time, guess, closure.origin)[1]
    sizes = np.abs(slopes).max(axis=1, keepdims=True, initial=0.0)
    if not (np.isfinite(slopes).all() and sizes.all()) or np.linalg.cond(slopes / sizes) > _REGULAR:
        return event
    for share in _ASTRAY:
        times = max(event.time - share * end, 0.0), min(event.time + share * end, end)
        ends = determinant(times[0]), determinant(times[1])
        if ends[0] * ends[1] < 0 and (time := crossing(determinant, times, ends, _TOLERANCE)) is not None:
            found = position_at(time)
            return event if found is None else replace(event, time=time, position=found)
    return event


def _growth(flow: Flow, event: Event, moving: Array, end: float) -> tuple[int, float]:
    """Return the order n and c where the determinant is c (t - t0)^n along the only motion; order 0 if it is flat.

    A factor that stands twice in an equation makes a double zero.
    """
    for order, share in ((1, _NUDGE), (2, _NUDGE**0.5)):
        nudge = share * end
        after, before = (
            flow.scaled(event.time + side * nudge, (event.position + side * nudge * moving).tolist())[event.block]
            for side in (1, -1)
        )
        growth = (after - (-1) ** (order + 1) * before) / 2 / nudge**order
        if abs(growth) * end**order >= _FLAT:
            return order, growth
    return 0, 0.0


def _flanked(
    flow: Flow, middle: State, moving: Array, way: Sequence[Array], flank: float, growth: tuple[int, float], block: int,
    within: tuple[float, float],
) -> Passage | None:  # fmt: skip
    """Return the passage with the given distance of flanks (s), None if the motion there is not that of one zero."""
    times = [middle.time + part * flank for part in FLANKS]
    begun = next((state for state in reversed(way) if within[0] <= state[-1] <= times[0]), None)
    if begun is None or times[-1] > within[1]:
        return None

    def field(t: float, *q: float) -> list[float]:
        *motion, clock = flow.slopes(t, q, block)
        return [float(rate / clock) for rate in np.array(motion)]

    before = integrate_adaptive(field, begun[:-1], np.array([begun[-1], *times[:2]]), _TOLERANCE)[0][1:]
    # The change of velocities since the inner flank gives the second derivative (the error is cubic in the jump).
    bent = (moving - np.array(field(times[1], *before[1].tolist()))) / flank
    order, factor = growth
    jump = (_JUMP[order - 1] / abs(factor)) ** (1 / order)
    beyond = middle.position + jump * moving + jump**2 / 2 * bent
    after = integrate_adaptive(field, beyond, np.array([middle.time + jump, *times[2:]]), _TOLERANCE)[0][1:]
    positions = [*before, *after]
    found = np.array([flow.scaled(t, q.tolist()) for t, q in zip(times, positions, strict=True)])
    straight = found[:, block] / ((np.array(FLANKS) * flank) ** order * factor)
    others = np.delete(np.sign(found), block, axis=1)
    if np.any(others != others[0]) or not np.all((straight > 1 / _STRAIGHT) & (straight < _STRAIGHT)):
        return None
    flanks = tuple(_state(flow, t, q) for t, q in zip(times, positions, strict=True))
    if any(state.velocities.keys() != middle.velocities.keys() for state in flanks):  # a flank is singular itself
        return None
    return Passage(block, middle, flanks, flank, flow.equations.variant.rates, order)


def _state(flow: Flow, t: float, q: Array, known: dict[str, float] | None = None, block: int = 0) -> State:
    """Return a state with all velocities: the `known` ones if given, else from blocks that are not singular."""
    found = dict(known or {})
    if known is None:
        every = zip(flow.system.unknowns, flow.velocities(t, q.tolist(), -1, ()), strict=True)
        found = {name: value for name, value in every if value is not None}
    driven = flow.part(t, q.tolist(), block)[2].tolist()
    driven_rates = zip(flow.rates, flow.equations.variant.rates, driven, strict=True)
    given = {name: value for (is_driven, _), name, value in driven_rates if is_driven}
    return State(t, q, found | given)
