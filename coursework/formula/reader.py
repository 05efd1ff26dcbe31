"""Text of a formula -> a checked tree; never evaluated, never handed to anything that evaluates text.

Enters: one formula as text.  Leaves: a `Formula` tree, or a `FormulaFault` with its column.
Used where variant files are read.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import pi

from coursework.formula.alphabet import foreign_letter, spell
from coursework.formula.tree import FUNCTIONS, LARGEST, Formula, FormulaFault, bounded, constant

# Sizes are bounded before any work (see also `variant.MAX_BYTES`): formulas of coursework stay far below.
MAX_CHARACTERS = 2000
MAX_NODES = 500
MAX_DEPTH = 60
MAX_EXPONENT = 8
MAX_NUMBER = 1e12

_FUNCTION_ALIASES = {
    "tg": "tan", "arctg": "atan", "arctan": "atan", "arcsin": "asin", "arccos": "acos", "ln": "log",
}  # fmt: skip
_COTANGENT = {"ctg", "cot"}
# Words that mean a function wherever they stand, so that nothing can be called so.
FUNCTION_WORDS = frozenset({*FUNCTIONS, *_FUNCTION_ALIASES, *_COTANGENT})
_SIGNS = {"·": "*", "⋅": "*", "∙": "*", "×": "*", "−": "-", "–": "-", "÷": "/", "∕": "/", "²": "^2", "³": "^3"}
_ADVICE = {
    "[": "use round parentheses", "]": "use round parentheses", "{": "use round parentheses", "}": "use round parentheses",
    "√": "write sqrt(…)", "|": "write abs(…)", "°": "angles in formulas are radians: 30*pi/180",
}  # fmt: skip
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/^@(),.=]))"
)


@lru_cache(maxsize=4096)
def parse(text: str, *, vectors: bool = False) -> Formula:
    """Read one formula.

    Parameters: `text`; `vectors` allows `L @ angle`, `(x, y)` and `.x`/`.y`.
    Raises `FormulaFault` naming the column, for anything outside the grammar or the size limits.
    """
    reader = _Reader(text, vectors)
    tree = reader.expression()
    reader.expect_end()
    return tree


@lru_cache(maxsize=4096)
def parse_equation(text: str, *, vectors: bool = False) -> tuple[Formula, Formula]:
    """Read `left = right`; raises `FormulaFault` where the sign of equality is missing or doubled."""
    if text.count("=") != 1:
        found = "none" if "=" not in text else str(text.count("="))
        second = text.find("=", text.find("=") + 1) + 1
        raise FormulaFault(max(second, 1), f'an equation "left = right" needs exactly one "=" ({found} found)')
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
            advice = _ADVICE.get(plain[start], "signs are + - * / ^ ( ) and the comma of atan2(y, x)")
            # Kept for later: what stands before it may be the greater fault.
            message = f"the sign “{plain[start]}” has no meaning in a formula; {advice}"
            return [*tokens, _Token("fault", message, columns[start] + 1)]
        kind = str(match.lastgroup)
        column = columns[match.start(kind)] + 1
        word = match.group(kind)
        if kind == "name":
            if strange := foreign_letter(word):
                raise FormulaFault(
                    column + strange[0], f'"{word[:40]}" contains the {strange[1]}; names use Latin or Greek letters'
                )
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
        self.numbers: dict[int, tuple[Formula, float]] = {}  # by identity: the parts made of numbers only, and their values

    def peek(self) -> _Token:
        token = self.tokens[self.position] if self.position < len(self.tokens) else _Token("end", "", self.end)
        if token.kind == "fault":
            raise FormulaFault(token.column, token.text)
        return token

    def take(self, text: str, what: str) -> _Token:
        token = self.peek()
        if token.text != text:
            self.misplaced(token)
            found = f'"{token.text}"' if token.text else "the end"
            raise FormulaFault(token.column, f"{what} was expected here (found {found})")
        self.position += 1
        return token

    def node(self, op: str, args: tuple[Formula, ...], column: int, name: str = "") -> Formula:
        self.nodes += 1
        if self.nodes > MAX_NODES:
            raise FormulaFault(column, f"the formula has more than {MAX_NODES} parts; split it")
        tree = Formula(op, args, name, column)
        values = [self.numbers[id(arg)][1] for arg in args if id(arg) in self.numbers]
        if op == "number" or (op == "name" and name == "pi"):
            self.numbers[id(tree)] = tree, pi if op == "name" else float(name)
        elif args and len(values) == len(args) and op not in {"@", "pair", "part"}:
            self.numbers[id(tree)] = tree, bounded(tree, values)
        return tree

    def deeper(self, rule: Callable[[], Formula]) -> Formula:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise FormulaFault(self.peek().column, f"the formula is nested deeper than {MAX_DEPTH} levels")
        tree = rule()
        self.depth -= 1
        return tree

    def expect_end(self) -> None:
        token = self.peek()
        if token.kind != "end":
            self.misplaced(token)
            raise FormulaFault(token.column, f'"{token.text}" was not expected here')

    def misplaced(self, token: _Token) -> None:
        """Raise for what stands where an operator was expected, where the reason can be told."""
        if token.kind in {"name", "number"} or token.text == "(":
            raise FormulaFault(token.column, f'an operator is missing before "{token.text}"; a product is written with *')
        if token.text == ",":
            raise FormulaFault(token.column, "a comma has no meaning here; decimals are written with a point (0.5)")
        if token.text == ".":
            raise FormulaFault(token.column, "a point stands inside a number (0.5) or, in the geometry, before x and y")

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
                raise FormulaFault(token.column, f"the number {token.text[:20]} is larger than 1e12")
            if float(token.text) < 1 / LARGEST and re.search("[1-9]", re.split("[eE]", token.text)[0]):
                raise FormulaFault(token.column, f"the number {token.text[:20]} is too small to be told from 0")
            return self.node("number", (), token.column, token.text)
        if token.kind == "name":
            return self.call(token) if self.peek().text == "(" else self.symbol(token)
        if token.text == "(":
            return self.parenthesis(token)
        what = f'"{token.text}"' if token.text else "the end"
        raise FormulaFault(token.column, f"a number, a name or ( was expected here (found {what})")

    def symbol(self, token: _Token) -> Formula:
        if token.text in FUNCTION_WORDS:
            raise FormulaFault(token.column, f"write the argument of {token.text} in parentheses: {token.text}(…)")
        return self.node("name", (), token.column, token.text)

    def call(self, token: _Token) -> Formula:
        name = _FUNCTION_ALIASES.get(token.text, token.text)
        if name not in FUNCTIONS and name not in _COTANGENT:
            known = ", ".join(FUNCTIONS)
            raise FormulaFault(token.column, f'"{token.text}(…)" is not allowed; the functions are {known}; a product needs *')
        arguments = self.arguments()
        if name in _COTANGENT and len(arguments) == 1:
            # Not cos/sin: with the argument twice, one inside the other, sixty letters would make a formula without end.
            one = self.node("number", (), token.column, "1")
            return self.node("/", (one, self.node("call", arguments, token.column, "tan")), token.column)
        wanted = FUNCTIONS.get(name, 1)
        if len(arguments) != wanted:
            plural = "s" if wanted > 1 else ""
            raise FormulaFault(token.column, f"{name} takes {wanted} argument{plural}, {len(arguments)} given")
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
