"""Friction while forces move a mechanism: its effect on the free accelerations of a state, and the sliding direction of pairs.

Enters: a `State` without friction.  Leaves: `Rubbing`; raises `Held`.  Imported for a file with [friction] only.
Used by `rubbed_motion.py`, which finds the states, and `equations_of_motion.py`, which carries it.

In a state the reactions are linear in the free accelerations, R = R0 + D a, and every pair adds its own share, R += s f G,
where the reactions determine the size f of its friction, and s is the sign of its sliding.  The drives keep the torques of the
motor, so only the sizes are unknown; they are found as a fixed point as in `friction.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

from coursework.effects.friction.held import STILL, Held
from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.order_eight import dormand_prince_8
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

ROUNDS, SETTLED = 200, 4e-16  # for a fixed point that shrinks by a third or more a round
MOST_TURNS = 4  # number of guesses for the directions of pairs at rest
LATER = 1e-5  # s; how far ahead a pair with zero speed and acceleration is examined
SHARP = 1e-14  # share of a step: accuracy of the time at which a pair reverses
STANDS = 1e-9  # share of the speeds: below it a pair is at rest at a reversal
HALVINGS = 40  # halvings of a step from rest, until a pair slides the way it began
Moving = Callable[..., list[float]]  # a state, its time last -> its derivative
Where = Callable[..., tuple[float, ...]]  # a state, its time last -> time, closed position, free rates


@frozen
class Pair:
    """A rubbing pair at a point: `kind` "pin", "wheel" or "guide", index of its first reaction, whether a couple follows it."""

    at: str
    kind: str
    place: int
    couple: bool


@frozen
class State:
    """A state without friction.

    `a` are the free accelerations, `others` the rates of the other coordinates, `loose` the reactions (k,).  A unit of a pair's
    friction adds `reactions` (pairs, k) to the reactions and `changes` (pairs, f) to `a`; `factors` are its (factor, length).
    `speeds` are the sliding speeds of the pairs, `turning` their derivatives for zero free accelerations, `by_free` (pairs, f)
    the derivatives of these by the free accelerations.
    """

    a: list[float]
    others: list[float]
    loose: list[float]
    reactions: list[list[float]]
    changes: list[list[float]]
    factors: list[tuple[float, float]]
    speeds: list[float]
    turning: list[float]
    by_free: list[list[float]]


@dataclass(slots=True)
class Rubbing:
    """The rubbing pairs; `held` are the signs of their speeds while the exact motion is computed, () if the speeds decide."""

    pairs: tuple[Pair, ...]
    state: Callable[..., State]
    held: tuple[float, ...] = ()

    @contextmanager
    def sliding_as(self, *state: float) -> Iterator[None]:
        """Keep the signs of a state (0 for pairs at rest) for all states that are evaluated inside the `with` block."""
        before = self.held
        self.held = tuple(_signs(self.state(*state).speeds))
        try:
            yield
        finally:
            self.held = before

    def slope(self, *state: float) -> tuple[float, ...]:
        """Return free accelerations, then the rates of the others, for t, coordinates and free rates.  Raises `Held`."""
        now = self.state(*state)
        return (*self.free(now, self.held or _signs(now.speeds)), *now.others)

    def free(self, now: State, signs: Sequence[float]) -> list[float]:
        """Return the free accelerations if pairs slide with these signs.  Raises `Held` if the fixed point does not converge."""
        sizes = self._settled(now, signs)
        return [a + sum(s * f * row[k] for s, f, row in zip(signs, sizes, now.changes, strict=True)) for k, a in enumerate(now.a)]

    def _settled(self, now: State, signs: Sequence[float]) -> list[float]:
        sizes, least = [0.0] * len(self.pairs), math.inf
        for count in range(ROUNDS):
            found = list(now.loose)
            for sign, size, row in zip(signs, sizes, now.reactions, strict=True):
                if sign and size:
                    found = [value + sign * size * one for value, one in zip(found, row, strict=True)]
            after = [self._size(pair, found, *given) for pair, given in zip(self.pairs, now.factors, strict=True)]
            change = max(abs(x - y) * bool(s) for x, y, s in zip(after, sizes, signs, strict=True))
            sizes = after
            if change <= SETTLED * max(after) or (count > ROUNDS // 2 and change <= 1e3 * SETTLED * max(after)):
                return sizes
            least = min(least, change)
            if not change < 1e6 * least:
                break
        raise Held(self.pairs[max(range(len(sizes)), key=lambda k: sizes[k])].at, locked=True)

    @staticmethod
    def _size(pair: Pair, found: Sequence[float], factor: float, length: float) -> float:
        first = found[pair.place]
        if pair.kind == "pin":
            return factor * math.hypot(first, found[pair.place + 1])
        if pair.couple and length:
            return factor * max(abs(first), 2 * abs(found[pair.place + 1]) / length)
        return factor * abs(first)

    def signs(self, *state: float, still: Sequence[bool] = ()) -> tuple[float, ...]:
        """Return the sign of each pair's sliding; for pairs at rest (`still`) their accelerations decide.  Raises `Held`."""
        now = self.state(*state)
        rest = list(still) or [not v for v in now.speeds]
        signs = [0.0 if here else math.copysign(1.0, v) for v, here in zip(now.speeds, rest, strict=True)]
        for _ in range(MOST_TURNS):
            begun = self._beginning(now, self.free(now, signs), rest)
            if begun == signs:
                return tuple(signs)
            if any(here and x * y < 0 for x, y, here in zip(begun, signs, rest, strict=True)):
                break  # with the friction for one direction it would slide in the other: it does not slide
            signs = begun
        raise Held(next(pair.at for pair, here in zip(self.pairs, rest, strict=True) if here), locked=False)

    def _beginning(self, now: State, a: Sequence[float], rest: Sequence[bool]) -> list[float]:
        """Return the signs of the speeds; for pairs at rest, of the speeds they start with."""
        found = []
        for v, change, slopes, here in zip(now.speeds, now.turning, now.by_free, rest, strict=True):
            parts = [change, *(c * x for c, x in zip(slopes, a, strict=True))]
            way = sum(parts) if here else v
            none = here and abs(way) <= STILL * max(map(abs, parts))  # both bodies turn alike: no sliding at all
            found.append(0.0 if none else math.copysign(1.0, way))
        return found

    def begin(self, moving: Moving, where: Where, state: Array, still: Sequence[bool] = ()) -> None:
        """Hold the signs with which every pair goes on, including those at rest (`still`).  Raises `Held`."""
        try:
            self._begin(moving, where, state, still)
        except Held as error:
            self.held, error.state = (), tuple(state.tolist())
            raise error.seen(error.state[-1]) from None

    def _begin(self, moving: Moving, where: Where, state: Array, still: Sequence[bool]) -> None:
        signs = self.held = self.signs(*where(*state.tolist()), still=still)
        if all(signs):
            return
        # A pair with zero speed and acceleration (at rest in a dead position, or under a force that grows from 0) is examined a
        # little later: it then slides or is held.
        later, _ = dormand_prince_8(moving, state, np.array(moving(*state.tolist())), LATER)
        rates = _rates(state)
        if not (state[rates].any() or later[rates].any()):
            raise Held("", locked=False)
        found = self.signs(*where(*later.tolist()), still=[not sign for sign in signs])
        self.held = tuple(sign or other for sign, other in zip(signs, found, strict=True))

    def goes_on(self, where: Where, *state: float) -> bool:
        """Return whether pairs at rest in a state start to slide, by more than the round-off of the driving forces."""
        found = where(*state)
        try:
            signs = self.signs(*found)
            now = self.state(*found)
            begins = [abs(a) > STILL * abs(ideal) for a, ideal in zip(self.free(now, signs), now.a, strict=True)]
        except Held:
            return False
        return any(signs) and any(begins)

    def loose(self, where: Where, rest: Sequence[float], times: Sequence[float]) -> float | None:
        """Return when (s) a mechanism at rest from the first of the `times` on starts to slide; None if not by the last."""
        held = times[0]
        for time in times[1:]:
            if self.goes_on(where, *rest, time):
                while held < (middle := (held + time) / 2) < time:
                    held, time = (held, middle) if self.goes_on(where, *rest, middle) else (middle, time)
                return time
            held = time
        return None

    def speeds(self, where: Where, state: Array) -> list[float]:
        """Return the sliding speeds of the pairs in a state."""
        return self.state(*where(*state.tolist())).speeds

    def turned(self, moving: Moving, where: Where, begin: tuple[Array, Array], taken: float, after: Array) -> tuple[float, Array]:
        """Return length and end of a step from a state and its slope; it is cut, and restarted, where the first pair reverses."""
        (state, slope), ends = begin, {}

        def left(length: float) -> float:
            end = after if length == taken else dormand_prince_8(moving, state, slope, length)[0]
            ends[length] = end, self.speeds(where, end)
            return self._least(ends[length][1])

        at_end = left(taken)
        if at_end >= 0:
            return taken, after
        sizes = [abs(v) for v in ends[taken][1]]
        low, at_low = 0.0, max(self._least(self.speeds(where, state)), 0.0)
        if not at_low:  # it begins at rest: it turns round where it comes to rest again
            low, at_low = next(((x, v) for k in range(1, HALVINGS) if (v := left(x := taken / 2**k)) > 0), (low, at_low))
        length = crossing(left, (low, taken), (at_low, at_end), SHARP) or 0.0
        if length not in ends:
            left(length)
        (end, found), rates = ends[length], _rates(state)
        end[rates] *= np.abs(end[rates]) > STANDS * np.max(np.abs(state[rates]))
        self.begin(moving, where, end, [abs(v) <= STANDS * max(size, *sizes) for v, size in zip(found, sizes, strict=True)])
        return length, end

    def _least(self, speeds: Sequence[float]) -> float:
        """Return the least speed in the assumed direction of sliding; it is negative if a pair slides the other way."""
        return min((sign * v for sign, v in zip(self.held, speeds, strict=True) if sign), default=0.0)

    def taken(self, count: int, *rows: Array) -> Array:
        """Return what friction adds to the `count` free accelerations (f, n), for t, coordinates and free rates, each (n,)."""
        states = [self.state(*map(float, row)) for row in zip(*rows, strict=True)]
        speeds = np.array([one.speeds for one in states]).reshape(len(states), len(self.pairs))
        signs = np.where(np.abs(speeds) > STILL * np.abs(speeds).max(axis=0, initial=0.0), np.sign(speeds), 0.0)
        found = np.zeros((count, len(states)))
        for row, (now, way) in enumerate(zip(states, signs.tolist(), strict=True)):
            try:
                way = way if any(way) or count > 1 else self.signs(*(float(one[row]) for one in rows))
                found[:, row] = np.array(self.free(now, way)) - np.array(now.a)
            except Held as error:
                found[:, row] = np.nan if error.locked else -np.array(now.a)  # it is at rest and stays at rest
        return found


def _rates(state: Array) -> slice:
    """Return the slice of the free rates in a state: after the free coordinates, before the time."""
    return slice((len(state) - 1) // 2, -1)


def _signs(speeds: Sequence[float]) -> list[float]:
    return [math.copysign(1.0, v) if v else 0.0 for v in speeds]
