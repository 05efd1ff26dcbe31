"""Coordinates that are angles: the points of the drawing about which each turns, from which direction, in which sense.

Enters: a `Mechanism`, and the values of its names in one position.  Leaves: `Turn`.
Used by `angles.py`, `figures.py`, `sketch.py` and `assigning/senses.py`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import permutations

from coursework.drawing.outline.lengths import gaps_of
from coursework.mechanism.mechanism import Mechanism
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate_any, named, signed
from coursework.variant.record.held import is_origin

Values = Mapping[str, complex]
Sum = list[tuple[Formula, int]]  # terms with their signs
Signed = tuple[tuple[Formula, int], ...]  # the same, as a field of a record
SAME = 1e-9  # of the distance of the farthest point from the origin: places this near to each other are one
NEAR = 0.01  # rad: a link this near to the direction of an angle from x shows that the angle is counted from there


@frozen
class Turn:
    """A `coordinate` (rad) that is measured at one of the places `at` (m, x + iy) from the direction `axis`.

    It turns by `size`, from 0 to less than a whole turn, in its positive `sense`: +1 counter-clockwise, -1 clockwise.
    The angle of the axis is the sum `beside`, empty for the x axis; `line` names the two ends of the turning arm, or is "".
    """

    coordinate: str
    at: tuple[complex, ...]
    axis: complex
    size: float
    sense: int
    beside: Signed = ()
    line: str = ""


@frozen
class _Arm:
    """A term "L @ angle" that begins at a place.

    Its angle is `part` (1 or -1) times the coordinate, plus the `rest`, which has the value `aside` (rad).
    `is_named`: a point of the file lies there; `line` names both ends of the arm if the file writes it so, else "".
    """

    begin: complex
    is_named: bool
    part: int
    rest: Signed
    aside: float
    line: str


def turns(mechanism: Mechanism, values: Values) -> Iterator[Turn]:
    """Yield every coordinate that is an angle, if the file tells what turns with it; `values` hold points as x + iy."""
    variant = mechanism.variant
    moving = {coordinate.name for coordinate in variant.coordinates}
    for coordinate in variant.coordinates:
        name = coordinate.name
        if coordinate.unit != "rad" or name not in values:
            continue
        ranked = sorted((_rank(arm, moving), place, arm) for place, arm in enumerate(_arms(mechanism, values, name)))
        value = values[name].real
        if not ranked:
            at = _centre(mechanism, coordinate.rate, values, cmath.exp(1j * value))
            if at is not None:
                yield Turn(name, (at,), 1 + 0j, value % math.tau, 1)
            continue
        least, _, arm = ranked[0]
        same = [one for rank, _, one in ranked if rank == least and (one.part, one.rest) == (arm.part, arm.rest)]
        line = next((one.line for one in same if one.line), "")
        # A given angle added to the coordinate is a bend of the link: the coordinate itself is measured from x, to another arm.
        bent = any(variant.values.keys() & {*part.names()} for part, _ in arm.rest)
        counts = arm.part < 0 or not bent or any(moving & {*part.names()} for part, _ in arm.rest)
        axis = cmath.exp(1j * arm.aside) if counts else 1 + 0j
        beside, places = arm.rest if counts else (), tuple(dict.fromkeys(one.begin for one in same))
        yield Turn(name, places, axis, value % math.tau, arm.part, beside, line if counts or not arm.rest else "")


def clockwise_rates(mechanism: Mechanism, places: Values) -> set[str]:
    """Return the rates of the coordinates that the file counts clockwise; `places` are its points, in any position."""
    rates = {coordinate.name: coordinate.rate for coordinate in mechanism.variant.coordinates}
    laws = [law.name for law in mechanism.variant.laws]
    values = {**mechanism.variant.values, "pi": math.pi, **dict.fromkeys([*rates, *laws], 1.0), **places}
    return {rates[turn.coordinate] for turn in turns(mechanism, values) if turn.sense < 0}


def _rank(arm: _Arm, moving: set[str]) -> tuple[int, bool]:
    """Return how well an arm shows its coordinate, best first: alone, plus a constant, plus coordinates; at a named point."""
    if not arm.rest and arm.part > 0:
        return 0, not arm.is_named
    return 1 + sum(not moving.isdisjoint(part.names()) for part, _ in arm.rest), not arm.is_named


def _arms(mechanism: Mechanism, values: Values, coordinate: str) -> Iterator[_Arm]:
    """Yield the arms that turn with a coordinate, found in points, closures and `holds`."""
    corners = [values[name] for name, _ in mechanism.points if name in values]
    near = SAME * max(map(abs, corners), default=0.0)
    for parts, is_gap, end in _sums(mechanism):
        for place, (part, _) in enumerate(parts):
            if part.op != "@" or coordinate not in part.args[1].names():
                continue
            angle = list(signed(part.args[1]))
            own = [one for term, one in angle if term == named(coordinate)]
            rest = tuple((term, one) for term, one in angle if term != named(coordinate))
            if len(own) != 1 or any(coordinate in term.names() for term, _ in rest):
                continue
            try:
                begin = _gap_begin(parts, place, values) if is_gap else _begin(parts, place, values)
                aside = sum(sign * evaluate_any(term, values).real for term, sign in rest)
            except (KeyError, FormulaFault):  # a length or an angle given by a law
                continue
            line = _line(mechanism, parts, end)
            yield _Arm(begin, any(abs(begin - corner) <= near for corner in corners), own[0], rest, aside, line)


def _begin(parts: Sum, place: int, values: Values) -> complex:
    """Return where the arm at a place of a sum begins; an arm with a minus is taken from its end, so it begins after its term."""
    ends = parts[: place + (parts[place][1] < 0)]
    return sum((sign * evaluate_any(part, values) for part, sign in ends), 0j)


def _gap_begin(parts: Sum, place: int, values: Values) -> complex:
    """Return where an arm begins in a sum that stays zero: "C - B - r2 @ phi2" says that it leads from B to C."""
    same = [(part, at) for at, (part, sign) in enumerate(parts) if sign == parts[place][1]]
    return sum((evaluate_any(part, values) for part, at in same if at < place or part.op != "@"), 0j)


def _line(mechanism: Mechanism, parts: Sum, end: str) -> str:
    """Return the two ends, such as "DA", of the arm in "D + r1 @ phi1", a sum that leads to the point `end`; else ""."""
    *before, (_, sign) = parts
    origin = next((name for name, formula in mechanism.points if is_origin(formula)), "")
    begin = before[0][0].name if len(before) == 1 and before[0][0].op == "name" and before[0][1] > 0 else ""
    begin = begin if before else origin
    return begin + end if begin and end and sign > 0 else ""


def _sums(mechanism: Mechanism) -> Iterator[tuple[Sum, bool, str]]:
    """Yield sums of vectors: the terms, whether the sum is a gap between two points, and the point that it leads to, or ""."""
    sides = [(formula, name) for name, formula in mechanism.points]
    met = {formula: name for name, formula in mechanism.points}
    for one in mechanism.constraints:
        if one.is_closure and not any(map(is_origin, one.sides)):  # a sum that is zero is a gap
            pair = one.sides, one.sides[::-1]
            sides += [(side, other.name if other.op == "name" else met.get(other, "")) for side, other in pair]
    gaps = gaps_of(mechanism.variant)
    sides += [(hold.args[0], "") for hold in mechanism.variant.holds if hold.op == "part" and hold.args[0] not in gaps]
    yield from (([*signed(side)], False, name) for side, name in sides)
    yield from (([*signed(gap)], True, "") for gap in gaps)


def _centre(mechanism: Mechanism, rate: str, values: Values, way: complex) -> complex | None:
    """Return the centre of the wheel that has a rate, or the point from which a link that has it leads this `way`, else None."""
    for link in mechanism.variant.links:
        if link.rate != rate:
            continue
        if (wheel := link.wheel or "") in values:
            return complex(values[wheel])
        places = [complex(values[name]) for name in link.points if name in values]
        if len(places) == 1:
            return places[0]
        leads = (
            one for one, other in permutations(places, 2) if abs(other - one - abs(other - one) * way) < NEAR * abs(other - one)
        )
        if (begin := next(leads, None)) is not None:
            return begin
    return None
