"""What cells of a table may have been, told by the cells that were made from them.

Enters: a table, its ways, which cells are wrong.  Leaves: `StudentTable`s to be tried.  Used by `restored.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.made import as_it_was, beside_makers, made_from_rows
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
    own_ways,
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
# How often coordinates are computed back from those of the next row.
_BACK = 4
# An angle is searched for from so many places of a turn, as a misprint may lie anywhere; so many cells of a row are tried.
_AROUND, _TRIED = 8, 3


def guesses(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags, untold: Flags) -> Iterator[StudentTable]:
    """Yield tables of what rows may have been, given the `wrong` cells that are made from them.

    `other` marks cells that may have had another value, `untold` those of them that are not explained yet: the former as those
    say that were made from them, then the latter as the rows above make them.
    """
    m = key.m
    makes, rows = np.asarray(beside_makers(wrong, m).any(axis=1)), makers_of_several(wrong, m)
    is_method = bool(rows.mean() > FEW)  # so many wrong cells come from another method, not from slips
    if is_method:
        of_task = near(was.values, key.table, as_printed(key, was.units))
        other = other & put_right(of_task) & (np.arange(len(rows)) > 0)[:, None]  # row 1 is not put right
        rows &= other.any(axis=1)
    # Rows in which one cell may tell what another was, as what follows from there makes cells of the next row right.
    alone = makes & np.append(makes[1:] & ~wrong[1:, m:].any(axis=1), False) & (makes.mean() <= FEW)
    if rows.any():  # several coordinates of a row may be misprints: as the next row has them
        values, rates = was.values.copy(), was.values[:, m : 2 * m]
        broken = (other & rows[:, None])[:-1, :m] & ~own.step.holds(was.values)[1:, :m]
        for place in range(_BACK):  # by the velocities as printed, then by those that the coordinates make
            if place:
                rates = np.where(other[:, m : 2 * m], key.velocities_at(key.t, values[:, :m])[:, :m], rates)
            back = was.values[1:, :m] - key.stride * rates[:-1]
            moved = broken & (np.abs(back - was.values[:-1, :m]) > was.units[:-1, :m])
            values[:-1, :m] = np.where(moved, back, was.values[:-1, :m])
            if place in (0, _BACK - 1):
                yield replace(was, values=values.copy())
    for some, least in ((rows, _AGREE), (alone, 1)):
        for values, units in agreed(key, was, own, wrong, other & some[:, None], least) if some.any() else ():
            told = np.isfinite(values)
            found = np.where(told, values, was.values), np.fmax(np.where(told, units, 0.0), was.units)
            yield (guess := replace(was, values=found[0], units=found[1]))
            if least == 1 or told[:, m:].any():
                yield as_it_was(key, guess, other & ~wrong & ~told, own_ways(key, guess, own.coarse)) or guess
    if above := as_it_was(key, was, untold, own):
        yield above
        for part in _parts(np.asarray(np.abs(above.values - was.values) > was.units), makes, m, alone=is_method):
            yield as_it_was(key, was, untold & part, own) or was


def _parts(moved: Flags, makes: Flags, m: int, *, alone: bool) -> Iterator[Flags]:
    """Yield coordinates, then rows, of which `moved` cells (n, m + r) are other alone, where a row `makes` wrong cells (n,).

    With `alone`, only single coordinates.
    """
    columns, rows = np.flatnonzero(moved[makes, :m].any(axis=0)), np.asarray(moved.any(axis=1))
    for count in range(1, 2 if alone else len(columns) + 1):
        yield from (np.isin(np.arange(moved.shape[1]), some) for some in combinations(columns.tolist(), count))
    # The lower one of two was made beside the upper one as it is printed.
    if not alone and (rows[:-1] & (rows & makes)[1:]).any():
        yield from (np.arange(len(rows))[:, None] % 2 == odd for odd in range(2))


def makers_of_several(wrong: Flags, m: int) -> Flags:
    """Return the rows (n,) from which several `wrong` cells (n, m + r) are made."""
    return np.asarray(beside_makers(wrong, m).sum(axis=1) >= _AGREE)


def agreed(
    key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags, least: int = _AGREE
) -> list[tuple[Array, Array]]:
    """Return tables (n, m + r) of what one cell in each row was, NaN elsewhere; the one on which most cells agree comes first.

    Each `wrong` cell gives a value for a cell that may have been `other`. That wrong cell, all others made from the same cell,
    and the cells it was made from leave it spans as wide as their tolerances; a value where most spans meet is taken. With it
    come the units of its last places, as wide as all cells that agree leave it open: no value in there makes any of them wrong.
    """
    m, r, printed = key.m, len(key.velocities), was.values
    made = beside_makers(wrong & np.isfinite(printed), m)
    angles, earlier, step, true = (np.where(made, beside_makers(_open_by(key, way, printed), m), np.nan) for way in own.tried)
    tolerance = np.hstack([angles[:, :r], earlier[:, :r], step[:, r:], true[:, r:], true[:, r:]])
    cells = np.concatenate([np.tile(np.arange(r), 2), np.tile(r + np.arange(m), 3)])  # velocities two ways, steps three
    row, place, by = np.argwhere(other[:, :, None] & np.isfinite(tolerance)[:, None]).T
    if not len(row):
        return []
    x, again = _begun(key, printed, row, place, by)
    row, place, by = row[again], place[again], by[again]
    at, beside = np.arange(len(row)), beside_makers(printed, m)[row][:, cells]
    rows, places, times = np.tile(printed[row], (2, 1)), np.tile(place, 2), np.tile(key.t[row], 2)
    turning = _is_open(key, place, by)
    wild = turning & (np.abs(beside[at, by]) > key.ranges[m + cells[by] % r])

    def makes(x: Array) -> tuple[Array, Array]:
        rows[np.arange(len(rows)), places] = np.concatenate([x, x + _DIFFERENCE])
        found, moved = np.split(made_from_rows(key, times, rows), 2)
        return found, (moved - found) / _DIFFERENCE

    with np.errstate(all="ignore"):
        for last in range(_ROUNDS + 1):
            if last == _ROUNDS:
                x = x - np.where(turning, whole_turns(x - key.table[row, place]), 0.0)
            found, slopes = makes(x)
            off = beside - found
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
        # Well within that place, as the spans are estimates.
        x = np.where(one, np.clip(x, (2 * low + high) / 3, (low + 2 * high) / 3), x)
        units = np.where(one, np.fmin(high - x, x - low), 0.0) / HALF
        other_than = np.abs(x - printed[row, place]) > HALF * was.units[row, place]
        counts = np.sum([meet[:, cells == cell].any(axis=1) for cell in np.unique(cells)], axis=0)
        counts *= (off[at, by] <= own_half) & other_than
    far = np.where(turning, np.rint(np.abs(x - printed[row, place])), 0.0)
    return _ranked(printed.shape, (row, place, by >= 2 * r), (x, units), np.where(counts < least, 0, counts), far, own_half)


def _begun(key: Key, printed: Array, row: Places, place: Places, by: Places) -> tuple[Array, Places]:
    """Return initial values of the search, and for which of the `row`, `place`, `by` each is; some have several.

    The search begins near the neighbours, as a misprint leads astray, at the next row's value, and for an angle all around.
    """
    m, after = key.m, np.minimum(row + 1, len(printed) - 1)
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
    open_by[:, : key.m] = way.tolerance[:, : key.m]
    return np.asarray(open_by)


def _ranked(
    shape: tuple[int, ...], at: tuple[Places, Places, Flags], found: tuple[Array, Array], counts: Counts, far: Array, half: Array
) -> list[tuple[Array, Array]]:
    """Return tables of what was found: in each row first the cell on which most others agree, then the most exact one.

    `at` are the row and place of each value, and whether a step tells it or a velocity: a cell may have one value by each. If it
    has several with equal support, the one less `far` from the printed value is taken.
    """
    row, place, by_step = at
    best = np.lexsort((half, far, -counts))
    best = best[counts[best] > 0]
    _, first = np.unique((row[best] * shape[1] + place[best]) * 2 + by_step[best], return_index=True)
    best = best[first]
    tables = [(np.full(shape, np.nan), np.full(shape, np.nan)) for _ in range(_TRIED)]
    x, units = found
    taken = np.zeros(shape[0], dtype=int)
    for one in best[np.lexsort((half[best], -counts[best]))].tolist():
        count, cell = taken[row[one]], (row[one], place[one])
        if count < _TRIED and not any(abs(table[cell] - x[one]) <= half[one] for table, _ in tables[:count]):
            tables[count][0][cell], tables[count][1][cell] = x[one], units[one]
            taken[row[one]] += 1
    return tables[: max(taken, default=0)]
