"""What stood in a table before a cell of it was misprinted or put right: the cells made from that follow from it still.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
A right cell may stand among those of another motion.  Whatever it was before, what follows from it costs nothing now either:
where two cells or more agree on what another was when they were made, and more do than speak for what is printed there, they
are right.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.ways import HALF, OwnWays, StudentTable, Way, as_printed, near, own_ways
from coursework.system.arrays import Array, Flags

Places = NDArray[np.intp]
Counts = NDArray[np.intp]
# What is found is set in, and what stands beside it looked for again; so is the march forward with the angles that it found.
_PASSES = 2
# So many cells must agree on what another was when they were made; what is so in nearly all rows was never otherwise.
_AGREE, _FEW = 2, 0.75
# So many of the longest steps of its column it may lie from the rows beside.
_FAR = 4.0
# What a cell was is told by cells that it leaves no more open than so many times what is usual in their column.
_USUAL = 4.0
# How often what a cell was is mended until they do, with slopes over so small a part.
_ROUNDS, _DIFFERENCE = 5, 1e-6


def from_what_was(key: Key, student: StudentTable, wrong: Flags, own: OwnWays, before: StudentTable | None) -> Iterator[Way]:
    """Yield the ways to `wrong` cells (n, m + r) from what others were; `before` is the table as the rows above make it.

    A cell that is the task's may have been put right: it speaks neither for nor against what stood beside it.
    """
    put = near(student.values, key.table, as_printed(key, student.units))
    wrong = wrong & ~put
    if before is not None:
        above = own_ways(key, before, own.coarse).tried
        yield from above
        wrong = wrong & ~_held(above, student)
    m, was, usual = len(key.coordinates), student, _usual(own)
    as_it_stands = _held(own.tried, student)
    for _ in range(_PASSES):
        before = was
        for guess, fitted in _guesses(key, was, wrong):
            if not (_made_from(wrong & _likely(key, student, guess, usual), m) > fitted).any():
                continue
            tried = own_ways(key, guess, own.coarse).tried
            ways = [replace(way, expected=np.where(way.tolerance <= usual, way.expected, np.nan)) for way in tried]
            held = _held(ways, student)
            new, lost = wrong & held, (as_it_stands & ~held & ~put)[:, m:].sum(axis=1)
            rows = (_made_from(new, m) > fitted + lost) & new[:, m:].any(axis=1)
            if rows.any():
                made = np.zeros_like(wrong)
                made[rows, m:] = True
                made[1:, :m] = rows[:-1, None]
                yield from (replace(way, expected=np.where(made, way.expected, np.nan)) for way in ways)
                wrong = wrong & ~(new & made)
                was = replace(was, values=np.where(rows[:, None], guess.values, was.values))
        if was is before:
            return


def _usual(own: OwnWays) -> Array:
    """Return up to where tolerances are believed in each column (m + r,): some times the largest that is usual there."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # columns of which a way says nothing
        return np.asarray(_USUAL * np.fmax.reduce([np.nanmedian(way.tolerance, axis=0) for way in own.tried]))


def _likely(key: Key, student: StudentTable, guess: StudentTable, usual: Array) -> Flags:
    """Return which cells (n, m + r) may be right if the table was a guess: what is worth being worked out."""
    m, h, values = len(key.coordinates), key.stride, guess.values
    found, likely = key.velocities_at(key.t, values[:, :m]), np.zeros(values.shape, dtype=bool)
    for velocities in (found, _later(key, key.t, values)):
        likely[:, m:] |= near(student.values[:, m:], velocities, usual[m:])
    for rates in (found[:-1, :m], values[:-1, m : 2 * m]):
        likely[1:, :m] |= near(student.values[1:, :m], values[:-1, :m] + h * rates, usual[:m])
    return likely


def _held(ways: Sequence[Way], student: StudentTable) -> Flags:
    return np.asarray(np.any([way.holds(student.values) for way in ways], axis=0))


def _made_from(cells: Flags, m: int) -> Counts:
    """Return how many of some cells (n, m + r) are made from each row (n,): its velocities, the coordinates of the next one."""
    found = cells[:, m:].sum(axis=1)
    found[:-1] += cells[1:, :m].sum(axis=1)
    return np.asarray(found)


def _guesses(key: Key, was: StudentTable, wrong: Flags) -> Iterator[tuple[StudentTable, Counts]]:
    """Yield what rows may have been, and how many cells (n,) each of them was fitted to; as many prove nothing."""
    m = len(key.coordinates)
    if 0 < wrong[:, m:].any(axis=1).sum() <= _FEW * len(wrong):
        yield from _by_next_row(key, was, wrong)
        yield from _by_velocities(key, was, wrong)


def _by_next_row(key: Key, was: StudentTable, wrong: Flags) -> Iterator[tuple[StudentTable, Counts]]:
    """Yield the coordinates, and the velocities, that the steps to the next row were made from: all of a row, or one."""
    m, h = len(key.coordinates), key.stride
    q, w, after = was.values[:-1, :m], was.values[:-1, m : 2 * m], was.values[1:, :m]
    true = q
    for _ in range(_ROUNDS):
        true = after - h * key.velocities_at(key.t[:-1], true)[:, :m]
    digits, finer, next_digits = was.units[:-1, :m], was.units[:-1, m : 2 * m], was.units[1:, :m]
    with np.errstate(invalid="ignore"):
        broken = np.abs(after - q - h * w) > HALF * (digits + next_digits + h * finer)
    for chosen in dict.fromkeys([*((place,) for place in range(m)), tuple(range(m))]):
        here = np.zeros_like(broken)
        here[:, chosen] = broken[:, chosen]
        fitted = np.full(len(was.values), wrong.size)
        fitted[:-1][here.any(axis=1)] = (here & wrong[1:, :m]).sum(axis=1)[here.any(axis=1)]
        for first, made, units in (
            (0, after - h * w, next_digits + h * finer),
            (0, true, next_digits),
            (m, (after - q) / h, (digits + next_digits) / h),
        ):
            part = slice(first, first + m)
            guess = replace(was, values=was.values.copy(), units=was.units.copy())
            guess.values[:-1, part] = np.where(here, made, guess.values[:-1, part])
            guess.units[:-1, part] = np.where(here, units, guess.units[:-1, part])
            yield guess, fitted


def _by_velocities(key: Key, was: StudentTable, wrong: Flags) -> Iterator[tuple[StudentTable, Counts]]:
    """Yield each cell as the velocities of its row have it: all follow from a coordinate, later blocks from a velocity."""
    m = len(key.coordinates)
    rows = np.flatnonzero(wrong[:, m:].any(axis=1) & (_made_from(wrong, m) >= _AGREE))

    def by_coordinates(t: Array, cells: Array) -> Array:
        return key.velocities_at(t, cells[:, :m])

    first = [m + key.velocities.index(name) for block in key.blocks[:-1] for name in block]
    if len(rows):
        for places, made in ((range(m), by_coordinates), (first, partial(_later, key))):
            for place in places:
                guess = replace(was, values=was.values.copy())
                guess.values[rows, place] = _fitted(made, key.t[rows], was.values[rows], was.units[rows], wrong[rows, m:], place)
                fitted = np.full(len(wrong), wrong.size)
                fitted[rows[_beside(key, guess.values[:, place], was.values[:, place], place)[rows]]] = 1
                yield guess, fitted


def _beside(key: Key, guess: Array, printed: Array, place: int) -> Flags:
    """Return where a guess (n,) lies near what is printed in rows above or below: roots of chance lie anywhere."""
    far, near = _FAR * np.max(np.abs(np.diff(key.table[:, place])), initial=0.0), np.zeros(len(guess), dtype=bool)
    with np.errstate(invalid="ignore"):
        for by in (1, 2):
            close = np.abs(guess[by:] - printed[:-by]) <= far, np.abs(guess[:-by] - printed[by:]) <= far
            near[by:] |= close[0]
            near[:-by] |= close[1]
    return near


def _fitted(made: Callable[[Array, Array], Array], t: Array, cells: Array, units: Array, wrong: Flags, place: int) -> Array:
    """Return what most of the `wrong` velocities (n, r) in rows of `cells` (n, m + r) have the one at a place for (n,)."""
    count, r = wrong.shape
    m = cells.shape[1] - r
    one, printed = (np.arange(r * count), np.repeat(np.arange(r), count)), np.tile(cells[:, m:], (r, 1))
    times, moved = np.tile(t, r), np.tile(cells, (r, 1))
    for _ in range(_ROUNDS):
        nearer = moved.copy()
        nearer[:, place] += _DIFFERENCE
        found = made(times, moved)
        slopes = (made(times, nearer) - found) / _DIFFERENCE
        with np.errstate(divide="ignore", invalid="ignore"):
            moved[:, place] += np.nan_to_num(((printed - found) / slopes)[one], posinf=0.0, neginf=0.0)
    doubt = np.tile(units[:, m:], (r, 1)) + np.abs(slopes) * np.tile(units[:, [place]], (r, 1))
    with np.errstate(invalid="ignore"):
        agree = (np.abs(printed - made(times, moved)) <= doubt) & (slopes != 0)
    best = (agree & np.tile(wrong, (r, 1))).sum(axis=1).reshape(r, count).argmax(axis=0)
    return np.asarray(moved[:, place].reshape(r, count)[best, np.arange(count)])


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
    m, h = len(key.coordinates), key.stride
    q, units = student.values[:, :m].copy(), student.units.copy()
    for place in range(m):
        column, digits, rates = q[:, place].tolist(), units[:, place].tolist(), units[:, m + place].tolist()
        last = 0
        for row in (np.flatnonzero(right[1:, place]) + 1).tolist():
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
