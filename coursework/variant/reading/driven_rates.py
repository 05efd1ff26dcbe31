"""A constraint that only says how fast a coordinate changes, whatever the mechanism does, such as w1 = n: it is a drive.

Enters: a `Variant` as its file has it.  Leaves: the same with such constraints in its drive.  Used by `reader.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import replace

from coursework.variant.formula.made import summed
from coursework.variant.formula.tree import Formula, constant, factors, signed
from coursework.variant.reading.parts import ZERO
from coursework.variant.record.variant import Constraint, Law, Variant
from coursework.variant.toml.positions import KeyPath


def with_driven_rates(variant: Variant) -> Variant:
    r"""Return the variant with each rate that a constraint gives as a function of time among its drives.

    A rate that is 0 says how a link is held, one that follows from the velocity of a driven point is geometry, and where links
    are not listed or nothing would be left for another constraint to determine, the constraint is one of the equations: all stay.

    >>> import coursework
    >>> text = coursework.load("cardan").path.read_text(encoding="utf-8").replace('w1 = "w0"', "")
    >>> coursework.parse_variant(text + '[[constraint]]\nequation = "2*w1 = 2*w0"').known_rates
    ('w1',)
    """
    if variant.motor is not None or not variant.links:
        return variant
    of_points = {f"V{point}{axis}" for point, _ in variant.points for axis in "xy"}
    known = {"t", "pi", *variant.values, *(law.name for law in variant.drive if law.name not in {*of_points, *variant.rates})}
    found: list[tuple[str, Formula, Constraint]] = []
    for one in variant.constraints:
        rate = next((name for side in one.sides for name in side.names() if name not in known), "")
        if rate in variant.sought and rate in variant.rates and not one.is_closure:
            law = _solved(rate, one, known)
            if law is not None and constant(law) != 0:
                found.append((rate, law, one))
    times = Counter(rate for rate, _, _ in found)
    found = [each for each in found if times[each[0]] == 1]
    left = tuple(one for one in variant.constraints if one not in [constraint for _, _, constraint in found])
    sought = {*variant.sought} - {*times}
    if not all(one.is_closure or sought & {*one.left.names(), *one.right.names()} for one in left):
        return variant
    lines: dict[KeyPath, int] = {("drive", rate): one.line for rate, _, one in found}
    drive = (*variant.drive, *(Law(rate, law) for rate, law, _ in found))
    return replace(variant, drive=drive, constraints=left, lines={**variant.lines, **lines}) if found else variant


def _solved(rate: str, constraint: Constraint, known: Collection[str]) -> Formula | None:
    """Return what a rate equals; None if it is not the only unknown name of the constraint, once and linearly."""
    names = [node.name for side in constraint.sides for node in side.walk() if node.op == "name"]
    if names.count(rate) != 1 or not {*names} <= {rate, *known}:
        return None
    own, other = constraint.difference, ZERO
    while own.op != "name":
        terms = [*signed(own)]
        own, sign = next((term, sign) for term, sign in terms if rate in term.names())
        rest = [(term, -sign * each) for term, each in terms if term is not own and constant(term) != 0]
        other = summed([*([(other, sign)] if constant(other) != 0 else []), *rest])
        parts = [*factors(own, {"*", "/"})]
        own, power = next((part, power) for part, power in parts if rate in part.names())
        if power < 0 or own.op not in {"name", "+", "-", "neg"} or any(constant(part) == 0 for part, _ in parts):
            return None
        for part, power in parts:
            other = other if part is own else Formula("/" if power > 0 else "*", (other, part))
    return other
