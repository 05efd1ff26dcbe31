"""A variant -> the same variant with one misconception written into its formulas.

Enters: a `Variant`.  Leaves: a `Variant`, or None where the misconception cannot be written into it.  Used by `key.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

from coursework.equations.reduction.equations import VelocityEquations
from coursework.variant.formula.tree import Formula, mapped, named, number
from coursework.variant.record.variant import Constraint, Law, Variant

_TURNING = ("sin", "cos", "tan")
_OTHER = {"sin": "cos", "cos": "sin"}
_DEGREE = Formula("/", (named("pi"), number(180)))
_PER_RADIAN = Formula("/", (number(180), named("pi")))
_ROUNDED_PI = Fraction("3.14")
_BY_PI = ("deg", "rpm")  # units whose size in SI has π in it


def misread(variant: Variant, equations: VelocityEquations, code: str) -> Variant | None:
    """Return the variant with one misconception in its formulas, None if it cannot be written into them.

    "sign_drive" turns the sign of the drive, "cosine_drive" exchanges sine and cosine in it; with the name of a law instead of
    "drive" they do so in this law alone, if others would change too.  Degrees are taken for radians in all formulas
    ("degree_mode"), in functions of time ("degree_drive") or of position ("degree_geometry").  "radian_mode" puts positions in
    degrees where radians are expected, as in a spreadsheet.  "pi_rounded" takes π as 3.14 in formulas and units.
    `equations` are the variant's velocity equations: a student who derives them from the geometry puts positions into these, not
    into the geometry.
    """
    fault, _, of = code.partition("_")
    if fault in _IN_LAWS:
        every = tuple(map(_IN_LAWS[fault], variant.drive))
        drive = tuple(new if of in {"drive", law.name} else law for law, new in zip(variant.drive, every, strict=True))
        is_told = drive == variant.drive or (of != "drive" and drive == every)
        return None if is_told else replace(variant, drive=drive)
    if code == "pi_rounded":
        changed = _with_pi_rounded(variant)
        return None if changed == variant else changed
    if code == "degree_geometry" and _in_degrees(variant, drive=True, geometry=False) == variant:
        return None  # without a sine in the drive this is the same as "degree_mode"
    if code != "degree_drive" and (variant.groups or any(one.is_closure for one in variant.constraints)):
        written = _written_out(variant, equations)
        return written and _misread(written, code)
    changed = _misread(variant, code)
    return None if changed == variant else changed


def _written_out(variant: Variant, equations: VelocityEquations) -> Variant | None:
    """Return the variant with its velocity equations instead of the geometry, None if a term in them has no name."""
    sides = [(one.name, one.shown(equations.order)) for one in equations.equations]
    if variant.functions or any(not {*tree.names()} <= {*variant.names, "pi"} for _, both in sides for tree in both):
        return None
    begun = tuple(replace(one, start=one.start or 0.0) for one in variant.coordinates)  # the start does not change velocities
    lines = tuple(Constraint(name, "", *both) for name, both in sides)
    return replace(
        variant, constraints=lines, coordinates=begun, groups=(), points=(), links=(), holds=(), driven=None, bindings=()
    )


def _exchanged(tree: Formula) -> Formula:
    """Return a formula with sine and cosine exchanged everywhere."""
    return replace(mapped(tree, _exchanged), name=_OTHER.get(tree.name, tree.name) if tree.op == "call" else tree.name)


def _with_pi_rounded(variant: Variant) -> Variant:
    return replace(
        _rewritten(variant, _pi_rounded, _pi_rounded),
        given=tuple(
            replace(datum, value=datum.value * float(_ROUNDED_PI) / math.pi) if datum.unit.startswith(_BY_PI) else datum
            for datum in variant.given
        ),
    )


def _pi_rounded(tree: Formula) -> Formula:
    return number(_ROUNDED_PI) if tree.op == "name" and tree.name == "pi" else mapped(tree, _pi_rounded)


def _turned(law: Law) -> Law:
    """Return the law with the other sign; 0 stays 0."""
    turned = law.rewritten(lambda formula: formula if formula == number(0) else Formula("neg", (formula,)))
    return replace(turned, table=tuple((at, -value) for at, value in law.table))


# Faults of laws, by the word that their codes begin with.
_IN_LAWS: dict[str, Callable[[Law], Law]] = {"sign": _turned, "cosine": lambda law: law.rewritten(_exchanged)}


def _misread(variant: Variant, code: str) -> Variant:
    if code == "radian_mode":
        return _in_degrees(variant, drive=False, geometry=True, factor=_PER_RADIAN)
    return _in_degrees(variant, drive=code in {"degree_mode", "degree_drive"}, geometry=code != "degree_drive")


def _in_degrees(variant: Variant, *, drive: bool, geometry: bool, factor: Formula = _DEGREE) -> Variant:
    """Return the variant as a calculator in degrees computes it: the argument of every sine, cosine and tangent is scaled."""

    def degrees(tree: Formula) -> Formula:
        turned = mapped(tree, degrees)
        if tree.op == "@" or (tree.op == "call" and tree.name in _TURNING):
            *length, angle = turned.args
            return replace(turned, args=(*length, Formula("*", (angle, factor))))
        return turned

    return _rewritten(variant, degrees if drive else _as_it_is, degrees if geometry else _as_it_is)


def _as_it_is(tree: Formula) -> Formula:
    return tree


def _rewritten(variant: Variant, in_time: Callable[[Formula], Formula], in_place: Callable[[Formula], Formula]) -> Variant:
    """Return the variant with the formulas of time rewritten in one way, those of positions in another."""

    def laws(found: Sequence[Law]) -> tuple[Law, ...]:
        return tuple(law.rewritten(in_place if law.of in positions else in_time) for law in found)

    positions = {coordinate.name for coordinate in variant.coordinates}
    return replace(
        variant,
        drive=laws(variant.drive),
        functions=laws(variant.functions),
        constraints=tuple(replace(c, left=in_place(c.left), right=in_place(c.right)) for c in variant.constraints),
        points=tuple((name, in_place(point)) for name, point in variant.points),
        holds=tuple(in_place(hold) for hold in variant.holds),
    )
