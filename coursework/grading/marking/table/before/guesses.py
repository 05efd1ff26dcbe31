"""What cells of a table may have been, told by the cells that were made from them.

Enters: a table, its ways, which cells are wrong.  Leaves: `StudentTable`s to be tried.  Used by `restored.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.before.made import as_it_was, beside_makers, made_from_rows
from coursework.grading.marking.table.ways import HALF, OwnWays, Places, StudentTable
from coursework.system.arrays import Array, Flags

Counts = NDArray[np.intp]
# So many cells must agree on what another was when they were made; what is so in nearly all rows was never otherwise.
_AGREE, _FEW = 2, 0.75
# How often what a cell was is mended until they do, with slopes over so small a part.
_ROUNDS, _DIFFERENCE = 5, 1e-6


def guesses(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags, untold: Flags) -> Iterator[StudentTable]:
    """Yield what rows may have been where `wrong` cells are made from them.

    What is `untold` may be as the rows above make it.  Where several wrong cells are made from a row, it is one of the cells that
    were `other`, as most of them and the row above have it; or all its coordinates that were, as the next row has them.
    """
    if (guess := as_it_was(key, was, untold, own)) is not None:
        yield guess
    m = len(key.coordinates)
    rows = np.flatnonzero(beside_makers(wrong, m).sum(axis=1) >= _AGREE)
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
            found = made_from_rows(key, times, moved)[at[0], used[one]]
            slopes = ((made_from_rows(key, times, nearer)[at[0], used[one]] - found) / _DIFFERENCE).reshape(shape)
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
