"""The dead point of a class III group in the words of geometry: the lines of its three rods meet in one point.

Enters: velocity equations, the unknowns of a block, a singular position.  Leaves: a part of a sentence.  Used by `explain.py`.
A plate on three rods can turn a little about the point in which their lines meet, or be moved across them if they are parallel,
while the other ends of the rods stand still.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.system import compile_values
from coursework.system.arrays import Array
from coursework.variant.record.entries import Link
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_RODS = 3
# Share of the plate's size: lines that pass closer to one point meet there; the position is found to about 1e-10.
_MEET = 1e-6


def lines_meet(equations: VelocityEquations, unknowns: Sequence[str], time: float, position: Sequence[float]) -> Sentence | None:
    """Return that the lines of three rods of a plate meet at a `position` (m,), None if they do not or there is no such plate."""
    links = [link for link in equations.variant.links if link.rate in unknowns]
    for plate in (link for link in links if len(link.held) >= _RODS):
        rods = [link for link in links if len(link.held) == 2 and len({*link.held} & {*plate.held}) == 1]
        if len(rods) != _RODS:
            continue
        ends = np.array([_ends(rod, plate, equations, time, position) for rod in rods])
        lines = ends[:, 1] - ends[:, 0]
        lines = lines / np.linalg.norm(lines, axis=1)[:, None]
        arms = ends[:, 0] - ends[0, 0]
        size = float(np.max(np.linalg.norm(arms, axis=1)))
        if abs(np.linalg.det(np.column_stack([lines, _cross(arms, lines) / size]))) > _MEET:
            continue
        turned = max(abs(_cross(one, other)) for one in lines for other in lines)
        key = "determinant.rods_meet" if turned > _MEET else "determinant.rods_parallel"
        return say(key, rods=tuple(rod.name for rod in rods), plate=plate.name)
    return None


def _ends(rod: Link, plate: Link, equations: VelocityEquations, time: float, position: Sequence[float]) -> Array:
    """Return the ends (2, 2) of a rod in m, first the one on the plate."""
    names = sorted(rod.held, key=lambda name: name not in plate.held)
    parts = [part for name in names for part in equations.symbols.vectors[name]]
    return np.array(compile_values(equations, parts)[0](time, *position), dtype=float).reshape(2, 2)


def _cross(one: Array, other: Array) -> Array:
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])
