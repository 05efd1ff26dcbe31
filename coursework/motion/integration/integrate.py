"""The march of the coursework: row by row with one scheme, every determinant watched.

Enters: rates, a scheme, a step.  Leaves: a `Motion`; rows end before a dead point.  t = i*step, never a running sum.
Used by the scene and the accuracy study.  The rows come from a loop generated from the tableau; where it ends early, or a
correction is asked for, the same steps are made one by one, which tells why a motion ends.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.loops import generate_rows
from coursework.motion.integration.motion import Motion, Stop, rows_before
from coursework.motion.integration.passage import Passage
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import Scheme, scheme_of
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import whole_steps
from coursework.words.errors import InputError
from coursework.words.sentences import say

Row = tuple[float, ...]  # coordinates, velocities, determinants
# One step that turns a link whose angle stands in a determinant by more than this (rad) can cross a dead point unseen.
WIDEST_STEP = 1.0
# A coordinate (rad or m) beyond this is none of a mechanism: the rows of a step that is too large grow from row to row.
OUTGROWN = 1e9
# The kind of a stop that the scheme makes and the mechanism does not.
TOO_LARGE = "step too large"


@frozen
class Correction:
    """What keeps the positions closed: `newton` corrections a step, or Baumgarte's `gain` (1/s); none by default."""

    closure: Closure | None = None
    newton: int = 0
    gain: float = 0.0


def refuse_gain(gain: float, step: float) -> None:
    """Raise `InputError` for a Baumgarte gain outside 0 < gain*step < 2: the error is multiplied by 1 - gain*step a step."""
    if not 0 < gain * step < 2:
        raise InputError(say("fault.C018", gain=gain, step=step, number=1 - gain * step, number_2=2 / step, number_3=1 / step))


def march(
    rates: Rates, scheme: str, start: Sequence[float], step: float, end: float,
    correction: Correction | None = None, stop: Stop | None = None, guarded: Sequence[int] = (),
    passages: Sequence[Passage] = (),
) -> Motion:  # fmt: skip
    """March from `start` (rad, m) at t = 0 to `end` (s).

    `stop`: where the true motion ends (rows beyond it are not computed).  `guarded`: the coordinates in determinants.
    `passages`: where a determinant may change its sign.
    The motion stops also where the scheme itself steps over a dead point or out of the numbers.
    """
    last = whole_steps(step, end)
    if stop is not None:
        last = min(last, rows_before(stop.time, step) - 1)
    times: Array = np.arange(last + 1).astype(np.float64) * step
    tableau = scheme_of(scheme)
    rows = [] if correction else _generated(rates, tableau, start, step, last, guarded)
    if len(rows) <= last:
        own = _followed(rates, tableau, start, step, times, correction, guarded, rows, passages)
        stop = stop if own is None else _first_stop(stop, own)
    size, velocities = len(rates.coordinates), len(rates.velocities)
    width = size + velocities + len(rates.blocks)
    table = np.fromiter(itertools.chain.from_iterable(rows), float, len(rows) * width).reshape(len(rows), width)
    known = table[:, size : size + velocities].copy(), table[:, size + velocities :].copy()
    evaluations = max(0, len(rows) - 1) * tableau.slopes
    return rates.motion(times[: len(rows)].copy(), table[:, :size].copy(), scheme, step, evaluations, known, stop=stop)


def _generated(rates: Rates, scheme: Scheme, start: Sequence[float], step: float, last: int, guarded: Sequence[int]) -> list[Row]:
    """Return the rows up to `last`, or up to the first one after which something is to be told."""
    rows: list[Row] = []
    with suppress(ZeroDivisionError, ValueError, OverflowError):
        generate_rows(scheme, rates, guarded, WIDEST_STEP)(0, last, step, rates.may_look_until, rows.append, *start)
    return rows


def _followed(
    rates: Rates, scheme: Scheme, start: Sequence[float], step: float, times: Array, correction: Correction | None,
    guarded: Sequence[int], rows: list[Row], passages: Sequence[Passage],
) -> Stop | None:  # fmt: skip
    """Add all further rows to those known, step by step from the last one; return why they end early."""
    size, last = len(start), len(times) - 1
    first = max(0, len(rows) - 1)
    q = np.array(rows.pop()[:size] if rows else start, dtype=float)
    targets = correction.closure.targets(times) if correction and correction.closure and last >= 0 else None
    for index, t in enumerate(times[first:].tolist(), start=first):
        try:
            row = rates.evaluate(t, *q.tolist())
        except (ZeroDivisionError, ValueError, OverflowError):
            return _broken("event.singular", index, t, step, q)
        if not all(map(math.isfinite, row)) and _has_outgrown(q):
            return _broken("event.overflow", index, t, step, q)
        if rows and (found := _crossed(rows[-1][size:], row, rates, index, t, step, q, passages)):
            return found
        rows.append((*q.tolist(), *row))
        if index == last:
            return None
        try:
            moved = scheme.step(rates.slopes((index + 1) * step), t, q, step, np.array(row[:size]))
        except (ZeroDivisionError, ValueError, OverflowError):
            return _broken("event.singular_inside", index, t, step, q)
        wide = [place for place in guarded if abs(float(moved[place] - q[place])) > WIDEST_STEP]
        if wide:
            turned = float(moved[wide[0]] - q[wide[0]])
            return _too_wide(rates.coordinates[wide[0]], turned, index, t, step, q, rates)
        if correction and targets is not None:
            moved = corrected(correction, targets, index, step, t, q, moved)
        q = moved
        if not np.isfinite(q).all():
            return _broken("event.overflow", index, t, step, q)
    return None


def _first_stop(true: Stop | None, own: Stop) -> Stop:
    """Return the stop of the true motion where there is one: the scheme's own is told behind it."""
    if true is None:
        return own
    return replace(true, meaning=say("event.both", meaning=true.meaning, cause=own.cause))


def corrected(
    correction: Correction, targets: tuple[Array, Array], index: int, step: float, t: float, q: Array, moved: Array
) -> Array:
    """Return the position (m,) that a correction makes of `moved`, which one step has made of row `index`, `q` at `t`.

    `targets`: the values kept (n, k) and the driven coordinates (n, d) of all rows.
    """
    closure = correction.closure
    assert closure is not None
    kept, known = targets
    if correction.gain:
        return np.asarray(moved + step * correction.gain * closure.linear(t, q, kept[index]))
    moved = moved.copy()
    moved[list(closure.driven)] = known[index + 1]
    for _ in range(correction.newton):
        moved = moved + closure.correction(t + step, moved, kept[index + 1])
    return moved


def _crossed(
    before: tuple[float, ...], after: tuple[float, ...], rates: Rates, index: int, t: float, step: float, q: Array,
    passages: Sequence[Passage],
) -> Stop | None:  # fmt: skip
    first = len(rates.velocities)
    # A scheme that is a little off meets the singular position a row early or late.
    passing = {passage.block for passage in passages if t - 2 * step < passage.middle.time < t + step}
    for place in range(len(rates.blocks)):
        old, new = before[first + place], after[first + place]
        if old * new <= 0 and old != 0 and rates.blocks[place] not in passing:
            between = {"row": index, "next": index + 1, "begin": t - step, "end": t}
            cause = say("event.stepped_over", **between, old=old, new=new, step=step)
            return Stop(TOO_LARGE, t, float(index), (), _named(rates, q), cause, say("event.better_scheme"))
    return None


def _too_wide(name: str, turned: float, index: int, t: float, step: float, q: Array, rates: Rates) -> Stop:
    turn = {"turned": turned, "degrees": float(np.degrees(turned)), "widest": WIDEST_STEP}
    cause = say("event.too_wide", row=index + 1, time=t, step=step, name=name, **turn)
    return Stop(TOO_LARGE, t, float(index), (), _named(rates, q), cause, say("event.smaller_step"))


def _broken(what: str, index: int, t: float, step: float, q: Array) -> Stop:
    if _has_outgrown(q):  # what then has no value has none because of the rows before
        cause = say("event.broken", row=index + 1, time=t, what=say("event.overflow"))
        return Stop(TOO_LARGE, t, float(index), (), {}, cause, say("event.smaller_step"))
    cause = say("event.broken", row=index + 1, time=t, what=say(what))
    return Stop("not finite", t, float(index), (), {}, cause, say("event.rows_kept", step=step))


def left_by_scheme(motion: Motion) -> Motion:
    """Return rows that end where the true motion goes on: the scheme with its step has left it."""
    assert motion.stop is not None
    return replace(motion, stop=replace(motion.stop, kind=TOO_LARGE, meaning=say("event.smaller_step")))


def _has_outgrown(q: Array) -> bool:
    return float(np.max(np.abs(q), initial=0.0)) > OUTGROWN


def _named(rates: Rates, q: Array) -> dict[str, float]:
    return dict(zip(rates.coordinates, q.tolist(), strict=True))
