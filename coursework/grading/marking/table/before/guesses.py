"""What cells of a table may have been, told by the cells that were made from them.

Enters: a table, its ways, which cells are wrong.  Leaves: `StudentTable`s to be tried.  Used by `restored.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.made import as_it_was, beside_makers, made_from_rows, with_later
from coursework.grading.marking.table.ways import (
    HALF,
    LEAST,
    SLACK,
    OwnWays,
    Places,
    StudentTable,
    Way,
    as_printed,
    near,
    put_right,
)
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags

Counts = NDArray[np.intp]
# _AGREE: so many cells must agree on an earlier value.  FEW: if more than this part of the rows have wrong cells, only cells
# with the task's value may have been put right, and only in columns where few cells have it.
_AGREE, FEW = 2, 0.5
# Newton steps in the search for an earlier value, and the difference over which its slopes are taken.
_ROUNDS, _DIFFERENCE = 8, 1e-6
# An angle is searched for from so many places of a turn, as a misprint may lie anywhere; so many cells of a row are tried.
_AROUND, _TRIED = 8, 3


def guesses(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags, untold: Flags) -> Iterator[StudentTable]:
    """Yield tables of what rows may have been, given the `wrong` cells that are made from them.

    `other` marks cells that may have had another value, `untold` those of them that are not explained yet. For rows from which
    several wrong cells are made: all `other` coordinates as the next row has them; then one `other` cell with the value on
    which most cells agree, without and with the velocities that follow from it. Last, `untold` cells as the rows above make
    them, in all columns or in one coordinate.
    """
    m = len(key.coordinates)
    places = np.arange(untold.shape[1])
    rows, columns = makers_of_several(wrong, m), [places >= 0, *(places == place for place in range(m))]
    if rows.mean() > FEW:
        of_task = near(was.values, key.table, as_printed(key, was.units))
        other = other & put_right(of_task) & (np.arange(len(rows)) > 0)[:, None]  # row 1 is not put right
        rows &= other.any(axis=1)
        columns = columns[:1]  # so many wrong cells come from another method, not from one coordinate
    if rows.any():
        yield _by_next_row(key, was, other)
        for values in agreed(key, was, own, wrong, other & rows[:, None]):
            told = np.isfinite(values)
            alone = replace(was, values=np.where(told, values, was.values))
            yield alone
            if (guess := with_later(key, alone, other, told)) is not None:
                yield guess
    for some in columns:
        if (guess := as_it_was(key, was, untold & some, own)) is not None:
            yield guess


def makers_of_several(wrong: Flags, m: int) -> Flags:
    """Return the rows (n,) from which several `wrong` cells (n, m + r) are made."""
    return np.asarray(beside_makers(wrong, m).sum(axis=1) >= _AGREE)


def _by_next_row(key: Key, was: StudentTable, other: Flags) -> StudentTable:
    """Return the table with coordinates recomputed from broken steps to the next row: several in a row may be misprints."""
    m, h, guess = len(key.coordinates), key.stride, replace(was, values=was.values.copy(), units=was.units.copy())
    q, digits = guess.values[:-1, :m], guess.units[:-1, :m]
    made, doubt = was.values[1:, :m] - h * was.values[:-1, m : 2 * m], was.units[1:, :m] + h * was.units[:-1, m : 2 * m]
    with np.errstate(invalid="ignore"):
        broken = (np.abs(q - made) > HALF * (digits + doubt)) & other[:-1, :m]
    q[broken], digits[broken] = made[broken], doubt[broken]
    return guess


def agreed(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags) -> list[Array]:
    """Return tables (n, m + r) of what one cell in each row was, NaN elsewhere; the one on which most cells agree comes first.

    Each `wrong` cell gives a value for a cell that may have been `other`. That wrong cell, all others made from the same cell,
    and the cells it was made from leave it spans as wide as their tolerances; a value where most spans meet is taken.
    """
    m, r, printed = len(key.coordinates), len(key.velocities), was.values
    made = beside_makers(wrong & np.isfinite(printed), m)
    angles, earlier, step, true = (np.where(made, beside_makers(_open_by(key, way, printed), m), np.nan) for way in own.tried)
    tolerance = np.hstack([angles[:, :r], earlier[:, :r], step[:, r:], true[:, r:], true[:, r:]])
    cells = np.concatenate([np.tile(np.arange(r), 2), np.tile(r + np.arange(m), 3)])  # velocities two ways, steps three
    row, place, by = np.argwhere(other[:, :, None] & np.isfinite(tolerance)[:, None]).T
    if not len(row):
        return []
    x, again = _begun(key, printed, row, place, by)
    row, place, by = row[again], place[again], by[again]
    at, rows, beside = np.arange(len(row)), printed[row], beside_makers(printed, m)[row][:, cells]
    turning = _is_open(key, place, by)
    wild = turning & (np.abs(beside[at, by]) > key.ranges[m + cells[by] % r])

    def makes(x: Array) -> Array:
        rows[at, place] = x
        return made_from_rows(key, key.t[row], rows)

    with np.errstate(all="ignore"):
        for last in range(_ROUNDS + 1):
            if last == _ROUNDS:
                x = x - np.where(turning, whole_turns(x - key.table[row, place]), 0.0)
            found = makes(x)
            slopes, off = (makes(x + _DIFFERENCE) - found) / _DIFFERENCE, beside - found
            if last < _ROUNDS:  # near a singular position the reciprocal of a velocity is nearly linear
                straight = np.where(wild, (found / beside)[at, by], 1.0)
                x = x + np.nan_to_num(straight * off[at, by] / slopes[at, by], posinf=0.0, neginf=0.0)
        own_ways = [(way.expected[row, place], way.tolerance[row, place]) for way in own.tried]
        root = np.column_stack([x[:, None] + off / slopes, *(expected for expected, _ in own_ways)])
        spans = np.where(slopes != 0.0, tolerance[row] / np.abs(slopes), np.nan)
        half = np.column_stack([spans, *(open_by for _, open_by in own_ways)])
        cells = np.concatenate([cells, np.full(len(own_ways), r + m)])
        off, own_half = np.abs(root - x[:, None]), half[at, by]
        meet = off <= half + own_half[:, None]
        low, high = (np.max(np.where(meet, side * root - half, -np.inf), axis=1) * side for side in (1, -1))
        one = low <= high  # all of them meet in one place
        meet = np.where(one[:, None], meet, off <= half)
        x = np.where(one, np.clip(x, low, high), x)
        other_than = np.abs(x - printed[row, place]) > HALF * was.units[row, place]
        counts = np.sum([meet[:, cells == cell].any(axis=1) for cell in np.unique(cells)], axis=0)
        counts *= (off[at, by] <= own_half) & other_than
    far = np.where(turning, np.rint(np.abs(x - printed[row, place])), 0.0)
    return _ranked(printed.shape, (row, place, by >= 2 * r), x, counts, far, own_half)


def _begun(key: Key, printed: Array, row: Places, place: Places, by: Places) -> tuple[Array, Places]:
    """Return initial values of the search, and for which of the `row`, `place`, `by` each is; some have several.

    The search begins near the neighbours, as a misprint leads astray, at the next row's value, and for an angle all around.
    """
    m, after = len(key.coordinates), np.minimum(row + 1, len(printed) - 1)
    middle = np.median([printed[row - 1, place], key.table[row, place], printed[after, place]], axis=0)
    middle = np.where(np.isfinite(middle), middle, printed[row, place])
    below = np.where((place < m) & np.isfinite(printed[after, place]), printed[after, place], middle)
    turned = np.flatnonzero(_is_open(key, place, by))
    around = 2 * np.pi / _AROUND * np.arange(1, _AROUND)
    begun = np.concatenate([middle, below, *(middle[turned] + part for part in around)])
    return begun, np.concatenate([np.tile(np.arange(len(row)), 2), np.tile(turned, _AROUND - 1)])


def _is_open(key: Key, place: Places, by: Places) -> Flags:
    """Return where a cell is known only up to whole turns: an angle found from a velocity, but not one found from a step."""
    angles = [index for index, name in enumerate(key.coordinates) if key.variant.unit_of(name) == "rad"]
    return np.isin(place, angles) & (by < 2 * len(key.velocities))


def _open_by(key: Key, way: Way, printed: Array) -> Array:
    """Return the tolerances of a way scaled to the printed values: larger velocities are less certain, as is their slack."""
    least = LEAST * key.usual_ranges
    here, found = np.fmax(np.abs(printed), least), np.fmax(np.abs(way.expected), least)
    with np.errstate(divide="ignore", invalid="ignore"):
        open_by = np.where(here > found, way.tolerance * here / found, way.tolerance - SLACK * (found - here))
    open_by[:, : len(key.coordinates)] = way.tolerance[:, : len(key.coordinates)]
    return np.asarray(open_by)


def _ranked(
    shape: tuple[int, ...], at: tuple[Places, Places, Flags], x: Array, counts: Counts, far: Array, half: Array
) -> list[Array]:
    """Return tables of what was found: in each row first the cell on which most others agree, then the most exact one.

    `at` are the row and place of each value, and whether a step tells it or a velocity: a cell may have one value by each. If it
    has several with equal support, the one less `far` from the printed value is taken.
    """
    row, place, by_step = at
    best = np.lexsort((half, far, -counts))
    best = best[counts[best] >= _AGREE]
    _, first = np.unique((row[best] * shape[1] + place[best]) * 2 + by_step[best], return_index=True)
    best = best[first]
    tables = [np.full(shape, np.nan) for _ in range(_TRIED)]
    taken = np.zeros(shape[0], dtype=int)
    for one in best[np.lexsort((half[best], -counts[best]))].tolist():
        found, cell = taken[row[one]], (row[one], place[one])
        if found < _TRIED and not any(abs(table[cell] - x[one]) <= half[one] for table in tables[:found]):
            tables[found][cell] = x[one]
            taken[row[one]] += 1
    return tables[: max(taken, default=0)]
