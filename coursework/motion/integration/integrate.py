"""The march of the coursework: row by row with one scheme, watching every determinant.

Enters: rates, a scheme, a step.  Leaves: a `Motion`; rows end before a dead point.  t = i*step, never a running sum.
Used by the scene and the accuracy study.  The rows come from a loop generated from the tableau.  If the loop ends early, or if a
correction is asked for, the same steps are made one by one, which shows why a motion ends.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.loops import generate_rows
from coursework.motion.integration.motion import Motion, Stop, rows_before
from coursework.motion.integration.passage import Passage
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import Scheme
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import whole_steps
from coursework.words.errors import InputError
from coursework.words.sentences import say

Numbers = tuple[float, ...]  # one row: coordinates, velocities, determinants
# A step that turns a link by more than this (rad) can cross a dead point unseen, if the link's angle occurs in a determinant.
WIDEST_STEP = 1.0
# No mechanism has a coordinate beyond this (rad or m): rows made with too large a step grow from row to row.
OUTGROWN = 1e9
# The kind of a stop caused by the scheme, not by the mechanism.
TOO_LARGE = "step too large"


@frozen
class Correction:
    """The correction that keeps the positions closed: `newton` corrections a step, or Baumgarte's `gain` (1/s)."""

    closure: Closure
    newton: int
    gain: float = 0.0

    def corrected(self, targets: tuple[Array, Array], row: Row, step: float, moved: Array) -> Array:
        """Return the corrected position (m,) from `moved`, the result of one step from `row`.

        `targets` are the target values (n, k) and the driven coordinates (n, d) of all rows.
        """
        kept, known = targets
        if self.gain:
            return np.asarray(moved + step * self.gain * self.closure.linear(row.t, row.q, kept[row.index]))
        moved = moved.copy()
        moved[list(self.closure.driven)] = known[row.index + 1]
        for _ in range(self.newton):
            moved = moved + self.closure.correction(row.t + step, moved, kept[row.index + 1])
        return moved


def refuse_gain(gain: float, step: float) -> None:
    """Raise `InputError` for a Baumgarte gain outside 0 < gain*step < 2; each step multiplies the error by 1 - gain*step."""
    if not 0 < gain * step < 2:
        raise InputError(say("fault.C018", gain=gain, step=step, number=1 - gain * step, number_2=2 / step, number_3=1 / step))


@frozen
class Row:
    """The state of a march: the coordinates `q` (m,) of row `index`, counted from 0, at `t` (s)."""

    index: int
    t: float
    q: Array

    def broken(self, what: str, step: float) -> Stop:
        """Return the stop of a row that is not finite; `what` is the reason."""
        if self.has_outgrown:  # then the values fail because of the rows before
            return self._stop(TOO_LARGE, {}, self._cause(say("event.overflow")), say("event.smaller_step"))
        return self._stop("not finite", {}, self._cause(what), say("event.rows_kept", step=step))

    def stepped_over(self, rates: Rates, old: float, new: float, step: float) -> Stop:
        """Return the stop of a row before which a determinant has changed its sign."""
        between = {"row": self.index, "next": self.index + 1, "begin": self.t - step, "end": self.t}
        cause = say("event.stepped_over", **between, old=old, new=new, step=step)
        return self._stop(TOO_LARGE, self._named(rates), cause, say("event.better_scheme"))

    def too_wide(self, rates: Rates, place: int, turned: float, step: float) -> Stop:
        """Return the stop of a row whose step turns a guarded coordinate by `turned` (rad), too far to watch the determinant."""
        turn = {"turned": turned, "degrees": float(np.degrees(turned)), "widest": WIDEST_STEP}
        cause = say("event.too_wide", row=self.index + 1, time=self.t, step=step, name=rates.coordinates[place], **turn)
        return self._stop(TOO_LARGE, self._named(rates), cause, say("event.smaller_step"))

    def led_out(self, law: str) -> Stop:
        """Return the stop of a row whose step leads out of the table of a law."""
        return self._stop(TOO_LARGE, {}, self._cause(say("event.outside", name=law)), say("event.more_nodes"))

    @property
    def has_outgrown(self) -> bool:
        """Return whether a coordinate is too large for any mechanism."""
        return float(np.max(np.abs(self.q), initial=0.0)) > OUTGROWN

    def _cause(self, what: str) -> str:
        return say("event.broken", row=self.index + 1, time=self.t, what=what)

    def _named(self, rates: Rates) -> dict[str, float]:
        return dict(zip(rates.coordinates, self.q.tolist(), strict=True))

    def _stop(self, kind: str, named: dict[str, float], cause: str, meaning: str) -> Stop:
        return Stop(kind, self.t, float(self.index), (), named, cause, meaning)


@frozen
class March:
    """How rows are made: `rates`, a `scheme`, its `step` (s), and a correction of each position if asked for.

    `guarded` are the indices of coordinates that occur in determinants, `passages` the places where a determinant may change
    sign.  If the true motion `goes_on` to the end, it is the scheme that leaves a table.
    """

    rates: Rates
    scheme: Scheme
    step: float
    correction: Correction | None = None
    guarded: Sequence[int] = ()
    passages: Sequence[Passage] = ()
    goes_on: bool = False

    def until(self, start: Sequence[float], end: float, stop: Stop | None = None) -> Motion:
        """Return the rows from `start` (rad, m) at t = 0 to `end` (s), or to the `stop` of the true motion.

        The rows also end where the scheme itself steps over a dead point or overflows.
        """
        rates, step, last = self.rates, self.step, whole_steps(self.step, end)
        if stop is not None:
            last = min(last, rows_before(stop.time, step) - 1)
        times: Array = np.arange(last + 1).astype(np.float64) * step
        # Generated rows know no limits: a slope just at a passage would be another than when the row is made again.
        before = min((rows_before(passage.middle.time, step) - 1 for passage in self.passages), default=last)
        rows = [] if self.correction else self._generated(start, min(last, max(0, before)))
        if len(rows) <= last:
            own = self._followed(start, times, rows)
            stop = stop if own is None else _first_stop(stop, own)
        size, velocities = len(rates.coordinates), len(rates.velocities)
        width = size + velocities + len(rates.blocks)
        table = np.fromiter(itertools.chain.from_iterable(rows), float, len(rows) * width).reshape(len(rows), width)
        known = table[:, size : size + velocities].copy(), table[:, size + velocities :].copy()
        evaluations = max(0, len(rows) - 1) * self.scheme.slopes
        name = self.scheme.name
        return rates.motion(times[: len(rows)].copy(), table[:, :size].copy(), name, step, evaluations, known, stop=stop)

    def _generated(self, start: Sequence[float], last: int) -> list[Numbers]:
        """Return the rows up to `last`, or up to the first row after which something must be reported."""
        rows: list[Numbers] = []
        with suppress(ZeroDivisionError, ValueError, OverflowError, OutsideTable):
            made = generate_rows(self.scheme, self.rates, self.guarded, WIDEST_STEP)
            made(0, last, self.step, self.rates.may_look_until, rows.append, *start)
        return rows

    def _followed(self, start: Sequence[float], times: Array, rows: list[Numbers]) -> Stop | None:
        """Add all further rows to `rows`, step by step from the last one; return why they end early, None if they do not."""
        rates, step, size, last = self.rates, self.step, len(start), len(times) - 1
        first = max(0, len(rows) - 1)
        q = np.array(rows.pop()[:size] if rows else start, dtype=float)
        correction = self.correction
        targets = correction.closure.targets(times) if correction and last >= 0 else None
        for index, t in enumerate(times[first:].tolist(), start=first):
            here = Row(index, t, q)
            try:
                values = rates.evaluate(t, *q.tolist())
            except (ArithmeticError, ValueError) as error:
                return here.broken(say(_broken_by(error)), step)
            except OutsideTable as left:
                return self._left(here, left)
            if not all(map(math.isfinite, values)) and here.has_outgrown:
                return here.broken(say("event.overflow"), step)
            if rows and (found := self._crossed(rows[-1][size:], values, here)):
                return found
            rows.append((*q.tolist(), *values))
            if index == last:
                return None
            try:
                moved = self.scheme.step(rates.slopes((index + 1) * step), t, q, step, np.array(values[:size]))
            except (ArithmeticError, ValueError) as error:
                return here.broken(say("event.inside", what=say(_broken_by(error))), step)
            except OutsideTable as left:
                return self._left(here, left)
            for place in self.guarded:
                if abs(turned := float(moved[place] - q[place])) > WIDEST_STEP:
                    return here.too_wide(rates, place, turned, step)
            q = correction.corrected(targets, here, step, moved) if correction and targets is not None else moved
            if not np.isfinite(q).all():
                return Row(index, t, q).broken(say("event.overflow"), step)
        return None

    def _left(self, here: Row, table: OutsideTable) -> Stop:
        """Return the stop of a row whose step leads out of a table; raise its fault if the true motion may leave it as well."""
        if not self.goes_on:
            raise table
        return here.led_out(table.name)

    def _crossed(self, before: Numbers, after: Numbers, here: Row) -> Stop | None:
        """Return the stop if a determinant has changed its sign between two rows outside a passage; None if none has."""
        first, step = len(self.rates.velocities), self.step
        # A slightly inaccurate scheme meets the singular position a row early or late.
        passing = {passage.block for passage in self.passages if here.t - 2 * step < passage.middle.time < here.t + step}
        for block, old, new in zip(self.rates.blocks, before[first:], after[first:], strict=True):
            if old * new <= 0 and old != 0 and block not in passing:
                return here.stepped_over(self.rates, old, new, step)
        return None


def _broken_by(error: Exception) -> str:
    """Return the key of the reason why a row has no velocities."""
    outgrown = "event.overflow" if isinstance(error, OverflowError) else "event.undefined"
    return "event.singular" if isinstance(error, ZeroDivisionError) else outgrown


def _first_stop(true: Stop | None, own: Stop) -> Stop:
    """Return the stop of the true motion, with the scheme's own added to its meaning; the scheme's own if there is no other."""
    if true is None:
        return own
    return replace(true, meaning=say("event.both", meaning=true.meaning, cause=own.cause))


def left_by_scheme(motion: Motion) -> Motion:
    """Return the motion with its stop marked as too large a step: the true motion goes on, but the scheme has left it."""
    assert motion.stop is not None
    return replace(motion, stop=replace(motion.stop, kind=TOO_LARGE, meaning=say("event.smaller_step")))
