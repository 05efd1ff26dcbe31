"""One stroke of a slider, or one swing of a rocker, from dead position to dead position.

Enters: the exact motion and its rates.  Leaves: `Way`, whose ends are found in continuous time.
Used by `extra.py` and `turning_points.py`.
"""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np

from coursework.motion.integration.finer import at_times
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.integration.turning import closer, root, stands, turns
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Coordinate

# Share of a step by which a dead position may lie before the first row or after the last: a start is rounded.
_OFF = 0.1
# A row within this share of a step of a dead position is that position.
_SAME = 1e-6
# A dead position within this share of a step of a row is off by round-off only.
_ROUND_OFF = 1e-9
# If the crank angles of two strokes differ by less than this share, the first is taken: they belong to two turns.
_ALIKE = 1e-2


@frozen
class Samples:
    """Close samples of the exact `motion`.

    `begins` and `ends` say that the samples start with the first row and end with the last, because nothing is known beyond.
    """

    motion: Motion
    begins: bool
    ends: bool


@frozen
class Way:
    """A one-way travel of a `slider` or rocker, with its rows in `motion`; table rows `first` to `last` (from 1) lie in it.

    `is_stroke`: it begins and ends at dead positions.  If the run has no two of them, it is the longest stretch of rows.
    """

    slider: Coordinate
    motion: Motion
    first: int
    last: int
    is_stroke: bool


def longest_way(exact: Motion, rates: Rates, crank: Coordinate, slider: Coordinate) -> Way:
    """Return the stroke with the largest turn of the crank; if there is none, the longest stretch of rows in one direction."""
    samples = samples_of(exact, rates)
    brackets = _brackets(samples, slider.rate)
    omega, angle = samples.motion.column(crank.rate), samples.motion.column(crank.name)
    strokes = [
        (abs(float(np.mean(angle[list(end)]) - np.mean(angle[list(begin)]))), begin, end)
        for begin, end in itertools.pairwise(brackets)
        if np.all(omega[begin[0] : end[1] + 1] * omega[begin[0]] > 0)
    ]
    longest = max((turned for turned, *_ in strokes), default=0.0)
    chosen = next((ends for turned, *ends in strokes if turned >= (1 - _ALIKE) * longest), [])
    times = [_dead(exact, rates, slider.rate, samples.motion.t[list(end)].tolist()) for end in chosen]
    dead = [at_times(exact, rates, [time]) for time in times if time is not None]
    ends = [end for end in dead if end is not None]
    return _stroke(exact, rates, slider, *ends) if len(ends) == 2 else _stretch(exact, rates, slider)


def dead_positions(exact: Motion, rates: Rates, rate: str, samples: Samples) -> Motion | None:
    """Return the exact motion at the times when the coordinate with this `rate` turns back, None if one cannot be reached."""
    found = [_dead(exact, rates, rate, samples.motion.t[list(one)].tolist()) for one in _brackets(samples, rate)]
    times = [time for time in found if time is not None]
    return at_times(exact, rates, times) if len(times) == len(found) else None


def swings(exact: Motion, coordinate: Coordinate) -> bool:
    """Return whether a coordinate turns back within the rows."""
    return bool(turns(exact.column(coordinate.rate)))


def samples_of(exact: Motion, rates: Rates) -> Samples:
    """Return close samples of a run, from a little before its first row to a little after its last, as far as they exist."""
    before, behind = (
        at_times(exact, rates, [float(exact.t[place]) + part * exact.step]) for place, part in ((0, -_OFF), (-1, _OFF))
    )
    parts = [part for part in (before, closer(exact, rates), behind) if part is not None]
    return Samples(_together(exact, rates, parts), before is None, behind is None)


def _brackets(samples: Samples, rate: str) -> list[tuple[int, int]]:
    """Return pairs of samples between which the coordinate of a rate is at a dead position; an equal pair if it is at one."""
    slopes = samples.motion.column(rate)
    at_rest, last = stands(slopes), len(slopes) - 1
    begins = [(0, 0)] if samples.begins and at_rest[0] else []
    return [*begins, *turns(slopes), *([(last, last)] if samples.ends and at_rest[last] else [])]


def _dead(exact: Motion, rates: Rates, rate: str, bracket: list[float]) -> float | None:
    """Return the time (s) of the dead position between two samples, moved to a row if it differs by round-off only."""
    begin, end = bracket
    time = begin if begin == end else root(exact, rates, lambda motion: motion.column(rate), (begin, end))
    if time is None:
        return None
    row = float(exact.t[np.argmin(np.abs(exact.t - time))])
    return row if abs(time - row) < _ROUND_OFF * exact.step else time


def _stroke(exact: Motion, rates: Rates, slider: Coordinate, begin: Motion, end: Motion) -> Way:
    """Return the way between two dead positions: these as first and last rows, with the rows between them."""
    edge = _SAME * exact.step
    inside = np.flatnonzero((exact.t > begin.t[0] + edge) & (exact.t < end.t[0] - edge))
    between = replace(exact, t=exact.t[inside], coordinates=exact.coordinates[inside])
    motion = _together(exact, rates, [begin, between, end])
    first = int(np.searchsorted(exact.t, begin.t[0] - edge))
    last = int(np.searchsorted(exact.t, end.t[0] + edge))
    return Way(slider, motion, first + 1, last, is_stroke=True)


def _stretch(exact: Motion, rates: Rates, slider: Coordinate) -> Way:
    """Return the longest stretch of rows over which a coordinate moves in one direction."""
    signs = np.sign(np.diff(exact.column(slider.name)))
    edges = [0, *(np.flatnonzero(np.diff(signs)) + 1).tolist(), len(signs)]
    first, last = max(itertools.pairwise(edges), key=lambda pair: pair[1] - pair[0])
    rows = slice(first, last + 1)
    motion = rates.motion(exact.t[rows], exact.coordinates[rows], exact.scheme, exact.step)
    return Way(slider, motion, first + 1, last + 1, is_stroke=False)


def _together(exact: Motion, rates: Rates, parts: list[Motion]) -> Motion:
    """Return one motion with the rows of several parts of the exact motion."""
    t, positions = (np.concatenate(rows) for rows in ([part.t for part in parts], [part.coordinates for part in parts]))
    return rates.motion(t, positions, exact.scheme, exact.step)
