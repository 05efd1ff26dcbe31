"""Whether the written velocity equations say what the geometry of the file says.

Enters: written equations, those differentiated from [closure], positions on the closure.  Leaves: the names of the
equations that agree.  Raises `InputError` naming the one that does not.  Used by `way_to_motion.py`.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.closure import Closure, compile_closure
from coursework.system.arrays import Array, Flags
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

# Compared after scaling each row to its length: far above round-off, far below a wrong coefficient or sign.
TOLERANCE = 1e-8
_CONFIGURATIONS = 5
# Data taken at random: each its own value moved by up to half of the spread, no two by the same part.
_SPREAD, _GOLDEN = 0.02, 0.6180339887498949
_SMOOTH = (sp.sin, sp.cos, sp.tan, sp.exp)


def require_agreement(equations: VelocityEquations, closure: Closure | None) -> tuple[str, ...]:
    """Return the written equations that the geometry confirms; raises `InputError` naming the one that disagrees.

    Confirmed is an equation that follows from all the others: one that alone brings in an unknown velocity could have any
    coefficient.  What is confirmed whatever the data is found once for all variants of a template.
    """
    if closure is None or not equations.from_closure:
        return ()
    zeros = tuple(given.name for given in equations.variant.given if not given.value)
    always = equations.once(("agreed", zeros), lambda: _whatever_the_data(equations, closure))
    return _confirmed(equations, closure, *_configurations(closure)) if always is None else always


def _whatever_the_data(equations: VelocityEquations, closure: Closure) -> tuple[str, ...] | None:
    """Return what the geometry confirms for all data but zeros, None where that is not certain.

    Sums, products, sines and whole powers of the data that are equal for data taken at random are equal for all data.
    """
    variant = equations.variant
    if variant.functions or not _is_smooth(equations):
        return None
    given = tuple(
        replace(datum, value=datum.value * (1 + _SPREAD * (_GOLDEN * place % 1 - 0.5)))
        for place, datum in enumerate(variant.given, start=1)
    )
    with suppress(InputError):
        others = replace(equations, variant=replace(variant, given=given))
        near = compile_closure(others, closure.start.tolist())
        if near is not None and len((found := _configurations(near))[0]) == _CONFIGURATIONS:
            return _confirmed(others, near, *found)
    return None


def _is_smooth(equations: VelocityEquations) -> bool:
    """Return whether values at some data tell those at all others: not so with roots, sizes and the like."""
    both = (*equations.from_closure, *equations.equations)
    written = [position.expression for position in equations.positions]
    written += [part for equation in both for part in (*equation.coefficients.values(), equation.right_side)]
    parts = {part for expression in written for part in expression.atoms(sp.Function, sp.Pow)}
    return all(isinstance(part, _SMOOTH) or (isinstance(part, sp.Pow) and part.exp.is_Integer) for part in parts)


def _confirmed(equations: VelocityEquations, closure: Closure, times: Array, positions: Array) -> tuple[str, ...]:
    """Return what the geometry confirms, comparing values and Jacobian at several closed positions (c, m).

    Both are rows (A | b); the written ones must lie in the space the derived ones span together with the unknown
    velocities that only the written ones know.
    """
    _require_free(equations, times, positions)
    both = (*equations.from_closure, *equations.equations)
    first = len(equations.from_closure)
    matrix, right, _ = compile_system(equations, both).matrices(times, positions)
    every = np.concatenate([matrix, right[:, :, None]], axis=2)
    scale = np.max(np.abs(every), axis=1, keepdims=True, initial=0.0)
    every = every / np.where(scale > 0, scale, 1.0)
    lengths = np.linalg.norm(every, axis=2, keepdims=True)
    every = every / np.where(lengths > 0, lengths, 1.0)
    # Where the geometry alone cannot follow its drive there is a dead point, told as such.
    disagree = _contradictory(every) & ~_contradictory(every[:, :first])
    if not disagree.any():
        left = every[:, :, :-1]
        follow = _ranks(_each_left_out(left, first)) == _ranks(left)[:, None]
        return tuple(
            both[first + place].name for place in np.flatnonzero(follow.any(axis=0)).tolist() if both[first + place].written
        )
    suspects = set(range(first, len(both)))
    for culprits in _contradictory(_each_left_out(every[disagree], first)):
        suspects -= {first + place for place in np.flatnonzero(culprits).tolist()}
    file = equations.variant.file
    if not suspects:
        raise InputError([Fault(say("fault.V301"), file, equations.equations[0].line)])
    found = [both[index] for index in sorted(suspects)]
    if len(found) == 1:
        told = say("fault.V302", name=found[0].name)
    else:
        told = say("fault.V303", names="; ".join(f"{each.name} (:{each.line})" for each in found))
    raise InputError([Fault(told, file, found[0].line)])


def _require_free(equations: VelocityEquations, times: Array, positions: Array) -> None:
    """Raise `InputError` where what [closure] keeps or drives is moved otherwise by driven coordinates alone."""
    bound = [equation for equation in equations.from_closure if not equation.coefficients]
    if not bound:
        return
    faults = []
    rights = compile_system(equations, bound).matrices(times, positions)[1]
    for equation, largest in zip(bound, np.max(np.abs(rights), axis=0), strict=True):
        if largest > TOLERANCE:
            told = say("fault.V304", name=equation.name, largest=float(largest), because=equation.because)
            variant = equations.variant
            faults.append(Fault(told, variant.file, variant.line_of("closure")))
    if faults:
        raise InputError(faults)


def _each_left_out(rows: Array, first: int) -> Array:
    """Return the matrices (c, k, n) without one of their rows from `first` on, (c, k - first, k - 1, n)."""
    count = rows.shape[1]
    kept = [[row for row in range(count) if row != index] for index in range(first, count)]
    return rows[:, kept]


def _contradictory(rows: Array) -> Flags:
    """Return which of the systems (…, k, n), each with its right side in the last column, have no solution (…)."""
    return np.asarray(_ranks(rows) > _ranks(rows[..., :-1]))


def _ranks(matrices: Array) -> NDArray[np.int_]:
    """Return the ranks (…) of matrices (…, k, n)."""
    sizes = np.linalg.svd(matrices, compute_uv=False)
    largest = np.maximum(np.max(sizes, axis=-1, keepdims=True, initial=0.0), 1e-300)
    return np.asarray(np.sum(sizes > TOLERANCE * largest, axis=-1))


def _configurations(closure: Closure) -> tuple[Array, Array]:
    """Return times and positions near the start that close with the drive moved on; the start alone if none is found."""
    end = closure.equations.variant.time.end
    times = np.linspace(0.0, end / 50, _CONFIGURATIONS)
    kept, known = closure.targets(times)
    guess = np.tile(closure.start, (len(times), 1))
    guess[:, list(closure.driven)] = known
    try:
        q, closed = closure.newton_rows(times, guess, kept)
    except np.linalg.LinAlgError:
        closed = np.zeros(len(times), dtype=bool)
    count = int(np.argmin(closed)) if not closed.all() else len(times)
    return (times[:count], q[:count]) if count else (times[:1], closure.start[None])
