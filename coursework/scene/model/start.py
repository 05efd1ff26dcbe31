"""Where the motions of many data sets begin: groups assembled and closures closed for all sets at once.

Enters: a `Model` and `Data`.  Leaves: `Start`; a set that leaves any doubt is marked, never guessed.
Used by `sets.py` and `assigning/judge.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.symbolic import symbol
from coursework.mechanism.groups import CannotAssemble, group_kind
from coursework.motion.geometry.chain import dyad
from coursework.motion.geometry.closed_start import OPEN
from coursework.motion.geometry.start import START_TOLERANCE, kept_at_start
from coursework.scene.model.data import Data
from coursework.scene.model.model import Columns, Model
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags, as_columns
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Group

# Largest number of Newton corrections, and the size (rad, m) below which the last one is round-off.
_MOST, _SETTLED = 12, 1e-11


@frozen
class Start:
    """`begin` (m, n): where the rows begin; `closed` (m, n): where the true motion begins; `doubtful` (n,) sets."""

    begin: Array
    closed: Array
    doubtful: Flags


def start_of(model: Model, data: Data, numbers: Columns) -> Start:
    """Return the start of every set."""
    variant = model.variant
    begin = np.ascontiguousarray(data.start.T)
    doubtful: Flags = np.asarray(np.isnan(begin).any(axis=0))
    follow = model.follow(data.changed)
    if variant.groups:
        begin, doubtful = _by_groups(model, begin, numbers, follow)
        return Start(begin, begin, doubtful)
    rows = [position.expression for position in model.equations.positions if position.target == "zero"]
    free = [place for place, c in enumerate(variant.coordinates) if c.rate not in variant.known_rates]
    moved = [place for place in free if model.coordinates[place] in follow]
    kept = kept_at_start(model.equations, len(moved)) if moved else {}
    if kept:
        loops = [model.equations.positions[place].expression - value for place, value in kept.items()]
        begin, settled = close(model, 0.0, begin, numbers, moved, loops)
        doubtful = doubtful | ~settled
    if not rows:
        return Start(begin, begin, doubtful)
    lengths = [np.abs(data.given[given.name]) for given in variant.given if given.si == "m"]
    scale = np.max(lengths, axis=0, initial=0.0) if lengths else np.ones(data.count)
    residual = as_columns(model.compiled(tuple(rows))(0.0, *begin, *numbers), begin[0].shape)
    doubtful |= ~(np.max(np.abs(residual), axis=1) <= OPEN * np.where(scale > 0, scale, 1.0))
    closed, settled = close(model, 0.0, begin, numbers, free, rows)
    return Start(begin, closed, doubtful | ~settled)


def left_open(model: Model, begin: Array, numbers: Columns) -> Flags:
    """Return which sets (n,) begin with a loop open: more starts were set than the geometry leaves free."""
    loops = tuple(position.expression for position in model.equations.positions if position.closes)
    if not loops:
        return np.zeros(begin.shape[1], dtype=bool)
    residual = as_columns(model.compiled(loops)(0.0, *begin, *numbers), begin[0].shape)
    return np.asarray((np.abs(residual) > START_TOLERANCE).any(axis=1))


def close(
    model: Model, t: Any, q: Array, numbers: Columns, moved: list[int], positions: Sequence[Expression]
) -> tuple[Array, Flags]:
    """Return positions (m, n) at which `positions` are zero, by moving the coordinates `moved`, and if Newton converged (n,)."""
    names = [symbol(model.coordinates[place]) for place in moved]
    slopes = [model.equations.symbols.partial(expression, name) for expression in positions for name in names]
    function = model.compiled((*positions, *slopes))
    q = q.copy()
    k, f, n = len(positions), len(moved), q.shape[1]
    settled = np.zeros(n, dtype=bool)
    for _ in range(_MOST if f else 0):
        values = np.array([np.broadcast_to(value, n) for value in function(t, *q, *numbers)]).T
        residual, jacobian = values[:, :k], values[:, k:].reshape(n, k, f)
        step = _least(jacobian, -residual)
        q[moved] += step.T
        settled = np.max(np.abs(step), axis=1) < _SETTLED
        if settled[np.isfinite(step).all(axis=1)].all():
            break
    return q, settled | (f == 0)


def _least(matrix: Array, right: Array) -> Array:
    """Return the smallest x (n, f) for which matrix (n, k, f) x is nearest to right (n, k); nan if it is singular."""
    k, f = matrix.shape[1:]
    turned = np.swapaxes(matrix, 1, 2)
    square = matrix if k == f else matrix @ turned if k < f else turned @ matrix
    known = right if k <= f else (turned @ right[..., None])[..., 0]
    good: Flags = np.asarray(np.isfinite(square).all(axis=(1, 2)) & np.isfinite(known).all(axis=1))
    safe = np.where(good[:, None, None], square, np.eye(min(k, f)))
    regular: Flags = np.asarray(good & (np.linalg.det(safe) != 0.0))
    solved = np.linalg.solve(np.where(regular[:, None, None], safe, np.eye(min(k, f))), known[..., None])
    found = turned @ solved if k < f else solved
    return np.asarray(np.where(regular[:, None], found[..., 0], np.nan))


def of_rows(numbers: Columns, rows: NDArray[np.intp]) -> Columns:
    """Return the numbers of some of the sets."""
    return [number if np.ndim(number) == 0 else number[rows] for number in numbers]


def _by_groups(model: Model, begin: Array, numbers: Columns, follow: frozenset[str]) -> tuple[Array, Flags]:
    """Return the starts with the groups assembled; start values in the file must agree with them, or the set is doubtful."""
    variant = model.variant
    q = np.nan_to_num(begin)
    doubtful = np.zeros(q.shape[1], dtype=bool)
    for group in variant.groups:
        if group_kind(group.kind).driven:
            continue
        places = [model.coordinates.index(name) for name in group.coordinates]
        guesses = begin[places]
        found = _assembled(model, group, q, numbers, guesses, doubtful)
        for place, guess, values in zip(places, guesses, found, strict=True):
            coordinate = variant.coordinates[place]
            turned = values
            if coordinate.unit == "rad":
                turned = values + whole_turns(np.where(np.isnan(guess), values, guess) - values)
            if coordinate.start is not None and coordinate.name not in follow:
                doubtful |= ~(np.abs(guess - turned) <= START_TOLERANCE)
            q[place] = turned
    return q, doubtful | np.isnan(q).any(axis=0)


def _assembled(model: Model, group: Group, q: Array, numbers: Columns, guesses: Array, doubtful: Flags) -> Array:
    """Return the coordinates (k, n) of one dyad in the mode written, else in the mode nearest to the guesses."""
    if group.mode or not group_kind(group.kind).modes:
        return _in_mode(model, group, group.mode, q, numbers, doubtful)
    angles = np.array([[c.unit == "rad"] for name in group.coordinates for c in model.variant.coordinates if c.name == name])
    ways = [_in_mode(model, group, mode, q, numbers, doubtful) for mode in (1, -1)]
    gaps = np.array(ways) - guesses
    first, second = np.max(np.abs(np.where(angles, gaps - whole_turns(gaps), gaps)), axis=1)
    return np.where(first <= second, *ways)


def _in_mode(model: Model, group: Group, mode: int, q: Array, numbers: Columns, doubtful: Flags) -> Array:
    """Return the coordinates (k, n) of one dyad; sets that cannot be assembled are marked and get nan."""
    count = q.shape[1]
    kept = np.flatnonzero(~doubtful)

    def values(wanted: list[Expression]) -> Array:
        found = model.compiled(tuple(wanted))(0.0, *q[:, kept], *of_rows(numbers, kept))
        return np.array([np.broadcast_to(v, len(kept)) for v in found], dtype=float).T

    result = np.full((len(group.coordinates), count), np.nan)
    while len(kept):
        try:
            result[:, kept] = dyad(model.equations.symbols, group, mode, values).coordinates.T
            break
        except CannotAssemble as error:
            doubtful[kept[list(error.rows)]] = True
            kept = np.delete(kept, list(error.rows))
        except ValueError:
            doubtful[kept] = True
            break
    return result
