"""A `Stop` made from an event of the true motion, with its cause and its meaning for the mechanism.

Enters: an `Event`, the reduction.  Leaves: words with units.  Used by `way_to_motion.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from coursework.equations.algebra.expression import add
from coursework.equations.reduction.blocks import Block, Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.meaning import meaning as meaning_of
from coursework.equations.reduction.meaning import vanishing
from coursework.equations.reduction.tidying.tidy import as_sum
from coursework.motion.integration.motion import AT_EVENT, Stop, rows_before
from coursework.motion.integration.passage import Passage
from coursework.motion.singular.event import Event
from coursework.motion.singular.lines import dyad_straight, lines_meet
from coursework.variant.formula.made import as_read
from coursework.variant.record.held import unit_of
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

# Rounding limit: branches come from differences exact to 1e-10, coordinates from a better search.
_ROUNDING = 1e-9
# In an equation of velocities the numbers of the terms are near one; beyond this the whole equation was multiplied.
_MULTIPLIED = 10
# A slide longer than this multiple of the longest length has left every guide: two guides have become parallel.
_AWAY = 1e4


def explain(
    event: Event, equations: VelocityEquations, reduction: Reduction, step: float, branches: tuple[dict[str, float], ...] | None
) -> Stop:
    """Return the stop of a dead or change point; `step` (s) places it between rows.

    `branches` are the velocities possible there.  None means that there are none: the links close there but nowhere nearby, which
    is a dead point whatever the drive demands.
    """
    block = reduction.blocks[event.block]
    coordinates = {c.name: float(value) for c, value in zip(equations.variant.coordinates, event.position, strict=True)}
    row = event.time / step
    rows = rows_before(event.time, step)
    at_row = abs(row - rows) <= AT_EVENT * (1 + rows)
    where = say("event.at_row" if at_row else "event.between", time=event.time, row=rows + at_row, next=rows + 1)
    if not rows:
        where = say("event.at_start")
    which = _which(block, equations, coordinates)
    cause = joined([say("event.cause", where=where, unknowns=block.unknowns, which=which), _together(event, reduction)])
    holds = block.meaning
    if block.condition is not None:
        holds = meaning_of(block.condition, equations.variant, block.unknowns, coordinates)
        if holds == say("determinant.zero", formula=as_read(vanishing(block.condition, equations.variant, coordinates))):
            holds = dyad_straight(equations, block.unknowns, event.time, event.position.tolist()) or holds
        if holds == say("determinant.never"):  # nor is it, but as a slide runs away it becomes as small as anything
            holds = say("determinant.zero", formula=as_read(block.condition))
    elif (met := lines_meet(equations, block.unknowns, event.time, event.position.tolist())) is not None:
        holds = met
    kept = say("event.kept", row=rows) if rows else say("event.none_kept")
    if branches is None:
        event, branches = replace(event, kind="dead point"), ()
        locked = "event.locked_together" if len(equations.variant.drive) > 1 else "event.locked"
        meaning = say(locked, holds=holds, kept=kept)
    elif away := _away(coordinates, equations):
        event, branches = replace(event, kind="dead point"), ()
        meaning = say("event.away", holds=holds, names=away, kept=kept)
        coordinates = {name: value for name, value in coordinates.items() if name not in away}
    elif event.kind == "dead point":
        demanded = say(_unit(block, equations), value=event.demanded)
        meaning = say("event.dead", holds=holds, demanded=demanded, kept=kept)
    else:
        own = {one.name for one in equations.variant.coordinates if one.rate in block.unknowns}
        comes_anyway = block.condition is not None and own.isdisjoint(block.condition.names())
        is_removable = len(branches) == 1 or (not branches and comes_anyway)  # no other motion leads here
        key = "event.removable" if is_removable else "event.change"
        meaning = say(key, holds=holds, branches=_branches(branches), kept=kept)
    told = tuple(_tidied_rates(branch) for branch in branches)
    return Stop(
        event.kind, event.time, row, block.unknowns, {n: _tidied(q) for n, q in coordinates.items()}, cause, meaning, told
    )


def _away(coordinates: dict[str, float], equations: VelocityEquations) -> tuple[str, ...]:
    """Return the slides that grow without bound towards a singular position and so have no value there."""
    variant = equations.variant
    lengths = [abs(given.value) for given in variant.given if given.si == "m"]
    starts = [abs(c.start_or_guess) for c in variant.coordinates if c.unit == "m" and c.start_or_guess]
    longest = max([*lengths, *starts], default=1.0)
    return tuple(c.name for c in variant.coordinates if c.unit == "m" and abs(coordinates[c.name]) > _AWAY * longest)


def explain_passage(passage: Passage, equations: VelocityEquations, reduction: Reduction) -> str:
    """Return the sentence about a singular position that the motion passes through."""
    block, middle = reduction.blocks[passage.block], passage.middle
    coordinates = {c.name: float(value) for c, value in zip(equations.variant.coordinates, middle.position, strict=True)}
    which = _which(block, equations, coordinates)
    velocities = {name: middle.velocities[name] for name in block.unknowns}
    return say("event.passed", time=middle.time, unknowns=block.unknowns, which=which, branch=_velocities(velocities))


def _together(event: Event, reduction: Reduction) -> str:
    """Return how far the rank drops if several blocks become singular at once; empty for a single block."""
    others = [reduction.blocks[index] for index in event.together if index != event.block]
    if not others:
        return ""
    size = sum(block.size for block in reduction.blocks)
    names = [f"({', '.join(block.unknowns)})" for block in others[:3]] + ([say("event.others")] if len(others) > 3 else [])
    rank = size - len(event.together)
    return say("event.together", number=len(others), names=tuple(names), size=size, rank=rank)


def _unit(block: Block, equations: VelocityEquations) -> str:
    """Return the key for a velocity in m/s, or in the unit of the equations if they measure something else."""
    scalars = {constraint.name for constraint in equations.variant.constraints if constraint.is_closure}
    left = [add(*row.terms) for row in equations.equations if row.name in block.equations]
    numbers = [[abs(term.split()[0]) for term in one.terms] for one in left]
    plain = all(min(each) < _MULTIPLIED and max(each) * _MULTIPLIED > 1 for each in numbers)
    are_speeds = plain and all(unit_of(as_sum(one, equations.order), equations.variant) == "m" for one in left)
    return "event.in_m_per_s" if are_speeds and not scalars & set(block.equations) else "event.in_own_unit"


def _which(block: Block, equations: VelocityEquations, coordinates: dict[str, float]) -> str:
    """Return what is zero there, with its coordinates and their values; "" for a block without a formula."""
    if block.condition is None:
        return ""
    inside = block.condition.names()
    shown = []
    for coordinate in equations.variant.coordinates:
        if coordinate.name in inside:
            value = _tidied(coordinates[coordinate.name])
            key = "event.angle" if coordinate.unit == "rad" else "event.length"
            shown.append(say(key, name=coordinate.name, value=value, degrees=math.degrees(value)))
    equation = say("event.equation", equation=as_read(vanishing(block.condition, equations.variant, coordinates)))
    return joined([equation, say("event.with", values=tuple(shown)) if shown else ""], "join.nothing")


def _branches(branches: tuple[dict[str, float], ...]) -> str:
    told = [_velocities(branch) for branch in branches]
    if len(told) == 1:
        return say("event.one_branch", branch=told[0])
    return say("event.branches", told=joined(told, "join.or_else")) if told else ""


def _velocities(branch: Mapping[str, float]) -> Sentence:
    return joined(
        [say("event.velocity", name=name, value=value) for name, value in _tidied_rates(branch).items()], "join.numbers"
    )


def _tidied_rates(branch: Mapping[str, float]) -> dict[str, float]:
    fastest = max(map(abs, branch.values()), default=0.0)
    return {name: _tidied(value, fastest) for name, value in branch.items()}


def _tidied(value: float, size: float = 1.0) -> float:
    """Return a value (rad, m, or per second) with rounding errors around zero removed, which are a share of a `size`."""
    return 0.0 if abs(value) <= _ROUNDING * size else value
