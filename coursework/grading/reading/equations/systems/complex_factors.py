"""An equation of complex numbers written out, r*w*(-sin(phi) + i*cos(phi)) = v -> its real and its imaginary part.

Enters: a line, `Spellings`.  Leaves: the two equations; nothing is computed.  Used by `lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.formulas.equations import TURNED
from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.formulas.repair import sides_of
from coursework.grading.reading.equations.notation.latex import without_latex
from coursework.grading.reading.equations.notation.signs import plain_signs
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.variant.formula.made import sum_of
from coursework.variant.formula.reader import parse_equation
from coursework.variant.formula.tree import Formula, FormulaFault, number, spelled

_UNIT = re.compile(r"(?<![\w^.])[ij](?!\w)")
_ZERO = number(0)
_FEWEST, _MOST = 2, 4  # imaginary units in an equation, products of two complex numbers, each of which doubles the formula
Parts = tuple[Formula, Formula]


class _NotKnownError(ValueError):
    """A formula whose parts cannot be told apart: the unit stands in a function or below a line."""


def by_parts(line: str, spellings: Spellings) -> list[str]:
    """Return the real and the imaginary part of an equation with one imaginary unit, i or j, [] if it is none.

    >>> by_parts("i*a*(cos(b) + i*sin(b)) = i*d", Spellings(frozenset("abd"), {}, {}))
    ['-a*sin(b) = 0', 'a*cos(b) = d']
    >>> by_parts("a - i*b = (1 - i)*d", Spellings(frozenset("abd"), {}, {}))
    []
    """
    found = _UNIT.findall(line) if line.count("=") == 1 and len(line) <= EQUATION_CHARACTERS else []
    # i may be a ratio, too: of a loop, sines and cosines stand in it, and i at each turned length.
    if (
        len(units := {*found}) != 1
        or len(found) < _FEWEST
        or not TURNED.search(line)
        or spellings.canonical(unit := units.pop())
        or spellings.is_own(unit)
    ):
        return []
    try:
        sides = parse_equation(" = ".join(sides_of(plain_signs(without_latex(line)), spellings).texts))
        if (
            sum(node.op == "*" and all(unit in arg.names() for arg in node.args) for side in sides for node in side.walk())
            > _MOST
        ):
            return []
        parts = [_parts(side, unit) for side in sides]
    except (FormulaFault, _NotKnownError):
        return []
    if all(imaginary == _ZERO for _, imaginary in parts):
        return []
    (left, upper), (right, lower) = parts
    return [f"{spelled(left)} = {spelled(right)}", f"{spelled(upper)} = {spelled(lower)}"]


def _parts(tree: Formula, unit: str) -> Parts:
    """Return the real and the imaginary part of a formula."""
    if tree.op == "name" and tree.name == unit:
        return _ZERO, number(1)
    if unit not in tree.names():
        return tree, _ZERO
    if tree.op == "neg":
        real, imaginary = _parts(tree.args[0], unit)
        return sum_of("-", _ZERO, real), sum_of("-", _ZERO, imaginary)
    if tree.op not in {"+", "-", "*", "/"} or (tree.op == "/" and unit in tree.args[1].names()):
        raise _NotKnownError
    (a, b), (c, d) = (_parts(side, unit) for side in tree.args)
    if tree.op == "*":
        return sum_of("-", _times(a, c), _times(b, d)), sum_of("+", _times(a, d), _times(b, c))
    if tree.op == "/":
        a, b = (one if one == _ZERO else Formula("/", (one, c)) for one in (a, b))
        return a, b
    return sum_of(tree.op, a, c), sum_of(tree.op, b, d)


def _times(one: Formula, other: Formula) -> Formula:
    if _ZERO in (one, other):
        return _ZERO
    return other if one == number(1) else one if other == number(1) else Formula("*", (one, other))
