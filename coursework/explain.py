"""An event of the true motion -> a `Stop` with its cause and its meaning for the mechanism.

Enters: an `Event`, the reduction.  Leaves: words with units.  Used by `quantities.py`.
"""

from __future__ import annotations

import math

from coursework.dead_point import Event
from coursework.equations import VelocityEquations
from coursework.errors import listing
from coursework.formula import spelled
from coursework.meaning import vanishing
from coursework.motion import Stop
from coursework.reduction import Block, Reduction


def explain(
    event: Event, equations: VelocityEquations, reduction: Reduction, step: float, branches: tuple[dict[str, float], ...] = ()
) -> Stop:
    """Return the stop of a dead or change point.  `step` (s) places it between rows; `branches` are velocities there."""
    block = reduction.blocks[event.block]
    coordinates = {c.name: float(value) for c, value in zip(equations.variant.coordinates, event.position, strict=True)}
    row = event.time / step
    last = math.floor(row) + 1
    where = f"At t = {event.time:.6g} s, between rows {last} and {last + 1},"
    if event.time <= 1e-12:
        where = "At the very first row, t = 0,"
    which = _equation(block, equations) + _angles(block, equations, coordinates)
    cause = f"{where} the equations for {listing(block.unknowns)} become singular{which}."
    if event.kind == "dead point":
        meaning = (
            f"This is a dead point: {block.meaning}. The drive asks for {event.demanded:.4g} m/s there in a direction in which "
            f"the links can give none, so the mechanism cannot follow it. Rows after row {last} are not computed."
        )
    else:
        meaning = (
            f"This is a change point: {block.meaning}. The equations stay consistent, two motions meet here and nothing in "
            f"the data says which one follows{_branches(branches)}. The tool does not guess; rows after row {last} "
            "are not computed."
        )
    return Stop(event.kind, event.time, row, block.unknowns, coordinates, cause, meaning, branches)


def _equation(block: Block, equations: VelocityEquations) -> str:
    if block.determinant is None:
        return ""
    return f": {spelled(vanishing(block.determinant, equations.variant))} = 0"


def _angles(block: Block, equations: VelocityEquations, coordinates: dict[str, float]) -> str:
    """Name the coordinates in the determinant with their values there."""
    inside = block.determinant.names() if block.determinant is not None else ()
    shown = []
    for coordinate in equations.variant.coordinates:
        if coordinate.name in inside:
            value = coordinates[coordinate.name]
            shown.append(
                f"{coordinate.name} = {value:.6g} rad = {math.degrees(value):.2f}°"
                if coordinate.unit == "rad"
                else f"{coordinate.name} = {value:.6g} m"
            )
    return f", with {listing(shown)}" if shown else ""


def _branches(branches: tuple[dict[str, float], ...]) -> str:
    told = [", ".join(f"{name} = {value:.6g}" for name, value in branch.items()) for branch in branches]
    return f": either {'; or '.join(told)}" if told else ""
