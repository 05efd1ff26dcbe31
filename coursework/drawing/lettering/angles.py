"""Angles that a file gives: the slope of a guide, the bend of a link, as an arc between two directions with its letter.

Enters: a `Painter` whose mechanism is drawn, and the `Mechanism`.  Leaves: thin arcs, and `Arc` for their letters.
Used by `drawing/figures.py`.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from coursework.drawing.outline.lengths import arm_base
from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.sheet import ITALIC, inside
from coursework.drawing.paper.symbols import name_word
from coursework.mechanism.mechanism import Mechanism
from coursework.variant.formula.tree import Formula, constant, terms

PEN = 'fill="none" stroke="black" stroke-width="0.15"'
LINE = 'stroke="black" stroke-width="0.15"'
RADII = (7.0, 9.0, 11.0, 13.5)  # mm, the first the best
FARTHER = 1.0  # mm of lines that an arc rather covers than having a radius 1 mm larger
PAST = 1.5  # mm: the line from which an angle is measured ends that far behind its arc
PIECE = 0.05  # rad of an arc that is drawn straight
CHORDS = 6  # so many does an arc count for where words are placed
ALONG = 0.02  # rad: a link that near to a direction shows it
SMALLEST = 0.03  # rad: a smaller angle is not seen


@dataclass(frozen=True, slots=True)
class Angle:
    """A datum `name` from the direction `begin` by `turn` (rad, as on the sheet) at one of the places `at`."""

    name: str
    at: tuple[complex, ...]
    begin: complex
    turn: float


@dataclass(frozen=True, slots=True)
class Arc:
    """The arc of a datum, through a few of its points; `out` is the direction away from where it turns."""

    name: str
    points: tuple[complex, ...]
    out: complex


def draw_angles(painter: Painter, mechanism: Mechanism) -> list[Arc]:
    """Draw the given angles, each once; return their arcs, for `angle_names`."""
    arcs: dict[str, Arc] = {}
    for angle in (*_slopes(painter, mechanism), *_bends(painter, mechanism)):
        if angle.name not in arcs and SMALLEST < abs(angle.turn) < math.tau and (arc := _place(painter, angle)):
            arcs[angle.name] = arc
    return list(arcs.values())


def angle_names(painter: Painter, arcs: Sequence[Arc]) -> None:
    """Write the letters of angles beside their arcs."""
    for arc in arcs:
        lines = list(itertools.pairwise(arc.points))
        middle = arc.points[len(arc.points) // 2]
        owner = Owner(lines, painter.sheet.heavy)
        painter.sheet.label(name_word(arc.name), [(middle, arc.out, 0.6), (middle, -arc.out, 0.6)], ITALIC, owner=owner)


def _slopes(painter: Painter, mechanism: Mechanism) -> Iterator[Angle]:
    """Yield the slopes of guides, fixed or of a link, from the direction that the rest of their formula says."""
    points = dict(painter.outline.points)
    for rail, (a, b) in painter.rails.items():
        toward = points[rail.toward]
        if toward.op == "+" and toward.args[1].op == "@":
            along = (b - a) / abs(b - a)
            yield from _angle(mechanism, toward.args[1].args[1], (a, a + 0.35 * (b - a)), along)
    for slot in painter.outline.slots:
        toward = points[slot.toward]
        if slot.toward.startswith("~"):  # made for the direction; a corner of a link says nothing of a slope
            way = painter.at[slot.toward] - painter.at[slot.base]
            yield from _angle(mechanism, toward.args[1].args[1], (painter.at[slot.at],), way / abs(way))


def _bends(painter: Painter, mechanism: Mechanism) -> Iterator[Angle]:
    """Yield the bends of links: E = D + r5 @ (phi3 + gamma)."""
    turning = {coordinate.name for coordinate in mechanism.variant.coordinates if coordinate.unit == "rad"}
    for name, formula in mechanism.points:
        base = next((base for coordinate in turning if (base := arm_base(formula, coordinate))), "")
        if base in painter.names and name in painter.names and painter.at[name] != painter.at[base]:
            way = painter.at[name] - painter.at[base]
            _, arm = terms(formula)
            yield from _angle(mechanism, arm.args[1], (painter.at[base],), way / abs(way))


def _angle(mechanism: Mechanism, formula: Formula, at: tuple[complex, ...], along: complex) -> Iterator[Angle]:
    """Yield the one datum of a direction, the rest of which is a coordinate or a number; the sheet turns the other way round."""
    given = {datum.name: datum.value for datum in mechanism.variant.given if datum.si == "rad"}
    parts = list(_signed(formula, 1))
    data = [(part.name, sign) for part, sign in parts if part.op == "name" and part.name in given]
    rest = [part for part, _ in parts if part.name not in given]
    if len(data) == 1 and all(_is_direction(part) for part in rest):
        [(name, sign)] = data
        turn = -sign * given[name]
        yield Angle(name, at, along * cmath.exp(-1j * turn), turn)


def _is_direction(part: Formula) -> bool:
    return part.op == "name" or constant(part) is not None or all(name == "pi" for name in part.names())


def _signed(formula: Formula, sign: int) -> Iterator[tuple[Formula, int]]:
    if formula.op in {"+", "-"}:
        yield from _signed(formula.args[0], sign)
        yield from _signed(formula.args[1], sign if formula.op == "+" else -sign)
    elif formula.op == "neg":
        yield from _signed(formula.args[0], -sign)
    else:
        yield formula, sign


def _place(painter: Painter, angle: Angle) -> Arc | None:
    """Draw an angle where its arc covers least; return the arc, None where there is no room."""
    sheet = painter.sheet
    best, chosen = math.inf, None
    for at in angle.at:
        for radius in RADII:
            count = max(2, math.ceil(abs(angle.turn) / PIECE))
            points = tuple(at + radius * angle.begin * cmath.exp(1j * angle.turn * k / count) for k in range(count + 1))
            sides = [way for way in (angle.begin, angle.begin * cmath.exp(1j * angle.turn)) if not _is_shown(painter, at, way)]
            lines = [(at, at + (radius + PAST) * way) for way in sides]
            ends = [line[1] for line in lines]
            if not all(inside(p - 0.01, p + 0.01, sheet.field) for p in (*points, *ends)):
                continue
            looked = [*points[2:-2], *ends, *((at + end) / 2 for end in ends)]
            squares = np.array([(p.real, p.imag) for p in looked]).reshape(-1, 2)
            cost = float(sheet.taken.covered(squares, 0.4, 0.4, sheet.field).sum()) / max(len(looked), 1) + FARTHER * radius
            if cost < best - 1e-9:
                best, chosen = cost, (at, points, lines)
    if chosen is None:
        return None
    at, points, lines = chosen
    for line in lines:
        sheet.line(*line, LINE)
    sheet.path(list(points), f'{PEN} data-angle="{"".join(name_word(angle.name))}"', blocks=False)
    few = points[:: max(1, len(points) // CHORDS)]
    sheet.segments += itertools.pairwise(few)
    return Arc(angle.name, few, few[len(few) // 2] - at)


def _is_shown(painter: Painter, at: complex, direction: complex) -> bool:
    """Return whether a link that begins at a place, or a fixed guide there, goes in a direction."""
    ways = [end - at for line in painter.sheet.heavy for end in line if at in line and end != at]
    ways += [b - at for a, b in painter.rails.values() if abs(at - a) + abs(b - at) < abs(b - a) + 0.01]
    return any(abs(cmath.phase(way / direction)) < ALONG for way in ways)


def segments_of(arcs: Sequence[Arc]) -> list[Segment]:
    """Return the arcs as short lines, which have words of their own."""
    return [line for arc in arcs for line in itertools.pairwise(arc.points)]
