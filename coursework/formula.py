"""Text of a formula -> a checked tree; never evaluated, never handed to anything that evaluates text.

Enters: one formula as text.  Leaves: a `Formula` tree, or a `FormulaFault` with its column.
Any floor may read the tree; only `lower.py` turns it (by way of SymPy objects) into numbers.
"""

from __future__ import annotations

import math
import operator
import re
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

# Sizes are bounded before any work (see also `variant.MAX_BYTES`): formulas of coursework stay far below.
MAX_CHARACTERS = 2000
MAX_NODES = 500
MAX_DEPTH = 60
MAX_EXPONENT = 8
MAX_NUMBER = 1e12

FUNCTIONS = {name: 1 for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs")} | {"atan2": 2}
_FUNCTION_ALIASES = {
    "tg": "tan", "arctg": "atan", "arctan": "atan", "arcsin": "asin", "arccos": "acos", "ln": "log",
}  # fmt: skip
_GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "eps", "ζ": "zeta", "η": "eta", "θ": "theta",
    "ϑ": "theta", "λ": "lam", "μ": "mu", "ν": "nu", "ξ": "xi", "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau",
    "φ": "phi", "ϕ": "phi", "χ": "chi", "ψ": "psi", "ω": "w", "Δ": "Delta", "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega",
    "Θ": "Theta", "Γ": "Gamma",
}  # fmt: skip
_SIGNS = {"·": "*", "⋅": "*", "∙": "*", "×": "*", "−": "-", "–": "-", "÷": "/", "∕": "/", "²": "^2", "³": "^3"}
_SUBSCRIPTS = {ord("₀") + digit: str(digit) for digit in range(10)}
_TOKEN = re.compile(r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/^@(),.=]))")


class FormulaFault(ValueError):
    """A formula cannot be read; `column` counts characters from 1."""

    def __init__(self, column: int, message: str) -> None:
        super().__init__(message)
        self.column = column
        self.message = message


@dataclass(frozen=True, slots=True)
class Formula:
    """One node: `op` is number, name, neg, + - * / ^, call, @ (polar vector), pair (x, y) or part (.x, .y)."""

    op: str
    args: tuple[Formula, ...] = ()
    name: str = ""
    column: int = field(default=0, compare=False)

    def walk(self) -> Iterator[Formula]:
        """Yield this node and all below it, in the author's order."""
        yield self
        for arg in self.args:
            yield from arg.walk()

    def names(self) -> tuple[str, ...]:
        """Return the symbols used, each once, in order of appearance."""
        return tuple(dict.fromkeys(node.name for node in self.walk() if node.op == "name"))

    @property
    def value(self) -> Fraction:
        """Return the exact value of a number node."""
        return Fraction(self.name)


def number(value: Fraction | int) -> Formula:
    """Return the node of an exact number: a decimal where it has one of at most 12 digits, else a quotient."""
    value = Fraction(value)
    if value < 0:
        return Formula("neg", (number(-value),))
    if value.denominator == 1:
        return Formula("number", name=str(value.numerator))
    decimal = f"{float(value):.12g}"
    if Fraction(decimal) == value:
        return Formula("number", name=decimal)
    return Formula("/", (number(value.numerator), number(value.denominator)))


def spell(name: str) -> str:
    """Return a name in the tool's own spelling: Greek letters written out, subscripts as digits."""
    plain = "".join(_GREEK.get(letter, letter) for letter in unicodedata.normalize("NFC", name))
    return plain.translate(_SUBSCRIPTS)


def foreign_letter(name: str) -> tuple[int, str] | None:
    """Return position and description of a letter from another alphabet, or None."""
    for position, letter in enumerate(name):
        if letter.isalpha() and not letter.isascii() and letter not in _GREEK:
            return position, f"{unicodedata.name(letter, 'unknown letter').lower()} “{letter}”"
    return None


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


def constant(tree: Formula) -> Fraction | None:
    """Return the exact value of a formula of numbers only (+ - * /), else None."""
    if tree.op == "number":
        return tree.value
    values = [constant(arg) for arg in tree.args]
    known = [value for value in values if value is not None]
    if tree.op not in {"neg", "+", "-", "*", "/"} or len(known) != len(values) or not known:
        return None
    if tree.op == "neg":
        return -known[0]
    first, second = known
    if tree.op == "/":
        return first / second if second else None
    return {"+": first + second, "-": first - second, "*": first * second}[tree.op]


_LEVELS = {"+": 1, "-": 1, "neg": 2, "*": 3, "/": 3, "@": 3, "^": 5}


def spelled(tree: Formula) -> str:
    """Return the formula as text that `parse` reads back to the same meaning."""
    if tree.op in {"number", "name"}:
        return tree.name
    if tree.op == "part":
        return f"{_enclosed(tree.args[0], 6)}.{tree.name}"
    if tree.op in {"call", "pair"}:
        return f"{tree.name}({', '.join(map(spelled, tree.args))})"
    level = _LEVELS[tree.op]
    if tree.op == "neg":
        return f"-{_enclosed(tree.args[0], level + 1)}"
    first, second = tree.args
    sign = f" {tree.op} " if level == 1 or tree.op == "@" else tree.op
    return f"{_enclosed(first, level + (tree.op == '^'))}{sign}{_enclosed(second, level + 1)}"


def _enclosed(tree: Formula, least: int) -> str:
    text = spelled(tree)
    return f"({text})" if _LEVELS.get(tree.op, 9) < least else text


def evaluate(tree: Formula, values: Mapping[str, float]) -> float:
    """Return the float value of a scalar formula whose names all stand in `values` (and pi).

    Used for data such as the period "2*pi/p"; everything that depends on the motion goes through `lower.py`.
    Raises `FormulaFault` where the value is not a finite number.
    """
    try:
        value = float(_evaluate(tree, {"pi": math.pi, **values}))
    except (ArithmeticError, ValueError, TypeError) as error:
        raise FormulaFault(tree.column or 1, f"the value cannot be computed ({error})") from error
    if not math.isfinite(value):
        raise FormulaFault(tree.column or 1, "the value is not a finite number")
    return value


def _evaluate(tree: Formula, values: Mapping[str, float]) -> float:
    args = [_evaluate(arg, values) for arg in tree.args]
    match tree.op:
        case "number":
            return float(tree.name)
        case "name":
            return values[tree.name]
        case "neg":
            return -args[0]
        case "call":
            return float(abs(args[0]) if tree.name == "abs" else getattr(math, tree.name)(*args))
    return float(_ARITHMETIC[tree.op](*args))


_ARITHMETIC: dict[str, Callable[[float, float], float]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "^": operator.pow,
}  # fmt: skip
