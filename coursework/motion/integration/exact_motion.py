"""The motion without a scheme's error: closed-form chain, Newton on the closure, or a scheme refined until it converges.

Enters: a scene.  Leaves: a `Motion` on the coursework's own rows, with a label that tells how it was found.
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
from coursework.motion.geometry.drives.drive import resolution
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

# Without closed positions, two results of one interval must agree to this (rad or sizes of the mechanism), and the extrapolated
# value is used.
AGREEMENT = 1e-13
# An angle of many turns has fewer than thirteen digits after its point: there two results can agree only to round-off.
_EPS = float(np.finfo(float).eps)
_ROUND_OFF = 4 * _EPS
# Halving the step divides the error by _GAIN + 1; so the finer result is off by the difference of the two over _GAIN.
_GAIN = 2**PRECISE.order - 1
_MOST_HALVINGS = 30
_JUMP = 1e-9  # share of an interval
# Steps a refined motion may take (some two seconds), besides twelve a row; rows of a table over `_LONG` start with fewer parts.
MOST_STEPS, _LONG = 100_000, 2_000
_COUNT, _FEW = 8, 2
# If the summed differences exceed this (rad or sizes, relative for coordinates beyond 1), the result is not the motion.
_LOST = 1e-6
# Start offset (rad or sizes) of a neighbouring motion, which shows how errors grow until the end.
_BESIDE = 1e-6


class NoVelocities(ArithmeticError):
    """The velocities cannot be computed between two `times` (s), starting from `position` (rad, m)."""

    def __init__(self, times: tuple[float, float], position: Sequence[float]) -> None:
        super().__init__(f"the velocities cannot be computed between t = {times[0]:.9g} s and {times[1]:.9g} s")
        self.times, self.position = times, position


class OutOfReach(ArithmeticError):
    """A refined motion takes too many steps, or its results do not come to agree."""


@changing
class Growth:
    """The growth of errors: `off` (rad or `sizes`), that of a refined motion, grows as the offset `beside` of a neighbour."""

    beside: Array
    off: float = 0.0
    sizes: Array | float = 1.0

    def go_on(self, follow: Callable[[Array], Array], begin: Array, end: Array, left: float) -> None:
        """Add the error `left` of an interval from `begin` to `end`; `follow` maps a start to the end of the interval."""
        with suppress(ArithmeticError, ValueError):  # a neighbouring motion need not exist
            beside = follow(begin + self.beside) - end
            before, after = (float(np.max(np.abs(way) / self.sizes, initial=0.0)) for way in (self.beside, beside))
            if 0 < after < np.inf:
                self.off, self.beside = self.off * after / before, beside * (before / after)
        self.off += left + _EPS * float(np.max(np.abs(end) / self.sizes, initial=0.0))


def refine(
    rates: Rates, start: Sequence[float], times: Array, most: int = MOST_STEPS, growth: Growth | None = None
) -> tuple[Array, float, int]:
    """Return positions (n, m) by the precise scheme, the sum of the remaining differences, and the number of steps.

    `growth` collects how these differences (rad or sizes of the mechanism) grow.

    If eight and sixteen steps of an interval disagree (in a long table two and four), it is halved, so that a dead point ahead
    costs only its own interval.  No step crosses a time at which the drive changes its formula, no interval a faster change of
    the drive.  Raises `OutOfReach` if this takes more than `most` steps besides a dozen a row.
    """
    count = _COUNT if len(times) <= _LONG else _FEW
    most += 12 * len(times)
    loop = generate_loop(PRECISE, rates)
    cells, sizes = resolution(rates.equations, float(times[-1])).edges, rates.sizes.tolist()
    rows = [[*map(float, start)]]
    gap, steps = 0.0, 0
    for begin, end in itertools.pairwise(times.tolist()):
        edges = [begin, *sorted({*[b for b in rates.breaks if begin < b < end], *quick_times(cells, begin, end)}), end]
        q = rows[-1]
        for a, b in itertools.pairwise(edges):
            q, left, taken = _halved(loop, a, min(b, rates.may_look_until(b)), q, sizes, count, most - steps, growth)
            gap, steps = gap + left, steps + taken
        rows.append(q)
    return np.array(rows), gap, steps


def quick_times(cells: Array, begin: float, end: float) -> list[float]:
    """Return the times (s) inside an interval at which shorter stretches of the drive end, leaving out those almost equal."""
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
    sizes: list[float],
    count: int,
    left: int,
    growth: Growth | None,
    depth: int = 0,
) -> tuple[list[float], float, int]:
    """Return the extrapolated position after an interval, the difference of two results, and the steps (limited by `left`)."""
    try:
        coarse, fine = (loop(begin, parts, (end - begin) / parts, *q) for parts in (count, 2 * count))
        apart = [b - a for a, b in zip(coarse, fine, strict=True)]
        gap = _largest(apart, sizes) / _GAIN if math.isfinite(sum(apart)) else math.inf
    except (ArithmeticError, ValueError):
        gap = math.inf
    if gap < max(AGREEMENT, _ROUND_OFF * _largest(q, sizes)) or depth >= _MOST_HALVINGS:
        if not math.isfinite(gap):
            raise NoVelocities((begin, end), q)
        if growth is not None:
            ahead = partial(loop, begin, count, (end - begin) / count)
            growth.go_on(lambda there: np.array(ahead(*there.tolist())), np.array(q), np.array(coarse), gap)
        return [b + off / _GAIN for b, off in zip(fine, apart, strict=True)], gap, 3 * count
    if left <= 0:
        raise OutOfReach
    middle = (begin + end) / 2
    q, open_, steps = _halved(loop, begin, middle, q, sizes, count, left - 3 * count, growth, depth + 1)
    after, more, further = _halved(loop, middle, end, q, sizes, count, left - 3 * count - steps, growth, depth + 1)
    return after, open_ + more, steps + further + 3 * count


def _largest(values: Sequence[float], sizes: Sequence[float]) -> float:
    return max((abs(value) / size for value, size in zip(values, sizes, strict=True)), default=0.0)


def passing_motion(
    rates: Rates, start: Sequence[float], times: Array, passages: Sequence[Passage], notes: tuple[str, ...]
) -> Motion:
    """Return the exact motion at `times` through singular positions: refined between them, by their polynomials near them.

    `rates` must know the limits at these positions (`passage.through`).
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
    """Return the exact motion at `times`, which must end before a dead point.

    Raises `NotReached` if a closure cannot be followed although no dead point was found before, `OutOfReach` if a motion
    without closed positions takes too long.
    """
    if chain is not None:
        positions, label = chain(times), say("exact.groups")
    elif closure is not None and closure.complete:
        positions, label = follow_closure(closure, rates, times), say("exact.closure")
    else:
        growth = Growth(_BESIDE * rates.sizes, sizes=rates.sizes)
        positions, gap, steps = refine(rates, start, times, growth=growth)
        if max(gap, growth.off) > _LOST * max(1.0, float(np.max(np.abs(positions) / rates.sizes, initial=0.0))):
            raise OutOfReach
        return _refined(rates, times, positions, gap, steps)
    return rates.motion(times, positions, EXACT, _step(times), label=label)


def no_rows(rates: Rates) -> Motion:
    """Return a motion without rows, for a mechanism that cannot begin to move or whose motion is unknown."""
    q, velocities, determinants = (np.zeros((0, len(names))) for names in (rates.coordinates, rates.velocities, rates.blocks))
    return rates.motion(np.zeros(0), q, EXACT, 0.0, known=(velocities, determinants), label=say("exact.nothing"))
