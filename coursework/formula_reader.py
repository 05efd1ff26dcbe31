"""Text of a formula -> a checked tree; never evaluated, never handed to anything that evaluates text.

Enters: one formula as text.  Leaves: a `Formula` tree, or a `FormulaFault` with its column.
Used where variant files are read.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from coursework.alphabet import foreign_letter, spell
from coursework.formula import FUNCTIONS, Formula, FormulaFault, constant

# Sizes are bounded before any work (see also `variant.MAX_BYTES`): formulas of coursework stay far below.
MAX_CHARACTERS = 2000
MAX_NODES = 500
MAX_DEPTH = 60
MAX_EXPONENT = 8
MAX_NUMBER = 1e12

_FUNCTION_ALIASES = {
    "tg": "tan", "arctg": "atan", "arctan": "atan", "arcsin": "asin", "arccos": "acos", "ln": "log",
}  # fmt: skip
_SIGNS = {"·": "*", "⋅": "*", "∙": "*", "×": "*", "−": "-", "–": "-", "÷": "/", "∕": "/", "²": "^2", "³": "^3"}
_TOKEN = re.compile(r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/^@(),.=]))")


def parse(text: str, *, vectors: bool = False) -> Formula:
    """Read one formula.

    Parameters: `text`; `vectors` allows `L @ angle`, `(x, y)` and `.x`/`.y`.
    Raises `FormulaFault` naming the column, for anything outside the grammar or the size limits.
    """
    reader = _Reader(text, vectors)
    tree = reader.expression()
    reader.expect_end()
    return tree


def parse_equation(text: str, *, vectors: bool = False) -> tuple[Formula, Formula]:
    """Read `left = right`; raises `FormulaFault` where the sign of equality is missing or doubled."""
    if text.count("=") != 1:
        found = "none" if "=" not in text else str(text.count("="))
        raise FormulaFault(1, f'an equation "left = right" needs exactly one "=" ({found} found)')
    reader = _Reader(text, vectors)
    left = reader.expression()
    reader.take("=", 'the "=" of the equation')
    right = reader.expression()
    reader.expect_end()
    return left, right


@dataclass(frozen=True, slots=True)
class _Token:
    kind: str
    text: str
    column: int


def _tokens(text: str) -> list[_Token]:
    if len(text) > MAX_CHARACTERS:
        raise FormulaFault(MAX_CHARACTERS, f"the formula has {len(text)} characters; at most {MAX_CHARACTERS} are read")
    tokens: list[_Token] = []
    columns = [i for i, letter in enumerate(text) for _ in _SIGNS.get(letter, letter)] + [len(text)]
    plain = "".join(_SIGNS.get(letter, letter) for letter in text)
    position = 0
    depth = 0
    while plain[position:].strip():
        match = _TOKEN.match(plain, position)
        if not match:
            start = position + len(plain[position:]) - len(plain[position:].lstrip())
            raise FormulaFault(columns[start] + 1, f"the sign “{plain[start]}” has no meaning in a formula")
        kind = str(match.lastgroup)
        column = columns[match.start(kind)] + 1
        word = match.group(kind)
        if kind == "name":
            if strange := foreign_letter(word):
                raise FormulaFault(column + strange[0], f'"{word}" contains the {strange[1]}; names use Latin or Greek letters')
            word = spell(word)
        depth += {"(": 1, ")": -1}.get(word, 0)
        if depth > MAX_DEPTH or len(tokens) > 4 * MAX_NODES:
            raise FormulaFault(column, f"the formula is nested or long beyond {MAX_DEPTH} levels or {MAX_NODES} parts")
        tokens.append(_Token(kind, "^" if word == "**" else word, column))
        position = match.end()
    return tokens


class _Reader:
    """Precedence climbing over the tokens; every node counted, every level bounded."""

    def __init__(self, text: str, vectors: bool) -> None:
        self.tokens = _tokens(text)
        self.end = len(text) + 1
        self.vectors = vectors
        self.position = 0
        self.nodes = 0
        self.depth = 0

    def peek(self) -> _Token:
        return self.tokens[self.position] if self.position < len(self.tokens) else _Token("end", "", self.end)

    def take(self, text: str, what: str) -> _Token:
        token = self.peek()
        if token.text != text:
            found = f'"{token.text}"' if token.text else "the end"
            raise FormulaFault(token.column, f"{what} was expected here (found {found})")
        self.position += 1
        return token

    def node(self, op: str, args: tuple[Formula, ...], column: int, name: str = "") -> Formula:
        self.nodes += 1
        if self.nodes > MAX_NODES:
            raise FormulaFault(column, f"the formula has more than {MAX_NODES} parts; split it")
        return Formula(op, args, name, column)

    def deeper(self, rule: Callable[[], Formula]) -> Formula:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise FormulaFault(self.peek().column, f"the formula is nested deeper than {MAX_DEPTH} levels")
        tree = rule()
        self.depth -= 1
        return tree

    def expect_end(self) -> None:
        token = self.peek()
        if token.kind == "end":
            return
        if token.kind in {"name", "number"} or token.text == "(":
            raise FormulaFault(token.column, f'an operator is missing before "{token.text}"; a product is written with *')
        if token.text == ",":
            raise FormulaFault(token.column, "a comma has no meaning here; decimals are written with a point (0.5)")
        raise FormulaFault(token.column, f'"{token.text}" was not expected here')

    def expression(self) -> Formula:
        left = self.term()
        while self.peek().text in {"+", "-"}:
            sign = self.peek()
            self.position += 1
            left = self.node(sign.text, (left, self.term()), sign.column)
        return left

    def term(self) -> Formula:
        left = self.factor()
        while self.peek().text in {"*", "/", "@"}:
            sign = self.peek()
            if sign.text == "@" and not self.vectors:
                raise FormulaFault(sign.column, "“length @ angle” stands only in [points], [closure] and closure = …")
            self.position += 1
            left = self.node(sign.text, (left, self.factor()), sign.column)
        return left

    def factor(self) -> Formula:
        token = self.peek()
        if token.text in {"-", "+"}:
            self.position += 1
            inner = self.deeper(self.factor)
            return inner if token.text == "+" else self.node("neg", (inner,), token.column)
        base = self.part()
        if self.peek().text != "^":
            return base
        sign = self.take("^", "^")
        exponent = self.deeper(self.exponent)
        return self.node("^", (base, exponent), sign.column)

    def exponent(self) -> Formula:
        start = self.peek()
        tree = self.factor() if start.text in {"-", "+"} else self.part()
        value = constant(tree)
        if value is None:
            raise FormulaFault(start.column, f"an exponent is a number of at most {MAX_EXPONENT}, such as x^2 or x^(1/2)")
        if abs(value) > MAX_EXPONENT or self.peek().text == "^":
            raise FormulaFault(start.column, f"the exponent is too large; at most {MAX_EXPONENT} is read")
        return tree

    def part(self) -> Formula:
        tree = self.atom()
        while self.peek().text == "." and self.vectors:
            dot = self.take(".", ".")
            which = self.peek()
            if which.text not in {"x", "y"}:
                raise FormulaFault(which.column, 'after the point "." only x or y may stand')
            self.position += 1
            tree = self.node("part", (tree,), dot.column, which.text)
        return tree

    def atom(self) -> Formula:
        token = self.peek()
        self.position += 1
        if token.kind == "number":
            if not float(token.text) <= MAX_NUMBER:
                raise FormulaFault(token.column, f"the number {token.text[:20]} is larger than {MAX_NUMBER:g}")
            return self.node("number", (), token.column, token.text)
        if token.kind == "name":
            return self.call(token) if self.peek().text == "(" else self.symbol(token)
        if token.text == "(":
            return self.parenthesis(token)
        what = f'"{token.text}"' if token.text else "the end"
        raise FormulaFault(token.column, f"a number, a name or ( was expected here (found {what})")

    def symbol(self, token: _Token) -> Formula:
        if token.text in FUNCTIONS or token.text in _FUNCTION_ALIASES or token.text in {"ctg", "cot"}:
            raise FormulaFault(token.column, f"write the argument of {token.text} in parentheses: {token.text}(…)")
        return self.node("name", (), token.column, token.text)

    def call(self, token: _Token) -> Formula:
        name = _FUNCTION_ALIASES.get(token.text, token.text)
        arguments = self.arguments()
        if name in {"ctg", "cot"} and len(arguments) == 1:
            above, below = (self.node("call", arguments, token.column, part) for part in ("cos", "sin"))
            return self.node("/", (above, below), token.column)
        if name not in FUNCTIONS:
            known = ", ".join(FUNCTIONS)
            raise FormulaFault(token.column, f'"{token.text}(…)" is not allowed; the functions are {known}; a product needs *')
        if len(arguments) != FUNCTIONS[name]:
            raise FormulaFault(token.column, f"{name} takes {FUNCTIONS[name]} argument(s), {len(arguments)} given")
        return self.node("call", arguments, token.column, name)

    def arguments(self) -> tuple[Formula, ...]:
        self.take("(", "(")
        arguments = [self.deeper(self.expression)]
        while self.peek().text == ",":
            self.position += 1
            arguments.append(self.deeper(self.expression))
        self.take(")", "a closing parenthesis )")
        return tuple(arguments)

    def parenthesis(self, token: _Token) -> Formula:
        inner = self.deeper(self.expression)
        if self.peek().text == "," and self.vectors:
            self.position += 1
            other = self.deeper(self.expression)
            self.take(")", "a closing parenthesis )")
            return self.node("pair", (inner, other), token.column)
        self.take(")", "a closing parenthesis )")
        return inner
