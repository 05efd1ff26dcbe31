"""Drawn data -> which mechanisms can be given to a student, and how difficult each is; many sets at once.

Enters: a template compiled once, sets of data, limits.  Leaves: a `Verdict` for each set.  Used by `accept.py`.

The vectorised search proves for most sets that they can move; every other set is searched alone, as `coursework.feasible` does,
so that no verdict depends on the other sets in the array.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import field, replace

import numpy as np

from coursework.assigning.ranges import Limits
from coursework.equations.reduction.magnitude import largest
from coursework.grading.marking.decimals import gap_of
from coursework.many import feasible
from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE, SCHEMES
from coursework.motion.singular.scaled_flow import compile_flow
from coursework.motion.singular.search import search_event
from coursework.scene.model.data import Data
from coursework.scene.model.model import Model
from coursework.scene.model.one_set import with_numbers
from coursework.scene.model.rows import rows_of
from coursework.scene.model.sets import prepare
from coursework.scene.model.start import left_open, start_of
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen
from coursework.system.grouped import grouped
from coursework.variant.record.variant import MAX_ROWS, Variant
from coursework.words.errors import CourseworkError

# The exact motion is computed in at least PARTS parts of a step and FEWEST of the whole: Runge-Kutta 4 is then right to 1e-8
# where Euler is off by 0.1, and the smallest determinant found is right to a thousandth.
PARTS, FEWEST = 8, 400
_LATEST = 1 + 1e-9  # times the horizon: later rows are left out


@frozen
class Verdict:
    """`refused` is the key of the reason, "" if the data may be given out; `numbers` are the measures of difficulty (SI)."""

    refused: str
    numbers: Mapping[str, float] = field(default_factory=dict)


def judge(model: Model, data: Data, limits: Limits) -> list[Verdict]:
    """Return the verdict on each set of data."""
    variants = [with_numbers(model.variant, data, index) for index in range(data.count)]
    verdicts = [_refused_at_sight(model.variant, data, index, variants[index]) for index in range(data.count)]
    times = [(variant.time.step, variant.time.end) for variant in variants]
    groups = grouped((times[index], index) for index, verdict in enumerate(verdicts) if not verdict.refused)
    for members in groups.values():
        judged = _judge_alike(model, data.part(members), [variants[index] for index in members], limits)
        for index, verdict in zip(members, judged, strict=True):
            verdicts[index] = verdict
    return verdicts


def _refused_at_sight(template: Variant, data: Data, index: int, variant: Variant) -> Verdict:
    """Return a refusal of data that need no computing: those of the template itself, and times that make no table."""
    names = [name for name in data.changed if name in data.given]
    starts = zip(template.coordinates, data.start[index].tolist(), strict=True)
    same = all(variant.values[name] == template.values[name] for name in names)
    if same and all(c.start_or_guess == start for c, start in starts if c.name in data.changed):
        return Verdict("same")
    step, end = variant.time.step, variant.time.end
    sound = step > 0 and math.isfinite(end) and step * (1 - 1e-9) <= end <= MAX_ROWS * step
    return Verdict("" if sound else "refused")


def _judge_alike(model: Model, data: Data, variants: list[Variant], limits: Limits) -> list[Verdict]:
    """Return the verdicts on sets of data whose rows have the same times."""
    time = variants[0].time
    horizons = np.array([one.time.whole for one in variants])
    prepared = prepare(model, data, float(np.max(horizons)))
    movable = _movable(model, data, prepared.sure, horizons)
    drawn_start = not {*data.changed}.isdisjoint(model.coordinates)
    opened = left_open(model, prepared.begin, prepared.numbers) if drawn_start else np.zeros(data.count, dtype=bool)
    rows, runs = rows_of(model, prepared, SCHEMES[DEFAULT_SCHEME.name], np.arange(time.steps + 1).astype(np.float64) * time.step)
    runs &= prepared.frequency * time.step < np.pi * (1 - 1e-12)
    parts = max(PARTS, -(-FEWEST // max(1, time.steps)))
    fine_step = time.step / parts
    count = math.ceil(float(np.max(horizons)) / fine_step * (1 - 1e-9))
    fine: Array = np.arange(max(count, time.steps * parts) + 1).astype(np.float64) * fine_step
    exact, followed = rows_of(model, prepared, PRECISE, fine)
    numbers = _measured(model, data, variants, rows, exact, fine, horizons)
    verdicts = []
    for index in range(data.count):
        mine = {name: float(column[index]) for name, column in numbers.items()}
        refused = "open" if opened[index] else "" if movable[index] else "motion"
        refused = refused or ("" if runs[index] and followed[index] else "stepped_over")
        verdicts.append(Verdict(refused or _beyond(limits, mine, time.step), mine))
    return verdicts


def _beyond(limits: Limits, numbers: Mapping[str, float], step: float) -> str:
    """Return the name of the first limit that a mechanism exceeds, "" if it keeps all."""
    least, fastest = numbers["least_determinant"], numbers["largest_velocity"]
    if limits.least_determinant is not None and not least >= limits.least_determinant:
        return "least_determinant"
    if limits.least_transmission is not None and not math.asin(min(1.0, least)) >= limits.least_transmission:
        return "least_transmission"
    if limits.largest_velocity is not None and not fastest <= limits.largest_velocity:
        return "largest_velocity"
    if limits.least_rows_a_turn is not None and not 2 * math.pi >= limits.least_rows_a_turn * fastest * step:
        return "least_rows_a_turn"
    return ""


def _movable(model: Model, data: Data, sure: Flags, horizons: Array) -> Flags:
    """Return for which sets (n,) the whole motion is possible; sets that are not sure are searched one by one."""
    movable = sure.copy()
    places = np.flatnonzero(~sure)
    if not len(places):
        return movable
    with np.errstate(all="ignore"):
        start = start_of(model, data, model.numbers(data))
    clear = ~start.doubtful & (not model.own_breaks(data.changed))
    for place in places.tolist():
        if clear[place] and _stops(model, data, place, start.closed[:, place].tolist(), float(horizons[place])):
            continue
        with suppress(CourseworkError):
            movable[place] = feasible(model.variant.with_data(*data.of(place, model.variant)))[0]
    return movable


def _stops(model: Model, data: Data, place: int, start: list[float], end: float) -> bool:
    """Return whether the motion of one set surely stops, by the search alone, without a message."""
    variant = model.variant.with_values({one.name: float(data.given[one.name][place]) for one in model.variant.given})
    try:
        flow = compile_flow(replace(model.equations, variant=variant), model.reduction, start)
        return search_event(flow, start, end, breaks=model.breaks).event is not None
    except (CourseworkError, ArithmeticError, ValueError):
        return False


def _measured(
    model: Model, data: Data, variants: list[Variant], rows: Array, exact: Array, fine: Array, horizons: Array
) -> dict[str, Array]:
    """Return the measures of difficulty (n,) by name; nan where a motion could not be followed."""
    m, h = len(model.coordinates), variants[0].time.step
    numbers = model.numbers(data, 1)
    t = np.arange(rows.shape[1]) * h
    angular = [m + place for place, name in enumerate(model.velocities) if model.variant.unit_of(name) == "rad/s"]
    with np.errstate(all="ignore"):
        gap = np.max(np.abs(rows[:, :, :m] - exact[:, :: round(h / float(fine[1])), :m][:, : len(t)]), axis=(1, 2))
        fastest = np.max(np.abs(rows[:, :, angular]), axis=(1, 2), initial=0.0)
        slopes = rows[:, :-1, m : 2 * m]
        ahead = model.rates(t[1:], rows[:, :-1, :m] + h * slopes, data)[..., :m]
        step_gap = gap_of(slopes, ahead, h, np.ptp(rows[:, :, :m], axis=1))
        values = model.program(fine, *np.moveaxis(exact[:, :, :m], -1, 0), *numbers)[len(model.velocities) :]
        shape = exact.shape[:2]
        sizes = np.abs(np.array([np.broadcast_to(value, shape) for value in values])).reshape(-1, *shape)
        least = np.min(np.where(fine <= horizons[:, None] * _LATEST, sizes, np.inf), axis=2)
    scaled = least / _scales(model, variants, data) if len(model.blocks) else np.ones((1, data.count))
    return {
        "euler_error": gap, "least_determinant": np.min(scaled, axis=0), "largest_velocity": fastest, "one_step_gap": step_gap,
    }  # fmt: skip


def _scales(model: Model, variants: list[Variant], data: Data) -> Array:
    """Return the largest value (blocks, n) that each determinant can take, by which it is scaled as in `Motion.scaled`."""
    bounds = [[largest(b.determinant, one) if b.determinant else 0.0 for b in model.blocks] for one in variants]
    for place, row in enumerate(bounds):
        if not all(row):
            start = [0.0 if math.isnan(value) else value for value in data.start[place].tolist()]
            bounds[place] = [*compile_flow(replace(model.equations, variant=variants[place]), model.reduction, start).largest]
    return np.array(bounds).T
