"""The motion without a scheme's error: closed-form chain, Newton on the closure, or a scheme refined until it stands.

Enters: a scene.  Leaves: a `Motion` on the coursework's own rows, labelled with the way it was found.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from coursework.geometry.closure import Closure
from coursework.integration.loops import generate_loop
from coursework.integration.motion import Motion
from coursework.integration.rates import Rates
from coursework.reduction.equations import VelocityEquations
from coursework.schemes import PRECISE
from coursework.sentences import say, title_of

Array = NDArray[np.float64]
Predictor = Callable[[float, float, Array], Array]
# Two results of one interval must agree to this (rad or m) where no position is known; what is used is the extrapolated one.
AGREEMENT = 1e-13
_MOST_HALVINGS = 30
# With half the step the error is smaller by this and 1: what is left of the difference of two results.
_GAIN = 2**PRECISE.order - 1
# Parts of one row after which a closure counts as not to be followed: a dead point takes about 60, a wrong motion all there are.
_MOST_PARTS = 1000
# A prediction further than this from the closed position (rad or m) is not trusted to be the same assembly.
_FAR = 0.05


class NotReached(Exception):
    """The closure could not be followed beyond row `row` (counted from 0)."""

    def __init__(self, row: int, time: float) -> None:
        super().__init__(f"the position could not be followed beyond t = {time:.9g} s")
        self.row = row
        self.time = time


def predictor(rates: Rates) -> Predictor:
    """Return `predict(t, h, q)`: four steps of the precise scheme over h."""

    def slopes(t: float, q: Array) -> Array:
        return np.array(rates.evaluate(t, *q.tolist())[: len(q)])

    def predict(t: float, h: float, q: Array) -> Array:
        for part in range(4):
            q = PRECISE.step(slopes, t + part * h / 4, q, h / 4)
        return q

    return predict


def follow_closure(closure: Closure, rates: Rates, times: Array) -> Array:
    """Return the positions (n, m) at `times`, each closed to round-off.

    The assembly is kept by prediction along the motion and by the signs of the determinants, which change at a dead point
    only; where the prediction is poor the interval is halved.  Raises `NotReached` where the mechanism cannot follow.
    """
    predict = predictor(rates)
    kept, known = closure.targets(times)
    row = _place(closure.start, closure, known[0])
    found = closure.newton(0.0, row, kept[0])
    if found is None:
        raise NotReached(0, 0.0)
    signs = _signs(rates, 0.0, found)
    parts = 0

    def advance(begin: float, end: float, q: Array, target: Array, known: Array, depth: int = 0) -> Array | None:
        nonlocal parts
        parts += 1
        with suppress(ArithmeticError, ValueError):  # where the prediction meets a dead point a shorter one does not
            guess = _place(predict(begin, end - begin, q), closure, known)
            found = closure.newton(end, guess, target)
            if found is not None and float(np.max(np.abs(found - guess))) < _FAR and _signs(rates, end, found) == signs:
                return found
        if depth == _MOST_HALVINGS or parts > _MOST_PARTS:
            return None
        middle = (begin + end) / 2
        inner_target, inner_known = closure.targets(np.array([0.0, middle]))
        half = advance(begin, middle, q, inner_target[1], inner_known[1], depth + 1)
        return None if half is None else advance(middle, end, half, target, known, depth + 1)

    positions = [found]
    for index, (begin, end) in enumerate(itertools.pairwise(times.tolist()), start=1):
        parts = 0
        following = advance(begin, end, positions[-1], kept[index], known[index])
        if following is None:
            raise NotReached(index, end)
        positions.append(following)
    return np.array(positions)


def _signs(rates: Rates, t: float, q: Array) -> list[float]:
    return [math.copysign(1.0, value) for value in rates.evaluate(t, *q.tolist())[len(rates.velocities) :]]


def _place(q: Array, closure: Closure, known: Array) -> Array:
    q = q.copy()
    q[list(closure.driven)] = known
    return q


def refine(rates: Rates, start: Sequence[float], times: Array) -> tuple[Array, float, int]:
    """Return positions (n, m) by the precise scheme, the sum of the differences that are left, and the steps taken.

    Where eight and sixteen steps of an interval do not agree it is halved, so that a dead point ahead costs its own interval
    only.  No step reaches across a time at which the drive changes its formula.
    """
    loop = generate_loop(PRECISE, rates)
    rows = [np.array(start, dtype=float)]
    gap, steps = 0.0, 0
    for begin, end in itertools.pairwise(times.tolist()):
        edges = [begin, *[b for b in rates.breaks if begin < b < end], end]
        q = rows[-1]
        for a, b in itertools.pairwise(edges):
            q, left, taken = _halved(loop, a, min(b, rates.latest(b)), q)
            gap, steps = gap + left, steps + taken
        rows.append(q)
    return np.array(rows), gap, steps


def _halved(
    loop: Callable[..., tuple[float, ...]], begin: float, end: float, q: Array, depth: int = 0
) -> tuple[Array, float, int]:
    """Return the position after an interval, extrapolated from two results, their difference and the steps."""
    try:
        coarse, fine = (np.array(loop(begin, count, (end - begin) / count, *q.tolist())) for count in (8, 16))
        gap = float(np.max(np.abs(fine - coarse), initial=0.0)) / _GAIN
    except (ArithmeticError, ValueError):
        coarse = fine = q
        gap = np.inf
    if gap < AGREEMENT or depth >= _MOST_HALVINGS:
        if not np.isfinite(gap):
            raise ZeroDivisionError(f"the velocities cannot be computed between t = {begin:.9g} s and {end:.9g} s")
        return fine + (fine - coarse) / _GAIN, gap, 24
    middle = (begin + end) / 2
    q, left, steps = _halved(loop, begin, middle, q, depth + 1)
    after, right, more = _halved(loop, middle, end, q, depth + 1)
    return after, left + right, steps + more + 24


def exact_motion(
    equations: VelocityEquations, rates: Rates, closure: Closure | None, start: Sequence[float], times: Array,
    blocks: int, chain: Callable[[Array], Array] | None = None,
) -> Motion:  # fmt: skip
    """Return the exact motion at `times` (rows up to a dead point only).

    Raises `NotReached` where a closure cannot be followed although no dead point was found before.
    """
    evaluations = 0
    if chain is not None:
        positions, label = chain(times), say("exact.groups")
    elif closure is not None and closure.complete:
        positions, label = (
            follow_closure(closure, rates, times),
            say("exact.closure"),
        )
    else:
        positions, gap, steps = refine(rates, start, times)
        evaluations = PRECISE.slopes * steps
        label = say("exact.refined", gap=gap, scheme=title_of(PRECISE))
    velocities, determinants = rates.table(times, positions)
    return Motion(
        times, positions, velocities, determinants, np.zeros((len(times), 0)),
        rates.coordinates, rates.velocities, "exact", float(times[1] - times[0]) if len(times) > 1 else 0.0, evaluations,
        label=label,
    )  # fmt: skip
