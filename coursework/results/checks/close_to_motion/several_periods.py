"""A gear train with a ratio that is not whole: back after several periods of its drive, or never.

Enters: `Evidence` whose exact motion is not back after the stated period.  Leaves: `Later`, None if gears do not explain it.
Used by `period.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.integration.finer import exact_at
from coursework.results.checks.evidence import Evidence
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

# Share of the scale by which the exact motion may miss its start after the stated period.  Measured over 38 stated periods:
# T off by 0.2 % (three digits of it) moves the exact motion by at most 0.021, T off by 2 % by at least 0.031.
RETURNS = 0.03

# The stated period is followed up to this multiple of the run's length: as much work after the run as in it.
FURTHEST = 2.0

# Largest number of drive periods: nobody waits longer for a mechanism.
MOST = 100

# Share of a turn by which a whole number of turns may be missed, and of its scale by which a length may grow each period.
# Among a hundred multiples of any number one is whole to 0.01: with the limit for T every ratio would count as a simple fraction.
WHOLE = 1e-4


@frozen
class Later:
    """When the mechanism is back: after `periods` of its drive, at `time` s; `periods` is None if it is not within `MOST`."""

    periods: int | None
    time: float


def later(evidence: Evidence) -> Later | None:
    """Return when the mechanism is back; None if the drive is not back after T, or if no wheel gains steadily each period."""
    return evidence.once(f"back later than {evidence.period!r}", lambda: _later(evidence))


def after(evidence: Evidence, time: float) -> Array | None:
    """Return the exact row (m + k,) at any time (s), None if there is none."""
    exact = evidence.exact
    return evidence.once(f"exact at {time!r}", lambda: exact_at(exact, evidence.rates, time))


def share_of(size: float, scale: float, least: float) -> float:
    """Return a difference as a share of the scale, 0 if it is below the `least` that counts."""
    return 0.0 if abs(size) < least else abs(size) / scale


def ends(evidence: Evidence, row: Array, name: str) -> tuple[float, float]:
    """Return a column of the exact motion at its start and in an exact row, without whole turns."""
    exact = evidence.exact
    first, last = float(exact.column(name)[0]), float(row[exact.names.index(name)])
    return first, last - float(whole_turns(last - first)) if evidence.unit(name) == "rad" else last


def missed(evidence: Evidence, row: Array, name: str) -> float:
    """Return the share of its scale by which a column of an exact row misses its start, without whole turns."""
    first, last = ends(evidence, row, name)
    return share_of(last - first, evidence.scale[name], evidence.least(name))


def _later(evidence: Evidence) -> Later | None:
    exact, variant, period = evidence.exact, evidence.variant, evidence.period
    driven = [coordinate.name for coordinate in variant.driven_coordinates]
    once = after(evidence, period) if driven else None
    if once is None or any(missed(evidence, once, name) > RETURNS for name in (*driven, *variant.known_rates)):
        return None
    twice = after(evidence, 2 * period)  # last: after its period an arm without a crank may be led out of its reach
    if twice is None:
        return None
    gains = np.diff([exact.rows[0], once, twice], axis=0)[:, : len(exact.coordinate_names)]
    late = _lateness(evidence, gains, driven)
    wheels = []
    for coordinate in variant.coordinates:
        is_angle = coordinate.unit == "rad"
        whole = 2 * np.pi if is_angle else evidence.scale[coordinate.name]
        first, second = (gains[:, exact.coordinate_names.index(coordinate.name)] / late / whole).tolist()
        is_steady = abs(second - first) <= WHOLE and missed(evidence, once, coordinate.rate) <= RETURNS
        if coordinate.name in driven or not is_steady:
            continue  # what hangs on a wheel that is not back is not back either
        if is_angle:
            wheels.append((first + second) / 2)
        elif abs(first) > WHOLE:
            return None  # it travels on
    if all(abs(gain - round(gain)) <= WHOLE for gain in wheels):
        return None
    true = period / float(late[0])
    for periods in range(2, MOST + 1):
        if all(abs(periods * gain - round(periods * gain)) <= WHOLE for gain in wheels):
            return Later(periods, periods * true) if _is_back(evidence, periods * true) else None
    return Later(None, np.inf)


def _lateness(evidence: Evidence, gains: Array, driven: list[str]) -> Array:
    """Return the ratio (2,) of each period's turn of the driven crank to whole turns; 1 if no crank turns round.

    Dividing by it makes the ratio of a wheel to the crank independent of the digits of T that are stated.
    """
    exact = evidence.exact
    for name in driven:
        turned = gains[:, exact.coordinate_names.index(name)]
        whole = whole_turns(turned)
        if evidence.unit(name) == "rad" and np.all(whole != 0):
            return np.asarray(turned / whole)
    return np.ones(len(gains))


def _is_back(evidence: Evidence, time: float) -> bool:
    """Return whether every column is back at `time`, if the motion can be followed so far; beyond, whole turns are enough."""
    if time > FURTHEST * float(evidence.motion.t[-1]):
        return True
    row = after(evidence, time)
    return row is not None and all(missed(evidence, row, name) <= RETURNS for name in evidence.names)
