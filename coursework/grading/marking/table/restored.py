"""What stood in a table before a cell of it was misprinted or put right: the cells made from that follow from it still.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
A right cell may stand among those of another motion.  Whatever it was before, what follows from it costs nothing now either.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.ways import HALF, OwnWays, StudentTable, Way, own_ways
from coursework.system.arrays import Array, Flags

Places = NDArray[np.intp]
# The march forward is repeated with the velocities of the angles that it found.
_PASSES = 2
# So many velocities must agree on what another was when they were made.
_AGREE = 2
# How often what a cell was is mended until they do, with slopes over so small a part.
_ROUNDS, _DIFFERENCE = 5, 1e-6


def from_what_was(key: Key, student: StudentTable, right: Flags, own: OwnWays, before: StudentTable | None) -> Iterator[Way]:
    """Yield the ways from cells as they were before those that are `right` (n, m + r), the key's, were put so.

    `before` is the table as the rows above make it.
    """
    yield from _before_a_misprint(key, student, own)
    yield from _before_it_was_put_right(key, student, right, own)
    if before is not None:
        yield from own_ways(key, before).tried


def as_it_was(key: Key, student: StudentTable, right: Flags, own: OwnWays) -> StudentTable | None:
    """Return the table with what the rows before make of each `right` cell that does not follow from them, None for the same."""
    m = len(key.coordinates)
    w, printed = student.values[:, m:], student.values[:, m:]
    allowed = np.fmax(own.angles.tolerance, own.earlier.tolerance)[:, m:]
    follows = (own.step.holds(student.values) | own.step_true.holds(student.values))[:, :m]
    for _ in range(_PASSES):
        q, units = _marched(key, student, right[:, :m], follows, w)
        made = _made(key, q, w)
        with np.errstate(invalid="ignore"):
            w = np.where(right[:, m:] & (np.abs(printed - made) > allowed), made, printed)
    values = np.hstack([q, w])
    return None if np.array_equal(values, student.values, equal_nan=True) else replace(student, values=values, units=units)


def _marched(key: Key, student: StudentTable, right: Flags, follows: Flags, velocities: Array) -> tuple[Array, Array]:
    """Return coordinates (n, m) and digits; what is `right` or a misprint, and no step from above, is that step.

    A misprint is what follows from nothing, and from which nothing follows, between cells that do follow.
    """
    m, h = len(key.coordinates), key.step
    q, units = student.values[:, :m].copy(), student.units.copy()
    misprints = ~right & ~follows
    misprints[:-1] &= ~follows[1:]
    misprints[:-2] &= follows[2:]
    misprints[2:] &= (follows | right)[1:-1]
    for place in range(m):
        column, digits, rates = q[:, place].tolist(), units[:, place].tolist(), units[:, m + place].tolist()
        last = 0
        for row in (np.flatnonzero(right[1:, place] | misprints[1:, place]) + 1).tolist():
            if follows[row, place] and last < row - 1:
                continue
            moved = column[row - 1] + h * float(velocities[row - 1, place])
            doubt = digits[row] + digits[row - 1] + h * rates[row - 1]
            if abs(column[row] - moved) > HALF * doubt:
                column[row], digits[row], last = moved, doubt, row
        q[:, place], units[:, place] = column, digits
    return q, units


def _made(key: Key, q: Array, w: Array) -> Array:
    """Return the velocities (n, r) of coordinates (n, m); those of later blocks from the velocities (n, r) of earlier ones."""
    made, later = key.velocities_at(key.t, q), _later(key, key.t, np.hstack([q, w]))
    return np.where(np.isnan(later), made, later)


def _later(key: Key, t: Array, cells: Array) -> Array:
    """Return the velocities (n, r) of the later blocks from rows of `cells` (n, m + r), NaN for the first."""
    m = len(key.coordinates)
    found = np.full((len(cells), len(key.velocities)), np.nan)
    for index, block in enumerate(key.blocks[1:], start=1):
        found[:, [key.velocities.index(name) for name in block]] = key.block_at(index, t, cells[:, :m], cells[:, m:])
    return found


def _before_a_misprint(key: Key, student: StudentTable, own: OwnWays) -> Iterator[Way]:
    """Yield the velocities of the angles that the next row was made from, where the row prints others.

    An angle that is misprinted, or put right when all else is left as it was, is then one wrong cell and no more.
    """
    m = len(key.coordinates)
    values, made_from = student.values, student.values[:, :m].copy()
    broken = ~own.step.holds(values)[1:, :m] & np.isfinite(own.step.expected[1:, :m] + values[1:, :m])
    if broken.any():
        made_from[:-1][broken] = (values[1:, :m] - key.step * values[:-1, m : 2 * m])[broken]
        found = np.hstack([np.full_like(made_from, np.nan), key.velocities_at(key.t, made_from)])
        yield replace(own.angles, expected=found)


def _before_it_was_put_right(key: Key, student: StudentTable, right: Flags, own: OwnWays) -> Iterator[Way]:
    """Yield the velocities of a row from one cell as it was before it was put right, where several of them tell the same.

    From a coordinate all follow; from a velocity those of later blocks do.
    """
    m, values = len(key.coordinates), student.values

    def by_angles(rows: Places, cells: Array) -> Array:
        return key.velocities_at(key.t[rows], cells[:, :m])

    def by_velocities(rows: Places, cells: Array) -> Array:
        return _later(key, key.t[rows], cells)

    unexplained = ~(right | own.holds(values))[:, m:]
    first = [m + key.velocities.index(name) for block in key.blocks[:-1] for name in block]
    for way, places, made in ((own.angles, range(m), by_angles), (own.earlier, first, by_velocities)):
        with np.errstate(invalid="ignore"):
            away = (np.nan_to_num(np.abs((values - way.expected) / way.tolerance)) > 1.0)[:, m:] & unexplained
        for place in places:
            rows = np.flatnonzero(right[:, place] & (away.sum(axis=1) >= _AGREE))
            if len(rows):
                expected = np.full(values.shape, np.nan)
                expected[rows, m:] = _agreed(partial(made, rows), values[rows], place, away[rows], way.tolerance[rows, m:])
                expected[_beside(np.isfinite(expected).any(axis=1))] = np.nan
                yield replace(way, expected=expected)


def _beside(rows: Flags) -> Flags:
    """Return which rows stand beside another of them: what is so row by row was never otherwise."""
    beside = np.zeros_like(rows)
    beside[1:] |= rows[:-1]
    beside[:-1] |= rows[1:]
    return beside & rows


def _agreed(made: Callable[[Array], Array], cells: Array, place: int, away: Flags, tolerance: Array) -> Array:
    """Return the velocities (n, r) made from rows of `cells` with the one at a place as most that are `away` have it."""
    m = cells.shape[1] - away.shape[1]
    printed, moved = cells[:, m:], cells.copy()
    for _ in range(_ROUNDS):
        nearer = moved.copy()
        nearer[:, place] += _DIFFERENCE
        found = made(moved)
        slopes = np.where(away, np.nan_to_num((made(nearer) - found) / _DIFFERENCE / tolerance), 0.0)
        sizes = (slopes**2).sum(axis=1)
        off = np.where(away, np.nan_to_num((printed - found) / tolerance), 0.0)
        moved[:, place] += (slopes * off).sum(axis=1) / np.where(sizes > 0, sizes, np.inf)
    found = made(moved)
    with np.errstate(invalid="ignore"):
        agrees = away & (np.abs(printed - found) <= tolerance) & (slopes != 0)
    return np.where(agrees & (agrees.sum(axis=1, keepdims=True) >= _AGREE), found, np.nan)
