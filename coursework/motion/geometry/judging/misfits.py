"""Which written equations do not fit the links, where no position equation judges them: at the start the links move otherwise.

Enters: velocity equations, the start.  Leaves: their names.  Used by `analysis.py`, `turning.py`, `equations.py`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from coursework.equations.algebra.expression import MINUS, ZERO
from coursework.equations.reduction.bound import Speed
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.judging.agreement import given_by_geometry, gives
from coursework.system.arrays import Array

# Shares of the largest term of an equation, and of all: above what start values with two digits leave open, below a wrong sign.
_LARGE, _OF_ALL = 0.05, 0.03
_RANK = 1e-6


def row_of(speed: Speed) -> VelocityEquation:
    """Return an equation whose residual (coefficients times velocities less the right side) is the given speed."""
    return VelocityEquation("", "", dict(speed.coefficients), -speed.rest)


def _shapes(equations: VelocityEquations) -> Iterator[Speed]:
    """Yield what is zero as links keep their shape and turn at their rates; arms that grow are left out."""
    bars = {link.slides for link in equations.variant.links}
    for turn in equations.geometry.turns():
        moving = len(turn.grows.coefficients) + (turn.grows.rest is not ZERO)
        if not moving or (moving > 1 and turn.link not in bars):
            yield turn.named.plus(turn.found, MINUS)
            yield turn.grows


def misfits(equations: VelocityEquations, times: Array, positions: Array) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the written equations that no position equation judges, and those of them that do not fit the links.

    Links keep their shape and turn at their rates: the first row (n, m) of some positions tells; if that leaves velocities open
    there, none is named as unfit.
    """
    derived, written = given_by_geometry(equations), [one for one in equations.equations if one.written]
    shapes = [*map(row_of, _shapes(equations))]
    matrix, right, _ = compile_system(equations, [*derived, *shapes, *written]).matrices(times[:1], positions[:1])
    first = matrix.shape[1] - len(written)
    known, asked, wanted = matrix[0, :first], matrix[0, first:], right[0, first:]
    open_rows = [place for place in range(len(written)) if not gives(matrix[:, : len(derived)], asked[place])]
    unjudged = tuple(written[place].name for place in open_rows)
    tried = open_rows if equations.positions else [*range(len(written))]  # what contacts give is judged with a closure only
    if np.linalg.matrix_rank(known, _RANK) < known.shape[1]:
        return unjudged, ()
    velocities = np.linalg.lstsq(known, right[0, :first], rcond=None)[0]
    largest = np.abs(np.column_stack([asked * velocities, wanted])).max(axis=1)
    least = np.maximum(_LARGE * largest, _OF_ALL * np.max(largest[tried], initial=0.0))
    off = np.abs(asked @ velocities - wanted) > least
    return unjudged, tuple(written[place].name for place in tried if off[place])
