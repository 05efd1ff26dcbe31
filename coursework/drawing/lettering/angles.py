"""Angles as arcs between two directions, with letters: those that a file gives, and coordinates in the sense of their value.

The given ones are slopes of guides and bends of links.  A coordinate has an arrow at its end; its arc says data-angle="phi1".
Enters: a `Painter` whose mechanism is drawn, and the `Mechanism`.  Leaves: thin arcs, and `Arc` for their letters.
Used by `drawing/figures.py`.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from coursework.drawing.lettering.turns import Turn, turns
from coursework.drawing.outline.lengths import arm_base
from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.sheet import ITALIC, Word, inside, plain
from coursework.drawing.paper.symbols import angle_word
from coursework.mechanism.mechanism import Mechanism
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, constant, signed, terms

PEN = 'fill="none" stroke="black" stroke-width="0.15"'
LINE = 'stroke="black" stroke-width="0.15"'
RADII = (7.0, 9.0, 11.0, 13.5)  # mm, the first is the best
FARTHER = 1.0  # mm of covered lines: price of a radius 1 mm larger
PAST = 1.5  # mm: the side of an angle ends this far beyond its arc
PIECE = 0.05  # rad: an arc is drawn in straight pieces of at most this angle
CHORDS, CHORD = 6, 0.5  # when words are placed an arc counts as at least this many chords, or one per this angle (rad)
ALONG, REACHED = 0.02, 0.9  # rad: a link this near to a direction shows it, if it is at least this part of the radius long
SMALLEST = 0.03  # rad: smaller angles are not drawn
AROUND = (5.0, 6.0, 7.5, 9.0, 11.0, 13.5, 17.0, 21.0, 26.0)  # mm: radii for the arcs of coordinates
HIDDEN = 20.0  # mm of covered lines: price of an arrow that ends in a hinge, or of an angle 0 whose axis no link shows
RING = 1.25  # mm: the side of an angle begins this far from its joint
MISTAKEN = 14.0  # mm of covered lines: price of a letter that could be taken for another angle's
HEAD, ROOM = 1.7, 3.0  # mm: arrow head of a coordinate, and length of an arc that shows it well
TOO_SHORT = 6.0  # mm of covered lines: price of each mm by which an arc is shorter than ROOM
OVER, LONGER = 3.0, 0.5  # arcs of coordinates are often long: weight of what they cover, price of each mm of length
SENSE = 0.6  # rad: an angle that is 0 gets an arc of this size, which only shows its positive sense
NOUGHT = 1e-9  # rad
PARTS = (0.5, 0.75, 0.25, 0.9)  # parts of an arc's length at which its letter may stand
ONE = 1e-6  # mm: places this near to each other are one


@frozen
class Angle:
    """The angle `name` from the direction `begin` by `turn` (rad, in the sense of the sheet), drawn at one of the places `at`.

    A coordinate is `counted` from an axis and has an arrow at its end; `tail` is written behind its name.
    """

    name: str
    at: tuple[complex, ...]
    begin: complex
    turn: float
    counted: bool = False
    tail: str = ""


@frozen
class Arc:
    """The arc of an angle, by a few of its points, about the place `at`; `word` names it, its `sides` are drawn as lines."""

    word: Word
    points: tuple[complex, ...]
    at: complex
    sides: tuple[Segment, ...]


def draw_angles(painter: Painter, mechanism: Mechanism, values: Mapping[str, float] | None = None) -> list[Arc]:
    """Draw each given angle once; return the arcs, for `angle_names`.

    With `values` of the coordinates (rad, m), those coordinates that are angles are drawn too.
    """
    arcs: dict[str, Arc] = {}
    for angle in (*_slopes(painter, mechanism), *_bends(painter, mechanism)):
        if angle.name not in arcs and SMALLEST < abs(angle.turn) < math.tau and (arc := _place(painter, angle, RADII)):
            arcs[angle.name] = arc
    for angle in _coordinates(painter, mechanism, values) if values is not None else ():
        if arc := _place(painter, angle, AROUND):
            arcs[angle.name] = arc
    return list(arcs.values())


def room_of_angles(painter: Painter, mechanism: Mechanism, values: Mapping[str, float]) -> Iterator[tuple[complex, float]]:
    """Yield the places (m) about which coordinates turn, each with the radius (mm) that a small arc around it takes."""
    for turn in _turns(painter, mechanism, values):
        yield from ((at, AROUND[1] + PAST) for at in turn.at[:1])


def _coordinates(painter: Painter, mechanism: Mechanism, values: Mapping[str, float]) -> Iterator[Angle]:
    """Yield the coordinates that are angles as they appear on the sheet, whose y points down."""
    for turn in _turns(painter, mechanism, values):
        places = tuple(_known(painter, painter.put(at)) for at in turn.at)
        value = values[turn.coordinate]
        if -math.pi < value < -SMALLEST:  # the short way, against its sense, as its value says
            yield Angle(turn.coordinate, places, turn.axis.conjugate(), -turn.sense * value, counted=True, tail=" < 0")
        elif SMALLEST < turn.size < math.tau - SMALLEST:  # nearly a whole turn counts as nearly 0
            yield Angle(turn.coordinate, places, turn.axis.conjugate(), -turn.sense * turn.size, counted=True)
        else:
            tail = " = 0" if min(turn.size, math.tau - turn.size) < NOUGHT else " ≈ 0"
            yield Angle(turn.coordinate, places, turn.axis.conjugate(), -turn.sense * SENSE, counted=True, tail=tail)


def _turns(painter: Painter, mechanism: Mechanism, values: Mapping[str, float]) -> Iterable[Turn]:
    return turns(mechanism, {**mechanism.variant.values, "pi": math.pi, **values, **painter.place})


def _known(painter: Painter, at: complex) -> complex:
    """Return the named point at a place of the sheet, the place itself if there is none."""
    return next((point for point in painter.at.values() if abs(point - at) < ONE), at)


def angle_names(painter: Painter, arcs: Sequence[Arc], near: Sequence[Segment]) -> None:
    """Write the letters of angles beside their arcs; lines in `near` have words of their own."""
    for arc in arcs:
        lines = list(itertools.pairwise(arc.points))
        beside = [arc.points[round(part * (len(arc.points) - 1))] for part in PARTS]
        places = [(at, way * (at - arc.at), 0.6) for at in dict.fromkeys(beside) for way in (1, -1)]
        others = [line for other in arcs if other is not arc for line in (*itertools.pairwise(other.points), *other.sides)]
        painter.sheet.label(
            arc.word, places, ITALIC, owner=Owner(lines, [*painter.sheet.heavy, *others, *near], mistaken=MISTAKEN)
        )


def _slopes(painter: Painter, mechanism: Mechanism) -> Iterator[Angle]:
    """Yield the slopes of guides, fixed or on a link, measured from the direction that the rest of their formula gives."""
    points = dict(painter.outline.points)
    for rail, (a, b) in painter.rails.items():
        toward = points[rail.toward]
        if toward.op == "+" and toward.args[1].op == "@":
            along = (b - a) / abs(b - a)
            yield from _angle(mechanism, toward.args[1].args[1], (a, a + 0.35 * (b - a)), along)
    for slot in painter.outline.slots:
        toward = points[slot.toward]
        if slot.toward.startswith("~"):  # a point made for the direction; a corner of a link gives no slope
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
    """Yield the only datum in the angle of a direction, if the rest are coordinates or numbers; the sheet reverses its sense."""
    given = {datum.name: datum.value for datum in mechanism.variant.given if datum.si == "rad"}
    parts = list(signed(formula))
    data = [(part.name, sign) for part, sign in parts if part.op == "name" and part.name in given]
    rest = [part for part, _ in parts if part.name not in given]
    if len(data) == 1 and all(_is_direction(part) for part in rest):
        [(name, sign)] = data
        turn = -sign * given[name]
        yield Angle(name, at, along * cmath.exp(-1j * turn), turn)


def _is_direction(part: Formula) -> bool:
    return part.op == "name" or constant(part) is not None or all(name == "pi" for name in part.names())


def _place(painter: Painter, angle: Angle, radii: Sequence[float]) -> Arc | None:
    """Draw an angle where its arc covers least; return the arc, None if there is no room."""
    sheet = painter.sheet
    best, chosen = math.inf, None
    for at in angle.at:
        for radius in radii:
            sides = [way for way in _sides(angle) if not _is_shown(painter, at, way, radius)]
            count = max(2, math.ceil(abs(angle.turn) / PIECE))
            points = tuple(at + radius * angle.begin * cmath.exp(1j * angle.turn * k / count) for k in range(count + 1))
            lines = [(at + RING * way, at + (radius + PAST) * way) for way in sides]
            ends = [line[1] for line in lines]
            if not all(inside(p - 0.01, p + 0.01, sheet.field) for p in (*points, *ends)):
                continue
            looked = [*points[2:-2], *ends, *((at + end) / 2 for end in ends)]
            squares = np.array([(p.real, p.imag) for p in looked]).reshape(-1, 2)
            cost = float(sheet.taken.covered(squares, 0.4, 0.4, sheet.field).sum()) / max(len(looked), 1)
            long = radius * abs(angle.turn)
            cost = OVER * cost + LONGER * long + TOO_SHORT * max(0.0, ROOM - long) if angle.counted else cost + FARTHER * radius
            hidden = painter.at_joint(points[-1]) or painter.in_ground(points[-1])
            if angle.counted and (hidden or (abs(angle.turn) == SENSE and sides)):
                cost += HIDDEN
            if cost < best - 1e-9:
                best, chosen = cost, (at, points, lines)
    if chosen is None:
        return None
    at, points, lines = chosen
    for line in lines:
        sheet.line(*line, LINE)
    word = angle_word(angle.name)
    sheet.path(list(points), f'{PEN} data-angle="{plain(angle.name) if angle.counted else "".join(word)}"', blocks=False)
    if angle.counted:
        _head(painter, points)
    few = points[:: max(1, len(points) // max(CHORDS, math.ceil(abs(angle.turn) / CHORD)))]
    sheet.segments += itertools.pairwise(few)
    return Arc((word[0], word[1], word[2] + angle.tail), few, at, tuple(lines))


def _sides(angle: Angle) -> Iterator[complex]:
    """Yield the directions of both sides of an angle; for an angle of 0, whose arc only shows a sense, only its axis."""
    yield angle.begin
    if abs(angle.turn) != SENSE:
        yield angle.begin * cmath.exp(1j * angle.turn)


def _head(painter: Painter, points: Sequence[complex]) -> None:
    """Draw the arrow at the end of an arc."""
    tip = points[-1]
    size = min(HEAD, 0.6 * sum(abs(b - a) for a, b in itertools.pairwise(points)))
    behind = min(points[:-1], key=lambda point: (round(abs(abs(point - tip) - size), 9), -points.index(point)))
    along = (tip - behind) / abs(tip - behind)
    neck, side = tip - size * along, 0.3 * size * 1j * along
    painter.sheet.path([tip, neck + side, neck - side], 'fill="black"', closed=True, blocks=False)


def _is_shown(painter: Painter, at: complex, direction: complex, radius: float) -> bool:
    """Return whether a link from `at` that reaches the arc, or a fixed guide through `at`, already shows a direction."""
    ways = [end - at for line in painter.sheet.heavy for end in line if at in line and abs(end - at) > REACHED * radius]
    ways += [b - at for a, b in painter.rails.values() if abs(at - a) + abs(b - at) < abs(b - a) + 0.01]
    return any(abs(cmath.phase(way / direction)) < ALONG for way in ways if way)


def segments_of(arcs: Sequence[Arc]) -> list[Segment]:
    """Return the arcs as short lines; each is a rival of words that belong to something else."""
    return [line for arc in arcs for line in itertools.pairwise(arc.points)]
