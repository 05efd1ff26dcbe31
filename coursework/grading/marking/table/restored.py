"""What stood in a table before a cell of it was misprinted or put right: the cells made from that follow from it still.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
A right cell may stand among those of another motion.  Whatever it was before, what follows from it costs nothing now either:
where two cells or more agree on what another was when they were made, and more do than speak for what is printed there, they
are right.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from dataclasses import replace

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
_FAR = 2.0
# A span wider than this part of that step meets others by chance.
_NARROW = 0.2
# What a cell was is told by cells that it leaves no more open than so many times what is usual in their column.
_USUAL = 4.0
# How often what a cell was is mended until they do, with slopes over so small a part.
_ROUNDS, _DIFFERENCE = 5, 1e-6


def what_was(
    key: Key, student: StudentTable, wrong: Flags, own: OwnWays, before: StudentTable | None
) -> tuple[list[Way], StudentTable | None]:
    """Return the ways to `wrong` cells (n, m + r) from what others were, and the table as it was, None where it is as it was.

    `before` is the table as the rows above make it.  A cell that is the task's may have been put right: it speaks neither for
    nor against what stood beside it.
    """
    put = near(student.values, key.table, as_printed(key, student.units))
    may_be_other = wrong | put  # what is right as its row has it was never otherwise
    wrong, put_back = wrong & ~put, np.zeros_like(wrong)
    found: list[Way] = []
    if before is not None:
        found += own_ways(key, before, own.coarse).tried
        wrong = wrong & ~_held(found, student)
    m, was, usual, as_it_stands = len(key.coordinates), student, _usual(own), _held(own.tried, student)
    for _ in range(_PASSES):
        last, speaking = was, wrong | put_back
        for guess, fitted in _guesses(key, was, own, speaking, may_be_other):
            if not (_made_from(speaking & _likely(key, was, guess, usual), m) > fitted).any():
                continue
            tried = own_ways(key, guess, own.coarse).tried
            ways = [replace(way, expected=np.where(way.tolerance <= usual, way.expected, np.nan)) for way in tried]
            held = _held(ways, was)
            new, lost = (wrong | put_back) & held, (as_it_stands & ~held & ~put)[:, m:].sum(axis=1)
            rows = (_made_from(new, m) > fitted + lost) & new[:, m:].any(axis=1)
            if rows.any():
                made = np.zeros_like(wrong)
                made[rows, m:] = True
                made[1:, :m] = rows[:-1, None]
                found += (replace(way, expected=np.where(made, way.expected, np.nan)) for way in ways)
                wrong = wrong & ~(new & made)
                put_back |= rows[:, None] & (guess.values != was.values) & put
                was = replace(was, values=np.where(rows[:, None], guess.values, was.values))
        if was is last:
            break
        own = own_ways(key, was, own.coarse)
    if before is not None:
        was = replace(before, values=np.where(was.values != student.values, was.values, before.values))
    return found, None if was is student else was


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


def _guesses(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags) -> Iterator[tuple[StudentTable, Counts]]:
    """Yield what rows may have been, and how many cells (n,) each of them was fitted to; as many prove nothing.

    In each row it is one of the cells that were `other`, as most of the wrong ones made from it, and the row above, have it;
    or several, as the next row has them.
    """
    m = len(key.coordinates)
    spoiled, apart = wrong[:, m:].any(axis=1), np.zeros(len(wrong), dtype=bool)
    apart[1:] = ~_held((own.step, own.step_true), was)[1:, :m].all(axis=1)
    rows = np.flatnonzero(spoiled & (apart | (_made_from(wrong, m) >= _AGREE)))
    if not len(rows) or spoiled.sum() > _FEW * len(wrong):
        return
    yield _by_next_row(key, was, wrong)
    later = [m + key.velocities.index(name) for block in key.blocks[:-1] for name in block]
    places = np.array([*dict.fromkeys([*range(2 * m), *later])])
    found, agree = _agreed(key, was, own, wrong, rows, places)
    agree = np.where(other[np.ix_(rows, places)].T, agree, 0)
    every = np.arange(len(rows))
    for place in np.argsort(-agree, axis=0, kind="stable"):  # in each row the cell first of which most speaks
        if not (agree[place, every] >= _AGREE).any():
            return
        guess, at = replace(was, values=was.values.copy()), (rows, places[place])
        guess.values[at] = found[place, every]
        fitted = np.full(len(wrong), wrong.size)
        fitted[rows] = np.where(_beside(key, guess, was)[at], 1 - _held(own.tried, guess)[at], wrong.size)
        yield guess, fitted


def _by_next_row(key: Key, was: StudentTable, wrong: Flags) -> tuple[StudentTable, Counts]:
    """Return the coordinates that broken steps to the next row were made from: several of a row may be misprints."""
    m, h, guess = len(key.coordinates), key.stride, replace(was, values=was.values.copy(), units=was.units.copy())
    q, digits = guess.values[:-1, :m], guess.units[:-1, :m]
    made, doubt = was.values[1:, :m] - h * was.values[:-1, m : 2 * m], was.units[1:, :m] + h * was.units[:-1, m : 2 * m]
    with np.errstate(invalid="ignore"):
        broken = np.abs(q - made) > HALF * (digits + doubt)
    q[broken], digits[broken] = made[broken], doubt[broken]
    fitted = np.full(len(wrong), wrong.size)
    fitted[:-1][broken.any(axis=1)] = (broken & wrong[1:, :m]).sum(axis=1)[broken.any(axis=1)]
    return guess, fitted


def _beside(key: Key, guess: StudentTable, printed: StudentTable) -> Flags:
    """Return where guesses (n, m + r) lie near what is printed in rows above or below: roots of chance lie anywhere."""
    far, close = _FAR * _longest_steps(key), np.zeros(key.table.shape, dtype=bool)
    for by in (1, 2):
        close[by:] |= near(guess.values[by:], printed.values[:-by], far)
        close[:-by] |= near(guess.values[:-by], printed.values[by:], far)
    return close


def _longest_steps(key: Key) -> Array:
    """Return by how much each column (m + r,) changes from row to row at the most."""
    return np.asarray(np.max(np.abs(np.diff(key.table, axis=0)), axis=0, initial=0.0))


def _agreed(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, rows: Places, places: Places) -> tuple[Array, Counts]:
    """Return what the cells at some places of some rows (places, rows) were by as many others as can be, and by how many.

    Each `wrong` one made from it leaves it a span as wide as its own tolerance, and so does what it was made from: where most
    spans meet it may have been.
    """
    m, r = len(key.coordinates), len(key.velocities)
    after = np.minimum(rows + 1, len(was.values) - 1)

    def of(tables: Sequence[Array]) -> Array:
        """Return what is made from the rows, each cell in two ways, by the tables of the ways."""
        return np.hstack([table[rows, m:] for table in tables[:2]] + [table[after, :m] for table in tables[2:]]).T

    tolerance = of([np.where(wrong, way.tolerance, np.nan) for way in own.tried])
    tolerance[2 * r :, after == rows] = np.nan
    used = np.flatnonzero(np.isfinite(tolerance).any(axis=1))
    shape = (len(places), len(used), len(rows))
    printed, tolerance = of([was.values] * len(own.tried))[used], tolerance[used]
    one, at = np.indices(shape)[1].ravel(), (np.arange(np.prod(shape)), np.repeat(places, shape[1] * shape[2]))
    times, moved = np.tile(key.t[rows], shape[0] * shape[1]), np.tile(was.values[rows], (shape[0] * shape[1], 1))
    beside = np.pad(was.values, ((1, 1), (0, 0)), mode="reflect")
    middle = np.median([beside[rows + by] for by in range(3)], axis=0)  # a misprint leads astray
    middle = np.where(np.isfinite(middle), middle, was.values[rows])
    moved[at] = np.repeat(middle.T[places], shape[1], axis=0).ravel()
    with np.errstate(divide="ignore", invalid="ignore"):
        for last in range(_ROUNDS + 1):
            nearer = moved.copy()
            nearer[at] += _DIFFERENCE
            found = _made_from_rows(key, times, moved)[at[0], used[one]]
            slopes = ((_made_from_rows(key, times, nearer)[at[0], used[one]] - found) / _DIFFERENCE).reshape(shape)
            off = printed - found.reshape(shape)
            if last < _ROUNDS:
                moved[at] += np.nan_to_num(off / slopes, posinf=0.0, neginf=0.0).ravel()
        half = np.where(np.abs(off) <= tolerance, tolerance / np.abs(slopes), np.nan)
    low, high = (moved[at].reshape(shape) + side * half for side in (-1, 1))
    for way in own.tried:
        made, by = way.expected[rows].T[places, None], way.tolerance[rows].T[places, None]
        low, high = np.hstack([low, made - by]), np.hstack([high, made + by])
    cells = np.concatenate([np.tile(np.arange(r), 2), np.tile(r + np.arange(m), 2)])[used]  # each is made in two ways
    cells = np.concatenate([cells, np.full(len(own.tried), r + m)])
    meet = (low[:, :, None] <= low[:, None]) & (low[:, None] <= high[:, :, None])  # (place, span, where one begins, row)
    meet &= (high - low <= _NARROW * _longest_steps(key)[places, None, None])[:, :, None]
    counts = np.sum([meet[:, cells == cell].any(axis=1) for cell in np.unique(cells)], axis=0)
    best, (place, row) = counts.argmax(axis=1), np.ogrid[: shape[0], : shape[2]]
    to = np.min(np.where(meet[place, :, best, row], high.transpose(0, 2, 1), np.inf), axis=-1)
    return (low[place, best, row] + to) / 2, counts[place, best, row]


def _made_from_rows(key: Key, t: Array, rows: Array) -> Array:
    """Return what rows (n, m + r) make: their velocities, later ones from earlier ones, the next coordinates in both ways."""
    m, h = len(key.coordinates), key.stride
    velocities = key.velocities_at(t, rows[:, :m])
    steps = (rows[:, :m] + h * rates[:, :m] for rates in (rows[:, m:], velocities))
    return np.hstack([velocities, _later(key, t, rows), *steps])


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
    """Return coordinates (n, m) and digits; what is `right`, and no step from above, is that step."""
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
