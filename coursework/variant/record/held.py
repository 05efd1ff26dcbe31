"""What [closure] holds: points that follow a drive, units and size of what is held, what can only be zero, parts of a vector.

Enters: a `Variant`.  Leaves: units, sizes, flags.
Used by `equations.py`, `changes.py`, `gaps.py`, `drift.py`, `structure.py`, `rigid.py` and by `scheme.py`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from contextlib import suppress
from itertools import permutations

from coursework.variant.formula.arms import with_arms
from coursework.variant.formula.tree import (
    Formula,
    FormulaFault,
    constant,
    evaluate_any,
    named,
    on_axes,
    signed,
    terms,
)
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Variant

MOST_PAIRED = 40  # scalars among which components of one vector are looked for; every pair is tried
_ALONG = 1e-12  # sine of an angle to an axis: below it a direction lies along the axis
POWERS = {2: "m²", 3: "m³", 4: "m⁴"}  # units of position equations in products of lengths


def largest_length(variant: Variant) -> float:
    """Return the largest length of the data (m), 1 if there is none: the size of the mechanism."""
    return max((abs(given.value) for given in variant.given if given.si == "m"), default=1.0) or 1.0


def followed(variant: Variant) -> dict[str, tuple[str, str]]:
    """Return the laws of [drive] that driven points follow, each with its point and its axis: VMx of M along x."""
    return _along_axes(variant, filter(None, (variant.driven, *variant.also_driven)))


def velocities_of_points(variant: Variant) -> dict[str, tuple[str, str]]:
    """Return the laws of [drive] that are velocities of named points, as in `followed`, whatever [closure] says of them."""
    return _along_axes(variant, (point for point, _ in variant.points))


def driving_laws(variant: Variant) -> tuple[str, ...]:
    """Return the laws of [drive] that drive a freedom each: rates, and velocities of points in an equation or in [closure].

    Left out is a velocity of zero across the guide of the frame in which its point slides: the guide says so already.
    """
    parts, followed_by = velocities_of_points(variant), followed(variant)
    used = {name for one in variant.constraints for side in (one.left, one.right) for name in side.names()}
    zero = {law.name for law in variant.drive if law.formula is not None and constant(law.formula) == 0}
    said = {law for law, (point, axis) in parts.items() if law in zero and _is_across_its_guide(variant, point, axis)}
    moving = (law for law in parts if law in {*used, *followed_by} - said)
    return tuple(dict.fromkeys((*variant.known_rates, *rates_without_angle(variant), *moving)))


def rates_without_angle(variant: Variant) -> dict[str, str]:
    """Return the laws of [drive] that are the rate of a link but of no coordinate, each with its link."""
    laws = {law.name for law in variant.drive} - {*variant.rates}
    found = {link.rate: link.name for link in reversed(variant.links) if link.rate in laws}
    return dict(sorted(found.items()))


def _is_across_its_guide(variant: Variant, point: str, axis: str) -> bool:
    """Return whether a guide of the frame through a point leaves it no velocity along an axis, whatever the data."""
    return any(through == named(point) and axis_of(angle, {}) in {*"xy"} - {axis} for through, angle in variant.frame.rails)


def axis_of(angle: Formula, values: Mapping[str, float]) -> str:
    """Return the axis, "x" or "y", along which a direction at an angle lies, "" if it lies along none or that is not known."""
    turned = known_value(angle, values)
    sides = () if turned is None else (("x", math.sin(turned)), ("y", math.cos(turned)))
    return next((axis for axis, across in sides if abs(across) < _ALONG), "")


def _along_axes(variant: Variant, points: Iterable[str]) -> dict[str, tuple[str, str]]:
    laws = {law.name for law in variant.drive}
    parts = {f"V{point}{axis}": (point, axis) for point in points for axis in "xy"}
    return {law: part for law, part in parts.items() if law in laws}


def closed_loops(variant: Variant) -> tuple[bool, ...]:
    """Return which of the held expressions close a loop, so that they mean zero, not the value that the start gives.

    C.y keeps a height that only the start gives; (C - O - r @ phi).x says that a link reaches from O to C; (C - C1).x together
    with (C - C1).y says that both links reach one hinge; x^2 + y^2 - r^2 gives a link its length.
    """
    written = [on_axes(hold) for hold in variant.holds]
    apart = [_apart(formula) for formula in written]
    met = {*map("".join, apart)}
    data = {*variant.values}
    return tuple(
        _is_loop(formula)
        or (bool(pair) and {pair + axis for axis in "xy"} <= met)
        or (any(data.issuperset(term.names()) for term in terms(formula)) and unit_of(formula, variant) in POWERS.values())
        for formula, (pair, _) in zip(written, apart, strict=True)
    )


def held_vectors(variant: Variant) -> tuple[Formula, ...]:
    """Return the sums of vectors that stay zero along both axes, in whichever way a file writes the two.

    C.x - B.x - r*cos(phi) and C.y - B.y - r*sin(phi) say that C - B - r @ phi is zero, and so does C - B - r @ phi = (0, 0).
    """
    closures = [one.sides for one in variant.constraints if one.is_closure]
    loops = [side for sides in closures for side, other in (sides, sides[::-1]) if is_origin(other)]
    points = {name for name, _ in variant.points}
    moving = points | {one.name for one in variant.coordinates}
    scalars = [on_axes(hold) for hold in variant.holds]
    scalars += [on_axes(Formula("-", sides)) for sides in closures if not _is_vector(sides[0], points)]
    named = [(formula, moving.intersection(formula.names())) for formula in scalars[:MOST_PAIRED]]
    both = (
        Formula("pair", (x, side))
        for (x, one), (y, other) in permutations(named, 2)
        if one and one == other
        for side in (y, Formula("neg", (y,)))
    )
    vectors = (with_arms(pair) for pair in both)
    paired = [vector for vector in vectors if all(moving.isdisjoint(part.names()) for part in vector.walk() if part.op == "pair")]
    return tuple(dict.fromkeys([*loops, *(vector for vector in paired if is_gap(vector, points))]))


def is_gap(vector: Formula, points: Collection[str]) -> bool:
    """Return whether a held sum of vectors leads round, so that it is zero: between points, or to a place that data give.

    C - r @ phi alone stays as well, but where the start puts it: at a pivot that is not in the sum.
    """
    parts = [*signed(vector)]
    return not sum(sign for part, sign in parts if part.name in points) or any(part.op == "pair" for part, _ in parts)


def closed_parts(variant: Variant) -> list[Formula]:
    """Return what closures keep zero, as scalars: both components of a vector equation."""
    points = {name for name, _ in variant.points}
    closures = [one for one in variant.constraints if one.is_closure]
    both = [(one.difference, "xy" if _is_vector(one.left, points) or _is_vector(one.right, points) else "") for one in closures]
    return [Formula("part", (gap,), axis) if axis else gap for gap, axes in both for axis in axes or [""]]


def between_points(gap: Formula) -> tuple[str, str, Formula] | None:
    """Return two points and the vector from the first to the second, if a sum that stays zero holds them alone; else None."""
    parts = [*signed(gap)]
    ends = {sign: part.name for part, sign in parts if part.op == "name"}
    vectors = [(part, sign) for part, sign in parts if part.op != "name"]
    if (len(parts), len(ends), len(vectors)) != (3, 2, 1):
        return None
    [(vector, sign)] = vectors
    return ends[sign], ends[-sign], vector


def is_origin(formula: Formula) -> bool:
    """Return whether a point or a sum of vectors is written as (0, 0)."""
    return formula.op == "pair" and all(arg.op == "number" and arg.value == 0 for arg in formula.args)


def is_arm(end: Formula, base: str, at: Formula) -> bool:
    """Return whether a point is defined as the point `base` plus one vector; `base` may be left out if it is (0, 0)."""
    parts = [part for part, _ in signed(end) if part != named(base)]
    whole = len([*signed(end)]) - len(parts) == 1 or (at.op == "pair" and all(part.name == "0" for part in at.args))
    return whole and len(parts) == 1 and parts[0].op == "@"


def _is_vector(formula: Formula, points: set[str]) -> bool:
    if formula.op in {"+", "-", "neg"}:
        return any(_is_vector(arg, points) for arg in formula.args)
    return formula.op in {"@", "pair"} or formula.name in points


def _apart(formula: Formula) -> tuple[str, str]:
    """Return which two points an expression holds apart, and along which axis; "" twice if it is no such difference."""
    terms = list(signed(formula))
    if len(terms) != 2 or any(term.op != "part" or term.args[0].op != "name" for term, _ in terms):
        return "", ""
    (one, plus), (other, minus) = terms
    same_axis = one.name == other.name and plus != minus
    return (" ".join(sorted((one.args[0].name, other.args[0].name))) + ".", one.name) if same_axis else ("", "")


def _is_loop(formula: Formula) -> bool:
    """Return whether a sum leads from one point to another along a link: a difference of points, and a length by its angle."""
    summands = list(signed(formula))
    points = {sign: term.args[0] for term, sign in summands if term.op == "part" and term.args[0].op == "name"}
    lengths = [term for term, _ in summands if not any(node.op == "part" for node in term.walk())]
    return len(points) > 1 and any(node.name in {"sin", "cos"} for term in lengths for node in term.walk())


def unit_of(formula: Formula, variant: Variant) -> str:
    """Return the unit of a scalar position equation: rad, m, m² … if its value doubles so often when all lengths are doubled.

    Of a velocity equation it is the unit times seconds.
    """
    has_parts = any(node.op == "part" for node in formula.walk())
    within = (inner for node in formula.walk() if node.op in {"*", "/", "^", "call"} for arg in node.args for inner in arg.walk())
    if has_parts and all(inner.op != "part" for inner in within):
        return "m"
    laws, size = {law.name: law for law in variant.laws}, largest_length(variant)

    def value(factor: float) -> float:
        values: dict[str, complex] = {"t": 0.37, "pi": math.pi}
        values |= {g.name: g.value * (factor / size if g.si == "m" else 1.0) for g in variant.given}
        values |= {name: factor if unit == "m/s" else 1.0 for name, unit in variant.unknowns}
        for place, coordinate in enumerate(variant.coordinates):
            scale = factor if coordinate.unit == "m" else 1.0
            values |= {coordinate.name: (0.3 + 0.1 * place) * scale, coordinate.rate: (0.9 - 0.07 * place) * scale}
        for name, where in variant.points:
            with suppress(KeyError):  # a point of a group is placed by its closure
                values[name] = evaluate_any(where, values)
        for name, law in laws.items():
            if law.formula is None:
                values.setdefault(name, factor)
            elif values.keys() >= {*law.formula.names()}:
                values[name] = evaluate_any(law.formula, values)
        return evaluate_any(formula, values).real

    try:
        one, two = value(1.0), value(2.0)
    except (FormulaFault, KeyError):
        return "m"
    if abs(two - one) <= 1e-9 * (1 + abs(one)):
        return "m" if has_parts and not one else "rad"
    degree = math.log2(two / one) if one * two > 0 else 1.0
    return POWERS.get(round(degree), "m") if abs(degree - round(degree)) < 1e-9 else "m"
