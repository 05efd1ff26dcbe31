"""Whether the whole motion is possible, and if not, where it ends.

Enters: the determinant-scaled flow, the start.  Leaves: `Search`, which depends on no scheme or step.
Used by the scene, `phases.py` and whoever asks only whether a motion is possible.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from coursework.motion.geometry.drives.drive import resolution
from coursework.motion.geometry.drives.oscillation import turns_repeat
from coursework.motion.integration.passage import Passage
from coursework.motion.singular.event import Event, GivenUp
from coursework.motion.singular.peaks import Peaks
from coursework.motion.singular.scaled_flow import Flow
from coursework.motion.singular.walk import Walk
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

# The event time must be right to 1e-8 s; the local tolerance leaves three digits for the sum of all steps.
TOLERANCE = 1e-12
_BACK = 1e-8
_NEARLY = 0.005


@frozen
class Search:
    """The true motion followed up to `end` (s): the first `event`, if any, and the `peaks` of the rates.

    `passages` are singular positions on the way with only one continuation.  `given_up` is the time (s) at which following was
    given up because the motion moves too much; else None.  `repeats`: it was followed until it repeats.
    `goes_round`: it was given up, but the only crank can be turned right round, so there is no later event either.
    """

    event: Event | None
    peaks: Peaks | None = None
    end: float = 0.0
    passages: tuple[Passage, ...] = ()
    given_up: float | None = None
    repeats: bool = False
    goes_round: bool = False

    @property
    def goes_on(self) -> bool:
        """Return whether the motion is known to go on to the end."""
        return self.event is None and self.given_up is None

    def fastest(self, turning: Sequence[int]) -> tuple[tuple[float, float | None], ...]:
        """Return per coordinate the largest |rate| and its time (s), None for a constant rate; empty for a motion that stops.

        `turning` are the coordinates among which the fastest is wanted exactly.
        """
        return self.peaks.found(self.end, turning) if self.goes_on and self.peaks is not None else ()

    def way_within(self, coordinate: int) -> Callable[[float], float]:
        """Return a function of a step (s): the longest path (rad) of a coordinate within it."""
        if self.peaks is None:
            return lambda step: 0.0
        rate, when = self.fastest([coordinate])[coordinate]
        return (lambda step: rate * step) if when is None else self.peaks.way_within(coordinate, self.end, self.repeats)

    def longest_step(self, coordinate: int, most: float, step: float) -> float:
        """Return the longest part of a step (s) within which a coordinate moves at most `most` (rad), to half a percent."""
        way, low, high = self.way_within(coordinate), 0.0, step
        while high - low > _NEARLY * high:
            middle = (low + high) / 2
            low, high = (middle, high) if way(middle) <= most else (low, middle)
        return low


def search_event(
    flow: Flow, start: Sequence[float], end: float, *, tolerance: float = TOLERANCE, breaks: Sequence[float] = ()
) -> Search:
    """Follow the true motion from `start` at t = 0 until `end` (s), or to its first dead or change point.

    `breaks` are the times at which the drive changes its formula.  Raises `InputError` if the motion cannot be followed.
    """
    if not len(flow.largest):
        return Search(None)  # every velocity is given, so nothing can become singular
    cells = resolution(flow.equations, end).edges
    # No step is short enough for more than round-off leaves: the walk would take all it may, each a billionth of the run.
    walk = Walk(flow, np.array([*start, 0.0], dtype=float), end, cells, max(tolerance, flow.noise))
    event = None
    turn = turns_repeat(flow.equations)
    for goal in sorted({*(b for b in (*breaks, turn, 2 * turn) if 0 < b < end), end}):
        try:
            event = event or walk.at_start() or walk.until(goal)
        except GivenUp as up:
            return Search(None, walk.peaks, end, tuple(walk.passages), up.time)
        repeats = event is None and not walk.passages and goal < end and goal in (turn, 2 * turn)
        if repeats and is_back(flow, walk.state[:-1], start):
            return Search(None, walk.peaks, goal, tuple(walk.passages), repeats=True)  # from here on the motion repeats itself
    return Search(event, walk.peaks, end, tuple(walk.passages))


def is_back(flow: Flow, position: Array, start: Sequence[float]) -> bool:
    """Return whether a position (m,) equals the start except for whole turns of its angles."""
    gap = position - np.asarray(start)
    angles = np.array([coordinate.unit == "rad" for coordinate in flow.equations.variant.coordinates])
    gap[angles] -= whole_turns(gap[angles])
    return bool(np.max(np.abs(gap) / flow.units, initial=0.0) < _BACK)
