"""The motion without a scheme's error: closed-form chain, Newton on the closure, or a scheme refined until it stands.

Enters: a scene.  Leaves: a `Motion` on the coursework's own rows, labelled with the way it was found.
Used by `results/accuracy/study.py`, `continuity.py`, `finer.py` and `way_to_motion.py`.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial

import numpy as np

from coursework.motion.geometry.closure import Closure
from coursework.motion.geometry.drive import resolution
from coursework.motion.integration.following import follow_closure
from coursework.motion.integration.loops import generate_loop
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.passage import Passage
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import PRECISE, title_of
from coursework.system.arrays import Array
from coursework.system.frozen import changing
from coursework.variant.record.vocabulary import EXACT
from coursework.words.sentences import say

# Two results of one interval must agree to this (rad or m) where no position is known; what is used is the extrapolated one.
AGREEMENT = 1e-13
# An angle of many turns has no thirteen digits behind its point: there round-off is all that two results can agree to.
_EPS = float(np.finfo(float).eps)
_ROUND_OFF = 4 * _EPS
# With half the step the error is smaller by this and 1: what is left of the difference of two results.
_GAIN = 2**PRECISE.order - 1
_MOST_HALVINGS = 30
_JUMP = 1e-9  # of an interval
# Steps that a refined motion may take, some two seconds, beside twelve a row; in a long table a row takes fewer.
MOST_STEPS, _LONG = 100_000, 2_000
_COUNT, _FEW = 8, 2
# Results that are further apart altogether (rad or m, or of a coordinate beyond 1) are two motions.
_LOST = 1e-6
# A motion beside the refined one, so far from it, shows how what it is off grows until the end.
_BESIDE = 1e-6


class NoVelocities(ArithmeticError):
    """There are no velocities between two `times` (s), from a `position` (rad, m) on."""

    def __init__(self, times: tuple[float, float], position: Sequence[float]) -> None:
        super().__init__(f"the velocities cannot be computed between t = {times[0]:.9g} s and {times[1]:.9g} s")
        self.times, self.position = times, position


class OutOfReach(ArithmeticError):
    """A refined motion takes more steps than are made, or its results do not come to agree."""


@changing
class Growth:
    """How far a refined motion is `off` (rad or m) by what was left in its intervals: it grows as the way `beside` it does."""

    beside: Array
    off: float = 0.0

    def go_on(self, follow: Callable[[Array], Array], begin: Array, end: Array, left: float) -> None:
        """Add what an interval from `begin` to `end` leaves; `follow` gives where a motion that begins elsewhere gets in it."""
        with suppress(ArithmeticError, ValueError):  # a way beside it need not exist
            beside = follow(begin + self.beside) - end
            before, after = (float(np.max(np.abs(way), initial=0.0)) for way in (self.beside, beside))
            if 0 < after < np.inf:
                self.off, self.beside = self.off * after / before, beside * (before / after)
        self.off += left + _EPS * float(np.max(np.abs(end), initial=0.0))


def refine(
    rates: Rates, start: Sequence[float], times: Array, most: int = MOST_STEPS, growth: Growth | None = None
) -> tuple[Array, float, int]:
    """Return positions (n, m) by the precise scheme, the sum of the differences that are left, and the steps taken.

    `growth` is told what becomes of them.

    Where eight and sixteen steps of an interval do not agree it is halved, so that a dead point ahead costs its own interval
    only.  No step reaches across a time at which the drive changes its formula, nor one interval over what it does in less.
    Raises `OutOfReach` where that takes more than `most` steps beside a dozen a row.
    """
    count = _COUNT if len(times) <= _LONG else _FEW
    most += 12 * len(times)
    loop = generate_loop(PRECISE, rates)
    cells = resolution(rates.equations, float(times[-1])).edges
    rows = [[*map(float, start)]]
    gap, steps = 0.0, 0
    for begin, end in itertools.pairwise(times.tolist()):
        edges = [begin, *sorted({*[b for b in rates.breaks if begin < b < end], *quick_times(cells, begin, end)}), end]
        q = rows[-1]
        for a, b in itertools.pairwise(edges):
            q, left, taken = _halved(loop, a, min(b, rates.may_look_until(b)), q, count, most - steps, growth)
            gap, steps = gap + left, steps + taken
        rows.append(q)
    return np.array(rows), gap, steps


def quick_times(cells: Array, begin: float, end: float) -> list[float]:
    """Return the times inside an interval (s) at which shorter stretches end, but none within a jump."""
    first, last = np.searchsorted(cells, (begin, end), side="right")
    if last - first < 2:
        return []
    found, nearest = [begin], _JUMP * (end - begin)
    for at in cells[first:last].tolist():
        if found[-1] + nearest < at < end - nearest:
            found.append(at)
    return found[1:]


def _halved(
    loop: Callable[..., tuple[float, ...]],
    begin: float,
    end: float,
    q: list[float],
    count: int,
    left: int,
    growth: Growth | None,
    depth: int = 0,
) -> tuple[list[float], float, int]:
    """Return the position after an interval, extrapolated from two results, their difference and the steps, `left` at most."""
    try:
        coarse, fine = (loop(begin, parts, (end - begin) / parts, *q) for parts in (count, 2 * count))
        apart = [b - a for a, b in zip(coarse, fine, strict=True)]
        gap = max(map(abs, apart), default=0.0) / _GAIN if math.isfinite(sum(apart)) else math.inf
    except (ArithmeticError, ValueError):
        gap = math.inf
    if gap < max(AGREEMENT, _ROUND_OFF * max(map(abs, q), default=0.0)) or depth >= _MOST_HALVINGS:
        if not math.isfinite(gap):
            raise NoVelocities((begin, end), q)
        if growth is not None:
            ahead = partial(loop, begin, count, (end - begin) / count)
            growth.go_on(lambda there: np.array(ahead(*there.tolist())), np.array(q), np.array(coarse), gap)
        return [b + off / _GAIN for b, off in zip(fine, apart, strict=True)], gap, 3 * count
    if left <= 0:
        raise OutOfReach
    middle = (begin + end) / 2
    q, open_, steps = _halved(loop, begin, middle, q, count, left - 3 * count, growth, depth + 1)
    after, more, further = _halved(loop, middle, end, q, count, left - 3 * count - steps, growth, depth + 1)
    return after, open_ + more, steps + further + 3 * count


def passing_motion(
    rates: Rates, start: Sequence[float], times: Array, passages: Sequence[Passage], notes: tuple[str, ...]
) -> Motion:
    """Return the exact motion at `times` through singular positions: refined between them, on their polynomials about them.

    `rates` are those that know the limits there (`passage.through`).
    """
    positions = np.empty((len(times), len(start)))
    begin, q, gap, steps = 0.0, np.array(start, dtype=float), 0.0, 0
    for passage in (*passages, None):
        first, last = (passage.flanks[1], passage.flanks[2]) if passage else (None, None)
        before = (times >= begin) & ((times < first.time) if first else True)
        found, left, taken = refine(rates, q.tolist(), np.array([begin, *times[before]]))
        positions[before] = found[1:]
        gap, steps = gap + left, steps + taken
        if passage and first and last:
            about = (times >= first.time) & (times <= last.time)
            positions[about] = passage.positions(times[about])
            begin, q = last.time, last.position
    return _refined(rates, times, positions, gap, steps, notes)


def _refined(rates: Rates, times: Array, positions: Array, gap: float, steps: int, notes: tuple[str, ...] = ()) -> Motion:
    label = say("exact.refined", gap=gap, scheme=title_of(PRECISE))
    return rates.motion(times, positions, EXACT, _step(times), PRECISE.slopes * steps, label=label, notes=notes)


def _step(times: Array) -> float:
    return float(times[1] - times[0]) if len(times) > 1 else 0.0


def exact_motion(
    rates: Rates, closure: Closure | None, start: Sequence[float], times: Array, chain: Callable[[Array], Array] | None = None
) -> Motion:
    """Return the exact motion at `times` (rows up to a dead point only).

    Raises `NotReached` where a closure cannot be followed although no dead point was found before, `OutOfReach` where a motion
    without positions in closed form takes too long.
    """
    if chain is not None:
        positions, label = chain(times), say("exact.groups")
    elif closure is not None and closure.complete:
        positions, label = follow_closure(closure, rates, times), say("exact.closure")
    else:
        growth = Growth(np.full(len(start), _BESIDE))
        positions, gap, steps = refine(rates, start, times, growth=growth)
        if max(gap, growth.off) > _LOST * max(1.0, float(np.max(np.abs(positions), initial=0.0))):
            raise OutOfReach
        return _refined(rates, times, positions, gap, steps)
    return rates.motion(times, positions, EXACT, _step(times), label=label)


def no_rows(rates: Rates) -> Motion:
    """Return the exact motion of a mechanism that cannot begin to move, or of one that is not known."""
    q, velocities, determinants = (np.zeros((0, len(names))) for names in (rates.coordinates, rates.velocities, rates.blocks))
    return rates.motion(np.zeros(0), q, EXACT, 0.0, known=(velocities, determinants), label=say("exact.nothing"))
