"""The points of a mechanism -> the known components of their velocities, and the segments of links between them.

Enters: a `Mechanism`.  Leaves: `PointGraph`, in formulas.  Used by `paths.py` and `derive.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction

from coursework.mechanism.mechanism import Mechanism
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named, number, signed
from coursework.variant.record.entries import reached
from coursework.variant.record.held import between_points, held_vectors
from coursework.variant.record.variant import Link, Variant

ZERO = number(0)
TURN = Fraction(2)  # a full turn in units of pi
EXACT = 1e-12  # right angles: tolerance for a right angle written in degrees and read as radians


@frozen
class Angle:
    """The angle of a segment: `base` (as in the file, None for a fixed direction) plus `offset` times pi, 0 <= offset < 2."""

    base: Formula | None
    offset: Fraction

    def turned(self, by: Fraction) -> Angle:
        """Return the angle increased by `by` times pi."""
        return Angle(self.base, (self.offset + by) % TURN)


@frozen
class Segment:
    """A straight segment from `start` to `end`: its `length` at `angle`, turning at the sum of `turning`, rates with signs.

    `slide` is the rate of a changing length, "" if the length is constant.
    """

    start: str
    end: str
    length: Formula
    angle: Angle
    turning: tuple[tuple[str, int], ...]
    slide: str = ""

    def reversed(self) -> Segment:
        """Return the segment from its end to its start."""
        return Segment(self.end, self.start, self.length, self.angle.turned(Fraction(1)), self.turning, self.slide)


@frozen
class Known:
    """The known velocity of a point: a formula for each component, None for an unknown component."""

    point: str
    x: Formula | None
    y: Formula | None

    @property
    def is_whole(self) -> bool:
        """Return whether both components are known."""
        return self.x is not None and self.y is not None

    def part(self, axis: str) -> Formula | None:
        """Return the component along "x" or "y"."""
        return self.x if axis == "x" else self.y


@frozen
class PointGraph:
    """Points with the known components of their velocities, the driven point first, and the segments between points."""

    known: tuple[Known, ...]
    segments: tuple[Segment, ...]

    def of(self, point: str) -> Known:
        """Return the known velocity of a point."""
        return next((known for known in self.known if known.point == point), Known(point, None, None))


def point_graph(mechanism: Mechanism) -> PointGraph:
    """Return the graph of the points of a mechanism.

    >>> import coursework
    >>> graph = point_graph(coursework.solve("31", quantities=["table"]).scene.mechanism)
    >>> [known.point for known in graph.known], [(one.start, one.end, one.turning) for one in graph.segments][:2]
    (['M', 'D', 'C', 'P'], [('D', 'A', (('w1', 1),)), ('A', 'B', (('w2', 1),))])
    """
    variant = mechanism.variant
    rates = {coordinate.name: coordinate.rate for coordinate in variant.coordinates}
    points = dict(mechanism.points)
    fixed = {name for name in points if rates.keys().isdisjoint(reached([name], points))}
    segments: dict[frozenset[str], Segment] = {}
    for start, end, vector in _drawn(mechanism, fixed):
        segment = _segment(start, end, vector, variant, rates)
        if segment is None or start == end or not _is_material(segment, variant):
            continue
        if frozenset((start, end)) not in segments:
            segments[frozenset((start, end))] = segment
    used = {name for pair in segments for name in pair}
    known = [known for known in _known(variant, points, fixed) if known.point in used]
    return PointGraph(tuple(known), tuple(segments.values()))


def _drawn(mechanism: Mechanism, fixed: set[str]) -> Iterator[tuple[str, str, Formula]]:
    """Yield (start, end, vector from start to end) for points, for closures written as a vector, and for held expressions."""
    minus = [Formula("-", (named(name), formula)) for name, formula in mechanism.points if name not in fixed]
    minus += [Formula("-", constraint.sides) for constraint in mechanism.variant.constraints if constraint.is_closure]
    yield from filter(None, map(between_points, (*minus, *held_vectors(mechanism.variant))))
    centres = [centre.name for centre, _ in mechanism.variant.frame.circles if centre.op == "name"]
    for hold in mechanism.variant.holds:
        inner = hold.args[0] if hold.op == "part" else hold
        if inner.op == "-" and inner.args[0].op == "name":
            yield from ((centre, inner.args[0].name, inner.args[1]) for centre in centres[:1])


def _segment(start: str, end: str, vector: Formula, variant: Variant, rates: Mapping[str, str]) -> Segment | None:
    """Return the segment of a vector, None if the vector is not a length at an angle that is a sum of coordinates."""
    polar = _polar(vector)
    if polar is None:
        return None
    length, angle = polar
    slides = [rates[name] for name in length.names() if name in rates]
    if slides and (length.op != "name" or len(slides) > 1):
        return None
    moving = [(term, sign) for term, sign in signed(angle.base or ZERO) if rates.keys() & {*term.names()}]
    if any(term.op != "name" for term, _ in moving):
        return None
    turning = tuple((rates[term.name], sign) for term, sign in moving)
    rate = next((link.rate for link in variant.links if {start, end} <= _held(link) and link.rate), None)
    if rate and rate not in dict(turning):  # the contact of a wheel moves with it, but its direction does not turn
        turning = ((rate, 1),)
    return Segment(start, end, length, angle, turning, slides[0] if slides else "")


def _held(link: Link) -> set[str]:
    return {*link.points, *(name for name in (link.wheel, link.contact) if name)}


def _is_material(segment: Segment, variant: Variant) -> bool:
    """Return whether both ends move with the segment: a contact belongs to its wheel only."""
    ends = {segment.start, segment.end}
    wheels = [link for link in variant.links if link.contact in ends]
    return all(ends <= _held(link) for link in wheels)


def _polar(vector: Formula) -> tuple[Formula, Angle] | None:
    """Return length and angle of "L @ a", "-(L @ a)", "(0, h)" or "(l, 0)", None for any other vector."""
    if vector.op == "neg":
        inner = _polar(vector.args[0])
        return None if inner is None else (inner[0], inner[1].turned(Fraction(1)))
    if vector.op == "@":
        return vector.args[0], _angle(vector.args[1])
    if vector.op == "pair":
        x, y = vector.args
        if x == ZERO:
            return y, Angle(None, Fraction(1, 2))
        if y == ZERO:
            return x, Angle(None, Fraction(0))
    return None


def _angle(formula: Formula) -> Angle:
    """Return an angle with its multiples of pi split off: phi3 + pi/2 -> (phi3, 1/2)."""
    if formula.op in {"+", "-"}:
        part = _part_of_pi(formula.args[1])
        if part is not None:
            inner = _angle(formula.args[0])
            return inner.turned(part if formula.op == "+" else -part)
    part = _part_of_pi(formula)
    return Angle(None, part % TURN) if part is not None else Angle(formula, Fraction(0))


def _part_of_pi(formula: Formula) -> Fraction | None:
    """Return q if a formula is q pi, None if it is not."""
    if formula == named("pi"):
        return Fraction(1)
    if formula.op == "number":  # "90 deg" is read as 1.5707963267948966
        quarters = 2 * float(formula.value) / math.pi
        return Fraction(round(quarters), 2) if abs(quarters - round(quarters)) < EXACT else None
    if formula.op == "neg":
        inner = _part_of_pi(formula.args[0])
        return None if inner is None else -inner
    if formula.op in {"*", "/"}:
        first, second = formula.args
        if second.op == "number" and (part := _part_of_pi(first)) is not None and second.value:
            return part * second.value if formula.op == "*" else part / second.value
        if formula.op == "*" and first.op == "number" and (part := _part_of_pi(second)) is not None:
            return first.value * part
    return None


def _known(variant: Variant, points: Mapping[str, Formula], fixed: set[str]) -> list[Known]:
    """Return the points whose velocity is wholly or partly known: driven, fixed, guided, or in contact with the frame."""
    found: dict[str, Known] = {}
    laws = {law.name: ZERO if law.formula == ZERO else named(law.name) for law in variant.drive}
    for name in points:
        x, y = laws.get(f"V{name}x"), laws.get(f"V{name}y")
        if x is not None or y is not None:
            found[name] = Known(name, x, y)
    on_frame = [link.contact for link in variant.links if link.contact and _touches_frame(link.contact, variant)]
    for name in (*points, *on_frame):
        if name in fixed or name in on_frame:
            found[name] = Known(name, ZERO, ZERO)
    guides = [(through.name, angle) for through, angle in variant.frame.rails if through.op == "name" and through.name in points]
    guides = [(name, angle) for name, angle in guides if name not in found]
    held = [(hold.args[0].name, hold.name) for hold in variant.holds if hold.op == "part" and hold.args[0].op == "name"]
    across = []
    for name, angle in guides:
        if (speed := _speed_along(name, angle, variant)) is not None:
            found[name] = Known(name, *_along(*speed))
        elif (place := _angle(angle)).base is None and place.offset % 1 in _AXES:
            across.append((name, "y" if place.offset % 1 == 0 else "x"))
    for name, axis in (*held, *across):
        old = found.get(name, Known(name, None, None))
        if name in points and old.part(axis) is None:
            found[name] = Known(name, *((ZERO, old.y) if axis == "x" else (old.x, ZERO)))
    order = {name: place for place, name in enumerate(dict.fromkeys((variant.driven or "", *points)))}
    return sorted(found.values(), key=lambda known: order[known.point])


_AXES = (Fraction(0), Fraction(1, 2))


def _speed_along(point: str, guide: Formula, variant: Variant) -> tuple[Formula, Formula] | None:
    """Return the unknown that the file declares as the speed of a point along its guide, and its declared direction."""
    line = _angle(guide)
    for binding in variant.bindings:
        if binding.point == point and not binding.relative and binding.along is not None:
            along = _angle(binding.along)
            if along.base == line.base and (along.offset - line.offset) % 1 == 0:
                return named(binding.name), binding.along
    return None


def _along(speed: Formula, angle: Formula) -> tuple[Formula, Formula]:
    """Return the components of a speed along a guide; one of them is zero if the guide is parallel to an axis."""
    place = _angle(angle)
    if place.base is None and place.offset % 1 in _AXES:
        signed = speed if place.offset < 1 else Formula("neg", (speed,))
        return (signed, ZERO) if place.offset % 1 == 0 else (ZERO, signed)
    return tuple(Formula("*", (speed, Formula("call", (angle,), name))) for name in ("cos", "sin"))  # type: ignore[return-value]


def _touches_frame(contact: str, variant: Variant) -> bool:
    """Return whether the contact of a wheel is at rest: it lies on a rail or circle of the frame and on no other link."""
    others = sum(contact in link.points for link in variant.links)
    on_rail = any(through == named(contact) for through, _ in variant.frame.rails)
    return not others and (on_rail or bool(variant.frame.circles))
