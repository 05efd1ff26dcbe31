"""Expressions -> lines of Python that compute every value once, and values of data alone before all others.

Enters: statements made by this program.  Leaves: text with the same meaning over `math` and over NumPy.
Used by `programs.py` only.
Local value numbering (A. V. Aho, R. Sethi, J. D. Ullman, "Compilers", 1986, 9.8): equal values get one number, and a value
that is read more than once gets a name.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import field

from coursework.equations.algebra.expression import POLE, Expression
from coursework.system.frozen import changing, frozen
from coursework.words.errors import InputError
from coursework.words.sentences import say

CALLS = {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "abs", "sign", "sqrt", "pow"}
_MOST_FACTORS = 16  # powers up to this exponent are written as products
_SUM, _PRODUCT, _ATOM = 1, 2, 3
# Operations that may be computed in advance if all operands are known: no tables (checked row by row), no choices.
_SETTLING = {"+", "*", "/", *CALLS}
MOST_OPERATIONS = 20_000  # distinct operations in one program; the largest of the catalogue has some hundreds


class FormulaRefused(InputError, ValueError):
    """Something that follows from the formulas of a variant cannot be computed; a caller that knows the variant adds its file."""


@frozen
class Line:
    """A line of code whose `text` assigns to the names `targets`."""

    targets: tuple[str, ...]
    text: str

    @property
    def value(self) -> str:
        """Return the expression that is assigned."""
        return self.text.partition(" = ")[2]


@changing
class StraightLine:
    """Collects statements, then returns their lines.

    `data` are private names of numbers that are constant during a run.  Values that depend on data alone are computed in lines of
    their own, `known`.  `reads` are the data and known values read by all other lines, `known_reads` the data read by `known`.
    A name in `definitions` that is not in `written` is defined where it is first read.
    A value is represented by its number, its negative by the negative number.  A form is an operation and its operands.
    """

    data: Collection[str]
    definitions: Mapping[Expression, Expression]
    written: set[Expression]
    _forms: list[tuple[str | int, ...]] = field(default_factory=lambda: [("",)])
    _numbers: dict[tuple[str | int, ...], int] = field(default_factory=dict)
    _uses: list[int] = field(default_factory=lambda: [0])
    known: list[Line] = field(default_factory=list)
    reads: dict[str, None] = field(default_factory=dict)
    known_reads: dict[str, None] = field(default_factory=dict)
    _folded: dict[int, float] = field(default_factory=dict)
    _settled: set[int] = field(default_factory=set)
    _seen: dict[Expression, int] = field(default_factory=dict)
    _statements: list[tuple[tuple[str, ...], tuple[int, ...], str]] = field(default_factory=list)
    _names: dict[int, str] = field(default_factory=dict)
    _lines: list[Line] = field(default_factory=list)
    _helpers: int = 0

    def add(self, targets: Sequence[Expression], expressions: Sequence[Expression], call: str = "") -> None:
        """Add `target = expression`, or `targets = call((expressions…))`."""
        values = tuple(self._value(expr) for expr in expressions)
        for value in values:
            self._uses[abs(value)] += 1
        self._statements.append((tuple(target.name for target in targets), values, call))

    def lines(self) -> list[Line]:
        """Return the lines of all statements in order."""
        for targets, values, call in self._statements:
            if call:
                entries = ", ".join(self._text(value, _SUM) for value in values)
                text = f"{', '.join(targets)} = {call}(({entries}))"
            else:
                (value,), (target,) = values, targets
                fresh = value > 0 and value not in self._names and len(self._forms[value]) > 1 and value not in self._settled
                text = f"{target} = {self._body(value)[0] if fresh else self._text(value, _SUM)}"
                if fresh:
                    self._names[value] = target
            self._lines.append(Line(targets, text))
        return self._lines

    def _value(self, expr: Expression) -> int:
        if expr not in self._seen:
            self._seen[expr] = self._valued(expr)
        return self._seen[expr]

    def _valued(self, expr: Expression) -> int:
        match expr.op:
            case "symbol":
                return self._symbol(expr)
            case "number":
                # Python rounds a quotient of two integers once, so the decimal of the task sheet comes back exactly.
                return self._constant(expr.value.numerator / expr.value.denominator)
            case "pi":
                return self._constant(math.pi)
            case "+":
                return self._sum([self._value(arg) for arg in expr.args])
            case "*":
                below = [arg for arg in expr.args if arg.op == "^" and arg.args[1].is_negative]
                above = [self._value(arg) for arg in expr.args if arg not in below]
                return self._quotient(self._product(above), self._product([self._power(arg) for arg in below]))
            case "^":
                found = self._power(expr)
                return self._quotient(self._constant(1.0), found) if expr.args[1].is_negative else found
            case "piecewise":
                time, *parts = expr.args
                return self._pieces(self._value(time), parts[::2], parts[1::2])
        return self._function(expr.op, [self._value(arg) for arg in expr.args])

    def _symbol(self, name: Expression) -> int:
        if name in self.definitions and name not in self.written:
            self.written.add(name)
            self.add([name], [self.definitions[name]])
        return self._number(name.name)

    def _number(self, *form: str | int) -> int:
        found = self._numbers.get(form)
        if found is None:
            found = self._numbers[form] = len(self._forms)
            if found > MOST_OPERATIONS:
                raise FormulaRefused(say("fault.V514", most=MOST_OPERATIONS))
            self._forms.append(form)
            self._uses.append(0)
            operands = [abs(int(value)) for value in form[1:]]
            for value in operands:
                self._uses[value] += 1
            operation = str(form[0])
            if operation in self.data or (operands and operation in _SETTLING and all(map(self._is_settled, operands))):
                self._settled.add(found)
        return found

    def _is_settled(self, value: int) -> bool:
        """Return whether a value depends on numbers and data alone."""
        return abs(value) in self._settled or abs(value) in self._folded

    def _constant(self, size: float) -> int:
        if math.copysign(1.0, size) < 0:
            return -self._constant(-size)
        found = self._number(repr(size))
        self._folded[found] = size
        return found

    def _apart(self, values: Sequence[int]) -> tuple[list[float], list[int], list[int]]:
        """Return the constants among `values`, then those that depend on data alone, then the others, each in order."""
        constants = [math.copysign(self._folded[abs(v)], v) for v in values if abs(v) in self._folded]
        others = sorted((v for v in values if abs(v) not in self._folded), key=abs)
        return constants, [v for v in others if abs(v) in self._settled], [v for v in others if abs(v) not in self._settled]

    def _sum(self, values: Sequence[int]) -> int:
        constants, settled, terms = self._apart(values)
        if sum(constants) or not (settled or terms):
            settled.append(self._constant(sum(constants)))
        return self._added([*terms, *([self._added(settled)] if settled else [])])

    def _added(self, terms: list[int]) -> int:
        if len(terms) == 1:
            return terms[0]
        sign = 1 if terms[0] > 0 else -1  # so that a - b and b - a are one value
        return sign * self._number("+", *[sign * term for term in terms])

    def _product(self, values: Sequence[int]) -> int:
        constants, settled, moving = self._apart(values)
        factors = [*settled, *moving]
        size = math.prod(constants)
        negative = sum(factor < 0 for factor in factors) + (math.copysign(1.0, size) < 0)
        sign = -1 if negative % 2 else 1
        total = self._constant(abs(size)) if abs(size) != 1.0 or not factors else 0
        for factor in map(abs, factors):
            total = self._number("*", total, factor) if total else factor
        return sign * total

    def _quotient(self, above: int, below: int) -> int:
        if abs(below) in self._folded and self._folded[abs(below)]:
            return self._product([above, self._constant(1 / math.copysign(self._folded[abs(below)], below))])
        if self._is_settled(below) and not self._is_settled(above):
            return self._product([above, self._quotient(self._constant(1.0), below)])
        sign = 1 if (above > 0) == (below > 0) else -1
        return sign * self._number("/", abs(above), abs(below))

    def _power(self, power: Expression) -> int:
        """Return a power, or its reciprocal if the exponent is negative."""
        if power is POLE:
            raise FormulaRefused(say("fault.V513", text="1/0"))
        base, exponent = power.args
        value, twice = self._value(base), 2 * abs(exponent.value)
        if twice.denominator > 1 or twice > 2 * _MOST_FACTORS:
            # A negative number to a fractional power is no real number; `**` would return a complex one.
            return self._function("pow", [value, self._constant(float(abs(exponent.value)))])
        whole, half = divmod(int(twice), 2)
        factors = [self._function("sqrt", [value])] if half else []
        while whole:
            if whole % 2:
                factors.append(value)
            whole //= 2
            value = self._product([value, value]) if whole else value
        return self._product(factors)

    def _function(self, name: str, values: list[int]) -> int:
        if name not in CALLS and not name.startswith("_table_"):
            raise FormulaRefused(say("fault.V515", name=name))
        known: Callable[..., float] | None = getattr(math, name, None)
        if known and all(abs(value) in self._folded for value in values):
            with suppress(ArithmeticError, ValueError):  # without a value it stays a call, which then raises
                return self._constant(known(*self._apart(values)[0]))
        return self._number(name, *values)

    def _pieces(self, time: int, pieces: Sequence[Expression], ends: Sequence[Expression]) -> int:
        """Return the piece that applies, found by bisection, because the ends of the pieces are in ascending order."""
        if len(pieces) == 1:
            return self._value(pieces[0])
        half = len(pieces) // 2
        before, after = self._pieces(time, pieces[:half], ends[: half - 1]), self._pieces(time, pieces[half:], ends[half:])
        return self._number("if >", self._value(ends[half - 1]), time, before, after)

    def _text(self, value: int, level: int, *, inline: bool = False, known: bool = False) -> str:
        """Return the text of a value inside a sum, a product or alone (`level`); `inline` forbids naming further values.

        `known` tells that the text belongs to a line of data alone.
        """
        number = abs(value)
        settled = number in self._settled
        if number not in self._names and len(self._forms[number]) > 1 and not inline:
            if settled and (not known or self._uses[number] > 1):
                self._name(number, "c", self.known, known=True)
            elif not settled and self._uses[number] > 1:
                self._name(number, "k", self._lines)
        if settled and (number in self._names or len(self._forms[number]) == 1):
            name = self._names.get(number, str(self._forms[number][0]))
            (self.known_reads if known else self.reads)[name] = None
        text, own = (self._names[number], _ATOM) if number in self._names else self._body(number, inline=inline, known=known)
        if value < 0:
            text, own = (f"-({text})" if own == _SUM else f"-{text}"), _SUM
        return text if own >= level else f"({text})"

    def _name(self, number: int, letter: str, lines: list[Line], *, known: bool = False) -> None:
        """Give a value a name, in a line of its own after those it needs."""
        body = self._body(number, known=known)[0]
        name = f"{letter}{self._helpers}"
        self._helpers += 1
        lines.append(Line((name,), f"{name} = {body}"))
        self._names[number] = name

    def _body(self, number: int, *, inline: bool = False, known: bool = False) -> tuple[str, int]:
        """Return the text of a value, and whether it is a sum, a product or an atom."""
        operation, *rest = self._forms[number]
        values = [int(value) for value in rest]
        if not values:
            return str(operation), _ATOM
        if operation == "+":
            first, *others = values
            terms = [f" {'+' if v > 0 else '-'} {self._text(abs(v), _PRODUCT, inline=inline, known=known)}" for v in others]
            return self._text(first, _SUM, inline=inline, known=known) + "".join(terms), _SUM
        if operation in {"*", "/"}:
            left = self._text(values[0], _PRODUCT, inline=inline, known=known)
            return f"{left}{operation}{self._text(values[1], _ATOM, inline=inline, known=known)}", _PRODUCT
        if str(operation).startswith("if "):
            left, right, yes, no = (self._text(value, _SUM, inline=True) for value in values)
            # Only the piece that applies may be computed: the others may have no value there.
            return f"_choose({left} {str(operation)[3:]} {right}, lambda: {yes}, lambda: {no})", _ATOM
        return f"{operation}({', '.join(self._text(value, _SUM, inline=inline, known=known) for value in values)})", _ATOM
