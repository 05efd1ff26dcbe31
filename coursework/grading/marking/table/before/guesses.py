"""What cells of a table may have been, told by the cells that were made from them.

Enters: a table, its ways, which cells are wrong.  Leaves: `StudentTable`s to be tried.  Used by `restored.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.before.made import as_it_was, beside_makers, made_from_rows, with_later
from coursework.grading.marking.table.ways import HALF, OwnWays, StudentTable
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
    rows = beside_makers(wrong, m).sum(axis=1) >= _AGREE
    if not rows.any() or rows.mean() > _FEW:
        return
    yield _by_next_row(key, was, other)
    told = _agreed(key, was, own, wrong, other & rows[:, None])
    for values in told:  # in each row the cell first of which most speaks
        guess = replace(was, values=np.where(np.isfinite(values), values, was.values))
        yield guess
        later = with_later(key, guess, other, np.isfinite(values))
        if later is not None:
            yield later


def _by_next_row(key: Key, was: StudentTable, other: Flags) -> StudentTable:
    """Return the coordinates that broken steps to the next row were made from: several of a row may be misprints."""
    m, h, guess = len(key.coordinates), key.stride, replace(was, values=was.values.copy(), units=was.units.copy())
    q, digits = guess.values[:-1, :m], guess.units[:-1, :m]
    made, doubt = was.values[1:, :m] - h * was.values[:-1, m : 2 * m], was.units[1:, :m] + h * was.units[:-1, m : 2 * m]
    with np.errstate(invalid="ignore"):
        broken = (np.abs(q - made) > HALF * (digits + doubt)) & other[:-1, :m]
    q[broken], digits[broken] = made[broken], doubt[broken]
    return guess


def _agreed(key: Key, was: StudentTable, own: OwnWays, wrong: Flags, other: Flags) -> list[Array]:
    """Return tables (n, m + r) of what one cell a row was, NaN elsewhere; first the one on which most cells agree.

    Each `wrong` one made from it leaves it a span as wide as its own tolerance, and so does what it was made from: where most
    spans meet it may have been.
    """
    m, r, printed = len(key.coordinates), len(key.velocities), was.values
    beside = beside_makers(printed, m)
    beside[-1, r:] = np.nan
    made = beside_makers(wrong & np.isfinite(printed), m)
    angles, earlier, step, true = (np.where(made, beside_makers(way.tolerance, m), np.nan) for way in own.tried)
    step = np.where(np.isnan(step), true, step)
    tolerance = np.hstack([angles[:, :r], earlier[:, :r], step[:, r:], true[:, r:], true[:, r:]])
    cells = np.concatenate([np.tile(np.arange(r), 2), np.tile(r + np.arange(m), 3)])
    row, place, by = np.argwhere(other[:, :, None] & np.isfinite(tolerance)[:, None]).T
    if not len(row):
        return []
    after = np.minimum(row + 1, len(printed) - 1)
    middle = np.median([printed[row - 1, place], key.table[row, place], printed[after, place]], axis=0)
    here = printed[row, place]
    starts = [np.where(np.isfinite(middle), middle, here), np.where(np.isfinite(printed[after, place]) & (place < m), printed[after, place], here)]
    row, place, by = (np.tile(one, len(starts)) for one in (row, place, by))
    at, all_made = np.arange(len(row)), tolerance[row]
    x, target, t = np.concatenate(starts), beside[row][:, cells], key.t[row]

    def makes(x):
        moved = printed[row]
        moved[at, place] = x
        return made_from_rows(key, t, moved)

    with np.errstate(all="ignore"):
        for last in range(_ROUNDS + 1):
            found = makes(x)
            slopes = (makes(x + _DIFFERENCE) - found) / _DIFFERENCE
            off = target - found
            if last < _ROUNDS:
                x = x + np.nan_to_num(off[at, by] / slopes[at, by], posinf=0.0, neginf=0.0)
        half = np.where(slopes != 0.0, all_made / np.abs(slopes), np.nan)
        root = x[:, None] + off / slopes
        ways = [(way.expected[row, place], way.tolerance[row, place]) for way in own.tried]
        root = np.column_stack([root, *(one for one, _ in ways)])
        half = np.column_stack([half, *(one for _, one in ways)])
        cells = np.concatenate([cells, np.full(len(ways), r + m)])
        own_half = half[at, by]
        right = np.abs(root[at, by] - x) <= own_half
        meet = np.abs(root - x[:, None]) <= half + own_half[:, None]
        low = np.max(np.where(meet, root - half, -np.inf), axis=1)
        high = np.min(np.where(meet, root + half, np.inf), axis=1)
        joint = low <= high
        meet = np.where(joint[:, None], meet, np.abs(root - x[:, None]) <= half)
        x = np.where(joint & right, (low + high) / 2, x)
    counts = np.sum([meet[:, cells == cell].any(axis=1) for cell in np.unique(cells)], axis=0) * right
    tables: list[Array] = []
    best = np.argsort(-counts, kind="stable")
    best = best[counts[best] >= _AGREE]
    _, first = np.unique(row[best] * (m + r) + place[best], return_index=True)
    best = best[np.sort(first)]
    rank = np.zeros(len(printed), dtype=int)
    for one in best.tolist():
        k = rank[row[one]]
        rank[row[one]] += 1
        if k == len(tables):
            tables.append(np.full(printed.shape, np.nan))
        tables[k][row[one], place[one]] = x[one]
    return tables
