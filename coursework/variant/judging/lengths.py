"""Links of zero length, whose angular velocity has no meaning, or of negative length: refused before any computation.

Enters: a `Variant` and its `Source`.  Leaves: faults.  Used by `whole_file.py` and `other_data.py`; the sentence about a length
that becomes negative during the motion comes from `motion/geometry/chain.py`.  Source: hard case H16.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from coursework.variant.formula.tree import Formula, named, spelled
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_RIGHT = 1e-9  # tolerance, in quarter turns, for a right angle in degrees read as radians


def faults_of_lengths(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each zero length (before @, of a group, wheel or circle) and for each datum that makes one negative.

    If there are none, return a fault for each velocity that has only zero factors.  A length that is negative for positive data
    is meant so: -r @ phi turns it round, (a - b) @ phi may count from either side.  The lengths in e @ (phi + pi/2), (x, y) and
    the offset of a guide are offsets with a sign.
    """
    found = dict.fromkeys((path, spelled(length)) for path, length, _ in _lengths(variant) if _value(length, variant) == 0)
    faults = [source.fault(source.path_of(path), say("fault.V087", text=text)) for path, text in found]
    return faults + _negative(variant, source) or _lost(variant, source)


def _lengths(variant: Variant) -> Iterator[tuple[KeyPath, Formula, bool]]:
    """Yield the path of every length, its formula, and whether it may be negative.

    These are lengths before @, of groups, from the centre of a wheel to its contact, and radii of circles of the frame.
    """
    for path, formula in variant.formulas():
        yield from ((path, node.args[0], _is_across(node.args[1], variant)) for node in formula.walk() if node.op == "@")
    for i, group in enumerate(variant.groups):
        yield from ((("group", i, "lengths", j), length, False) for j, length in enumerate(group.lengths))
    points = dict(variant.points)
    for link in variant.links:
        arm = points.get(link.contact or "")
        if (
            link.wheel
            and arm is not None
            and arm.op in {"+", "-"}
            and arm.args[0] == named(link.wheel)
            and arm.args[1].op == "pair"
        ):
            zeros = [_value(part, variant) == 0 for part in arm.args[1].args]
            for part, other_is_zero in zip(arm.args[1].args, reversed(zeros), strict=True):
                if other_is_zero:  # the wheel is on a guide along an axis
                    yield ("points", str(link.contact)), part, False
    for i, (_, radius) in enumerate(variant.frame.circles):
        yield ("frame", "circles", i, "radius"), radius, False


def refused_length(reason: str) -> Sentence:
    """Return the sentence about a group with a length that no rod can have."""
    return say("fault.V308", reason=reason)


def is_refused(variant: Variant, name: str, value: float) -> bool:
    """Return whether the variant would be refused with another value (SI) of a datum, as a length would be zero or negative."""
    other = variant.with_values({name: value})
    return bool(_below(other)) or any(_value(length, other) == 0 for _, length, _ in _lengths(other))


def _negative(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each datum that makes a length negative, at its simplest use, and for other such lengths of a group."""
    faults = []
    for path, length, value in _below(variant):
        reason = say("group.positive.alone", what=spelled(length), found=_typed(length, value, variant), row=0)
        faults.append(source.fault(source.path_of(path), refused_length(reason)))
    return faults


def _below(variant: Variant) -> list[tuple[KeyPath, Formula, float]]:
    """Return the path, formula and value of each length that a datum makes negative, where it is used most simply."""
    below = {name for name, value in variant.values.items() if value < 0}
    worst: dict[str, tuple[int, KeyPath, Formula, float]] = {}
    for path, length, is_signed in _lengths(variant):
        value = _value(length, variant)
        culprits = sorted(below & {*length.names()}) or [spelled(length)] * (path[0] in {"group", "frame"})
        if value is not None and value < 0 and not is_signed:
            for name in culprits:
                plainness = sum(1 for _ in length.walk())
                if name not in worst or plainness < worst[name][0]:
                    worst[name] = (plainness, path, length, value)
    return [(path, length, value) for _, path, length, value in worst.values()]


def _typed(length: Formula, value: float, variant: Variant) -> str:
    """Return a length as it was typed, with its unit; a length from a formula in metres."""
    texts = {given.name: f"{given.text} {given.unit}".strip() for given in variant.given if given.value == value}
    return texts.get(spelled(length)) or say("group.exact", metres=value)


def _is_across(angle: Formula, variant: Variant) -> bool:
    """Return whether an angle is that of a sideways offset, phi + pi/2, or of an axis."""
    turn = _value(angle.args[1] if angle.op in {"+", "-"} else angle, variant)
    quarters = (turn or 0.0) / (math.pi / 2)
    if turn is None or abs(quarters - round(quarters)) > _RIGHT:
        return False
    return angle.op not in {"+", "-"} or round(quarters) % 2 == 1


def _lost(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each unknown velocity in written equations that is always multiplied by a zero length."""
    kept: set[str] = set()
    beside: dict[str, tuple[str, int]] = {}
    for index, constraint in enumerate(variant.constraints):
        for side in constraint.sides:
            for name, zero in _beside_zero(side, variant, ""):
                if zero:
                    beside.setdefault(name, (zero, index))
                else:
                    kept.add(name)
    faults = []
    for name, (zero, index) in beside.items():
        if name not in kept and name in variant.sought:
            message = say("fault.V088", name=name, zero=zero)
            faults.append(source.fault(("constraint", index, "equation"), message))
    return faults


def _beside_zero(tree: Formula, variant: Variant, zero: str) -> list[tuple[str, str]]:
    """Return every name with the zero factor that multiplies it, "" if none."""
    if tree.op == "name":
        return [(tree.name, zero)]
    if tree.op == "*":
        both = ((tree.args[0], tree.args[1]), (tree.args[1], tree.args[0]))
        zeros = [(one, zero or (spelled(other) if _value(other, variant) == 0 else "")) for one, other in both]
        return [entry for one, beside in zeros for entry in _beside_zero(one, variant, beside)]
    return [entry for arg in tree.args for entry in _beside_zero(arg, variant, zero)]


def _value(length: Formula, variant: Variant) -> float | None:
    """Return a length that follows from the data alone (m), None for any other."""
    return known_value(length, variant.values)
