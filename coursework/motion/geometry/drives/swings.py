"""How fast tabulated drives swing and cranks turn, measured from the values of the drives over a run.

Enters: the drives of a scene.  Leaves: frequencies and speeds (rad/s).  Used by `step_rules.py`, `rows.py` and
`motion_results.py`.  A formula contains its frequencies (`oscillation.py`); the frequency of a table is measured from the time
between one swing and the next.
"""

from __future__ import annotations

import itertools

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.drives.drive import breaks, drive_values
from coursework.motion.geometry.drives.oscillation import fastest, written_out
from coursework.system.arrays import Array, distinct

# Smallest swing that counts, as a share of the law's range: the smaller of two waves then has about a twentieth of the power of
# the larger, as for formulas.
_OF_RANGE = 0.2
# A swing below this share of the law's largest size is only unevenness, or the last digit, of a nearly constant law.
_OF_SIZE = 0.1
# Number of times at which drives are evaluated in a run, and in each piece; the last lies this share of its time before a break.
_LOOKS, _LOOKS_A_PIECE, _BEFORE = 1025, 65, 1e-12
# A speed that changes by less than this share of its size between two breaks is constant there.
_CONSTANT = 1e-9


def drive_frequency(equations: VelocityEquations, of_formulas: float | None = None) -> float:
    """Return the highest frequency (rad/s) of the drives, both formulas and tables over t; 0 without any.

    `of_formulas` is the frequency of the formulas, if it is already known.

    >>> import coursework
    >>> round(drive_frequency(coursework.solve("31").scene.equations), 6)
    13.08
    """
    found = [fastest(equations) if of_formulas is None else of_formulas]
    for law in equations.variant.drive:
        whole = written_out(law, equations)
        if any(part.op.startswith("_table_") for part in whole.walk()):
            times = np.concatenate([*_looks(equations), *(table.nodes for table in equations.tables.values())])
            times = distinct(times[(times >= 0) & (times <= equations.variant.time.end)])
            found.append(swinging(times, drive_values(equations, [law.name], times)[:, 0]))
    return max(found)


def swinging(times: Array, values: Array) -> float:
    """Return the frequency (rad/s) of the shortest swing of a law (n,) at `times` (n,); 0 if it does not swing back and forth.

    A period is the time from the middle of one rise to the middle of the next, or between falls.  If the table does not hold two
    whole rises or falls, half a period is the time from a rise to a fall: the one cut off is measured at the level of the middle
    of its whole neighbour, and is left out if it does not reach that level.

    >>> t = np.linspace(0, 1, 101)
    >>> round(swinging(t, np.sin(20 * t)), 1), swinging(t, t**2)
    (20.0, 0.0)
    """
    least = max(_OF_RANGE * float(np.ptp(values)), _OF_SIZE * float(np.max(np.abs(values))))
    turned = _turning_points(values, least) if least > 0 else []
    whole = list(itertools.pairwise(turned[1:-1]))
    middles = [_passed(times, values, at, after, (values[at] + values[after]) / 2) for at, after in whole]
    if len(middles) > 2:
        return float(2 * np.pi / min(after - at for at, after in zip(middles, middles[2:], strict=False)))
    halves = []
    for before, at, after in zip(turned, turned[1:], turned[2:], strict=False):
        sizes = [abs(float(values[at] - values[other])) for other in (before, after)]
        uncut = [size for size, pair in zip(sizes, ((before, at), (at, after)), strict=True) if pair in whole]
        down = min(uncut, default=max(sizes)) / 2
        if down <= min(sizes):
            level = values[at] - np.copysign(down, values[at] - values[before])
            halves.append(_passed(times, values, at, after, level) - _passed(times, values, at, before, level))
    return float(np.pi / min(halves)) if halves else 0.0


def turning_cranks(equations: VelocityEquations) -> dict[str, float]:
    """Return the largest speed (rad/s) of each driven angle that keeps turning, by its name.

    Such an angle has a constant speed between the breaks of the drive, or makes a whole turn in the run.
    """
    pieces, found = _looks(equations), {}
    for coordinate in equations.variant.coordinates:
        if coordinate.unit != "rad" or coordinate.rate not in equations.variant.known_rates:
            continue
        speeds = [drive_values(equations, [coordinate.rate], piece)[:, 0] for piece in pieces]
        largest = max(float(np.max(np.abs(speed))) for speed in speeds)
        if not 0 < largest < np.inf:
            continue
        even = all(float(np.ptp(speed)) <= _CONSTANT * largest for speed in speeds)
        time, speed = np.concatenate(pieces), np.concatenate(speeds)
        angle = np.append(0.0, np.cumsum(np.diff(time) * (speed[1:] + speed[:-1]) / 2))
        if even or float(np.ptp(angle)) >= 2 * np.pi:
            found[coordinate.name] = largest
    return found


def _looks(equations: VelocityEquations) -> list[Array]:
    """Return the times (s) at which each piece of the run between breaks of the drive is evaluated."""
    end = equations.variant.time.end
    edges = [0.0, *(time for time in breaks(equations.variant) if time < end), end]
    count = max(_LOOKS_A_PIECE, _LOOKS // (len(edges) - 1))
    return [np.linspace(begin, stop if stop == end else stop * (1 - _BEFORE), count) for begin, stop in itertools.pairwise(edges)]


def _turning_points(values: Array, least: float) -> list[int]:
    """Return the indices where the law turns back by at least `least`, with the ends of the table first and last."""
    points, low, high, rising = [0], 0, 0, 0
    for place, value in enumerate(values.tolist()):
        high = place if rising >= 0 and value > values[high] else high
        low = place if rising <= 0 and value < values[low] else low
        if rising >= 0 and values[high] - value >= least:
            points.append(high)
            rising, low = -1, place
        elif rising <= 0 and value - values[low] >= least:
            points.append(low)
            rising, high = 1, place
    if rising:
        points.append(high if rising > 0 else low)
    return [place for place, _ in itertools.groupby(points)]


def _passed(times: Array, values: Array, at: int, towards: int, level: float) -> float:
    """Return the time (s) at which the law passes `level`, followed from index `at` to index `towards`."""
    step = 1 if towards > at else -1
    above = values[at] > level
    place = at
    while place != towards and (values[place] > level) == above:
        place += step
    here, there = values[place - step], values[place]
    share = (level - here) / (there - here) if there != here else 1.0
    return float(times[place - step] + share * (times[place] - times[place - step]))
