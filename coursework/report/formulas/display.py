"""A displayed equation on as many lines as it needs.

Enters: both sides as `Formula`.  Leaves: Typst math.  An equation too long for a line is broken before a sign; a quotient
with a wide sum in its numerator becomes a short fraction before that sum in brackets.
Used by `assigning/page_words.py`, `laws.py`, `model.py`, `motion_equations.py` and `solution.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache

from coursework.report.formulas.typst_math import Setter, text_equation
from coursework.report.text.numbers import POINT
from coursework.report.text.parts import Display, Runs
from coursework.report.text.symbols import NO_RATES, Rates
from coursework.variant.formula.made import product_of
from coursework.variant.formula.tree import Formula, factors
from coursework.words.templates import clean

LINE = 64  # characters of text form (spaces and subscripts not counted) that fit a line of the printed page
INDENT = 4  # in the same unit: the indent of a continued line

Piece = tuple[int, str]  # width, source
_DECIMAL = re.compile(r"(?<![\w.])(\d+)\.(\d+)(?![^\W⁰¹²³⁴-⁹]|\.)")  # 2.5, also in 2.5², but not in 2.5.1


def math_equation(left: Formula, right: Formula, rates: Rates = NO_RATES) -> str:
    """Return "left = right" as Typst math."""
    typst, plain = Setter(typst=True, rates=rates), Setter(typst=False, rates=rates)
    if _width(left, plain) + _width(right, plain) + 3 <= LINE:
        return f"{typst.set(left).source} = {typst.set(right).source}"
    parts = list(_terms(left, typst, plain))
    sign = "= "
    spread = _spread(right, plain) if _width(right, plain) > LINE else None
    if spread is None:
        found = list(_terms(right, typst, plain))
        parts += [(found[0][0] + 3, sign + found[0][1]), *found[1:]]
        return _folded(parts)
    is_negative, before, inside = spread
    found = list(_terms(inside, typst, plain))
    factor, width = (typst.set(before).source, _width(before, plain)) if before else ("", 0)
    head = f"{sign}{'-' if is_negative else ''}{factor} ["
    parts.append((found[0][0] + width + 4, f"{head} {found[0][1]}"))
    return _folded([*parts, *found[1:-1], (found[-1][0] + 1, f"{found[-1][1]} ]")])


def display(left: Formula, right: Formula, rates: Rates = NO_RATES, name: str = "", before: Runs | None = None) -> Display:
    """Return "left = right" as a display, with `name` at the margin and the words `before` it."""
    math, text = _set(left, right, rates)
    return Display(math, text, name=clean(name, 40), before=before or [])


@lru_cache(maxsize=2048)  # a page has about thirty; the next page of the same task template has the same ones
def _set(left: Formula, right: Formula, rates: Rates) -> tuple[str, str]:
    return math_equation(left, right, rates), text_equation(left, right, rates)


def marked(one: Display, mark: str) -> Display:
    """Return a display whose numbers have the decimal sign `mark`."""
    if mark == POINT:
        return one
    pieces = one.math.split('"')
    math = '"'.join(piece if place % 2 else _DECIMAL.sub(rf'"\1{mark}\2"', piece) for place, piece in enumerate(pieces))
    return replace(one, math=math, text=marked_text(one.text, mark))


def marked_text(text: str, mark: str) -> str:
    """Return a formula in plain text with the decimal sign `mark`."""
    return _DECIMAL.sub(rf"\1{mark}\2", text)


def _terms(tree: Formula, typst: Setter, plain: Setter) -> Iterator[Piece]:
    """Yield the terms of a sum, each with its sign."""
    measured = plain.terms(tree)
    for position, (sign, piece) in enumerate(typst.terms(tree)):
        lead = f"{sign} " if position or sign != "+" else ""
        yield _width_of(measured[position][1].source) + (3 if lead else 0), lead + piece.source


def _spread(tree: Formula, plain: Setter) -> tuple[bool, Formula | None, Formula] | None:
    """Split a quotient or product at its widest sum into (is negative, the factor before the sum, the sum); None without one.

    The factor is None where only a minus stands before the sum.
    """
    above, below = (tree.args[0], tree.args[1]) if tree.op == "/" else (tree, None)
    if above.op == "neg":
        rest = Formula("/", (above.args[0], below)) if below else above.args[0]
        if rest.op in {"+", "-"}:
            return True, None, rest
        inner = _spread(rest, plain)
        return None if inner is None else (not inner[0], inner[1], inner[2])
    parts = [factor for factor, _ in factors(above)]
    sums = [factor for factor in parts if factor.op in {"+", "-"}]
    if not sums or (below is None and len(parts) == 1):
        return None
    widest = max(sums, key=lambda factor: _width(factor, plain))
    before = product_of([factor for factor in parts if factor is not widest])
    return False, Formula("/", (before, below)) if below else before, widest


def _folded(parts: list[Piece]) -> str:
    lines: list[list[str]] = [[]]
    room = LINE
    for width, source in parts:
        # No break follows a left side that is no wider than the indent: the next line would have no more room.
        if lines[-1] and width > room and (len(lines) > 1 or LINE - room > INDENT):
            lines.append([])
            room = LINE - INDENT
        lines[-1].append(source)
        room -= width
    return r" \ ".join(("& " if row == 0 else "& quad ") + " ".join(line) for row, line in enumerate(lines))


def _width(tree: Formula, plain: Setter) -> int:
    """Estimate the printed width in characters; a fraction is as wide as its wider part."""
    if tree.op == "/":
        return max(_width(arg, plain) for arg in tree.args)
    if tree.op in {"+", "-", "*"}:
        return sum(_width(arg, plain) for arg in tree.args) + (0 if tree.op == "*" else 3)
    return _width_of(plain.set(tree).source)


def _width_of(source: str) -> int:
    return len(re.sub(r"[₀-₉⁰-⁹ _]", "", source))
