"""The positions of a closure at many times: Newton's method on all rows at once, and single steps where that is uncertain.

Enters: a `Closure`, the `Rates` of the same mechanism, times growing from 0.  Leaves: closed positions (n, m).
Used by `exact_motion.py` and the accuracy study.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.loops import generate_rows
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import PRECISE
from coursework.system.arrays import Array

# A closed position further than this (rad or m) from its guess may belong to another assembly.
FAR = 0.05
# Rows guessed at once: the guess drifts from row to row, and a failure wastes no more than these.
MOST_AT_ONCE = 1024
_MOST_HALVINGS = 30
# Largest number of parts of one row: a dead point takes about 60, a wrong motion would take any number.
_MOST_PARTS = 1000
# Largest number of parts of all rows together (some three seconds).
_MOST_ALTOGETHER = 20_000
_SUBSTEPS = 4


class NotReached(Exception):
    """The closure could not be followed beyond a certain time."""

    def __init__(self, time: float) -> None:
        super().__init__(f"the position could not be followed beyond t = {time:.9g} s")


def follow_closure(closure: Closure, rates: Rates, times: Array, spent: Callable[[int], object] | None = None) -> Array:
    """Return the positions (n, m) at equally spaced `times`, each closed to round-off.

    The assembly is kept by a guess along the motion for each row and by the signs of the determinants, which change only at a
    dead point.  If a row remains in doubt, its interval is followed by itself and halved until there is no doubt.  `spent` is
    called with the number of slopes of each guess.  Raises `NotReached` if the mechanism cannot follow.
    """
    kept, known = closure.targets(times)
    first = closure.newton(0.0, _placed(closure.start, closure, known[0]), kept[0])
    if first is None:
        raise NotReached(0.0)
    positions = np.empty((len(times), len(first)))
    positions[0] = first
    follower = _Follower(closure, rates, _signs(rates, first))
    row, at_once = 0, MOST_AT_ONCE
    while row < len(times) - 1:
        guess = follower.guess(row, min(row + at_once, len(times) - 1), times, positions[row])
        if spent:
            spent(PRECISE.slopes * len(guess))
        rows = slice(row + 1, row + 1 + len(guess))
        certain = follower.certain(times[rows], _placed(guess, closure, known[rows]), kept[rows])
        positions[row + 1 : row + 1 + len(certain)] = certain
        row += len(certain)
        at_once = min(2 * at_once, MOST_AT_ONCE)
        if len(certain) < len(guess) or not len(guess):
            begin, end = times[row : row + 2].tolist()
            found = follower.single(begin, end, positions[row], kept[row + 1], known[row + 1])
            if found is None:
                raise NotReached(end)
            positions[row + 1] = found
            row, at_once = row + 1, max(1, len(certain))
    return positions


class _Follower:
    """Follows one assembly of a closure, given by the `signs` of its determinants."""

    def __init__(self, closure: Closure, rates: Rates, signs: Array) -> None:
        self.closure, self.rates, self.signs = closure, rates, signs
        self.march = generate_rows(PRECISE, rates, (), 0.0)
        self.parts = 0

    def guess(self, row: int, last: int, times: Array, q: Array) -> Array:
        """Return the rows that the precise scheme makes from position q of `row` on, up to `last` or until it fails."""
        rows: list[tuple[float, ...]] = []
        with suppress(ArithmeticError, ValueError, OutsideTable):
            self.march(row, last, float(times[1]), self.rates.may_look_until, rows.append, *q.tolist())
        return np.array([found[: len(q)] for found in rows[1:]]).reshape(-1, len(q))

    def certain(self, times: Array, guess: Array, targets: Array) -> Array:
        """Return the closed positions of the rows before the first doubtful one."""
        with suppress(np.linalg.LinAlgError, OutsideTable), np.errstate(all="ignore"):
            found, is_closed = self.closure.newton_rows(times, guess, targets)
            _, determinants = self.rates.table(times, found)
            doubtful = ~is_closed | np.any(np.sign(determinants) != self.signs, axis=1)
            doubtful |= ~(np.max(np.abs(found - guess), axis=1, initial=0.0) < FAR)
            return np.asarray(found[: int(np.argmax(doubtful)) if np.any(doubtful) else len(found)])
        return guess[:0]

    def single(self, begin: float, end: float, q: Array, target: Array, known: Array) -> Array | None:
        """Return the closed position at `end` (s), reached from the one at `begin`; None if it cannot be reached."""
        parts = 0

        def advance(begin: float, end: float, q: Array, target: Array, known: Array, depth: int = 0) -> Array | None:
            nonlocal parts
            parts += 1
            self.parts += 1
            with suppress(ArithmeticError, ValueError):  # a shorter step may work where the guess meets a dead point
                guess = _placed(self._predicted(begin, end - begin, q), self.closure, known)
                found = self.closure.newton(end, guess, target)
                if (
                    found is not None
                    and np.max(np.abs(found - guess)) < FAR
                    and np.all(_signs(self.rates, found, end) == self.signs)
                ):
                    return found
            if depth == _MOST_HALVINGS or parts > _MOST_PARTS or self.parts > _MOST_ALTOGETHER:
                return None
            middle = (begin + end) / 2
            inner_target, inner_known = self.closure.targets(np.array([0.0, middle]))
            half = advance(begin, middle, q, inner_target[1], inner_known[1], depth + 1)
            return None if half is None else advance(middle, end, half, target, known, depth + 1)

        return advance(begin, end, q, target, known)

    def _predicted(self, t: float, h: float, q: Array) -> Array:
        """Return the position after four steps of the precise scheme over h (s)."""
        slopes = self.rates.slopes()
        for part in range(_SUBSTEPS):
            q = PRECISE.step(slopes, t + part * h / _SUBSTEPS, q, h / _SUBSTEPS)
        return q


def _signs(rates: Rates, q: Array, t: float = 0.0) -> Array:
    return np.sign(rates.evaluate(t, *q.tolist())[len(rates.velocities) :])


def _placed(q: Array, closure: Closure, known: Array) -> Array:
    """Return positions (m,) or (n, m) with the driven coordinates set to their `known` values."""
    q = q.copy()
    q[..., list(closure.driven)] = known
    return q
