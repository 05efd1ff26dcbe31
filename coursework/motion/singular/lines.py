"""The lines of links at a dead point: a dyad that is stretched, or three rods of a plate that meet in one point.

Enters: velocity equations, the unknowns of a block, a position or the flow.  Leaves: sentences.
Used by `explain.py` and `commands/check.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, product

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.system import compile_values
from coursework.motion.geometry.closure import Closure
from coursework.motion.singular.scaled_flow import Flow
from coursework.system.arrays import Array, cross
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import evaluate
from coursework.variant.record.entries import Link, reached
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

_RODS = 3
# Share of the plate's size: lines that pass closer to one point meet there; the position is found to about 1e-10.
_MEET = 1e-6
# Positions at which a determinant is compared with lines; shares by which their ratio may differ, and both must: round-off.
_LOOKS, _SAME, _MOVES = 5, 1e-9, 1e-6


@frozen
class _Lines:
    """What is zero where lines of links make a dead point: `crossed` of the places (n, 2) of the points `parts`, in m^2 or m^3.

    `size` is the same for lines at right angles.  `told` says what the lines do, in general or where they are `parallel`.
    """

    parts: Sequence[Expression]
    crossed: Callable[[Array], float]
    size: Callable[[Array], float]
    told: Sentence
    parallel: Sentence | None = None
    turned: Callable[[Array], float] = lambda places: 1.0

    def places(self, equations: VelocityEquations, time: float, position: Sequence[float]) -> Array:
        """Return the points (n, 2) in m."""
        found = compile_values(equations, [*self.parts])[0](time, *position)
        return np.array(found, dtype=float).reshape(-1, 2)


def lines_meet(equations: VelocityEquations, unknowns: Sequence[str], time: float, position: Sequence[float]) -> Sentence | None:
    """Return that the lines of three rods of a plate meet at a `position` (m,), None if they do not or there is no such plate.

    The plate can then turn a little about that point, or be moved across the lines if they are parallel, while the other ends of
    the rods stand still: the dead point of a class III group.  A guide for a point of the plate stands for a rod across it.
    """
    return _at(_plates(equations, unknowns), equations, time, position)


def dyad_straight(
    equations: VelocityEquations, unknowns: Sequence[str], time: float, position: Sequence[float]
) -> Sentence | None:
    """Return that two links lie on one line at a `position` (m,) whose joint moves with the `unknowns` and whose ends do not.

    It needs no angles: in a linkage whose points move by x and y the determinant is a sum that nobody recognises.
    """
    return _at(_dyads(equations, unknowns), equations, time, position)


def always_told(flow: Flow, closure: Closure | None, place: int, block: Block) -> Sentence | None:
    """Return what lines do wherever the determinant of a block (its `place` among all) is zero; None if none is known.

    It is so if the determinant is a multiple of theirs, at closed positions or, where none are known, at any.
    """
    equations = flow.equations
    begin = np.array(flow.begin)
    shares = np.array([[0.618 * row * (i + 1) % 1.0 for i in range(len(begin))] for row in range(1, _LOOKS + 1)])
    times, positions = np.zeros(_LOOKS), begin + 0.5 * shares * np.where(begin, np.abs(begin), 1.0)
    if closure is not None and closure.complete:
        times, positions = closure.configurations
    try:
        wanted = np.array([flow.scaled(t, q)[place] for t, q in zip(times.tolist(), positions.tolist(), strict=True)])
        for lines in (*_dyads(equations, block.unknowns), *_plates(equations, block.unknowns)):
            looked = zip(times.tolist(), positions.tolist(), strict=True)
            crossed = np.array([lines.crossed(lines.places(equations, t, q)) for t, q in looked])
            is_same = np.ptp(wanted / crossed) <= _SAME * np.max(np.abs(wanted / crossed))
            if is_same and np.ptp(crossed) > _MOVES * np.max(np.abs(crossed)):
                return lines.told if lines.parallel is None else joined([lines.told, lines.parallel], "join.or_else")
    except (ArithmeticError, ValueError):
        return None
    return None


def _at(every: Iterator[_Lines], equations: VelocityEquations, time: float, position: Sequence[float]) -> Sentence | None:
    for lines in every:
        places = lines.places(equations, time, position)
        if abs(lines.crossed(places)) <= _MEET * lines.size(places):
            return lines.parallel if lines.parallel is not None and lines.turned(places) <= _MEET else lines.told
    return None


def _plates(equations: VelocityEquations, unknowns: Sequence[str]) -> Iterator[_Lines]:
    """Yield the lines of each plate on three rods whose rates are among the `unknowns`."""
    variant, vectors = equations.variant, equations.symbols.vectors
    links = [link for link in equations.variant.links if link.rate in unknowns]
    for plate in (link for link in links if len(link.held) >= _RODS):
        rods = [link for link in links if len(link.held) == 2 and len({*link.held} & {*plate.held}) == 1]
        held = {name for rod in rods for name in rod.held}
        rails = [(at.name, way) for at, way in variant.frame.rails if at.name in {*plate.held} - held][: _RODS - 2]
        if len(rods) + len(rails) != _RODS:
            continue
        angle = evaluate(rails[0][1], variant.values) if rails else None
        names = [name for rod in rods for name in _ends(rod, plate)] + [name for name, _ in rails]

        def lines_of(places: Array, angle: float | None = angle) -> tuple[Array, Array]:
            if angle is not None:  # across the guide
                places = np.concatenate([places, [places[-1] + (-math.sin(angle), math.cos(angle))]])
            ends = places.reshape(_RODS, 2, 2)
            return ends[:, 1] - ends[:, 0], ends[:, 0] - ends[0, 0]

        def crossed(places: Array, of: Callable[[Array], tuple[Array, Array]] = lines_of) -> float:
            lines, arms = of(places)
            return float(np.linalg.det(np.column_stack([lines, cross(arms, lines)])))

        def size(places: Array, of: Callable[[Array], tuple[Array, Array]] = lines_of) -> float:
            lines, arms = of(places)
            return float(np.prod(np.linalg.norm(lines, axis=1)) * np.max(np.linalg.norm(arms, axis=1)))

        def turned(places: Array, of: Callable[[Array], tuple[Array, Array]] = lines_of) -> float:
            lines = of(places)[0]
            lines = lines / np.linalg.norm(lines, axis=1)[:, None]
            return float(max(abs(cross(one, other)) for one in lines for other in lines))

        parts = [part for name in names for part in vectors[name]]
        known = {"rods": tuple(rod.name for rod in rods), "plate": plate.name}
        known |= {"point": rails[0][0]} if rails else {}
        meet, parallel = (say(f"determinant.{'guide' if rails else 'rods'}_{way}", **known) for way in ("meet", "parallel"))
        yield _Lines(parts, crossed, size, meet, parallel, turned)


def _dyads(equations: VelocityEquations, unknowns: Sequence[str]) -> Iterator[_Lines]:
    """Yield the lines of each two links whose joint moves with the `unknowns` and whose ends do not."""
    variant, vectors = equations.variant, equations.symbols.vectors
    moved = {one.name for one in variant.coordinates if one.rate in unknowns}
    places = dict(variant.points)
    loose = {name for name in vectors if moved & {name, *reached([name], places)}}

    def lines_of(points: Array) -> Array:
        return np.asarray(points[1:] - points[0])

    for first, second in combinations(variant.links, 2):
        for joint in sorted({*first.held} & {*second.held} & loose):
            for here, there in product(*([name for name in link.held if name not in loose] for link in (first, second))):
                parts = [part for name in (joint, here, there) for part in vectors[name]]
                named = (say("determinant.link", name=link.name) for link in (first, second))
                told = say("determinant.one_line", first=next(named), second=next(named))
                yield _Lines(
                    parts, lambda points: float(cross(*lines_of(points))),
                    lambda points: float(np.prod(np.linalg.norm(lines_of(points), axis=1))), told,
                )  # fmt: skip


def _ends(rod: Link, plate: Link) -> list[str]:
    """Return the points of a rod, first the one on the plate."""
    return sorted(rod.held, key=lambda name: name not in plate.held)
