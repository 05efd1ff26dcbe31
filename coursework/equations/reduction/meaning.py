"""What a vanishing determinant means for the mechanism, in a sentence.

Enters: the determinant as shown.  Leaves: words.  Used by `blocks.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from coursework.mechanism.groups import group_kind
from coursework.mechanism.joints import link_names, linkage
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, factors, product_of, spelled
from coursework.variant.record.variant import Variant
from coursework.words.sentences import joined, say

# At a singular position a factor this small beside the largest one is the factor that vanishes.
_SMALL = 1e-3
# The sine of an angle given with all digits of pi is still this much beside zero.
_ROUNDING = 1e-12


def meaning(determinant: Formula, variant: Variant, equations: Sequence[str], at: Mapping[str, float] | None = None) -> str:
    """Return when the determinant of some equations is zero and what then holds, such as "links 1 and 2 lie on one line".

    With the coordinates of a singular position `at`: only what holds there.
    """
    if _vanishing(determinant, variant, at) and (known := _of_group(variant, equations)):
        return known
    found = [sentence for factor in _vanishing(determinant, variant, at) if (sentence := _factor(factor, variant))]
    return joined(found, "join.or_else") if found else say("determinant.never")


def _of_group(variant: Variant, equations: Sequence[str]) -> str:
    """Return what a dyad says of its determinant, where the angles alone do not tell link from guide."""
    for number, group in enumerate(variant.groups, start=1):
        if set(equations) == {f"G{number}x", f"G{number}y"}:
            key = group_kind(group.kind).meaning
            return say(key, link=_link(group.coordinates[0], variant)) if key else ""
    return ""


def vanishing(determinant: Formula, variant: Variant, at: Mapping[str, float] | None = None) -> Formula:
    """Return the determinant without sign and constant lengths: the part that can be zero (that is zero `at` a position)."""
    found = _vanishing(determinant, variant, at)
    return product_of(found) if found else determinant


def _vanishing(determinant: Formula, variant: Variant, at: Mapping[str, float] | None) -> list[Formula]:
    lengths = {g.name for g in variant.given}
    above = [factor for factor, power in factors(determinant, ("neg", "*", "/")) if power > 0]
    found = [factor for factor in above if not set(factor.names()) <= lengths or _is_nothing(factor, variant)]
    if at is None or len(found) < 2:
        return found
    try:
        sizes = [abs(evaluate(factor, {**variant.values, **at})) for factor in found]
    except (FormulaFault, KeyError):  # a factor that depends on the drive
        return found
    return [factor for factor, size in zip(found, sizes, strict=True) if size <= _SMALL * max(sizes)] or found


def _is_nothing(factor: Formula, variant: Variant) -> bool:
    """Return whether a factor of given data alone, such as the sine of the angle between two guides, is zero."""
    try:
        return abs(evaluate(factor, variant.values)) < _ROUNDING
    except (FormulaFault, KeyError):
        return False


def _factor(tree: Formula, variant: Variant) -> str:
    units = {c.name: c.unit for c in variant.coordinates}
    if tree.op == "name" and units.get(tree.name) == "m":
        return say("determinant.distance", name=tree.name)
    angles = [name for name in tree.names() if units.get(name) == "rad"]
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
    if tree.op in {"+", "-"}:
        return say("determinant.arms", links=_listed(angles, variant))
    key = "determinant.zero" if set(tree.names()) - set(variant.values) else "determinant.always_zero"
    return say(key, formula=spelled(tree)) if tree.names() else ""


def _is_difference(tree: Formula) -> bool:
    """Return whether a formula is one name less another."""
    return tree.op == "-" and all(arg.op == "name" for arg in tree.args)


def _link(angle: str, variant: Variant) -> str:
    rate = next((c.rate for c in variant.coordinates if c.name == angle), "")
    names = [link.name for link in variant.links if link.rate == rate] or _bodies(angle, variant)
    return say("determinant.link", name=names[0]) if names else say("determinant.link_at", angle=angle)


def _bodies(angle: str, variant: Variant) -> list[str]:
    """Return what the body of a chain of groups that goes with an angle is called, where no link is listed."""
    chain = linkage(variant, dict(variant.points)) if variant.groups and not variant.links else None
    names = link_names(chain, variant) if chain else {}
    return [name for body, name in names.items() if chain and chain.coordinates[body] == angle]


def _listed(angles: list[str], variant: Variant) -> object:
    return tuple(_link(angle, variant) for angle in angles) if angles else say("determinant.links")
