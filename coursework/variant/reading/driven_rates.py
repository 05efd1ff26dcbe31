"""A constraint that only says how fast a coordinate changes, whatever the mechanism does, such as w1 = n: it is a drive.

Enters: a `Variant` as its file has it.  Leaves: the same with such constraints in its drive.  Used by `reader.py`.
"""

from __future__ import annotations

import math
from dataclasses import replace

from coursework.variant.formula.made import quotient_of, summed
from coursework.variant.formula.tree import Formula, constant, factors, named, signed
from coursework.variant.reading.parts import ZERO
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Constraint, Law, Variant
from coursework.variant.toml.positions import KeyPath

_SOME_TIME = 0.37  # s; two laws that are equal then are one


def with_driven_rates(variant: Variant) -> Variant:
    r"""Return the variant with each rate that a constraint gives as a function of time among its drives.

    A rate that is 0 says how a link is held, one that follows from the velocity of a driven point is geometry, and where neither
    links nor groups are listed, or nothing would be left for another constraint to determine, the constraint is one of the
    equations: all stay.  Of several constraints that give one rate alike the first is the drive.

    >>> import coursework
    >>> text = coursework.load("cardan").path.read_text(encoding="utf-8").replace('w1 = "w0"', "")
    >>> coursework.parse_variant(text + '[[constraint]]\nequation = "2*w1 = 2*w0"').known_rates
    ('w1',)
    """
    if variant.motor is not None or not (variant.links or variant.groups):
        return variant
    of_points = {f"V{point}{axis}" for point, _ in variant.points for axis in "xy"}
    known = {"t", "pi", *variant.values, *(law.name for law in variant.drive if law.name not in {*of_points, *variant.rates})}
    found: dict[str, list[tuple[Formula, Constraint]]] = {}
    for one in variant.constraints:
        named_rates = [name for name in one.difference.names() if name in variant.rates and name in variant.sought]
        laws = [(rate, law) for rate in named_rates if not one.is_closure and (law := _solved(rate, one.difference, ZERO))]
        rate, law = next(((rate, law) for rate, law in laws if known.issuperset(law.names())), ("", ZERO))
        if constant(law) != 0:
            found.setdefault(rate, []).append((law, one))
    values = {"t": _SOME_TIME, "pi": math.pi, **variant.values}
    found = {rate: told for rate, told in found.items() if len({_rounded(known_value(law, values)) for law, _ in told}) == 1}
    firsts, repeated = [told[0][1] for told in found.values()], [one for told in found.values() for _, one in told[1:]]
    left = tuple(one for one in variant.constraints if one not in firsts)
    sought = {*variant.sought} - {*found}
    if not all(one in repeated or one.is_closure or sought.intersection(one.difference.names()) for one in left):
        return variant
    lines: dict[KeyPath, int] = {("drive", rate): told[0][1].line for rate, told in found.items()}
    drive = (*variant.drive, *(Law(rate, told[0][0]) for rate, told in found.items()))
    return replace(variant, drive=drive, constraints=left, lines={**variant.lines, **lines})


def _solved(rate: str, left: Formula, right: Formula) -> Formula | None:
    """Return what a rate is where `left` equals `right`, which is without it; None if it is not linear or has no slope."""
    if left == named(rate):
        return right
    terms = [(term, sign) for term, sign in signed(left) if all(constant(part) != 0 for part, _ in factors(term))]
    own = [(term, sign) for term, sign in terms if rate in term.names()]
    rest = [(term, -sign) for term, sign in terms if rate not in term.names()]
    right = summed([*([(right, 1)] if constant(right) != 0 else []), *rest])
    slopes = []
    for term, sign in own:
        parts = [*factors(term, {"*", "/"})]
        inner = [part for part, power in parts if rate in part.names() and power > 0]
        others = [(part, power) for part, power in parts if rate not in part.names()]
        if len(inner) + len(others) < len(parts) or len(inner) != 1:
            return None
        if len(own) == 1 and inner[0].op in {"+", "-", "neg", "name"}:
            for part, power in others:
                right = Formula("/" if power > 0 else "*", (right, part))
            return _solved(rate, inner[0], right if sign > 0 else summed([(right, -1)]))
        if inner[0] != named(rate):
            return None
        slopes.append((quotient_of(others), sign))
    slope = summed(slopes)
    return Formula("/", (right, slope)) if constant(slope) != 0 else None


def _rounded(value: float | None) -> str:
    return "" if value is None else f"{value:.12g}"
