"""Newton and Euler, link by link: the reactions in every joint and the drive of the mechanism, in all rows at once.

Enters: `Rows`.  Leaves: `Reactions`.  Computed on request only.
Used by `analysis.py`, `groups.py` and `misread.py`.

Three equations a body, two a pin that joins more than two links: m a_S = sum F, J eps = sum (p - S) x F + sum M.  A value that is
not unique (a support with more reactions than equations, or a dead point) is nan, never one arbitrary solution.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np

from coursework.effects.effects import Action, actions_of, wrenches
from coursework.effects.force_scheme import ForceScheme
from coursework.effects.rows import Rows
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen

# An unknown is unique if all null vectors have a component below this in it.
_NULL = 1e-9
# Largest condition number for which doubles can find a unique solution.
_SINGULAR = 1e13
_RANK, _CLOSED = 1e-11, 1e-6  # relative limits: for singular values, and for the residual of equations that can be satisfied


def places_of(scheme: ForceScheme) -> dict[str, int]:
    """Return the index of the first equation of each body, then of each pin."""
    count = 3 * len(scheme.bodies)
    bodies = {body.name: 3 * place for place, body in enumerate(scheme.bodies)}
    return bodies | {pin: count + 2 * place for place, pin in enumerate(scheme.pins)}


@frozen
class Reactions:
    """Reactions and drives: `names` of the unknowns and their values `rows` (n, names), N and N m, nan if they are not unique.

    `wrench` (n, bodies, 3) are the other forces, `matrix` (n, equations, names) holds the columns of the unknowns, `right`
    (n, equations) the right sides, both with moments divided by `length` (m); `condition` (n,) is the condition number.
    """

    names: tuple[str, ...]
    rows: Array
    wrench: Array
    matrix: Array
    right: Array
    condition: Array
    length: float
    partly: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    friction: tuple[Action, ...] = ()

    @property
    def largest(self) -> float:
        """Return the largest force (N, N m)."""
        found = np.abs(self.rows[np.isfinite(self.rows)])
        return float(found.max(initial=0.0))


def matrix_of(rows: Rows) -> Array:
    """Return the columns (n, equations, unknowns) of the unknowns; moments are about the centres of mass."""
    scheme, places = rows.scheme, places_of(rows.scheme)
    found = np.zeros((rows.count, 3 * len(scheme.bodies) + 2 * len(scheme.pins), len(scheme.unknowns)))
    centres = {body.name: rows.vector(body.centre) for body in scheme.bodies}
    for place, unknown in enumerate(scheme.unknowns):
        column, is_couple = found[..., place], unknown.direction.kind == "couple"
        unit = np.zeros(rows.count) if is_couple else rows.along(unknown)
        for name, sign in ((unknown.on, 1.0), (unknown.off, -1.0)):
            first = places.get(name)
            if first is None:
                continue  # the frame
            column[:, first] = sign * unit.real
            column[:, first + 1] = sign * unit.imag
            if is_couple:
                column[:, first + 2] = sign
            elif name in centres and unknown.at is not None:
                column[:, first + 2] = sign * (np.conj(rows.vector(unknown.at) - centres[name]) * unit).imag
    return found


def react(rows: Rows) -> Reactions:
    """Return every reaction and the drive of each row; with friction the fixed point, nan in rows where it does not converge."""
    found, friction = _ideal(rows, ()), rows.scheme.forces.friction
    if not friction:
        return found
    from coursework.effects.friction.friction import LEFT, MOST_ROUNDS, ROUNDS, SETTLED, friction_of

    ideal, before = found.largest, np.full(rows.count, np.inf)
    with np.errstate(over="ignore", invalid="ignore"):  # what does not converge grows without bound
        for count in range(MOST_ROUNDS):
            last, found = found, _ideal(rows, friction_of(rows, found.rows))
            change = np.abs(found.rows - last.rows).max(axis=1)
            share = change / np.maximum(np.abs(found.rows).max(axis=1), ideal or 1e-300)
            if (share <= SETTLED).all():
                return found
            if count % ROUNDS == 0 and count and not (2 * change < before)[~(share <= SETTLED)].any():
                break  # the remaining changes no longer shrink
            before = change if count % ROUNDS == 0 else before
    open_rows = ~(share <= LEFT)
    found.rows[open_rows] = np.nan  # self-locking: the drive cannot overcome the friction it causes
    return replace(found, friction=tuple(_unknown(action, open_rows) for action in found.friction))


def _unknown(action: Action, rows: Flags) -> Action:
    """Return an action set to nan in some rows."""
    force, couple = (None if of is None else np.where(rows, np.nan, of) for of in (action.force, action.couple))
    return replace(action, force=force, couple=couple)


def _ideal(rows: Rows, friction: tuple[Action, ...]) -> Reactions:
    """Return the reactions for known friction."""
    return replace(react_to(rows, (*actions_of(rows), *friction)), friction=friction)


def react_to(rows: Rows, actions: tuple[Action, ...]) -> Reactions:
    """Return the reactions to known forces and couples."""
    scheme, length, matrix = rows.scheme, rows.length, matrix_of(rows)
    wrench = wrenches(rows, actions)
    right = np.zeros(matrix.shape[:2])
    right[:, : 3 * len(scheme.bodies)] = -wrench.reshape(rows.count, 3 * len(scheme.bodies))
    moments = np.arange(2, 3 * len(scheme.bodies), 3)
    couples = np.array([one.direction.kind == "couple" for one in scheme.unknowns], dtype=bool)
    matrix[:, moments] /= length
    right[:, moments] /= length
    matrix[:, :, couples] *= length
    values, condition = solve(matrix, right)
    names, partly = tuple(one.name for one in scheme.unknowns), {}
    for place, (one, name) in enumerate(zip(scheme.unknowns, names, strict=True)):
        if one.direction.kind == "x" and np.isnan(values[:, place : place + 2]).any():
            partly[name.removesuffix("x")] = _across(
                matrix, right, np.asarray(np.isnan(values[:, place : place + 2]).all(axis=1)), place
            )
    values[:, couples] *= length
    return Reactions(names, values, wrench, matrix, right, condition, length, partly)


def solve(matrix: Array, right: Array) -> tuple[Array, Array]:
    """Return the unknowns (n, k), nan if they are not unique, and the condition (n,) of the matrices (n, m, k)."""
    count, m, k = matrix.shape
    if m == k:
        both = np.concatenate([right[..., None], np.broadcast_to(np.eye(m), matrix.shape)], axis=-1)
        try:
            found = np.linalg.solve(matrix, both)
        except np.linalg.LinAlgError:  # of a row that is singular to the last digit, the others are solved all the same
            regular, found = np.linalg.slogdet(matrix)[0] != 0, np.full(both.shape, np.nan)
            found[regular] = np.linalg.solve(matrix[regular], both[regular])
        condition = np.abs(matrix).sum(axis=1).max(axis=1) * np.abs(found[..., 1:]).sum(axis=1).max(axis=1)
        values = found[..., 0]
    else:
        values, condition = np.full((count, k), np.nan), np.full(count, np.inf)
    for row in np.flatnonzero(~(condition < _SINGULAR)).tolist():
        found, null = least(matrix[row], right[row])
        values[row] = np.where(np.abs(null).max(axis=0, initial=0.0) > _NULL, np.nan, found)
        condition[row] = np.inf
    return values, condition


def least(matrix: Array, right: Array) -> tuple[Array, Array]:
    """Return the least-norm solution (k,), nan if the equations have no solution, and the null vectors (r, k)."""
    u, sizes, v = np.linalg.svd(matrix)
    rank = int((sizes > sizes.max(initial=0.0) * _RANK).sum())
    found = v[:rank].T @ ((u.T[:rank] @ right) / sizes[:rank])
    if np.abs(matrix @ found - right).max(initial=0.0) > _CLOSED * np.abs(right).max(initial=0.0):
        found = np.full(len(found), np.nan)  # no force could hold it there
    return np.asarray(found), np.asarray(v[rank:])


def _across(matrix: Array, right: Array, rows: Flags, place: int) -> tuple[Array, Array]:
    """Return the unique component (n,) of the force in columns `place` and the next, and its angle (n,); nan if there is none."""
    value, angle = np.full(len(matrix), np.nan), np.full(len(matrix), np.nan)
    for row in np.flatnonzero(rows).tolist():
        found, null = least(matrix[row], right[row])
        _, sizes, v = np.linalg.svd(null[:, place : place + 2])
        if len(sizes) < 2 or sizes[1] < _NULL:
            across = v[1] if np.round(v[1, ::-1], 12).tolist() > [0.0, 0.0] else -v[1]  # upwards, or to the right
            value[row], angle[row] = across @ found[place : place + 2], np.arctan2(across[1], across[0])
    return value, angle
