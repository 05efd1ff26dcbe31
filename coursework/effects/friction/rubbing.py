"""Friction while forces move a mechanism: what it takes from the free accelerations of a state, and which way pairs go.

Enters: a `State` without friction.  Leaves: `Rubbing`; raises `Held`.  Imported for a file with [friction] only.
Used by `rubbed_motion.py`, which finds the states, and `equations_of_motion.py`, which carries it.

At a state the reactions are straight in the free accelerations, R = R0 + D a, and every pair adds its own share, R += s f G,
with the size f of its friction, which the reactions give, and the sign s of its sliding.  The drives keep what the motor
gives, so sizes alone are looked for, in a fixed point as in `friction.py`.
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

ROUNDS, SETTLED = 200, 4e-16  # of a fixed point that shrinks by a third or more a round
MOST_TURNS = 4  # guesses which way pairs go that stand still
LATER = 1e-5  # s
SHARP = 1e-14  # of a step: so well is known where a pair turns round
STANDS = 1e-9  # of the speeds: a pair stands there
HALVINGS = 40  # of a step from rest, until a pair slides the way that it began
Moving = Callable[..., list[float]]  # a state, its time last -> how it changes
Where = Callable[..., tuple[float, ...]]  # the same -> time, closed position, free rates


@frozen
class Pair:
    """What rubs at a point: `kind` "pin", "wheel" or "guide", the place of its first reaction, whether a couple follows it."""

    at: str
    kind: str
    place: int
    couple: bool


@frozen
class State:
    """A state without friction: free accelerations `a`, rates of the others, reactions `loose` (k,), what a unit of each pair's
    friction adds to reactions (pairs, k) and to `a` (pairs, f); speeds of the pairs, their derivatives for `a` and by it (f,).
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
    """The pairs that rub; `held` the signs of their speeds while the motion itself is looked for, () where speeds tell."""

    pairs: tuple[Pair, ...]
    state: Callable[..., State]
    held: tuple[float, ...] = ()

    @contextmanager
    def sliding_as(self, *state: float) -> Iterator[None]:
        """Keep the signs of a state, what stands still there included, whatever is asked of states near it."""
        before = self.held
        self.held = tuple(_signs(self.state(*state).speeds))
        try:
            yield
        finally:
            self.held = before

    def slope(self, *state: float) -> tuple[float, ...]:
        """Return free accelerations, then the rates of the others, of t, coordinates and free rates.  Raises `Held`."""
        now = self.state(*state)
        return (*self.free(now, self.held or _signs(now.speeds)), *now.others)

    def free(self, now: State, signs: Sequence[float]) -> list[float]:
        """Return the free accelerations where pairs slide with these signs.  Raises `Held` where nothing settles."""
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
        """Return which way each pair goes, those that stand `still` as their accelerations tell.  Raises `Held`."""
        now = self.state(*state)
        rest = list(still) or [not v for v in now.speeds]
        signs = [0.0 if here else math.copysign(1.0, v) for v, here in zip(now.speeds, rest, strict=True)]
        for _ in range(MOST_TURNS):
            begun = self._beginning(now, self.free(now, signs), rest)
            if begun == signs:
                return tuple(signs)
            if any(here and x * y < 0 for x, y, here in zip(begun, signs, rest, strict=True)):
                break  # what would slide one way slides the other way with the friction of that
            signs = begun
        raise Held(next(pair.at for pair, here in zip(self.pairs, rest, strict=True) if here), locked=False)

    def _beginning(self, now: State, a: Sequence[float], rest: Sequence[bool]) -> list[float]:
        """Return the signs of the speeds, of pairs at rest those of what they begin with."""
        found = []
        for v, change, slopes, here in zip(now.speeds, now.turning, now.by_free, rest, strict=True):
            parts = [change, *(c * x for c, x in zip(slopes, a, strict=True))]
            way = sum(parts) if here else v
            none = here and abs(way) <= STILL * max(map(abs, parts))  # turned by both alike: it does not slide at all
            found.append(0.0 if none else math.copysign(1.0, way))
        return found

    def begin(self, moving: Moving, where: Where, state: Array, still: Sequence[bool] = ()) -> None:
        """Hold the signs with which every pair goes on, those that stand `still` too.  Raises `Held`."""
        try:
            self._begin(moving, where, state, still)
        except Held as error:
            self.held, error.state = (), tuple(state.tolist())
            raise error.seen(error.state[-1]) from None

    def _begin(self, moving: Moving, where: Where, state: Array, still: Sequence[bool]) -> None:
        signs = self.held = self.signs(*where(*state.tolist()), still=still)
        if all(signs):
            return
        # A pair whose speed and acceleration both are 0, as in a dead position from rest or under a force that grows from 0, is
        # seen to go a little later, or to be held there.
        later, _ = dormand_prince_8(moving, state, np.array(moving(*state.tolist())), LATER)
        rates = _rates(state)
        if not (state[rates].any() or later[rates].any()):
            raise Held("", locked=False)
        found = self.signs(*where(*later.tolist()), still=[not sign for sign in signs])
        self.held = tuple(sign or other for sign, other in zip(signs, found, strict=True))

    def goes_on(self, where: Where, *state: float) -> bool:
        """Return whether what stands still in a state begins to slide, by more than round-off leaves of what drives it."""
        found = where(*state)
        try:
            signs = self.signs(*found)
            now = self.state(*found)
            begins = [abs(a) > STILL * abs(ideal) for a, ideal in zip(self.free(now, signs), now.a, strict=True)]
        except Held:
            return False
        return any(signs) and any(begins)

    def loose(self, where: Where, rest: Sequence[float], times: Sequence[float]) -> float | None:
        """Return when (s) what rests from the first of the times on begins to slide, None where it does not by the last."""
        held = times[0]
        for time in times[1:]:
            if self.goes_on(where, *rest, time):
                while held < (middle := (held + time) / 2) < time:
                    held, time = (held, middle) if self.goes_on(where, *rest, middle) else (middle, time)
                return time
            held = time
        return None

    def speeds(self, where: Where, state: Array) -> list[float]:
        """Return how fast the pairs slide in a state."""
        return self.state(*where(*state.tolist())).speeds

    def turned(self, moving: Moving, where: Where, begin: tuple[Array, Array], taken: float, after: Array) -> tuple[float, Array]:
        """Return a step from a state and its slope, as far as the first pair that turns round in it: there it begins anew."""
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
        """Return the least speed in the sense in which a pair is held to slide, below 0 where one goes the other way."""
        return min((sign * v for sign, v in zip(self.held, speeds, strict=True) if sign), default=0.0)

    def taken(self, count: int, *rows: Array) -> Array:
        """Return what friction adds to the `count` free accelerations (f, n) of t, coordinates and free rates, each (n,)."""
        states = [self.state(*map(float, row)) for row in zip(*rows, strict=True)]
        speeds = np.array([one.speeds for one in states]).reshape(len(states), len(self.pairs))
        signs = np.where(np.abs(speeds) > STILL * np.abs(speeds).max(axis=0, initial=0.0), np.sign(speeds), 0.0)
        found = np.zeros((count, len(states)))
        for row, (now, way) in enumerate(zip(states, signs.tolist(), strict=True)):
            try:
                way = way if any(way) or count > 1 else self.signs(*(float(one[row]) for one in rows))
                found[:, row] = np.array(self.free(now, way)) - np.array(now.a)
            except Held as error:
                found[:, row] = np.nan if error.locked else -np.array(now.a)  # it stands, and goes on standing
        return found


def _rates(state: Array) -> slice:
    """Return where the free rates stand in a state: behind the free coordinates, before the time."""
    return slice((len(state) - 1) // 2, -1)


def _signs(speeds: Sequence[float]) -> list[float]:
    return [math.copysign(1.0, v) if v else 0.0 for v in speeds]
