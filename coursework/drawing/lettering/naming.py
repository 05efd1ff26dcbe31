"""Names in a drawing: of points, of links, and of lengths beside the parts of links that have them.

Enters: a `Painter` whose mechanism is drawn.  Leaves: words on its sheet; what each word belongs to as `Owner`.
Used by `drawing/figures.py`, `dimensions.py` and `drawing/check_sheet/drawing.py`.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Mapping, Sequence

from coursework.drawing.lettering.offsets import offsets
from coursework.drawing.outline.ground import wheel_on
from coursework.drawing.outline.lengths import lengths
from coursework.drawing.outline.outline import Bar
from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.placing import FRACTION, Owner, Place
from coursework.drawing.paper.sheet import BOLD, ITALIC
from coursework.drawing.paper.symbols import length_word, name_word, short
from coursework.mechanism.mechanism import Mechanism
from coursework.system.angles import dot
from coursework.variant.formula.tree import Formula, named, terms

PARTS = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)  # parts of a line's length at which its word may stand, the middle first
SHORT = 2.5  # mm: shorter lines get no name
SAME = 1e-9  # relative: two lengths this near to each other are the same
NEAR_HINGE = (0.15, 0.3, 0.45)  # parts of a crank's length
SPOKES = 32  # radii that stand for a wheel's disc, within which its name may stand


def point_names(painter: Painter) -> None:
    """Write the name of each point beside it, away from the links."""
    for name in painter.names:
        at = painter.at[name]
        rivals = [(painter.at[other], painter.at[other]) for other in painter.names if painter.at[other] != at]
        painter.sheet.label(name_word(name), [(at, _away(painter, name), 1.6)], ITALIC, owner=Owner([(at, at)], rivals))


def _away(painter: Painter, name: str) -> complex:
    """Return the direction from a point in which it has no links."""
    at, places = painter.at[name], painter.at
    arms = [places[p] - at for bar in painter.outline.bars if name in bar.corners for p in bar.corners if places[p] != at]
    lean = sum((arm / abs(arm) for arm in arms), 0j)
    return -lean if abs(lean) > 0.2 else at - painter.middle


def link_lines(painter: Painter, bar: Bar) -> list[Segment]:
    """Return the lines (mm) of a link: its bars, slots and rack; its point if it has none of these."""
    found = [(painter.at[a], painter.at[b]) for a, b in itertools.pairwise(bar.corners)]
    for slot in painter.outline.slots:
        if slot.link == bar.link:
            found += [(a, b) for a, b in itertools.pairwise(painter.slot_line(slot)) if a != b]
    if contact := painter.racks.get(bar.link):
        found.append((painter.at[bar.corners[0]], painter.at[contact]))
    return found or [(painter.at[name], painter.at[name]) for name in bar.corners]


def link_owner(painter: Painter, bar: Bar) -> Owner:
    """Return what a link's name belongs to: its lines and the disc of its wheel; all other links and arrows are rivals."""
    own = link_lines(painter, bar)
    rivals = [line for line in painter.sheet.heavy if not any(lies_on(line, mine) for mine in own)] + painter.grounds
    for wheel in painter.outline.wheels:
        centre, radius = painter.at[wheel.centre], abs(painter.at[wheel.contact] - painter.at[wheel.centre])
        rim = [centre + cmath.rect(radius, math.tau * k / SPOKES) for k in range(SPOKES + 1)]
        if wheel.link == bar.link:
            own += [(centre, at) for at in rim]
        else:
            rivals += itertools.pairwise(rim)
    return Owner(own, rivals)


def beside(painter: Painter, line: Segment, gap: float, towards: int = 1) -> list[Place]:
    """Return the places beside a line, on the side away from the middle of the mechanism; `towards` -1 means the other side."""
    a, b = line
    side = 1j * (b - a) * towards
    outside = side if dot(1j * (b - a), (a + b) / 2 - painter.middle) > 0 else -side
    return [(a + part * (b - a), outside, gap) for part in PARTS]


def link_places(painter: Painter, bar: Bar) -> list[Place]:
    """Return the places where the name of a link may stand: in or beside its wheel, else at its block, then along its parts."""
    wheel = next((w for w in painter.outline.wheels if w.link == bar.link), None)
    if wheel is not None:
        centre = painter.at[wheel.centre]
        radius = abs(painter.at[wheel.contact] - centre)
        within = [(centre, centre - painter.middle, 4.0)] if radius > 12 else []
        return [*within, (centre, centre - painter.middle, radius + 1.0)]
    lines = [line for line in link_lines(painter, bar) if abs(line[1] - line[0]) > SHORT]
    lines.sort(key=lambda line: -round(abs(line[1] - line[0]), 6))
    at = painter.at[bar.corners[0]]
    block = [(at, at - painter.middle, 4.0)] if len(bar.corners) == 1 or not lines else []
    return [*block, *(place for line in lines for place in beside(painter, line, 1.2))]


def rate_places(painter: Painter, bar: Bar, hinge: str) -> list[Place]:
    """Return the places where the rate of a crank may stand: at its hinge, else along the crank near the hinge."""
    at = painter.at[hinge]
    ways = [end - at for line in link_lines(painter, bar) if at in line for end in line if end != at][:1]
    return [(at, at - painter.middle, 2.5), *((at + part * way, 1j * way, 1.0) for way in ways for part in NEAR_HINGE)]


def link_names(painter: Painter) -> None:
    """Write the names of the links in bold."""
    for bar in painter.outline.bars:
        if bar.corners:
            word = (short(bar.link), "", "")
            painter.sheet.label(word, link_places(painter, bar), BOLD, owner=link_owner(painter, bar))


def part_lengths(painter: Painter, mechanism: Mechanism, near: Sequence[Segment]) -> None:
    """Write the given lengths beside the parts of links that have them; lines in `near` have words of their own."""
    known = lengths(mechanism)
    drawn = [(bar.corners[k], bar.corners[k + 1]) for bar in painter.outline.bars for k in range(len(bar.corners) - 1)]
    drawn += [(wheel.centre, wheel.contact) for wheel in painter.outline.wheels]
    free = _unsaid(mechanism, known)
    named = [
        (known.get(frozenset(ends)) or _measured(painter, ends, free), painter.at[ends[0]], painter.at[ends[1]])
        for ends in dict.fromkeys(drawn)
    ]
    named += [(offset.length, *offset.stub) for offset in offsets(painter, mechanism) if offset.stub]
    for track, (_, radius) in zip(painter.outline.tracks, mechanism.variant.frame.circles, strict=True):
        wheel = wheel_on(painter.outline, painter.poses.pose(0), track)
        # Along a link between the two centres the radius would read as a length of that link.
        if wheel and not any({track.centre, wheel.centre} <= {*bar.corners} for bar in painter.outline.bars):
            named.append((radius, painter.at[track.centre], painter.at[wheel.contact]))
    for place, (length, a, b) in enumerate(named):
        word = length_word(length) if length is not None else ("", "", "")
        if word[0] and abs(b - a) > SHORT:
            thin = [(begin, end) for _, begin, end in (*named[:place], *named[place + 1 :])]
            rivals = [line for line in (*thin, *painter.sheet.heavy, *near, *painter.grounds) if not lies_on(line, (a, b))]
            owner = Owner([(a, b)], rivals, leading=FRACTION)
            painter.sheet.label(word, beside(painter, (a, b), 1.0, towards=-1), ITALIC, owner=owner)


def _unsaid(mechanism: Mechanism, known: Mapping[frozenset[str], Formula]) -> dict[str, float]:
    """Return the given lengths (m) that help to place points but are written neither between two points nor as a coordinate."""
    said = {length.name for length in known.values()} | {
        part.name for _, formula in mechanism.points if formula.op == "pair" for arg in formula.args for part in terms(arg)
    }
    variant = mechanism.variant
    sides = [side for one in mechanism.constraints if one.is_closure for side in one.sides]
    laws = [formula for law in variant.functions for formula in law.formulas]
    used = {name for formula in (*dict(mechanism.points).values(), *sides, *variant.holds, *laws) for name in formula.names()}
    return {datum.name: datum.value for datum in variant.given if datum.si == "m" and datum.name in used - said}


def _measured(painter: Painter, ends: tuple[str, str], free: Mapping[str, float]) -> Formula | None:
    """Return the only datum as long as a part without a given length, such as the third side of a triangle; else None."""
    size = abs(painter.place[ends[1]] - painter.place[ends[0]])
    alike = [name for name, value in free.items() if abs(value - size) <= SAME * size]
    return named(alike[0]) if len(alike) == 1 else None


def lies_on(line: Segment, other: Segment) -> bool:
    """Return whether two segments overlap along the same line, to 0.1 mm."""
    a, b = other
    if a == b or line[0] == line[1]:  # a point
        return False
    ends = [(end - a) * ((b - a) / abs(b - a)).conjugate() for end in line]
    low, high = sorted(end.real for end in ends)
    return all(abs(end.imag) < 0.1 for end in ends) and min(high, abs(b - a)) - max(low, 0.0) > 0.1
