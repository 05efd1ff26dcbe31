"""The way from a variant to its motion, one function a quantity: the first half of the graph.

The name of a function is the quantity, its parameters are what it needs.  Enters: a `Variant` and `Settings`.
Leaves: what `quantities.py` judges, derives and shows.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.errors import InputError
from coursework.geometry.agreement import require_agreement
from coursework.geometry.chain import chain_positions, is_chain, start_values
from coursework.geometry.closure import Closure, compile_closure, require_start
from coursework.geometry.drive import breaks, refuse_aliasing, refuse_endless
from coursework.integration.exact_motion import NotReached, exact_motion
from coursework.integration.integrate import Correction, march
from coursework.integration.motion import Motion, Stop, rows_before
from coursework.integration.rates import Rates, compile_rates
from coursework.mechanism import Mechanism, build
from coursework.reduction.blocks import Reduction, reduce
from coursework.reduction.equations import VelocityEquations, differentiate
from coursework.reduction.symbolic import symbol
from coursework.sentences import say
from coursework.settings import Settings
from coursework.singular.explain import explain
from coursework.singular.scaled_flow import Flow, compile_flow
from coursework.singular.search import Event, NotFollowed, find_event
from coursework.variant.record import Variant, whole_steps

Array = NDArray[np.float64]
# A periodic motion that lasts for many periods is looked at for dead points over the first two.
PERIODS_LOOKED_AT = 2.2


def mechanism(variant: Variant) -> Mechanism:
    """Points in order, chains written out, mobility."""
    return build(variant)


def equations(mechanism: Mechanism) -> VelocityEquations:
    """The velocity equations A(q, t) u = b(q, t)."""
    return differentiate(mechanism)


def start(equations: VelocityEquations) -> list[float]:
    """The coordinates at t = 0 (rad, m)."""
    return start_values(equations)


def closure(equations: VelocityEquations, start: list[float]) -> Closure | None:
    """The position equations, if the file has any; checked against start and written equations."""
    found = compile_closure(equations, start)
    require_start(found)
    require_agreement(equations, found)
    return found


def reduction(equations: VelocityEquations, start: list[float]) -> Reduction:
    """The blocks, their solutions and determinants."""
    return reduce(equations, start)


def rates(equations: VelocityEquations, reduction: Reduction, settings: Settings) -> Rates:
    """The right-hand side as a plain function, for the columns asked for."""
    return compile_rates(equations, reduction, settings.columns or None)


def flow(equations: VelocityEquations, reduction: Reduction, start: list[float]) -> Flow:
    """The determinant-scaled flow that finds dead points."""
    return compile_flow(equations, reduction, start)


def event(
    flow: Flow, equations: VelocityEquations, start: list[float], closure: Closure | None, variant: Variant
) -> Event | None:
    """The first dead or change point of the true motion, which starts closed also where the file's start is rounded."""
    time = variant.time
    horizon = time.end
    if time.period is not None and time.end > PERIODS_LOOKED_AT * time.period:
        horizon = PERIODS_LOOKED_AT * time.period
    closed = closure.newton(0.0, closure.start, closure.origin) if closure is not None and closure.complete else None
    try:
        return find_event(flow, start if closed is None else closed.tolist(), horizon, breaks=breaks(variant))
    except NotFollowed as error:
        refuse_endless(equations, error.time)
        raise


def stop(event: Event | None, equations: VelocityEquations, reduction: Reduction, flow: Flow, variant: Variant) -> Stop | None:
    """The event in words: where the motion ends and why."""
    if event is None:
        return None
    from coursework.singular.change_point import branches_at

    found = branches_at(flow, event.block, event.time, event.position.tolist()) if event.kind == "change point" else ()
    return explain(event, equations, reduction, variant.time.step, found)


def phases(event: Event | None, equations: VelocityEquations, reduction: Reduction, start: list[float]) -> str:
    """For a motion that stops: the phases of the drive with which the whole motion would be possible, in a sentence."""
    if event is None:
        return ""
    from coursework.singular.phases import phase_sentence

    return phase_sentence(equations, reduction, start)


def motion(
    variant: Variant, equations: VelocityEquations, rates: Rates, reduction: Reduction, flow: Flow, start: list[float],
    settings: Settings, closure: Closure | None, stop: Stop | None,
) -> Motion:  # fmt: skip
    """The rows of the coursework."""
    refuse_aliasing(equations, variant.time.step)
    return _march(variant.time.step, variant, equations, rates, reduction, flow, start, settings, closure, stop)


def _march(
    step: float, variant: Variant, equations: VelocityEquations, rates: Rates, reduction: Reduction, flow: Flow,
    start: list[float], settings: Settings, closure: Closure | None, stop: Stop | None,
) -> Motion:  # fmt: skip
    correction = None
    if settings.project or settings.gain:
        if closure is None or not closure.complete:
            raise InputError("the projection needs position equations for every coordinate: add [closure] to the variant.")
        if settings.columns:
            raise InputError("the projection needs every coordinate; ask for the whole table.")
        correction = Correction(closure, settings.project, settings.gain)
    names = [c.name for c in variant.coordinates]
    begin = [value for name, value in zip(names, start, strict=True) if name in rates.coordinates]
    free = {symbol(c.name) for c in variant.coordinates if c.rate not in variant.known_rates and c.unit == "rad"}
    inside = {s for i in rates.blocks for row in reduction.blocks[i].matrix for entry in row for s in entry.free_symbols}
    guarded = [place for place, name in enumerate(rates.coordinates) if symbol(name) in free & inside]
    rows = march(rates, settings.scheme, begin, step, variant.time.end, correction, stop, guarded)
    return replace(rows, scaled=_scaled(rows, rates, flow))


def _scaled(rows: Motion, rates: Rates, flow: Flow) -> Array:
    """Return the dimensionless determinants of the rows (n, blocks evaluated)."""
    return np.asarray(rows.determinants / np.array([flow.largest[index] for index in rates.blocks]))


def half(
    variant: Variant, equations: VelocityEquations, rates: Rates, reduction: Reduction, flow: Flow, start: list[float],
    settings: Settings, closure: Closure | None, stop: Stop | None, motion: Motion,
) -> Motion | None:  # fmt: skip
    """The same run with half the step: what the scheme's own error is estimated from."""
    if len(motion.t) < 2 or (motion.stop is not None and motion.stop is not stop):
        return None
    return _march(variant.time.step / 2, variant, equations, rates, reduction, flow, start, settings, closure, stop)


def exact(
    variant: Variant,
    equations: VelocityEquations,
    reduction: Reduction,
    rates: Rates,
    settings: Settings,
    start: list[float],
    closure: Closure | None,
    stop: Stop | None,
) -> Motion:
    """The motion without a scheme's error, on the same rows."""
    time = variant.time
    last = whole_steps(time.step, time.end)
    if stop is not None:
        last = min(last, rows_before(stop.time, time.step) - 1)
    times: Array = np.arange(last + 1).astype(np.float64) * time.step
    every = compile_rates(equations, reduction) if settings.columns else rates
    if last < 0:
        return _nothing(every)
    positions = (lambda at: chain_positions(equations, at)) if is_chain(variant) else None
    try:
        return exact_motion(equations, every, closure, start, times, len(reduction.blocks), positions)
    except NotReached:
        return exact_motion(equations, every, None, start, times, len(reduction.blocks))


def _nothing(every: Rates) -> Motion:
    empty = np.zeros((0, 0))
    return Motion(
        np.zeros(0), np.zeros((0, len(every.coordinates))), np.zeros((0, len(every.velocities))), empty, empty.copy(),
        every.coordinates, every.velocities, "exact", 0.0, 0, label=say("exact.nothing"),
    )  # fmt: skip


def wide(
    motion: Motion, rates: Rates, reduction: Reduction, settings: Settings, start: list[float], variant: Variant
) -> Array | None:
    """The same rows in extended numbers: what round-off did to them.  None where that cannot be had."""
    from coursework.integration.extended_precision import has_extended, march_in

    small = len(motion.t) <= 2001 and all(block.size <= 2 for block in reduction.blocks)
    if not (small and has_extended()) or motion.stop is not None or settings.project or settings.gain:
        return None
    names = [c.name for c in variant.coordinates]
    begin = [value for name, value in zip(names, start, strict=True) if name in rates.coordinates]
    found: Array = march_in(np.longdouble, rates, settings.scheme, begin, motion.step, len(motion.t) - 1)
    return found
