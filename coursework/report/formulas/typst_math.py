"""A formula tree -> Typst math, and plain Unicode text of the same meaning.

Enters: `Formula`.  Leaves: source that only this program makes (never a student's text, so the template may `eval` it).
Products have no sign, quotients are proper fractions in Typst and "a / (b c)" in text, terms keep the author's order.
Used by `display.py` and `report/sections/`.
"""

from __future__ import annotations

import re
from dataclasses import replace
from enum import IntEnum

from coursework.report.text.numbers import MINUS, TIMES, superscript
from coursework.report.text.symbols import NO_RATES, Rates, parts_of_derivative, symbol
from coursework.report.text.text_runs import ITALIC
from coursework.system.frozen import frozen
from coursework.variant.formula.made import degrees_in
from coursework.variant.formula.tree import Formula


class Level(IntEnum):
    """How tightly a piece binds; where a tighter piece is required, it is put into parentheses."""

    SUM = 0
    SIGNED = 1
    QUOTIENT = 2
    PRODUCT = 3
    APPLIED = 4
    POWER = 5
    ATOM = 6


@frozen
class Piece:
    """A rendered part.  `inner` is a SIGNED piece without its minus; `opens` and `closes` say how it begins and ends."""

    source: str
    level: Level
    inner: Piece | None = None
    opens: str = ""  # "number", "function", "word" or "parenthesis"
    closes: str = ""  # "number", "bare" (sin φ without parentheses), "word"


_TYPST_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln", "atan2": 'op("atan2")'}
_TEXT_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln", "sqrt": "√"}
_RAISED_FUNCTIONS = {"sin", "cos", "tan"}
_EXPONENTIAL = re.compile(r"(.*)[eE]\+?(-?\d+)")


@frozen
class Setter:
    """A writer of formulas, in Typst math if `typst`, else in plain text; `rates` are names whose "d…" is a time derivative.

    `in_sentence`: mark single letters, so that the sentence around the formula does not take them for words.
    """

    typst: bool
    rates: Rates = NO_RATES
    inline: bool = False  # inside an exponent: quotients with a slash
    in_sentence: bool = False

    def set(self, tree: Formula) -> Piece:
        """Return a formula as a rendered piece; raises `ValueError` for an unknown operation."""
        if turned := degrees_in(tree):
            return Piece(f"{turned} degree" if self.typst else f"{turned}°", Level.ATOM, opens="number", closes="number")
        match tree.op:
            case "number":
                return self._number(tree.name)
            case "name":
                return self._name(tree.name)
            case "neg":
                return self._negated(self.set(tree.args[0]))
            case "+" | "-":
                return self._sum(tree)
            case "*":
                return self._product(self.set(tree.args[0]), self.set(tree.args[1]))
            case "/":
                return self._quotient(self.set(tree.args[0]), self.set(tree.args[1]))
            case "^":
                return self._power(tree.args[0], tree.args[1])
            case "call":
                return self._call(tree)
            case "@":
                return self._polar(tree)
            case "pair":
                inside = ", ".join(self.set(arg).source for arg in tree.args)
                return Piece(f"({inside})", Level.ATOM, opens="parenthesis")
            case "part":
                return self._part(tree)
        raise ValueError(f"no way to set {tree.op!r}")

    def _number(self, digits: str) -> Piece:
        digits = digits if digits.strip("0.") else "0"
        if match := _EXPONENTIAL.fullmatch(digits):
            minus = "-" if self.typst else MINUS
            ten = f"10^({match[2].replace('-', minus)})" if self.typst else f"10{superscript(match[2])}"
            mantissa = match[1].rstrip(".")
            if float(mantissa) == 1:
                return Piece(ten, Level.POWER, opens="number", closes="number")
            return Piece(f"{mantissa} {self._dot} {ten}", Level.PRODUCT, opens="number", closes="number")
        return Piece(digits.rstrip("."), Level.ATOM, opens="number", closes="number")

    def _name(self, name: str) -> Piece:
        if parts := parts_of_derivative(name):
            partial = "partial " if self.typst else "∂"
            above, below = (Piece(partial + self._name(part).source, Level.POWER) for part in parts)
            return self._quotient(above, below)
        found = symbol(name, self.rates)
        kind = "word" if len(found.letter) > 1 else ""
        is_bare = self.in_sentence and len(found.text) == 1 and found.text.isascii()
        shown = f"{ITALIC[0]}{found.text}{ITALIC[1]}" if is_bare else found.text
        return Piece(found.typst if self.typst else shown, Level.ATOM, opens=kind, closes=kind)

    @property
    def _dot(self) -> str:
        return "dot" if self.typst else TIMES

    def _wrapped(self, piece: Piece, level: Level) -> Piece:
        if piece.level >= level:
            return piece
        return Piece(f"({piece.source})", Level.ATOM, opens="parenthesis")

    def _negated(self, piece: Piece) -> Piece:
        inner = self._wrapped(piece, Level.QUOTIENT)
        return Piece(f"{'-' if self.typst else MINUS}{inner.source}", Level.SIGNED, inner=inner)

    def _sum(self, tree: Formula) -> Piece:
        parts = [f"{sign} {piece.source}" for sign, piece in self.terms(tree)]
        first = parts[0][2:] if parts[0][0] == "+" else parts[0].replace(" ", "", 1)
        return Piece(" ".join([first, *parts[1:]]), Level.SUM)

    def terms(self, tree: Formula) -> list[tuple[str, Piece]]:
        """Return (sign, piece) of each term of a sum, in the author's order; a + (−b) reads a − b."""
        minus = "-" if self.typst else MINUS
        if tree.op not in {"+", "-"}:
            piece = self.set(tree)
            return [(minus, piece.inner) if piece.inner else ("+", piece)]
        right = self.set(tree.args[1])
        sign = "+" if tree.op == "+" else minus
        if right.inner:
            right, sign = right.inner, minus if tree.op == "+" else "+"
        return [*self.terms(tree.args[0]), (sign, self._wrapped(right, Level.SIGNED))]

    def _product(self, left: Piece, right: Piece) -> Piece:
        if left.inner:
            return self._negated(self._product(left.inner, right))
        left, right = (self._wrapped(piece, Level.PRODUCT) for piece in (left, right))
        number_meets_number = right.opens == "number"
        argument_would_grow = left.closes == "bare" and right.opens != "function"
        if number_meets_number or argument_would_grow:
            joint = f" {self._dot} "
        elif self.typst and "word" in {left.closes, right.opens}:
            joint = " thin "
        else:
            joint = " "
        return Piece(left.source + joint + right.source, Level.PRODUCT, opens=left.opens, closes=right.closes)

    def _quotient(self, above: Piece, below: Piece) -> Piece:
        if above.inner:
            return self._negated(self._quotient(above.inner, below))
        if self.typst and not self.inline:
            kind = "number" if above.opens == "number" else ""
            return Piece(f"frac({above.source}, {below.source})", Level.PRODUCT, opens=kind)
        above, below = self._wrapped(above, Level.PRODUCT), self._wrapped(below, Level.APPLIED)
        slash = "slash" if self.typst else "/"
        return Piece(f"{above.source} {slash} {below.source}", Level.QUOTIENT, opens=above.opens)

    def _exponent(self, tree: Formula) -> str:
        inside = Setter(self.typst, self.rates, inline=True).set(tree).source
        if self.typst:
            return f"^({inside})"
        plain = inside.replace(MINUS, "-")
        return superscript(plain) if plain.lstrip("-").isdigit() else f"^({inside})"

    def _power(self, below: Formula, above: Formula) -> Piece:
        exponent = self._exponent(above)
        whole = above.op == "number" and above.name.isdigit() and above.name not in {"0", "1"}
        if below.op == "call" and below.name in _RAISED_FUNCTIONS and whole:
            return self._applied(below.name + exponent, below.args)
        base = self._wrapped(self.set(below), Level.ATOM)
        return Piece(base.source + exponent, Level.POWER, opens=base.opens, closes="")

    def _call(self, tree: Formula) -> Piece:
        inside = ", ".join(self.set(arg).source for arg in tree.args)
        if self.typst and tree.name in {"sqrt", "abs"}:
            return Piece(f"{tree.name}({inside})", Level.APPLIED)
        return self._applied((_TYPST_NAMES if self.typst else _TEXT_NAMES).get(tree.name, tree.name), tree.args)

    def _applied(self, head: str, args: tuple[Formula, ...]) -> Piece:
        if len(args) == 1 and args[0].op == "name" and head != "abs" and not parts_of_derivative(args[0].name):
            space = "" if head == "√" else " "
            return Piece(f"{head}{space}{self.set(args[0]).source}", Level.APPLIED, opens="function", closes="bare")
        inline = replace(self, inline=True)  # a fraction inside parentheses would make them as tall as the line
        inside = ", ".join(inline.set(arg).source for arg in args)
        space = " " if "^" in head and self.typst else ""
        return Piece(f"{head}{space}({inside})", Level.APPLIED, opens="function")

    def _polar(self, tree: Formula) -> Piece:
        length, angle = (
            self._wrapped(self.set(arg), level) for arg, level in zip(tree.args, (Level.PRODUCT, Level.APPLIED), strict=True)
        )
        return Piece(f"{length.source} {'angle' if self.typst else '∠'} {angle.source}", Level.QUOTIENT, opens=length.opens)

    def _part(self, tree: Formula) -> Piece:
        (inner,) = tree.args
        if inner.op == "name":
            return self._name(f"{inner.name}.{tree.name}")
        return Piece(f"({self.set(inner).source})_{tree.name}", Level.ATOM, opens="parenthesis")


def text(tree: Formula, rates: Rates = NO_RATES) -> str:
    """Return a formula as plain text: "V_My / (r₃ (2 cos φ₃ + sin φ₃))"."""
    return Setter(typst=False, rates=rates).set(tree).source


def math(tree: Formula, rates: Rates = NO_RATES) -> str:
    """Return a formula as Typst math source."""
    return Setter(typst=True, rates=rates).set(tree).source


def text_equation(left: Formula, right: Formula, rates: Rates, *, in_sentence: bool = False) -> str:
    """Return "left = right" as plain text; `in_sentence`: mark single letters, so that none is taken for a word."""
    setter = Setter(typst=False, rates=rates, in_sentence=in_sentence)
    return f"{setter.set(left).source} = {setter.set(right).source}"
