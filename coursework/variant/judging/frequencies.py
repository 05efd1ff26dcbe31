"""A frequency that is turned into rad/s twice: n = "60 rpm" is read as 6.28 rad/s, and 2*pi*n/60 turns it once more.

Enters: a `Variant`.  Leaves: code, path and sentence of each remark.  Used by `plausibility.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from coursework.variant.formula.tree import Formula
from coursework.variant.formula.units import UNITS
from coursework.variant.judging.dimension_words import text_of
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Given, Variant
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# 0.1047, 0.105, 3.14/30, 1/9.55: a factor is the one of the unit where it has that many of its digits.
_NEAR = 0.005
_MINUTE = 60.0
_PLAIN = {"", "1"}  # SI units of a datum that may itself be the factor


def frequencies_turned_twice(variant: Variant) -> Iterator[tuple[str, KeyPath, Sentence]]:
    """Yield a remark for each law whose datum has a unit of frequency and is multiplied by the size of that unit, or by pi/30."""
    turned = {given.name: given for given in variant.given if given.si == "1/s"}
    if not turned:
        return
    plain = {given.name: given.value for given in variant.given if given.si in _PLAIN}
    told = set()
    for path, formula in _laws(variant):
        for name, factor, whole in _factors(formula, 1.0, formula, plain):
            given = turned.get(name)
            if given is None or (path, name) in told or not factor:
                continue
            sizes = {_size(given), math.pi / 30} - {1.0}
            key = "remark.rpm" if any(abs(factor / size - 1) < _NEAR for size in sizes) else ""
            if path[0] == "time" and factor == -_MINUTE and _size(given) < 1.0:
                key = "remark.rpm_turn"
            if key:
                told.add((path, name))
                known = {"name": name, "text": given.text, "unit": given.unit, "place": _place(path, variant)}
                yield "RPM", path, say(key, **known, term=text_of(whole))


def _place(path: KeyPath, variant: Variant) -> str:
    if path[0] == "constraint":
        return say("place.constraint", name=variant.constraints[int(path[1])].name)
    return str(path[1])


def _size(given: Given) -> float:
    return float(UNITS[given.unit][0]) if given.unit in UNITS else 1.0


def _laws(variant: Variant) -> Iterator[tuple[KeyPath, Formula]]:
    for section, laws in (("drive", variant.drive), ("functions", variant.functions)):
        for law in laws:
            if law.formula:
                yield (section, law.name), law.formula
            yield from (((section, law.name, "pieces", place, 1), formula) for place, (_, formula) in enumerate(law.pieces))
    for index, constraint in enumerate(variant.constraints):
        yield from ((("constraint", index, constraint.key), side) for side in constraint.sides)
    yield from variant.times.items()


def _factors(tree: Formula, factor: float, whole: Formula, plain: Mapping[str, float]) -> Iterator[tuple[str, float, Formula]]:
    """Yield (name, size of the number it is multiplied by, product it stands in); in a denominator the number is negative."""
    if tree.op == "name":
        yield tree.name, factor, whole
    elif tree.op in {"neg", "+", "-"}:
        for arg in tree.args:
            yield from _factors(arg, factor, whole if factor != 1.0 else arg, plain)
    elif tree.op in {"*", "/"}:
        first, second = tree.args
        left, right = known_value(first, plain), known_value(second, plain)
        is_quotient = tree.op == "/"
        if left is None and right != 0:
            number = 1.0 if right is None else abs(1 / right if is_quotient else right)
            yield from _factors(first, factor * number, whole, plain)
        if right is None:
            number = factor * (1.0 if left is None else abs(left))
            yield from _factors(second, -number if is_quotient else number, whole, plain)
    else:
        for arg in tree.args:
            yield from _factors(arg, 1.0, arg, plain)
