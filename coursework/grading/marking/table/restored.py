"""What stood in a table before a cell of it was misprinted or put right: the cells made from that follow from it still.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
A table is told by the fewest slips that explain it.  Each cell follows from what others were when it was made, or is a slip, and
costs one; what is printed is what a cell was, a misprint, which costs one, or the task's number, which costs nothing.  Whatever
explains a table explains it with any misprint put right too, at no more: so points never fall by a cell put right.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.ways import HALF, OwnWays, Places, StudentTable, Way, as_printed, near, own_ways
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen

Counts = NDArray[np.intp]
# What is found is set in, and what stands beside it looked for again; so is the march forward with the angles that it found.
_PASSES = 2
# So many cells must agree on what another was when they were made; what is so in nearly all rows was never otherwise.
_AGREE, _FEW = 2, 0.75
# How often what a cell was is mended until they do, with slopes over so small a part.
_ROUNDS, _DIFFERENCE = 5, 1e-6


@frozen
class Restored:
    """`ways` by which wrong cells are right from what others were; `fitted` (n, m + r) the wrong ones that say what these were.

    `before` is the table as it was, None where it is as it stands.
    """

    ways: tuple[Way, ...]
    fitted: Flags
    before: StudentTable | None


def restored(key: Key, student: StudentTable, wrong: Flags, right: Flags, own: OwnWays) -> Restored:
    """Return what makes `wrong` cells (n, m + r) right: what cells of their row, or of the row above, were.

    Those may be wrong, or the task's, put right.  What is `right` may have been what the rows above make of it; any other value
    is told by what was made from it, and costs a cell, as it did before it was put right.
    """
    m, put = len(key.coordinates), near(student.values, key.table, as_printed(key, student.units))
    other, sure, wrong = wrong | put, ~wrong & ~put, wrong & ~put
    was = printed = student
    told: Flags = np.zeros_like(wrong)
    coarse = own.coarse

    def worth(table: StudentTable, ways: OwnWays) -> Counts:
        """Return how many cells made from each row (n,) are right if a table stood there, without those that it costs."""
        held = ways.holds(printed.values)
        found = _made_from((speaking & held) * 1 - (sure & ~held), m).sum(axis=1)
        return np.asarray(found - _slips(table, student, ways))

    def made_by(table: StudentTable) -> OwnWays:
        """Return what a table makes; nothing is made with a velocity that is wrong, and was no other."""
        made = own_ways(key, table, coarse)
        idle = np.zeros_like(wrong)
        idle[1:, :m] = (wrong & ~_other(table, student))[:-1, m : 2 * m]
        step = made.step
        tolerance, expected = (np.where(idle, np.nan, values) for values in (step.tolerance, step.expected))
        return replace(made, step=replace(step, tolerance=tolerance, expected=expected))

    for _ in range(_PASSES):
        was = last = as_it_was(key, was, right & ~np.asarray(told.any(axis=1))[:, None], own) or was
        own, speaking, untold = made_by(last), wrong | told, other & ~told
        best = least = np.maximum(worth(last, own), 0)
        for base in (last, printed) if _touched(_made_from(speaking, m), printed, last) else (last,):
            ways = own if base is last else made_by(base)
            left = speaking & ~ways.holds(printed.values)
            for guess in _guesses(key, base, ways, left, other, untold):
                if not _touched(_made_from(left, m), guess, base):
                    continue
                found = worth(guess, made_by(guess))
                rows, best = np.asarray(found > best)[:, None], np.maximum(best, found)
                told = told | (rows & _other(guess, base))
                values, units = (np.where(rows, *both) for both in ((guess.values, was.values), (guess.units, was.units)))
                was = replace(was, values=values, units=units)
        if not (best > least).any():
            break
        own = made_by(was)
        printed = replace(student, values=np.where(told, was.values, student.values))
    made: Flags = _made_from(wrong & own.holds(student.values), m)
    fitted = made & (np.cumsum(made, axis=1) <= _slips(was, student, own)[:, None])
    return Restored(
        tuple(replace(way, expected=np.where(_made_into(made, m), way.expected, np.nan)) for way in own.tried),
        _made_into(fitted, m),
        was if _other(was, student).any() else None,
    )


def _slips(table: StudentTable, printed: StudentTable, ways: OwnWays) -> Counts:
    """Return how many cells of each row (n,) are other than they are printed, and do not follow from those before either."""
    return np.asarray((_other(table, printed) & ~ways.holds(table.values)).sum(axis=1))


def _other(table: StudentTable, than: StudentTable) -> Flags:
    return np.asarray((table.values != than.values) & np.isfinite(table.values))


def _touched(made: Flags, table: StudentTable, than: StudentTable) -> bool:
    """Return whether any cell `made` from a row (n, r + m) is made from one in which two tables differ."""
    return bool((made.any(axis=1) & _other(table, than).any(axis=1)).any())


def _made_from(cells: NDArray[Any], m: int) -> NDArray[Any]:
    """Return cells (n, r + m) beside the row that they are made from: its velocities, the coordinates of the next one."""
    return np.hstack([cells[:, m:], np.vstack([cells[1:, :m], np.zeros_like(cells[:1, :m])])])


def _made_into(cells: Flags, m: int) -> Flags:
    """Return cells (n, r + m) that stand beside the row that they are made from, where they stand, (n, m + r)."""
    return np.hstack([np.roll(cells[:, -m:], 1, axis=0), cells[:, :-m]])


def _guesses(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags, untold: Flags) -> Iterator[StudentTable]:
    """Yield what rows may have been where `wrong` cells are made from them.

    What is `untold` may be as the rows above make it.  Where several wrong cells are made from a row, it is one of the cells that
    were `other`, as most of them and the row above have it; or all its coordinates that were, as the next row has them.
    """
    if (guess := as_it_was(key, was, untold, own)) is not None:
        yield guess
    m = len(key.coordinates)
    rows = np.flatnonzero(_made_from(wrong, m).sum(axis=1) >= _AGREE)
    if not len(rows) or len(rows) > _FEW * len(wrong):
        return
    yield _by_next_row(key, was, other)
    later = [m + key.velocities.index(name) for block in key.blocks[:-1] for name in block]
    places = np.array([*dict.fromkeys([*range(2 * m), *later])])
    found, agree = _agreed(key, was, own, wrong, rows, places)
    agree = np.where(other[np.ix_(rows, places)].T, agree, 0)
    for place in np.argsort(-agree, axis=0, kind="stable"):  # in each row the cell first of which most speaks
        told = agree[place, np.arange(len(rows))] >= _AGREE
        if not told.any():
            return
        guess = replace(was, values=was.values.copy())
        guess.values[rows[told], places[place[told]]] = found[place[told], np.flatnonzero(told)]
        yield guess


def _by_next_row(key: Key, was: StudentTable, other: Flags) -> StudentTable:
    """Return the coordinates that broken steps to the next row were made from: several of a row may be misprints."""
    m, h, guess = len(key.coordinates), key.stride, replace(was, values=was.values.copy(), units=was.units.copy())
    q, digits = guess.values[:-1, :m], guess.units[:-1, :m]
    made, doubt = was.values[1:, :m] - h * was.values[:-1, m : 2 * m], was.units[1:, :m] + h * was.units[:-1, m : 2 * m]
    with np.errstate(invalid="ignore"):
        broken = (np.abs(q - made) > HALF * (digits + doubt)) & other[:-1, :m]
    q[broken], digits[broken] = made[broken], doubt[broken]
    return guess


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
    middle = np.median([beside[rows], key.table[rows], beside[rows + 2]], axis=0)  # a misprint leads astray
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
        half = np.where((np.abs(off) <= tolerance) & (slopes != 0.0), tolerance / np.abs(slopes), np.nan)
    low, high = (moved[at].reshape(shape) + side * half for side in (-1, 1))
    for way in own.tried:
        made, by = way.expected[rows].T[places, None], way.tolerance[rows].T[places, None]
        low, high = np.hstack([low, made - by]), np.hstack([high, made + by])
    cells = np.concatenate([np.tile(np.arange(r), 2), np.tile(r + np.arange(m), 2)])[used]  # each is made in two ways
    cells = np.concatenate([cells, np.full(len(own.tried), r + m)])
    meet = (low[:, :, None] <= low[:, None]) & (low[:, None] <= high[:, :, None])  # (place, span, where one begins, row)
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
