"""Motion under forces: rows of a scheme in the free coordinates and their rates, and the motion without a scheme's error.

Enters: `EquationsOfMotion`, the start.  Leaves: `FreeMotion`.
Used by `scene/motor_scene.py`.

Each slope first closes the positions of all other coordinates (Newton), so links keep their length whatever the scheme does.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.effects.dynamics.free_motion import FreeMotion
from coursework.effects.dynamics.why_ended import Open, why_ended
from coursework.effects.friction.held import Held
from coursework.motion.integration.adaptive import next_length
from coursework.motion.integration.exact_motion import quick_times
from coursework.motion.integration.order_eight import dormand_prince_8
from coursework.motion.integration.rates import may_look_until
from coursework.motion.schemes import SEMI_IMPLICIT, Scheme, Sum
from coursework.system.arrays import Array

# Number of Newton corrections; size at which the last one is accepted (relative, or rad): it leaves an error of its square.
MOST_NEWTON, CLOSED = 12, 1e-8
FARTHEST = 1.0  # relative, or rad: a larger correction leads to another assembly
TOLERANCE = 1e-13
Take = Callable[[float, list[float]], list[float]]  # time and state of a row -> state of the next row
MOST_STEPS = 3000  # largest number of steps between two rows; only very steep forces need more
# Beside a change point of the links round-off is more than the tolerance, and shorter steps do not help: after `_TRIED` tries it
# is ten times as large.  At a limit, where free coordinates turn back and the links may go on, their rates are first `_SLOW`.
_TRIED, _SLOW = 750, 0.01  # share of the fastest
_LEAST = 1e-11  # share of the whole time: smaller steps are not taken
_ALONE = ((0, 1),)  # the first slope alone
_LOOKS = 1000  # number of times at which it is tested whether friction still holds
_RUNAWAY = 1e9  # rad or sizes of the mechanism, and that a second: larger values are treated as not finite


@dataclass(slots=True)
class Dynamics:
    """The slopes of one mechanism; `q` is the last closed position, from which the next one is found.

    `rests_until` is the time (s) until which friction holds the mechanism at rest.
    """

    motion: EquationsOfMotion
    q: list[float]
    tolerance: float = TOLERANCE
    count: int = 0
    rests_until: float = -math.inf
    _rates: list[float] = field(default_factory=list)
    _first: tuple[float, ...] = ()
    _lost: tuple[float, ...] = ()

    def closed(self, t: float, free: Sequence[float]) -> list[float]:
        """Return the closed position with these free coordinates.  Raises `Open` if there is none nearby."""
        q, motion = list(self.q), self.motion
        for place, value in zip(motion.free, free, strict=True):
            q[place] = value
        if not motion.others:
            return q
        for _ in range(MOST_NEWTON):
            step = motion.newton(t, *q, *motion.kept)
            size = 0.0
            for place, value in zip(motion.others, step, strict=True):
                q[place] += value
                size = max(size, abs(value) / motion.sizes[place])
            if size < CLOSED:
                return q
            if not size < FARTHEST:
                break
        raise Open

    def slope(self, t: float, state: Sequence[float]) -> list[float]:
        """Return the rates and accelerations of a state (free coordinates, then their rates)."""
        if not math.isfinite(sum(state)):  # between the rows of a scheme
            raise OverflowError
        count = len(self.motion.free)
        free, rates = state[:count], state[count:]
        if not self.motion.others:
            self.q = self.closed(t, free)
        elif [self.q[place] for place in self.motion.free] != list(free):
            self.q = self.closed(t, free) if not self._rates else self._followed(t, free)
        try:
            found = self.motion.slope(t, *self.q, *rates)
        except (ValueError, ZeroDivisionError):  # a root below zero, a determinant or what a force is divided by
            self._lost = (t, *self.q, *rates)
            raise ZeroDivisionError from None
        self.count += 1
        self._rates = [rates[0], *found[count:]]
        return [*rates, *found[:count]]

    def _followed(self, t: float, free: Sequence[float]) -> list[float]:
        """Return the closed position, searched from where the last slope's rates move the other coordinates."""
        moved = free[0] - self.q[self.motion.free[0]]
        share = moved / self._rates[0] if self._rates[0] else 0.0
        kept = list(self.q)
        for place, rate in zip(self.motion.others, self._rates[1:], strict=True):
            self.q[place] += share * rate
        try:
            return self.closed(t, free)
        except Open:
            self.q = kept
            return self.closed(t, free)

    def rows(self, scheme: Scheme, state: Sequence[float], step: float, steps: int) -> FreeMotion:
        """Return the rows of a scheme, up to where no position closes or a number becomes too large."""
        one = _semi_implicit if scheme is SEMI_IMPLICIT else _stepper(scheme)

        def take(t: float, now: list[float]) -> list[float]:
            if not self.motion.breaks:
                return one(self.slope, t, now, step)
            latest = may_look_until(self.motion.breaks, t + step)  # a step that ends at a break uses the formula before it
            return one(lambda at, there: self.slope(min(at, latest), there), t, now, step)

        return self._march(state, step, steps, take)

    def exact(self, state: Sequence[float], step: float, steps: int) -> FreeMotion:
        """Return the rows of the exact motion: Dormand and Prince 8(5,3) to 1e-13, each row at the end of a step."""
        length, whole = [step], step * max(steps, 1)
        try:
            return self._march(state, step, steps, lambda t, now: self._through(t, now, t + step, length, whole))
        finally:
            self._let_go()

    def between(self, rows: FreeMotion, times: Array) -> FreeMotion:
        """Return the exact motion at times (n,) s, each followed from the last of its `rows` before it, as far as it goes."""
        count, found = len(self.motion.free), [np.zeros((0, rows.coordinates.shape[1] + rows.rates.shape[1]))]
        for time in times.tolist():
            row = max(int(np.searchsorted(rows.t, time, "right")) - 1, 0)
            begin, self.q, self._rates, self.rests_until = float(rows.t[row]), rows.coordinates[row].tolist(), [], -math.inf
            now = [*(self.q[place] for place in self.motion.free), *rows.rates[row].tolist()]
            self._first = (float(rows.t[0]), *rows.coordinates[0].tolist(), *rows.rates[0].tolist())
            try:
                if time > begin:
                    now = self._through(begin, now, time, [time - begin], time)
                    self.q = self._followed(time, now[:count]) if self._rates else self.closed(time, now[:count])
            except (Open, Held, ZeroDivisionError, OverflowError):
                break
            finally:
                self._let_go()
            found.append(np.array([[*self.q, *now[count:]]]))
        both = np.concatenate(found)
        return FreeMotion(times[: len(both)], both[:, :-count], both[:, -count:], rows.slopes)

    def _let_go(self) -> None:
        if self.motion.rubbing is not None:
            self.motion.rubbing.held = ()

    def _through(self, t: float, now: list[float], goal: float, length: list[float], whole: float) -> list[float]:
        """Return the state at time `goal`; no step goes over a time at which a force changes its formula or is quick."""
        breaks, acting = self.motion.breaks, self.motion.acting
        quick = quick_times(acting, t, goal) if acting is not None else ()
        inside = {*[one for one in breaks if t < one < goal], *quick}
        for begin, end in itertools.pairwise([t, *sorted(inside), goal]):
            now = self._over(begin, now, min(end, may_look_until(breaks, end)), length, whole)
        return now

    def _over(self, t: float, now: list[float], goal: float, length: list[float], whole: float) -> list[float]:
        """Return the state at time `goal`; a mechanism held by friction rests until the forces that vary with time release it."""
        rubbing, acting = self.motion.rubbing, self.motion.acting
        while goal > self.rests_until:
            try:
                return self._to(max(t, self.rests_until), now, goal, length, whole)
            except Held as error:
                if rubbing is None or acting is None or error.locked or (error.at and len(self.motion.free) > 1):
                    raise
                at, count = error.time, len(self.motion.free)
                now = [*error.state[:count], *[0.0] * count]
                later = np.unique(
                    [at, *np.linspace(at, whole, _LOOKS if len(acting) > 2 else 2), *acting[:: len(acting) // _LOOKS + 1]]
                )
                loose = rubbing.loose(self._where, now, later[later >= at].tolist())
                if (loose is None and error.at) or loose == at:
                    raise
                self.rests_until, length[0] = math.inf if loose is None else loose, goal - t
        return now

    def _to(self, t: float, now: list[float], goal: float, length: list[float], whole: float) -> list[float]:
        def moving(*state: float) -> list[float]:
            return [*self.slope(state[-1], state[:-1]), 1.0]

        at, state, rubbing = t, np.array([*now, t]), self.motion.rubbing
        if rubbing is not None and not rubbing.held:
            rubbing.begin(moving, self._where, state)
        begin, tries = (list(self.q), list(self._rates)), 0
        passed, rates = list[tuple[float, ...]](), slice(len(self.motion.free), -1)
        sizes = np.array(self.motion.sizes_of_state)
        while goal - at > _LEAST * whole:
            taken, tries = min(length[0], goal - at), tries + 1
            if tries > MOST_STEPS:
                self.q, self._rates = begin
                raise why_ended(self.motion, at, [self._first, *passed])
            kept, why = (list(self.q), list(self._rates)), None
            try:
                slope = np.array(moving(*state.tolist()))
                passed.append((at, *self.q, *state[rates].tolist()))
                after, error = dormand_prince_8(moving, state, slope, taken)
                most = self._allowed(tries, [self._first, passed[0], passed[-1]]) * (
                    sizes + np.maximum(np.abs(state[:-1]), np.abs(slope[:-1] * taken))
                )
                ratio = float(np.max(np.abs(np.array(error[:-1])) / most))
            except (Open, Held, ZeroDivisionError, OverflowError) as stopped:
                ratio, why = math.inf, stopped
            if ratio <= 1.0:
                if rubbing is not None:
                    taken, after = rubbing.turned(moving, self._where, (state, slope), taken, after)
                at, state, self._lost = at + taken, after, ()
                if taken == length[0] or ratio > 0:
                    length[0] = max(length[0], taken) if taken < length[0] else next_length(taken, ratio, 8)
                continue
            self.q, self._rates = kept
            length[0] = next_length(taken, ratio, 8) if math.isfinite(ratio) else taken / 4
            if length[0] < _LEAST * whole:
                self.q, self._rates = begin
                if isinstance(why, Held):
                    raise why.seen(at)
                raise why_ended(self.motion, at, [self._first, *passed])
        return [float(value) for value in state[:-1]]

    def _allowed(self, tries: int, some: Sequence[tuple[float, ...]]) -> float:
        """Return the largest error of a step (share) after so many tries since the last row; the last of `some` states is now."""
        if tries < _TRIED or not self.motion.others:
            return self.tolerance
        rates = np.abs(np.array(some)[:, -len(self.motion.free) :]).max(axis=1)
        return max(self.tolerance, TOLERANCE * 10.0 ** (tries // _TRIED)) if rates[-1] > _SLOW * rates.max() else self.tolerance

    def _where(self, *state: float) -> tuple[float, ...]:
        """Return time, closed position and free rates from a state that has its time at the end."""
        self.slope(state[-1], state[:-1])
        return (state[-1], *self.q, *state[len(self.motion.free) : -1])

    def _march(self, state: Sequence[float], step: float, steps: int, take: Take) -> FreeMotion:
        count, now, self.count, self._lost = len(self.motion.free), list(state), 0, ()
        positions, rates, ended, at, by, most = [], [], "", 0.0, "", _RUNAWAY * max(1.0, *self.motion.sizes_of_state)
        for row in range(steps + 1):
            t = row * step
            try:
                if not row or [self.q[place] for place in self.motion.free] != now[:count]:
                    self.q = self._followed(t, now[:count]) if self._rates else self.closed(t, now[:count])
                positions.append(list(self.q))
                rates.append(now[count:])
                if not row:
                    self._first = (t, *self.q, *now[count:])
                if row < steps:
                    now = take(t, now)
                if not (math.isfinite(sum(now)) and max(now) < most and min(now) > -most):
                    raise OverflowError
            except (Open, ZeroDivisionError) as error:
                ended = error.kind if isinstance(error, Open) else "dead point" if self.motion.others else "too steep"
                at = t if math.isnan(found := getattr(error, "at", math.nan)) else found
                break
            except Held as error:
                ended, at, by = "locked" if error.locked else "held", t if math.isnan(error.time) else error.time, error.at
                break
            except OverflowError:
                ended, at = "not finite", t + step
                break
        q, v = np.array(positions).reshape(len(positions), -1), np.array(rates).reshape(len(rates), count)
        times = np.arange(len(q)).astype(np.float64) * step
        return FreeMotion(times, q, v, self.count, ended, at, by, self._lost if ended else ())


def _stepper(scheme: Scheme) -> Callable[..., list[float]]:
    """Return a function that makes one step of a tableau on a list of numbers."""

    def take(f: Callable[[float, Sequence[float]], list[float]], t: float, now: list[float], h: float) -> list[float]:
        found: list[list[float]] = []
        for node, row in zip(scheme.nodes, scheme.inner, strict=True):
            at = now if not row.terms else _added(row, now, h, found)
            found.append(f(t + float(node) * h if node else t, at))
        return _added(scheme.outer, now, h, found)

    return take


def _added(row: Sum, now: list[float], h: float, found: list[list[float]]) -> list[float]:
    """Return a state moved by one row of a tableau."""
    factor = float(row.factor) * h
    if row.terms == _ALONE:
        return [value + factor * slope for value, slope in zip(now, found[0], strict=True)]
    return [value + factor * sum(whole * found[place][k] for place, whole in row.terms) for k, value in enumerate(now)]


def _semi_implicit(f: Callable[[float, Sequence[float]], list[float]], t: float, now: list[float], h: float) -> list[float]:
    """Return the next state: first the rates, v + h a(q, v, t), then the coordinates with the new rates, q + h v."""
    count = len(now) // 2
    slope = f(t, now)
    rates = [value + h * a for value, a in zip(now[count:], slope[count:], strict=True)]
    return [*(q + h * v for q, v in zip(now[:count], rates, strict=True)), *rates]
