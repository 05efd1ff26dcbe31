"""Rules for a step that do not depend on its error: enough rows for the drive and for a turn, no jump of a link.

Enters: velocity equations and the search for dead points.  Leaves: `StepRules`, counted in steps of a run.
Used by `step_search.py` and the command line; the same rules as the checks STEP and PEAK.
"""

from __future__ import annotations

import math
from fractions import Fraction

from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.drives.drive import breaks
from coursework.motion.geometry.drives.swings import drive_frequency, turning_cranks
from coursework.motion.integration.integrate import WIDEST_STEP
from coursework.motion.singular.search import Search
from coursework.results.checks.close_to_motion.rows import AT_ROW, ROWS_A_PERIOD, between_rows
from coursework.system.frozen import frozen
from coursework.variant.record.variant import MAX_ROWS

# If no division of the run into this many parts puts a row at a break, the break is left to the error.
_MOST_PARTS = 1000
_ROUNDING = 1e-9
# Factor by which the number of steps grows until the rows show every pulse.
_FINER = 1.25


@frozen
class StepRules:
    """The rules: a run has at least `fewest` steps, and a multiple of `pace`, which puts a row at each break of the drive."""

    fewest: int = 1
    pace: int = 1

    def rounded(self, steps: int) -> int:
        """Return the smallest number of steps, not below `steps`, that keeps the rules."""
        return self.pace * math.ceil(max(steps, self.fewest) / self.pace)


def step_rules(equations: VelocityEquations, search: Search) -> StepRules:
    """Return the rules for the steps of a whole run, 0 to the end of the variant.

    >>> import coursework
    >>> scene = coursework.solve("31").scene
    >>> step_rules(scene.equations, scene.search)
    StepRules(fewest=20, pace=1)
    """
    variant = equations.variant
    turning = [place for place, coordinate in enumerate(variant.coordinates) if coordinate.unit == "rad"]
    end = variant.time.end
    rows = ROWS_A_PERIOD * end * max([drive_frequency(equations), *turning_cranks(equations).values()]) / (2 * math.pi)
    known = search.fastest(turning)
    turns = end / min((search.longest_step(place, WIDEST_STEP, end) for place in turning if known), default=end)
    fewest = max(1, *(math.ceil(count * (1 - _ROUNDING)) for count in (rows, turns)))
    while fewest < MAX_ROWS and between_rows(equations, end / fewest) is not None:
        fewest = math.ceil(fewest * _FINER)
    return StepRules(fewest, _pace(breaks(variant), end))


def _pace(times: tuple[float, ...], end: float) -> int:
    """Return the number of equal parts of a run that puts the end of a part at each of the times; 1 if that takes too many."""
    parts = [Fraction(time / end).limit_denominator(_MOST_PARTS) for time in times if time < end]
    met = [part.denominator for part, time in zip(parts, times, strict=False) if abs(float(part) * end - time) <= AT_ROW * time]
    whole = math.lcm(*met)
    return whole if whole <= _MOST_PARTS else 1
