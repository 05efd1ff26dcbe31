"""The meaning of a zero determinant for the mechanism, as a sentence.

Enters: the determinant as shown.  Leaves: a sentence.  Used by `blocks.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence

from coursework.mechanism.groups import group_kind
from coursework.mechanism.joints import link_names, linkage
from coursework.variant.formula.made import as_read, product_of
from coursework.variant.formula.tree import Formula, FormulaFault, constant, evaluate, factors, on_axes, spelled, terms
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Variant
from coursework.words.sentences import joined, say

# At a singular position, a factor smaller than this fraction of the largest factor counts as zero.
_SMALL = 1e-3
# Stands for the angle itself in the text of an angle; alone it means: counted from x.
_FROM_X = "·"
# Keys for a link by its name and by its angle, in the nominative, and in "of link …" (another case in some languages).
_NAMED = ("determinant.link", "determinant.link_at")
_OF = ("determinant.of_link", "determinant.of_link_at")
# The sine of an angle given with all digits of pi may still differ from zero by this much.
_ROUNDING = 1e-12
# Stands for a coordinate whose value does not matter.
_ANY = 0.7


def meaning(determinant: Formula, variant: Variant, unknowns: Sequence[str], at: Mapping[str, float] | None = None) -> str:
    """Return when the determinant of the equations for `unknowns` is zero, such as "links 1 and 2 lie on one line".

    With the coordinates of a singular position `at`, only the condition that holds there is returned.
    """
    vanishing = _vanishing(determinant, variant, at)
    if len(vanishing) == 1 and (known := _of_group(variant, unknowns)):
        return known
    found = [sentence for factor in vanishing if (sentence := _factor(factor, variant))]
    return joined(found, "join.or_else") if found else say("determinant.never")


def _of_group(variant: Variant, unknowns: Sequence[str]) -> str:
    """Return the sentence of a dyad about its determinant, "" if none; its angles alone do not tell a link from a guide."""
    rates = {coordinate.name: coordinate.rate for coordinate in variant.coordinates}
    for group in variant.groups:
        if set(unknowns) == {rates.get(name, "") for name in group.coordinates}:
            key = group_kind(group.kind).meaning
            return say(key, link=_link(group.coordinates[0], variant)) if key else ""
    return ""


def vanishing(determinant: Formula, variant: Variant, at: Mapping[str, float] | None) -> Formula:
    """Return the determinant without sign and constant lengths: the part that can be zero, or that is zero `at` a position."""
    found = _vanishing(determinant, variant, at)
    return product_of(found) if found else determinant


def _vanishing(determinant: Formula, variant: Variant, at: Mapping[str, float] | None) -> list[Formula]:
    lengths = {"pi", *(g.name for g in variant.given)}
    above = [factor for factor, power in factors(determinant, ("neg", "*", "/")) if power > 0]
    found = [factor for factor in above if not set(factor.names()) <= lengths or _is_nothing(factor, variant)]
    if at is None or len(found) < 2:
        return found
    try:
        sizes = [abs(evaluate(factor, {**variant.values, **at})) for factor in found]
    except (FormulaFault, KeyError):  # a factor depends on the drive
        return found
    return [factor for factor, size in zip(found, sizes, strict=True) if size <= _SMALL * max(sizes)] or found


def _is_nothing(factor: Formula, variant: Variant) -> bool:
    """Return whether a factor of given data alone, such as the sine of the angle between two guides, is zero."""
    size = known_value(factor, variant.values)
    return size is not None and abs(size) < _ROUNDING


def _factor(tree: Formula, variant: Variant) -> str:
    units = {c.name: c.unit for c in variant.coordinates}
    if tree.op == "name" and units.get(tree.name) == "m":
        return _distance(tree.name, variant)
    angles = [name for name in tree.names() if units.get(name) == "rad"]
    if tree.op == "call" and tree.name in {"sin", "cos"} and not _counted_alike(angles, tree.args[0], variant):
        if len(angles) == 1 and tree.args[0].op == "name" and (other := _counted_from(angles[0], variant)):
            key = "determinant.across" if tree.name == "cos" else "determinant.one_line"
            return say(key, first=_link(other, variant), second=_link(angles[0], variant))
        return say("determinant.zero", formula=as_read(tree))
    if tree.op == "call" and tree.name in {"sin", "cos"} and len(angles) == 2 and _is_difference(tree.args[0]):
        first, second = (_link(name, variant) for name in angles)
        if tree.name == "cos":
            return say("determinant.across", first=first, second=second)
        return say("determinant.one_line", first=first, second=second)
    if tree.op == "call" and tree.name in {"sin", "cos"} and len(angles) == 1 and tree.args[0].op == "name":
        return say("determinant.vertical" if tree.name == "cos" else "determinant.horizontal", link=_link(angles[0], variant))
    if tree.op == "call" and tree.name in {"sin", "cos"} and len(angles) == 1 and _is_difference(tree.args[0]):
        (direction,) = set(tree.args[0].names()) - {angles[0]}
        key = "determinant.across_direction" if tree.name == "cos" else "determinant.along_direction"
        return say(key, link=_link(angles[0], variant), direction=direction)
    if tree.op == "call" and tree.name == "cos" and len(angles) == 1 and tree.args[0].names() == (angles[0],):
        return say("determinant.right_angle", link=_link(angles[0], variant))
    if angles and tree.op in {"+", "-"} and all(_FROM_X in _axes(angle, variant) for angle in angles) and _of_arms(tree, angles):
        return say("determinant.arms", links=tuple(_link(angle, variant, _OF) for angle in angles))
    key = "determinant.zero" if set(tree.names()) - {"pi", *variant.values} else "determinant.always_zero"
    return say(key, formula=as_read(tree)) if tree.names() else ""


def _of_arms(tree: Formula, angles: Sequence[str]) -> bool:
    """Return whether each term of a sum is an arm turned by one angle, or each by the same angles.

    In s - r*cos(phi1) and in d*sin(phi3) + a*sin(phi1 - phi3) it is a link without an angle of its own that counts.
    """
    calls = [[node for node in term.walk() if node.op == "call"] for term in terms(tree)]
    turned = [frozenset(name for call in found for name in call.names() if name in angles) for found in calls]
    return all(len(found) == 1 for found in calls) and (len({*turned}) == 1 or all(len(one) == 1 for one in turned))


def _counted_alike(angles: list[str], argument: Formula, variant: Variant) -> bool:
    """Return whether two angles count from one axis, or each from x; True for an argument that is no name or difference."""
    if argument.op != "name" and not _is_difference(argument):
        return True
    axes = [_axes(angle, variant) for angle in angles]
    return bool(set.intersection(*axes)) if len(axes) == 2 else all(_FROM_X in found for found in axes)


def _counted_from(angle: str, variant: Variant) -> str:
    """Return the angle from which another one is counted: phi1 for L @ (phi1 + phi2); "" if there is none."""
    found = re.fullmatch(rf"(\w+) [+-] {_FROM_X}|{_FROM_X} \+ (\w+)", " or ".join(_axes(angle, variant)))
    other = found[1] or found[2] if found else ""
    return other if any(c.name == other for c in variant.coordinates) and _FROM_X in _axes(other, variant) else ""


def _axes(angle: str, variant: Variant) -> set[str]:
    """Return how a file counts an angle: L @ phi from x, as groups do, L @ (phi - pi/2) and (L*sin(phi), …) from the vertical."""
    closures = [one for one in variant.constraints if one.is_closure]
    placed = [*(formula for _, formula in variant.points), *(side for one in closures for side in one.sides)]
    parts = [part for formula in placed for part in formula.walk()]
    ways = [part.args[1] for part in parts if part.op == "@" and angle in part.args[1].names()]
    after = [way for way in ways if {c.name for c in variant.coordinates if c.name != angle} & {*way.names()}]
    sides = [(Formula("call", (way,), "cos"), "x") for way in ways if way not in after]
    sides += [(side, axis) for part in parts if part.op == "pair" for side, axis in zip(part.args, "xy", strict=True)]
    held = [*variant.holds, *(Formula("-", one.sides) for one in closures)]
    sides += [side for formula in held for side in _sides(formula)]
    found = {re.sub(rf"\b{angle}\b", _FROM_X, spelled(way)) for way in after} | _from_sides(sides, angle, variant)
    grouped = any(angle in group.coordinates for group in variant.groups)
    return found | {_FROM_X} if grouped or not found else found


def _sides(hold: Formula) -> list[tuple[Formula, str]]:
    """Return the terms of a sum that stand beside components of points, such as r*cos(phi) in A.x - r*cos(phi), and the axis."""
    summands = list(terms(on_axes(hold)))
    axes = {node.name for term in summands for node in term.walk() if node.op == "part"}
    beside = [term for term in summands if all(node.op != "part" for node in term.walk())]
    return [(term, axis) for term in beside for axis in axes if len(axes) == 1]


def _from_sides(sides: Sequence[tuple[Formula, str]], angle: str, variant: Variant) -> set[str]:
    """Return how components along x and y count an angle: L*cos(phi) along x and L*sin(phi) along y from x."""
    found = set()
    for side, axis in sides:
        others = dict.fromkeys(side.names(), _ANY) | {"pi": math.pi, **variant.values}
        try:
            # Of K cos(phi + turn) + c, the sum of two neighbours less twice the middle is a multiple of K cos(phi + turn).
            across, along = (
                sum(
                    weight * evaluate(side, {**others, angle: at + step})
                    for step, weight in ((-1.0, 1.0), (0.0, -2.0), (1.0, 1.0))
                )
                for at in (math.pi / 2, 0.0)
            )
        except FormulaFault:
            continue
        if max(abs(across), abs(along)) > _ROUNDING:
            turn = (math.atan2(across, -along) + (math.pi / 2 if axis == "y" else 0.0)) / math.pi
            off = turn - round(turn)
            found.add(_FROM_X if abs(off) < _SMALL else f"{abs(off):.6f}")
    return found


def _distance(name: str, variant: Variant) -> str:
    """Return what it means that a length is zero: two points meet, if the file shows that it is their distance."""
    for group in variant.groups:
        if name in group.coordinates and not group_kind(group.kind).shape.guides:  # the slide is along the lever itself
            return say("determinant.distance" if constant(group.offset) == 0 else "determinant.level", name=name)
    for point, formula in variant.points:
        parts = [*terms(formula)]
        if [part.op for part in parts] == ["name", "@"] and parts[1].args[0].op == "name" and parts[1].args[0].name == name:
            return say("determinant.meet", name=name, point=point, other=parts[0].name)
    return say("determinant.nothing", name=name)


def _is_difference(tree: Formula) -> bool:
    """Return whether a formula is the difference of two names."""
    return tree.op == "-" and all(arg.op == "name" for arg in tree.args)


def _link(angle: str, variant: Variant, keys: tuple[str, str] = _NAMED) -> str:
    rate = next((c.rate for c in variant.coordinates if c.name == angle), "")
    names = [link.name for link in variant.links if link.rate == rate] or _bodies(angle, variant) or _held(angle, variant)
    named, at_angle = keys
    return say(named, name=names[0]) if names else say(at_angle, angle=angle)


def _held(angle: str, variant: Variant) -> list[str]:
    """Return the links that hold both ends of an arm placed by an angle: A and B in B = A + L @ angle."""
    angles = {c.name for c in variant.coordinates}
    arms = [
        (len(angles.intersection(formula.args[1].args[1].names())), {formula.args[0].name, point})
        for point, formula in variant.points
        if formula.op == "+" and [arg.op for arg in formula.args] == ["name", "@"] and angle in formula.args[1].args[1].names()
    ]
    fewest = min((count for count, _ in arms), default=0)  # phi1 + phi2 is the angle of the second link
    return [link.name for count, ends in arms if count == fewest for link in variant.links if ends <= {*link.points}]


def _bodies(angle: str, variant: Variant) -> list[str]:
    """Return the name of the body of a chain that goes with an angle, in a list; empty if [links] are given or none does."""
    chain = linkage(variant, dict(variant.points)) if variant.groups and not variant.links else None
    names = link_names(chain, variant) if chain else {}
    return [name for body, name in names.items() if chain and chain.coordinates[body] == angle]
