"""Conversions between degrees and radians in a line -> factors pi/180; and the line as meant if its angles are in degrees.

Enters: a line in plain signs; a tree with the variant's names.  Leaves: the line, or another tree; nothing is guessed.
Used by `plain_text.py` and `equations.py`.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction

from coursework.grading.reading.equations.notation.signs import closing
from coursework.variant.formula.made import summed
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate_any, mapped, number
from coursework.variant.record.variant import Variant

_CONVERSION = re.compile(
    r"\b(?:\w{1,20}\.)?(?:to_?radians|rad(?:ian[st]?)?|deg_?2_?rad|deg_?to_?rad|РАДИАНЫ|РАДІАНИ|RADIANES|BOGENMASS)\s*(?=\()",
    re.IGNORECASE,
)
_OF_DEGREES = re.compile(r"\b(sin|cos|tan)_?d(?:eg)?(?=\s*\(|\s+\w|\d)", re.IGNORECASE)  # cosd(phi3) in MATLAB, Julia, Fortran
_SIGN = r"\s*(?:°|º|\^\s*\{?\s*(?:circ|∘|\*)\s*\}?|(?:Degree|deg)\b(?!\())"
_NAME_IN_DEGREES = re.compile(rf"(?<![\w.])([^\W\d]\w{{0,20}}){_SIGN}")
_GROUP_IN_DEGREES = re.compile(r"(?<=\))\s*°")
_PI = re.compile(r"(?<![\w.])(?:M_PI|%pi|(?:pi|π|ПИ|ПІ)(?=\())(?:\(\s*\))?", re.IGNORECASE)  # in C, in Maxima, in spreadsheets
_TURNED = frozenset(("sin", "cos", "tan"))
_DEGREE, _SAME = math.pi / 180, 1e-3  # 0.01745 and 57.3 are the factor, too


def with_factors(text: str) -> str:
    """Return a line with degrees as products with pi/180.

    >>> with_factors("cosd(a + 90) + sin(radians(b)) - cos(c°)")
    'cos((pi/180)*(a + 90)) + sin((pi/180)*(b)) - cos((c*pi/180))'
    """
    text = _GROUP_IN_DEGREES.sub("*pi/180", _NAME_IN_DEGREES.sub(r"(\1*pi/180)", _PI.sub("pi", text)))
    text = _CONVERSION.sub("(pi/180)*", text)
    while found := _OF_DEGREES.search(text):
        begun = found.end() + len(text[found.end() :]) - len(text[found.end() :].lstrip())
        word = re.match(r"\w+", text[begun:])
        shut = closing(text, begun)
        end = begun + word.end() if word else shut + 1 if shut > begun else len(text)
        text = f"{text[: found.start()]}{found[1]}((pi/180)*{text[begun:end]}){text[end:]}"
    return text


def with_angles_in_degrees(tree: Formula, variant: Variant) -> Formula | None:
    """Return the tree that is meant if the angles which a line converts to radians are in degrees; None if it converts none."""
    angles = {one.name for one in variant.coordinates if one.unit == "rad"} | {
        one.name for one in variant.given if one.si == "rad"
    }

    def changed(node: Formula) -> Formula:
        if node.op == "call" and node.name in _TURNED and (turned := _in_radians(node.args[0], angles)):
            return mapped(node, lambda _: turned)
        return mapped(node, changed)

    found = changed(tree)
    return None if found is tree else found


def _in_radians(argument: Formula, angles: set[str]) -> Formula | None:
    """Return a sum of angles times pi/180 without this factor, e.g. phi3 + pi/2 for (phi3 + 90)*pi/180; None for any other."""
    found = {node.name: node for node in argument.walk() if node.op == "name" and node.name != "pi"}
    if not found or not angles.issuperset(found):
        return None
    none = {"pi": math.pi, **dict.fromkeys(found, 0.0)}
    try:
        rest = evaluate_any(argument, none).real
        slopes = {name: (evaluate_any(argument, none | {name: 1.0}).real - rest) / _DEGREE for name in found}
        together = evaluate_any(argument, none | {name: 1.0 + place for place, name in enumerate(found)}).real
    except (FormulaFault, ArithmeticError, ValueError):
        return None
    is_sum = abs(together - rest - _DEGREE * sum((1.0 + k) * slope for k, slope in enumerate(slopes.values()))) <= _SAME * _DEGREE
    if not is_sum or any(abs(abs(slope) - 1) > _SAME for slope in slopes.values()):
        return None
    of_number = [(number(Fraction(round(rest, 9)).limit_denominator(10**9)), 1)] if abs(rest) > _SAME * _DEGREE else []
    return summed([*of_number, *((found[name], 1 if slope > 0 else -1) for name, slope in slopes.items())])
