"""Text of a formula -> a checked tree; the text is never evaluated or passed to anything that evaluates text.

Enters: one formula as text.  Leaves: a `Formula` tree, or a `FormulaFault` with its column.
Used where variant files are read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from functools import lru_cache
from math import pi

from coursework.system.frozen import frozen
from coursework.variant.formula.alphabet import CYRILLIC_FUNCTIONS, foreign_letter, spell
from coursework.variant.formula.motion_units import UNITS
from coursework.variant.formula.tree import FUNCTIONS, LARGEST, Formula, FormulaFault, bounded, constant
from coursework.variant.formula.units import MAX_NUMBER
from coursework.words.sentence import Sentence
from coursework.words.sentences import say, say_count

# Sizes are bounded before any work (see also `MAX_BYTES` of `toml/source.py`): formulas of coursework stay far below.
MAX_CHARACTERS = 2000
MAX_NODES = 500
MAX_DEPTH = 60
MAX_EXPONENT = 8

_FUNCTION_ALIASES = {
    "tg": "tan", "arctg": "atan", "arctan": "atan", "arcsin": "asin", "arccos": "acos", "ln": "log",
}  # fmt: skip
# Units with a mass that no datum is called; their table is loaded only for files with forces.
_HEAVY = r"(k?N|kg|к?Н|кг)(?!\w)([*/](mm|cm|m|мм|см|м)(\^2)?(?!\w))?"
_UNIT_TOKENS = 5  # the longest unit: m, /, s, ^, 2
_COTANGENT = {"ctg", "cot"}
# Words that always mean a function, so that they cannot be names.
FUNCTION_WORDS = frozenset({*FUNCTIONS, *_FUNCTION_ALIASES, *_COTANGENT})
_SIGNS = {"·": "*", "⋅": "*", "∙": "*", "×": "*", "−": "-", "–": "-", "÷": "/", "∕": "/", "²": "^2", "³": "^3"}
_ADVICE = dict.fromkeys("[]{}", "round") | {"√": "sqrt", "|": "abs", "°": "degrees"}  # sign -> the advice about it
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|[-+*/^@(),.=]))"
)


@lru_cache(maxsize=4096)
def parse(text: str, *, vectors: bool = False) -> Formula:
    """Read one formula.

    `vectors` allows `L @ angle`, `(x, y)` and `.x`/`.y`.
    Raises `FormulaFault` with the column for text outside the grammar or the size limits.
    """
    reader = _Reader(text, vectors)
    tree = reader.expression()
    reader.expect_end()
    return tree


@lru_cache(maxsize=4096)
def parse_equation(text: str, *, vectors: bool = False) -> tuple[Formula, Formula]:
    """Read `left = right`; raises `FormulaFault` if the equals sign is missing or occurs twice."""
    if text.count("=") != 1:
        second = text.find("=", text.find("=") + 1) + 1
        raise FormulaFault(max(second, 1), say("fault.V112", count=text.count("=")))
    reader = _Reader(text, vectors)
    left = reader.expression()
    reader.take("=", say("fault.part.equals"))
    right = reader.expression()
    reader.expect_end()
    return left, right


@frozen
class _Token:
    kind: str
    text: str
    column: int
    fault: Sentence | None = None


def _tokens(text: str) -> list[_Token]:
    if len(text) > MAX_CHARACTERS:
        raise FormulaFault(MAX_CHARACTERS, say("fault.V113", count=len(text), max_characters=MAX_CHARACTERS))
    tokens: list[_Token] = []
    columns = [i for i, letter in enumerate(text) for _ in _SIGNS.get(letter, letter)] + [len(text)]
    plain = "".join(_SIGNS.get(letter, letter) for letter in text)
    position = 0
    depth = 0
    while plain[position:].strip():
        match = _TOKEN.match(plain, position)
        if not match:
            start = position + len(plain[position:]) - len(plain[position:].lstrip())
            before = tokens[-1].text if tokens and tokens[-1].kind == "number" else "30"
            advice = say(f"fault.sign.{_ADVICE.get(plain[start], 'other')}", number=before)
            # Reported later: an earlier part of the text may contain the more important fault.
            return [
                *tokens,
                _Token("fault", plain[start], columns[start] + 1, say("fault.V101", sign=plain[start], advice=advice)),
            ]
        kind = str(match.lastgroup)
        column = columns[match.start(kind)] + 1
        word = match.group(kind)
        if kind == "name":
            if meant := CYRILLIC_FUNCTIONS.get(word.lower()):
                raise FormulaFault(column, say("fault.V140", word=word, name=meant))
            if strange := foreign_letter(word):
                raise FormulaFault(column + strange[0], say("fault.V127", word=word[:40], strange=strange[1]))
            word = spell(word)
        depth += {"(": 1, ")": -1}.get(word, 0)
        if depth > MAX_DEPTH or len(tokens) > 4 * MAX_NODES:
            raise FormulaFault(column, say("fault.V115", max_depth=MAX_DEPTH, max_nodes=MAX_NODES))
        tokens.append(_Token(kind, "^" if word == "**" else word, column))
        position = match.end()
    return tokens


def _shown(token: _Token) -> str:
    return f'"{token.text}"' if token.text else say("fault.part.end")


class _Reader:
    """Precedence climbing over the tokens; the numbers of nodes and of nested levels are bounded."""

    def __init__(self, text: str, vectors: bool) -> None:
        self.text = text
        self.tokens = _tokens(text)
        self.end = len(text) + 1
        self.vectors = vectors
        self.position = 0
        self.nodes = 0
        self.depth = 0
        self.numbers: dict[int, tuple[Formula, float]] = {}  # by identity: parts of numbers only, and their values

    def peek(self) -> _Token:
        token = self.tokens[self.position] if self.position < len(self.tokens) else _Token("end", "", self.end)
        if token.fault is not None:
            raise FormulaFault(token.column, token.fault)
        return token

    def take(self, text: str, what: str) -> _Token:
        token = self.peek()
        if token.text != text:
            self.misplaced(token)
            raise FormulaFault(token.column, say("fault.V116", what=what, shown=_shown(token)))
        self.position += 1
        return token

    def node(self, op: str, args: tuple[Formula, ...], column: int, name: str = "") -> Formula:
        self.nodes += 1
        if self.nodes > MAX_NODES:
            raise FormulaFault(column, say("fault.V117", max_nodes=MAX_NODES))
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
            raise FormulaFault(self.peek().column, say("fault.V118", max_depth=MAX_DEPTH))
        tree = rule()
        self.depth -= 1
        return tree

    def expect_end(self) -> None:
        token = self.peek()
        if token.kind != "end":
            self.misplaced(token)
            if token.text == "=":
                raise FormulaFault(token.column, say("fault.V146"))
            raise FormulaFault(token.column, say("fault.V119", text=token.text))

    def misplaced(self, token: _Token) -> None:
        """Raise `FormulaFault` for a token in place of an operator, if a specific reason can be given."""
        if token.kind in {"name", "number"} or token.text == "(":
            before = self.tokens[self.position - 1] if self.position else token
            if before.kind == "number" and (unit := self.unit()):
                raise FormulaFault(token.column, say("fault.V143", number=before.text, unit=unit))
            raise FormulaFault(token.column, say("fault.V120", text=token.text))
        told = {")": "fault.V144", ",": "fault.V121", ".": "fault.V122"}
        if self.vectors and token.text == "," and not re.match(r"\d,\d", self.text[token.column - 2 : token.column + 1]):
            told[","] = "fault.V145"
        if token.text in told:
            raise FormulaFault(token.column, say(told[token.text]))

    def unit(self) -> str:
        """Return the unit that the next tokens are, "" if none."""
        behind = [one.text for one in self.tokens[self.position : self.position + _UNIT_TOKENS]]
        heavy = re.match(_HEAVY, "".join(behind))
        if heavy or UNITS.get(behind[0], (0, "1"))[1] == "1":
            return heavy[0] if heavy else ""
        return next(u for k in range(len(behind), 0, -1) if (u := "".join(behind[:k])) in UNITS)

    def expression(self) -> Formula:
        return self.joined({"+", "-"}, self.term)

    def term(self) -> Formula:
        return self.joined({"*", "/", "@"}, self.factor)

    def joined(self, signs: Collection[str], part: Callable[[], Formula]) -> Formula:
        """Return parts joined by operators, from left to right."""
        left = part()
        while self.peek().text in signs:
            sign = self.peek()
            if sign.text == "@" and not self.vectors:
                raise FormulaFault(sign.column, say("fault.V128"))
            self.position += 1
            left = self.node(sign.text, (left, part()), sign.column)
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
            raise FormulaFault(start.column, say("fault.V123", max_exponent=MAX_EXPONENT))
        if abs(value) > MAX_EXPONENT or self.peek().text == "^":
            raise FormulaFault(start.column, say("fault.V124", max_exponent=MAX_EXPONENT))
        return tree

    def part(self) -> Formula:
        tree = self.atom()
        while self.peek().text == "." and self.vectors:
            dot = self.take(".", ".")
            which = self.peek()
            if which.text not in {"x", "y"}:
                raise FormulaFault(which.column, say("fault.V129"))
            self.position += 1
            tree = self.node("part", (tree,), dot.column, which.text)
        return tree

    def atom(self) -> Formula:
        token = self.peek()
        self.position += 1
        if token.kind == "number":
            if not float(token.text) <= MAX_NUMBER:
                raise FormulaFault(token.column, say("fault.V130", text=token.text[:20]))
            if float(token.text) < 1 / LARGEST and re.search("[1-9]", re.split("[eE]", token.text)[0]):
                raise FormulaFault(token.column, say("fault.V131", text=token.text[:20]))
            return self.node("number", (), token.column, token.text)
        if token.kind == "name":
            return self.call(token) if self.peek().text == "(" else self.symbol(token)
        if token.text == "(":
            return self.parenthesis(token)
        raise FormulaFault(token.column, say("fault.V114", shown=_shown(token)))

    def symbol(self, token: _Token) -> Formula:
        if token.text in FUNCTION_WORDS:
            raise FormulaFault(token.column, say("fault.V125", text=token.text))
        return self.node("name", (), token.column, token.text)

    def call(self, token: _Token) -> Formula:
        name = _FUNCTION_ALIASES.get(token.text, token.text)
        if name not in FUNCTIONS and name not in _COTANGENT:
            known = ", ".join(FUNCTIONS)
            small = token.text.lower()
            hint = say("hint.closest", name=small) if small in FUNCTION_WORDS else ""
            raise FormulaFault(token.column, say("fault.V126", text=token.text, known=known, hint=hint))
        arguments = self.arguments()
        if name in _COTANGENT and len(arguments) == 1:
            # Not cos/sin: that doubles the argument, so that sixty letters of nested calls would give an enormous formula.
            one = self.node("number", (), token.column, "1")
            return self.node("/", (one, self.node("call", arguments, token.column, "tan")), token.column)
        wanted = FUNCTIONS.get(name, 1)
        if len(arguments) != wanted:
            raise FormulaFault(token.column, say_count("fault.V102", wanted, name=name, given=len(arguments)))
        return self.node("call", arguments, token.column, name)

    def arguments(self) -> tuple[Formula, ...]:
        self.take("(", "(")
        arguments = [self.deeper(self.expression)]
        while self.peek().text == ",":
            self.position += 1
            arguments.append(self.deeper(self.expression))
        self.take(")", say("fault.part.closing"))
        return tuple(arguments)

    def parenthesis(self, token: _Token) -> Formula:
        inner = self.deeper(self.expression)
        if self.peek().text == "," and self.vectors:
            self.position += 1
            other = self.deeper(self.expression)
            self.take(")", say("fault.part.closing"))
            return self.node("pair", (inner, other), token.column)
        self.take(")", say("fault.part.closing"))
        return inner
