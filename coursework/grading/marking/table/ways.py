"""The ways in which a cell of a table may be right: the value that each expects, and how far a printed number may lie from it.

Enters: a `Key` and the student's table on its grid.  Leaves: `Way`s.  Used by `cells.py`, `restored.py`, the hypotheses.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key.kept import FEW_NUMBERS
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.sensitivity import with_spread
from coursework.system.arrays import Array, Flags

Places = NDArray[np.intp]
# Half a unit of the last place, and a little for the last bit.
HALF = 0.505
# Part of a column's range that is always allowed: constants of a task sheet are copied with four digits.
SLACK = 2e-4
# A velocity near zero is judged as if it had this part of its column's range.
LEAST = 0.05
# With a tolerance beyond this part of the usual size a way does not count: anything would pass.
_VAGUE = 0.5
# Work computed coarser than it is printed: the floor of the tolerances, in median step errors.
_COARSE = 4.2
_USUAL_PRINT, _COARSE_NOTED = 1 / 3, 0.45  # median step errors, as parts of what the digits allow: usual; worth a note
_COARSE_ROWS = 0.75  # part of the steps that the floor must explain: among broken steps the median is chance
_COARSE_MOST, _COARSE_GAP = 3e-4, 21.0  # the median may be at most _COARSE_MOST (SI) and gap / _COARSE_GAP
_RUNG, _ROUND_OFF = 1.25, 1e-6  # the floor grows in rungs by this factor
# What rounding leaves does not depend on the row before; the deviations of another scheme's steps resemble it by more than this.
_RESEMBLES = 0.5
# In a column with at most this part of the key's values, those were put right one by one.
_FEW_PUT = 0.5
_KEPT = 48  # ways of so many tables, those of one that is being marked


KEY, ANGLES, EARLIER, STEP, STEP_TRUE, START = "key", "own angles", "own velocities", "step", "step true", "start"


@dataclass(frozen=True)
class OwnRows:
    """All rows of a table made with another `step` (s): `values` and `units` (rows, m + r) as in `StudentTable`."""

    step: float
    values: Array
    units: Array


@dataclass(frozen=True, eq=False)
class StudentTable:
    """A student's table on the key's grid: `values` (n, m + r) SI, NaN if missing; `units` of the last places, same shape.

    `turns` (n, m + r) are the whole turns that the reader took off, None if none. `own` is the table on the student's own rows,
    None if its step is the task's.
    """

    values: Array
    units: Array
    turns: Array | None = None
    own: OwnRows | None = None


@dataclass(frozen=True)
class Way:
    """One way to be right: the expected value and the tolerance of each cell, (n, m + r); NaN where it says nothing."""

    name: str
    expected: Array
    tolerance: Array

    def holds(self, values: Array) -> Flags:
        """Return which values are right in this way."""
        return near(values, self.expected, self.tolerance)


def near(values: Array, expected: Array, tolerance: Array) -> Flags:
    """Return which values differ from the expected ones by at most the tolerance; a missing value does not qualify."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.abs(values - expected) <= tolerance)


def put_right(right: Flags) -> Flags:
    """Return which cells with the task's value may have been put right: those of columns (n, …) in which few have it."""
    return np.asarray(right & (right.mean(axis=0) <= _FEW_PUT))


def as_printed(key: Key, units: Array) -> Array:
    """Return the tolerances of printed cells against the key: for the `units` of their last places, and for round-off."""
    sudden = key.usual_ranges < key.ranges  # a row within the pulse is judged by its own size
    return HALF * units + SLACK * np.where(sudden, np.maximum(key.usual_ranges, np.abs(key.table)), key.ranges)


@dataclass(frozen=True)
class OwnWays:
    """The ways from a student's own cells; `computed_to`: decimals of the work if it is coarser than its print, else None.

    `coarse` is the floor of the tolerances for coarser work, 0 if there is none.
    """

    angles: Way
    earlier: Way
    step: Way
    step_true: Way
    computed_to: int | None
    coarse: float

    @property
    def tried(self) -> tuple[Way, ...]:
        """Return the ways in the order in which they are tried."""
        return self.angles, self.earlier, self.step, self.step_true

    def holds(self, values: Array) -> Flags:
        """Return which values (n, m + r) are right in any of the ways."""
        return np.asarray(near(values, *self._of_all).any(axis=0))

    @cached_property
    def _of_all(self) -> tuple[Array, Array]:
        """Return the expected values and the tolerances of all ways, (ways, n, m + r) each."""
        return np.array([way.expected for way in self.tried]), np.array([way.tolerance for way in self.tried])


def own_ways(key: Key, student: StudentTable, coarse: float | None = None) -> OwnWays:
    """Return the ways from the cells that each cell was made from; `coarse` is the floor of coarse work if already known."""
    values, units = student.values, student.units
    if values.size > FEW_NUMBERS:
        return _own_ways(key, student, coarse)
    return _kept(key, values.shape, values.tobytes(), units.tobytes(), coarse)


@lru_cache(_KEPT)
def _kept(key: Key, shape: tuple[int, ...], values: bytes, units: bytes, coarse: float | None) -> OwnWays:
    """Return the ways of a table given by its numbers: what cells were is guessed in many ways that come to the same table."""
    table = StudentTable(np.frombuffer(values).reshape(shape), np.frombuffer(units).reshape(shape))
    return _own_ways(key, table, coarse)


def _own_ways(key: Key, student: StudentTable, coarse: float | None) -> OwnWays:
    computed_to = None
    if coarse is None:
        coarse, computed_to = _coarse(key, student, _steps(key, student))
    return replace(ways_of_all(key, [student], coarse)[0], computed_to=computed_to)


def ways_of_all(key: Key, tables: Sequence[StudentTable], coarse: float) -> list[OwnWays]:
    """Return the ways from the cells of each of several tables with the same floor, their velocities computed together."""
    stacked = StudentTable(np.vstack([one.values for one in tables]), np.vstack([one.units for one in tables]))
    both = [_own_angles(key, stacked, coarse), _own_velocities(key, stacked, coarse)]
    found = []
    for place, table in enumerate(tables):
        rows = slice(place * len(key.t), (place + 1) * len(key.t))
        angles, earlier = (Way(way.name, way.expected[rows], way.tolerance[rows]) for way in both)
        step = _steps(key, table)
        step = replace(step, tolerance=np.maximum(step.tolerance, coarse))
        found.append(OwnWays(angles, earlier, step, _true_steps(key, table, angles), None, coarse))
    return found


def _coarse(key: Key, student: StudentTable, step: Way) -> tuple[float, int | None]:
    """Return the floor of the tolerances, and the decimals of the work if it is coarser than its print, else None.

    The floor of usual print depends only on its digits, that of coarser work goes in rungs, and broken steps influence neither:
    otherwise a cell put right could make others wrong by narrowing the tolerance slightly.
    """
    m, units, most = key.m, student.units, min(_COARSE_MOST, key.gap / _COARSE_GAP)
    digits = HALF * (units[1:, :m] + units[:-1, :m] + key.stride * units[:-1, m : 2 * m])
    signed = (student.values - step.expected)[1:, :m]
    off = np.abs(signed)
    signed[off > _COARSE * most] = np.nan
    off, whole, digits = off[np.isfinite(off)], np.abs(signed[np.isfinite(signed)]), digits[np.isfinite(digits)]
    if not len(whole) or not len(digits):
        return 0.0, None
    allowed = float(np.median(digits))
    usual = _USUAL_PRINT * allowed
    middle = usual if _resemble(signed) else max(float(np.median(whole)), usual)
    coarse = _COARSE * usual * _RUNG ** math.ceil(math.log(middle / usual, _RUNG) - _ROUND_OFF)
    if middle > most or np.mean(off <= coarse) < _COARSE_ROWS:
        return 0.0, None
    return coarse, math.floor(-math.log10(middle)) if middle > _COARSE_NOTED * allowed else None


def _resemble(deviations: Array) -> bool:
    """Return whether deviations (n - 1, m) resemble those of the row before: then another scheme made the steps."""
    varied = deviations - np.nansum(deviations, axis=0) / np.maximum(np.isfinite(deviations).sum(axis=0), 1)
    return bool(np.nansum(varied[1:] * varied[:-1]) > _RESEMBLES * np.nansum(varied**2))


def rows_above(values: Array) -> Places:
    """Return the row from which each row but the first is made (n - 1,): the last one above in which anything was handed in."""
    rows = np.arange(len(values) - 1)
    last = np.maximum.accumulate(np.where(np.isfinite(values[:-1]).any(axis=1), rows, -1))
    return np.where(last < 0, rows, last)


def _steps(key: Key, student: StudentTable) -> Way:
    """Return the way of the step from the row before with its printed velocity."""
    m, h = key.m, key.stride
    rates, units = student.values[:-1, m : 2 * m], student.units[:-1, m : 2 * m]
    size = np.maximum(np.abs(rates), LEAST * key.usual_ranges[m : 2 * m])
    return _way_of_steps(STEP, key, student, rates, HALF * h * units, SLACK * h * size)


def _way_of_steps(name: str, key: Key, student: StudentTable, rates: Array, off: Array, slack: Array | float = 0.0) -> Way:
    """Return the way of the step from the row before with velocities (n - 1, m) that move the next row by `off` and `slack`."""
    m, values, units = key.m, student.values, student.units
    expected, tolerance = np.full(values.shape, np.nan), np.full(values.shape, np.nan)
    expected[1:, :m] = values[:-1, :m] + key.stride * rates
    tolerance[1:, :m] = HALF * (units[1:, :m] + units[:-1, :m]) + off + slack
    _several_steps(key, student, expected, tolerance, by_own_velocity=name == STEP)
    return Way(name, expected, tolerance)


def _several_steps(key: Key, student: StudentTable, expected: Array, tolerance: Array, *, by_own_velocity: bool) -> None:
    """Fill in rows of `expected` and `tolerance` (n, m + r) below missing rows: several Euler steps from the last row above.

    The first step uses the printed velocity if `by_own_velocity`; all others use the reference velocity.
    """
    above, m, h = rows_above(student.values), key.m, key.stride
    below = 1 + np.flatnonzero((above < np.arange(len(above))) & np.isfinite(student.values[1:, :m]).any(axis=1))
    if not len(below):
        return
    last, width = above[below - 1], 2 * m if by_own_velocity else m
    times = below - last

    def marched(cells: Array) -> Array:
        copies, q = len(cells) // len(last), cells[:, :m].copy()
        t, left = np.tile(key.t[last], copies), np.tile(times, copies)
        for step in range(int(times.max())):
            on = left > step
            rates = cells[on, m:] if by_own_velocity and not step else key.velocities_at(t[on] + step * h, q[on])[:, :m]
            q[on] += h * rates
        return q

    at = student.values[last, :width]
    size = np.maximum(np.abs(student.values[last, m : 2 * m]), LEAST * key.usual_ranges[m : 2 * m])
    expected[below, :m], spread = with_spread(marched, at, student.units[last, :width])
    tolerance[below, :m] = HALF * (student.units[below, :m] + spread) + SLACK * h * times[:, None] * np.nan_to_num(size)


def velocity_tolerance(key: Key, units: Array, expected: Array, spread: Array) -> Array:
    """Return the tolerance of printed velocities (n, r): own digits, digits of the cells they were made from, and slack."""
    size = np.maximum(np.abs(expected), LEAST * key.usual_ranges[key.m :])
    return np.asarray(HALF * np.where(np.isnan(units), 0.0, units) + HALF * spread + SLACK * size)


def clear(key: Key, expected: Array, tolerance: Array) -> Array:
    """Return expected velocities (n, r), NaN where the tolerance is as large as they are: there anything would pass."""
    sizes = np.maximum(np.abs(expected), np.max(np.abs(key.table[:, key.m :]), axis=0))
    with np.errstate(invalid="ignore"):
        return np.where(tolerance > _VAGUE * sizes, np.nan, expected)


def clear_velocities(key: Key, units: Array, found: Array, spread: Array) -> tuple[Array, Array]:
    """Return velocities (n, r) printed with `units`, NaN where the digits are too few, and their tolerance."""
    tolerance = velocity_tolerance(key, units, found, spread)
    return clear(key, found, tolerance), tolerance


def _own_angles(key: Key, student: StudentTable, coarse: float) -> Way:
    """Return the way of the reference velocities at the student's own angles."""
    q, units = student.values[:, : key.m], np.maximum(student.units[:, : key.m], coarse)
    found, spread = with_spread(lambda rows: key.velocities_at(np.tile(key.t, len(rows) // len(key.t)), rows), q, units)
    return _velocity_way(ANGLES, key, student.units, found, spread)


def _own_velocities(key: Key, student: StudentTable, coarse: float) -> Way:
    """Return the way of the later blocks' velocities from the student's own velocities of earlier blocks."""
    m, r = key.m, len(key.velocities)
    units = student.units.copy()
    units[:, :m] = np.maximum(units[:, :m], coarse)
    expected, spread = np.full((2, len(units), r), np.nan)
    for index, block in enumerate(key.blocks[1:], start=1):
        places = [key.velocities.index(name) for name in block]

        def at(cells: Array, index: int = index) -> Array:
            return key.block_at(index, np.tile(key.t, len(cells) // len(key.t)), cells[:, :m], cells[:, m:])

        expected[:, places], spread[:, places] = with_spread(at, student.values, units)
    return _velocity_way(EARLIER, key, units, expected, spread)


def _velocity_way(name: str, key: Key, units: Array, found: Array, spread: Array) -> Way:
    expected, tolerance = clear_velocities(key, units[:, key.m :], found, spread)
    blank = np.full((len(expected), key.m), np.nan)
    return Way(name, np.hstack([blank, expected]), np.hstack([blank, tolerance]))


def _true_steps(key: Key, student: StudentTable, own: Way) -> Way:
    """Return the way of the step from the row before with the reference velocity at the student's own angles there."""
    rates, off = (part[:-1, key.m : 2 * key.m] for part in (own.expected, own.tolerance))
    return _way_of_steps(STEP_TRUE, key, student, rates, key.stride * off)
