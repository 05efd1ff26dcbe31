"""Dimension lines: lengths of the file between points that no part of a link joins, as between the pivots of the frame.

Enters: a `Painter` whose mechanism is drawn, and the `Mechanism`.  Leaves: thin lines with arrows at both ends, words on them.
Used by `drawing/figures.py`.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections import Counter
from collections.abc import Iterator, Sequence

import numpy as np

from coursework.drawing.lettering.naming import beside, lies_on
from coursework.drawing.lettering.offsets import offsets
from coursework.drawing.outline.lengths import lengths
from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.sheet import ITALIC, Word
from coursework.drawing.paper.symbols import length_word
from coursework.mechanism.mechanism import Mechanism
from coursework.system.angles import dot
from coursework.system.frozen import frozen
from coursework.variant.record.held import is_origin

PEN = 'stroke="black" stroke-width="0.15"'
SHORTEST = 0.8  # mm: shorter lengths are not dimensioned
TIGHT = 4.5  # mm: the arrows of a shorter dimension stand outside and point at each other
OUTSIDE = 5.0  # mm: length of these arrows
LEVELS = (0.0, 5.0, 7.0, 9.5, 12.0, 15.0, 19.0)  # mm: distances of a dimension line from its points
CLEAR = 5.0  # mm beyond all points, where a dimension crosses no link
AWAY = 0.5  # mm of covered lines: price of standing 1 mm farther off
LEADS = 0.9  # weight of what extension lines cover: they cross links as in any drawing
THROUGH = 250.0  # mm of covered lines: price of crossing a link
HIDDEN = 60.0  # mm of covered lines: price of each sampled place, or arrow head, in the ground of a hinge
SAMPLE = 1.5  # mm between the places at which a line is sampled
PAST, OFF = 1.0, 1.8  # mm: an extension line ends this far past the arrow, and begins this far from its point
BELOW = 7.0  # mm: the ground of a hinge ends there
HEAD = 1.8  # mm
AT_POINT = 2.5  # mm: near its points a dimension line straight between them is not sampled
ORIGIN = "0"  # name of the origin if the file gives it none; no point can have it
WAYS = 32  # directions in which the radius of a ring is tried
SEVERAL = 13.5  # mm of room around a hinge from which there is more than one dimension


@frozen
class Dimension:
    """A length, written as `word`, between two points along a direction of the sheet."""

    word: Word
    begin: str
    end: str
    along: complex


def draw_dimensions(painter: Painter, mechanism: Mechanism, marks: Sequence[str]) -> list[tuple[Word, Segment]]:
    """Draw the dimension lines between named points and `marks`; return their words and lines for `dimension_names`."""
    found = []
    rims = {frozenset((track.centre, wheel.contact)) for track in painter.rings for wheel in painter.outline.wheels}
    for one in _dimensions(painter, mechanism, (*painter.names, *marks)):
        line = _radius(painter, one, rims) or _place(painter, one)
        if line is not None:
            found.append((one.word, line))
    return found


def dimension_names(painter: Painter, drawn: list[tuple[Word, Segment]], near: Sequence[Segment]) -> None:
    """Write the words of dimension lines beside them; lines in `near` have words of their own."""
    for word, line in drawn:
        rivals = [heavy for heavy in painter.sheet.heavy if not lies_on(heavy, line)]
        rivals += [*(other for _, other in drawn if other != line), *near]
        places = [*beside(painter, line, 0.6, towards=-1)]
        painter.sheet.label(word, places, ITALIC, owner=Owner([line], rivals))


def crowded_hinges(painter: Painter, mechanism: Mechanism) -> list[str]:
    """Return the hinges from which there is more than one dimension; each needs `SEVERAL` mm of room."""
    counts = Counter(name for one in _dimensions(painter, mechanism, painter.names) for name in (one.begin, one.end))
    return [name for name, count in counts.items() if count > 1 and name in painter.outline.hinges]


def _dimensions(painter: Painter, mechanism: Mechanism, shown: Sequence[str]) -> Iterator[Dimension]:
    """Yield what is to be dimensioned: given lengths between shown points, coordinates of fixed points, offsets of guides.

    A length that is driven, as of a cylinder, is one of them: no bent arrow shows its rate.
    """
    given = {datum.name for datum in mechanism.variant.given}
    given |= {one.name for one in mechanism.variant.driven_coordinates if one.unit == "m"}
    drawn = {frozenset(ends) for bar in painter.outline.bars for ends in itertools.pairwise(bar.corners)}
    drawn |= {frozenset((wheel.centre, wheel.contact)) for wheel in painter.outline.wheels}
    for ends, length in lengths(mechanism).items():
        word = length_word(length)
        if ends in drawn or not ends <= {*shown} or not {*length.names()} <= given or not word[0]:
            continue
        begin, end = sorted(ends)
        way = painter.at[end] - painter.at[begin]
        if abs(way) > SHORTEST:
            yield Dimension(word, begin, end, way / abs(way))
    for offset in offsets(painter, mechanism):
        far = abs(dot(offset.across, painter.at[offset.rider] - painter.at[offset.point]))
        if offset.stub is None and {offset.point, offset.rider} <= {*shown} and far > SHORTEST:
            yield Dimension(length_word(offset.length), offset.point, offset.rider, offset.across)
    origin = next((name for name, formula in mechanism.points if name in shown and is_origin(formula)), ORIGIN)
    said = set()
    for name, formula in mechanism.points:
        if origin not in shown or name not in shown or formula.op != "pair":
            continue
        parts = [part.args[0] if part.op == "neg" else part for part in formula.args]
        if all(part.op == "name" and part.name in given for part in parts):
            for part, along in zip(parts, (1 + 0j, 1j), strict=True):
                way = painter.at[name] - painter.at[origin]
                if part.name not in said and abs(dot(along, way)) > SHORTEST:
                    said.add(part.name)
                    yield Dimension(length_word(part), origin, name, along)


def _place(painter: Painter, one: Dimension) -> Segment | None:
    """Draw a dimension where it covers least; return its line, None if there is no room."""
    a, b = painter.at[one.begin], painter.at[one.end]
    across = 1j * one.along
    heights = (dot(across, a), dot(across, b))
    levels = dict.fromkeys(level for off in LEVELS for level in (max(heights) + off, min(heights) - off))
    everything = [dot(across, painter.at[name]) for name in painter.names]
    levels |= dict.fromkeys((max(everything) + CLEAR, min(everything) - CLEAR))
    away = {level: AWAY * sum(abs(level - height) for height in heights) for level in levels}
    best, chosen = math.inf, None
    for level in sorted(levels, key=lambda level: round(away[level], 6)):
        if away[level] >= best:
            break
        ends = tuple(end + (level - height) * across for end, height in zip((a, b), heights, strict=True))
        lines = [
            line
            for end, foot in zip(ends, ((one.begin, a), (one.end, b)), strict=True)
            if (line := _extension(painter, foot, end))
        ]
        straight = abs(ends[0] - a) + abs(ends[1] - b) < 1e-9
        trimmed = one.along * (AT_POINT if straight else 0.0) * (1 if dot(one.along, b - a) > 0 else -1)
        outer = _ends(*ends)
        whole = [(outer[0] + trimmed, outer[1] - trimmed), *lines]
        looked = [at for begin, end in whole for at in _samples(begin, end)]
        squares = np.array([(at.real, at.imag) for at in looked])
        covers = painter.sheet.taken.covered(squares, 0.6, 0.6, painter.sheet.field)
        own = [*_samples(*whole[0])]
        cost = float(covers[: len(own)].sum() + LEADS * covers[len(own) :].sum()) + HIDDEN * sum(map(painter.in_ground, own))
        unit = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        heads = (HEAD * unit, -HEAD * unit) if abs(ends[1] - ends[0]) > TIGHT else (-HEAD * unit, HEAD * unit)
        hidden = sum(painter.in_ground(end + head) for end, head in zip(ends, heads, strict=True))
        cost += away[level] + HIDDEN * hidden + THROUGH * _crossed(painter, whole[0])
        if cost < best - 1e-6:
            best, chosen = cost, (ends, lines)
    if chosen is None:
        return None
    (begin, end), lines = chosen
    for line in lines:
        painter.sheet.line(*line, PEN)
    along = (end - begin) / abs(end - begin)
    gap = 1.25 if abs(begin - a) + abs(end - b) < 1e-9 else 0.0
    tails = _ends(begin, end)
    is_tight = tails != (begin, end)
    data = f' data-dimension="{"".join(one.word)}"'
    for tail, tip, inwards in zip(tails, (begin, end), (along, -along), strict=True):
        painter.sheet.arrow(
            tail if is_tight else (begin + end) / 2, tip + gap * (-inwards if is_tight else inwards), PEN, data, head=HEAD
        )
    return tails


def _radius(painter: Painter, one: Dimension, rims: set[frozenset[str]]) -> Segment | None:
    """Draw the radius of a ring where it covers least, preferably downwards; return its line, None if `one` is no such radius."""
    if {one.begin, one.end} not in rims:
        return None
    centre, contact = (one.begin, one.end) if one.begin in {track.centre for track in painter.rings} else (one.end, one.begin)
    at, long = painter.at[centre], abs(painter.at[contact] - painter.at[centre])
    units = [cmath.exp(1j * math.tau * k / WAYS) for k in range(WAYS)]

    def cost(unit: complex) -> float:
        looked = [*_samples(at + AT_POINT * unit, at + (long - HEAD) * unit)]
        squares = np.array([(place.real, place.imag) for place in looked])
        hidden = sum(painter.in_ground(place) for place in looked)
        return float(painter.sheet.taken.covered(squares, 2.0, 2.0, painter.sheet.field).sum()) + HIDDEN * hidden - unit.imag

    unit = min(units, key=lambda unit: round(cost(unit), 6))
    line = (at + OFF * unit, at + long * unit)
    painter.sheet.arrow(*line, PEN, f' data-dimension="{"".join(one.word)}"', head=HEAD)
    return line


def _crossed(painter: Painter, line: Segment) -> int:
    begin, step = (np.array([[at.real, at.imag]]) for at in (line[0], line[1] - line[0]))
    return int(painter.sheet.taken.lines("heavy").crossed(begin, step)[0])


def _ends(begin: complex, end: complex) -> Segment:
    """Return the ends of a dimension line; if it is tight, those of its outside arrows."""
    way = end - begin
    outer = OUTSIDE * way / abs(way)
    return (begin, end) if abs(way) > TIGHT else (begin - outer, end + outer)


def _extension(painter: Painter, foot: tuple[str, complex], end: complex) -> Segment | None:
    """Return the extension line from beside a point to past the end of a dimension, None if there is no room for one."""
    name, at = foot
    way = end - at
    if abs(way) <= OFF:
        return None
    unit = way / abs(way)
    start = BELOW if name in painter.outline.hinges and dot(unit, painter.ground(name)) > 0.9 else OFF
    return (at + start * unit, end + PAST * unit) if abs(way) > start else None


def _samples(begin: complex, end: complex) -> Iterator[complex]:
    count = max(2, math.ceil(abs(end - begin) / SAMPLE))
    yield from (begin + (k + 0.5) / count * (end - begin) for k in range(count))
