"""An event of the true motion -> a `Stop` with its cause and its meaning for the mechanism.

Enters: an `Event`, the reduction.  Leaves: words with units.  Used by `motions.py`.
"""

from __future__ import annotations

import math

from coursework.dead_points.search import Event
from coursework.errors import listing
from coursework.formula.tree import spelled
from coursework.march.motion import AT_EVENT, Stop, rows_before
from coursework.reduction.blocks import Block, Reduction
from coursework.reduction.equations import VelocityEquations
from coursework.reduction.meaning import meaning as meaning_of
from coursework.reduction.meaning import vanishing

# Branches come from differences that are right to 1e-10, coordinates from a search that is better.
_ROUNDING = 1e-9


def explain(
    event: Event, equations: VelocityEquations, reduction: Reduction, step: float, branches: tuple[dict[str, float], ...] = ()
) -> Stop:
    """Return the stop of a dead or change point.  `step` (s) places it between rows; `branches` are velocities there."""
    block = reduction.blocks[event.block]
    coordinates = {c.name: float(value) for c, value in zip(equations.variant.coordinates, event.position, strict=True)}
    row = event.time / step
    rows = rows_before(event.time, step)
    at_row = abs(row - rows) <= AT_EVENT * (1 + rows)
    where = f"At t = {event.time:.6g} s, {f'at row {rows + 1}' if at_row else f'between rows {rows} and {rows + 1}'},"
    if not rows:
        where = "At the very first row, t = 0,"
    which = _equation(block, equations, coordinates) + _angles(block, equations, coordinates)
    cause = f"{where} the equations for {listing(block.unknowns)} become singular{which}.{_together(event, reduction)}"
    holds = block.meaning
    if block.determinant is not None:
        holds = meaning_of(block.determinant, equations.variant, block.equations, coordinates)
    kept = f"rows after row {rows} are not computed." if rows else "no row is computed."
    if event.kind == "dead point":
        meaning = (
            f"This is a dead point: {holds}. The drive asks for {event.demanded:.4g}{_unit(block, equations)} there in a "
            f"direction in which the links can give none, so the mechanism cannot follow it; {kept}"
        )
    elif len(branches) == 1:
        meaning = (
            f"This is a removable singularity: {holds}. The equations stay consistent but do not give the velocities here"
            f"{_branches(branches)}. The tool does not guess; {kept}"
        )
    else:
        meaning = (
            f"This is a change point: {holds}. The equations stay consistent, two motions meet here and nothing in "
            f"the data says which one follows{_branches(branches)}. The tool does not guess; {kept}"
        )
    return Stop(event.kind, event.time, row, block.unknowns, coordinates, cause, meaning, branches)


def _together(event: Event, reduction: Reduction) -> str:
    """Say how far the rank drops where several blocks become singular at once."""
    others = [reduction.blocks[index] for index in event.together if index != event.block]
    if not others:
        return ""
    size = sum(block.size for block in reduction.blocks)
    names = listing([f"({', '.join(block.unknowns)})" for block in others[:3]] + (["others"] if len(others) > 3 else []))
    rank = size - len(event.together)
    return f" {len(others)} more block(s) do so together with it, {names}: the rank drops from {size} to {rank}."


def _unit(block: Block, equations: VelocityEquations) -> str:
    """Return " m/s" unless the equations are a scalar closure, whose unit is the author's."""
    scalars = {constraint.name for constraint in equations.variant.constraints if constraint.is_closure}
    return " (in the unit of its equation)" if scalars & set(block.equations) else " m/s"


def _equation(block: Block, equations: VelocityEquations, coordinates: dict[str, float]) -> str:
    if block.determinant is None:
        return ""
    return f": {spelled(vanishing(block.determinant, equations.variant, coordinates))} = 0"


def _angles(block: Block, equations: VelocityEquations, coordinates: dict[str, float]) -> str:
    """Name the coordinates in the determinant with their values there."""
    inside = block.determinant.names() if block.determinant is not None else ()
    shown = []
    for coordinate in equations.variant.coordinates:
        if coordinate.name in inside:
            value = _tidied(coordinates[coordinate.name])
            shown.append(
                f"{coordinate.name} = {value:.6g} rad = {math.degrees(value):.2f}°"
                if coordinate.unit == "rad"
                else f"{coordinate.name} = {value:.6g} m"
            )
    return f", with {listing(shown)}" if shown else ""


def _branches(branches: tuple[dict[str, float], ...]) -> str:
    told = [", ".join(f"{name} = {_tidied(value):.6g}" for name, value in branch.items()) for branch in branches]
    if len(told) == 1:
        return f"; one motion only goes on with the drive, with {told[0]}"
    return f": either {'; or '.join(told)}" if told else ""


def _tidied(value: float) -> float:
    """Return a value with what rounding leaves of a zero taken off (rad, m, or per second)."""
    return 0.0 if abs(value) < _ROUNDING else value
