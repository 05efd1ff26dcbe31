"""Whether the written velocity equations say what the geometry of the file says.

Enters: written equations, those differentiated from [closure], positions on the closure.  Leaves: the names of the
equations that agree.  Raises `InputError` naming the one that does not.  Used by `scene.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from coursework.errors import Fault, InputError
from coursework.geometry.closure import Closure
from coursework.reduction.equations import VelocityEquations
from coursework.reduction.system import compile_system
from coursework.sentences import say

Array = NDArray[np.float64]
# Compared after scaling each row to its length: far above round-off, far below a wrong coefficient or sign.
TOLERANCE = 1e-8
_CONFIGURATIONS = 5


def require_agreement(equations: VelocityEquations, closure: Closure | None) -> tuple[str, ...]:
    """Return the written equations that the geometry confirms, comparing values and Jacobian at several closed positions.

    Both are rows (A | b); the written ones must lie in the space the derived ones span together with the unknown
    velocities that only the written ones know.  Confirmed is an equation that follows from all the others: one that alone
    brings in an unknown velocity could have any coefficient.  Raises `InputError` naming the equation that disagrees.
    """
    if closure is None or not equations.from_closure:
        return ()
    _require_free(equations, closure)
    both = (*equations.from_closure, *equations.equations)
    system = compile_system(equations, both)
    first = len(equations.from_closure)
    suspects: set[int] | None = None
    confirmed: set[int] = set()
    every = np.array([np.column_stack(system.matrix(t, q)[:2]) for t, q in _configurations(closure)])
    scale = np.max(np.abs(every), axis=1, keepdims=True, initial=0.0)
    every = every / np.where(scale > 0, scale, 1.0)
    lengths = np.linalg.norm(every, axis=2, keepdims=True)
    every = every / np.where(lengths > 0, lengths, 1.0)
    # Where the geometry alone cannot follow its drive there is a dead point, told as such.
    disagree = _contradictory(every) & ~_contradictory(every[:, :first])
    for rows, inconsistent in zip(every, disagree.tolist(), strict=True):
        if not inconsistent:
            confirmed |= _following(rows[:, :-1], first)
            continue
        without = _contradictory(_each_left_out(rows, first))
        culprits = {first + place for place in np.flatnonzero(~without).tolist()}
        suspects = culprits if suspects is None else suspects & culprits
    if suspects is None:
        return tuple(both[index].name for index in sorted(confirmed) if both[index].written is not None)
    file = equations.variant.file
    if not suspects:
        raise InputError([Fault(say("fault.V301"), file, equations.equations[0].line)])
    found = [both[index] for index in sorted(suspects)]
    if len(found) == 1:
        told = say("fault.V302", name=found[0].name)
    else:
        told = say("fault.V303", names="; ".join(f"{each.name} (:{each.line})" for each in found))
    raise InputError([Fault(told, file, found[0].line)])


def _require_free(equations: VelocityEquations, closure: Closure) -> None:
    """Raise `InputError` where what [closure] keeps or drives is moved otherwise by driven coordinates alone."""
    bound = [equation for equation in equations.from_closure if not equation.coefficients]
    if not bound:
        return
    system = compile_system(equations, bound)
    faults = []
    rights = np.array([system.matrix(t, q)[1] for t, q in _configurations(closure)])
    for equation, largest in zip(bound, np.max(np.abs(rights), axis=0), strict=True):
        if largest > TOLERANCE:
            told = say("fault.V304", name=equation.name, largest=float(largest), because=equation.because)
            variant = equations.variant
            faults.append(Fault(told, variant.file, variant.line_of("closure")))
    if faults:
        raise InputError(faults)


def _following(rows: Array, first: int) -> set[int]:
    """Return which rows (k, n), from `first` on, follow from all the others."""
    return {first + place for place in np.flatnonzero(_ranks(_each_left_out(rows, first)) == _ranks(rows[None])).tolist()}


def _each_left_out(rows: Array, first: int) -> Array:
    """Return the matrix (k, n) without one of its rows from `first` on, (k - first, k - 1, n)."""
    return np.array([np.delete(rows, index, axis=0) for index in range(first, len(rows))]).reshape(
        -1, len(rows) - 1, rows.shape[1]
    )


def _contradictory(rows: Array) -> NDArray[np.bool_]:
    """Return which of the systems (r, k, n), each with its right side in the last column, have no solution."""
    return np.asarray(_ranks(rows) > _ranks(rows[:, :, :-1]))


def _ranks(matrices: Array) -> NDArray[np.int_]:
    """Return the ranks (r,) of matrices (r, k, n)."""
    sizes = np.linalg.svd(matrices, compute_uv=False)
    return np.asarray(np.sum(sizes > TOLERANCE * np.maximum(np.max(sizes, axis=1, initial=0.0), 1e-300)[:, None], axis=1))


def _configurations(closure: Closure) -> list[tuple[float, Sequence[float]]]:
    """Return the start and positions near it that close with the drive moved on; the start alone if none is found."""
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
    return list(zip(times[:count].tolist(), q[:count].tolist(), strict=True)) if count else [(0.0, closure.start.tolist())]
