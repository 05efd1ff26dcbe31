"""Which written equations do not fit the links, where no position equation judges them: the links move otherwise.

Enters: velocity equations, the start.  Leaves: their names.  Used by `analysis.py`, `turning.py`, `equations.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from coursework.equations.algebra.expression import MINUS, ZERO
from coursework.equations.reduction.bound import Speed, Turn
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.system import LinearSystem, compile_system
from coursework.motion.geometry.drives.drive import drive_values
from coursework.motion.geometry.judging.agreement import given_by_geometry, gives
from coursework.motion.geometry.judging.compared import depends_on_time, with_drives_on
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula
from coursework.variant.record.held import POWERS, largest_length, unit_of

# Shares of the largest term of an equation, and of all: above what start values with two digits leave open, below a wrong sign.
_LARGE, _OF_ALL = 0.05, 0.03
_RANK = 1e-6
_PLACES = 12  # positions along the run


def row_of(speed: Speed) -> VelocityEquation:
    """Return an equation whose residual (coefficients times velocities less the right side) is the given speed."""
    return VelocityEquation("", "", dict(speed.coefficients), -speed.rest)


def _shapes(equations: VelocityEquations) -> Iterator[Speed]:
    """Yield what is zero as links keep their shape and turn at their rates; arms that grow are left out."""
    bars = {link.slides for link in equations.variant.links}
    for turn in equations.geometry.turns():
        moving = _moving(turn)
        if not moving or (moving > 1 and turn.link not in bars):
            yield turn.named.plus(turn.found, MINUS)
            yield turn.grows


def _moving(turn: Turn) -> int:
    """Return in how many terms the arm of a link may grow: none if it keeps its length wherever the coordinates are."""
    return len(turn.grows.coefficients) + (turn.grows.rest is not ZERO)


def misfits(equations: VelocityEquations, times: Array, positions: Array) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the written equations that no position equation judges, and those of them that do not fit the links.

    Links keep their shape and turn at their rates: the first row (n, m) of some positions tells, for the velocities of that time
    and, where drives wait, of a time at which they move; if that leaves velocities open there, none is named as unfit.  Where
    links keep their shape wherever the coordinates are, the motion is followed from there: at zero a sine hides its sign.
    """
    derived, written = given_by_geometry(equations), [one for one in equations.equations if one.written]
    shapes = [*map(row_of, _shapes(equations))]
    system = compile_system(equations, [*derived, *shapes, *written])
    later = np.zeros(0) if depends_on_time(equations) else with_drives_on(equations, times[:1])
    tried_at, there = np.concatenate([times[:1], later]), np.repeat(positions[:1], len(later) + 1, axis=0)
    matrix, right, _ = system.matrices(tried_at, there)
    first = matrix.shape[1] - len(written)
    columns = equations.speed_units
    even, geometry = _even(matrix[:1], columns), slice(len(derived))
    open_rows = [place for place in range(len(written)) if not gives(even[:, geometry], even[0, first + place])]
    unjudged = tuple(written[place].name for place in open_rows)
    tried = open_rows if equations.positions else [*range(len(written))]  # what contacts give is judged with a closure only
    if _solved(matrix[0, :first], right[0, :first], columns) is None:
        return unjudged, ()
    if not equations.from_closure and len(derived) == len(equations.bound) and not any(map(_moving, equations.geometry.turns())):
        matrix, right, _ = system.matrices(*_followed(equations, system, first, tried_at, there))
    off, units = np.zeros(len(written), bool), _units(equations)
    for rows, sides in zip(matrix, right, strict=True):
        velocities, asked, wanted = _solved(rows[:first], sides[:first], columns), rows[first:], sides[first:]
        if velocities is None:
            continue
        largest = np.abs(np.column_stack([asked * velocities, wanted])).max(axis=1) / units
        least = np.maximum(_LARGE * largest, _OF_ALL * np.max(largest[tried], initial=0.0))
        off |= np.abs(asked @ velocities - wanted) / units > least
    return unjudged, tuple(written[place].name for place in tried if off[place])


def _units(equations: VelocityEquations) -> Array:
    """Return what counts as 1 in each written equation: 1 rad/s, or what the size of the mechanism makes of it, in m/s, m²/s …"""
    size, degrees = largest_length(equations.variant), {"rad": 0, "m": 1} | {unit: degree for degree, unit in POWERS.items()}
    sides = (one.written for one in equations.equations if one.written)
    return np.array([size ** degrees[unit_of(Formula("-", both), equations.variant)] for both in sides])


def _followed(
    equations: VelocityEquations, system: LinearSystem, first: int, times: Array, positions: Array
) -> tuple[Array, Array]:  # fmt: skip
    """Return the times (k,) and positions (k, m), and further ones along the motion that the `first` equations alone make.

    Each holds wherever the coordinates are, so how exactly the motion is followed does not matter.
    """
    variant, unknowns = equations.variant, equations.unknowns
    laws, columns = [law.name for law in variant.drive], equations.speed_units
    seen, q = [(times, positions)], positions[:1]
    for now, then in pairwise(np.linspace(times[0], variant.time.end, _PLACES + 1)[:, None]):
        (matrix,), (right,), _rest = system.matrices(now, q)
        velocities = _solved(matrix[:first], right[:first], columns)
        if velocities is None:
            break
        found = dict(zip([*unknowns, *laws], [*velocities, *drive_values(equations, laws, now)[0]], strict=True))
        q = q + (then - now) * np.array([found[one.rate] for one in variant.coordinates])
        seen.append((then, q))
    at, there = zip(*seen, strict=True)
    return np.concatenate(at), np.concatenate(there)


def _solved(matrix: Array, right: Array, columns: Array) -> Array | None:
    """Return the velocities that the equations determine, None if they leave one open or have no value."""
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        return None
    found, _, rank, _ = np.linalg.lstsq(_even(matrix, columns), right / _lengths(matrix * columns), rcond=_RANK)
    return np.asarray(found * columns, dtype=np.float64) if rank == matrix.shape[1] else None


def _even(matrix: Array, columns: Array) -> Array:
    """Return equations (…, n, k) of length 1 in unknowns of the units `columns` (k,): of micrometres and of kilometres alike."""
    return np.asarray(matrix * columns / _lengths(matrix * columns)[..., None])


def _lengths(matrix: Array) -> Array:
    sizes = np.linalg.norm(matrix, axis=-1)
    return np.where(sizes > 0, sizes, 1.0)
