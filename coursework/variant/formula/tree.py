"""A formula as a checked tree: its names, its value from given data, its text.

Enters: nodes from `reader.py` (or made by this program).  Leaves: `Formula`.  Every floor may read a tree, but formulas
that depend on the motion are turned into numbers only by `codegen`.
"""

from __future__ import annotations

import cmath
import math
import operator
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from fractions import Fraction
from functools import lru_cache
from typing import Any

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# A part of numbers only must be 0 or between 1/LARGEST and LARGEST in size: the exact arithmetic of exp(exp(99)) or
# ((9^8)^8)^8 would never finish.
LARGEST = 1e100
FUNCTIONS = dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs"), 1) | {"atan2": 2}


class FormulaFault(ValueError):
    """A formula cannot be read; `column` counts characters from 1."""

    def __init__(self, column: int, message: Sentence) -> None:
        super().__init__(message)
        self.column = column
        self.message = message


@frozen
class Formula:
    """One node: `op` is number, name, neg, + - * / ^, call, @ (polar vector), pair (x, y) or part (.x, .y).

    `si` is the SI unit of a number that was written with a unit ("120 rpm"), "" for any other node.
    """

    op: str
    args: tuple[Formula, ...] = ()
    name: str = ""
    column: int = field(default=0, compare=False)
    si: str = field(default="", compare=False)

    def walk(self) -> Iterator[Formula]:
        """Yield this node and all nodes below it, in the author's order."""
        waiting = [self]
        while waiting:
            node = waiting.pop()
            yield node
            waiting += reversed(node.args)

    def names(self) -> tuple[str, ...]:
        """Return the symbols used, each once, in order of appearance."""
        return tuple(dict.fromkeys(node.name for node in self.walk() if node.op == "name"))

    @property
    def value(self) -> Fraction:
        """Return the exact value of a number node."""
        return _exact(self.name)


_exact = lru_cache(maxsize=1024)(Fraction)  # a page asks for the values of a few numbers again and again


@lru_cache(maxsize=1024)
def number(value: Fraction | int) -> Formula:
    """Return the node of an exact number: a decimal if it has one that a double prints, else a quotient."""
    value = Fraction(value)
    if value < 0:
        return Formula("neg", (number(-value),))
    if value.denominator == 1:
        return Formula("number", name=str(value.numerator))
    for decimal in (f"{float(value):.12g}", repr(float(value))):
        if Fraction(decimal) == value:
            return Formula("number", name=decimal)
    return Formula("/", (number(value.numerator), number(value.denominator)))


def named(name: str) -> Formula:
    """Return the node of a name."""
    return Formula("name", name=name)


def mapped(tree: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """Return a node with `change` applied to its arguments; the same object if no argument changes."""
    args = tuple([change(arg) for arg in tree.args])
    return tree if all(map(operator.is_, args, tree.args)) else _with(tree, args)


def with_names(tree: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """Return a tree with `change` applied to each name."""
    return change(tree) if tree.op == "name" else mapped(tree, lambda arg: with_names(arg, change))


def replaced(tree: Formula, path: Sequence[int], by: Formula) -> Formula:
    """Return a formula in which the node at `path`, a list of argument indices, is replaced."""
    if not path:
        return by
    place, *rest = path
    return _with(tree, (*tree.args[:place], replaced(tree.args[place], rest, by), *tree.args[place + 1 :]))


def _with(tree: Formula, args: tuple[Formula, ...]) -> Formula:
    """Return a node with other arguments; takes a third of the time of `dataclasses.replace`, and runs over all nodes."""
    return Formula(tree.op, args, tree.name, tree.column, tree.si)


def factors(tree: Formula, within: Collection[str] = "*", power: int = 1) -> Iterator[tuple[Formula, int]]:
    """Yield the factors of a product with their powers, 1 or -1; only operations in `within` are taken apart."""
    if tree.op not in within:
        yield tree, power
        return
    for place, arg in enumerate(tree.args):
        yield from factors(arg, within, -power if tree.op == "/" and place else power)


def terms(formula: Formula) -> Iterator[Formula]:
    """Return the terms of a sum without their signs."""
    return (term for term, _ in signed(formula))


def signed(formula: Formula, sign: int = 1) -> Iterator[tuple[Formula, int]]:
    """Yield the terms of a sum with their signs."""
    if formula.op in {"+", "-"}:
        yield from signed(formula.args[0], sign)
        yield from signed(formula.args[1], sign if formula.op == "+" else -sign)
    elif formula.op == "neg":
        yield from signed(formula.args[0], -sign)
    else:
        yield formula, sign


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


def on_axes(tree: Formula) -> Formula:
    """Return a scalar formula in which the component of a sum becomes a sum of components.

    So (E - A - r @ phi).x becomes E.x - A.x - r*cos(phi).  A minus of the first factor moves before the product:
    -C.x*sin(beta), not (-C.x)*sin(beta).
    """
    if tree.op == "part":
        return _component(tree.args[0], tree)
    args = tuple(on_axes(arg) for arg in tree.args)
    if tree.op in {"*", "/"} and args[0].op == "neg":
        return Formula("neg", (_with(tree, (args[0].args[0], args[1])),))
    return _with(tree, args)


def _component(vector: Formula, part: Formula) -> Formula:
    if vector.op in {"+", "-", "neg"}:
        return _with(vector, tuple(_component(arg, part) for arg in vector.args))
    if vector.op == "pair":
        return on_axes(vector.args["xy".index(part.name)])
    if vector.op == "@":
        length, angle = vector.args
        return Formula("*", (length, Formula("call", (angle,), "cos" if part.name == "x" else "sin")))
    return _with(part, (vector,))


_LEVELS = {"+": 1, "-": 1, "neg": 2, "*": 3, "/": 3, "@": 3, "^": 5}


def spelled(tree: Formula) -> str:
    """Return the formula as text that `parse` reads back with the same meaning."""
    text = _spelled(tree, spare=False)
    # Optional parentheses and spaces are left out if the text comes near the reader's limits of depth and length.
    return text if len(text) < _READABLE and text.count("(") < _CLEAR else _spelled(tree, spare=True)


_READABLE, _CLEAR = 1500, 25


def _spelled(tree: Formula, *, spare: bool) -> str:
    if tree.op in {"number", "name"}:
        return tree.name
    if tree.op == "part":
        return f"{_enclosed(tree.args[0], 6, spare)}.{tree.name}"
    if tree.op in {"call", "pair"}:
        return f"{tree.name}({(',' if spare else ', ').join(_spelled(arg, spare=spare) for arg in tree.args)})"
    level = _LEVELS[tree.op]
    if tree.op == "neg":
        return f"-{_enclosed(tree.args[0], level + (not spare), spare)}"
    first, second = tree.args
    sign = f" {tree.op} " if (level == 1 or tree.op == "@") and not spare else tree.op
    # A minus before a product binds to its first factor, with or without parentheses.
    before = level - spare if level == 3 else level + (tree.op == "^")
    return f"{_enclosed(first, before, spare)}{sign}{_enclosed(second, level + 1, spare)}"


def _enclosed(tree: Formula, least: int, spare: bool) -> str:
    text = _spelled(tree, spare=spare)
    return f"({text})" if _LEVELS.get(tree.op, 9) < least else text


def evaluate(tree: Formula, values: Mapping[str, float]) -> float:
    """Return the float value of a scalar formula whose names are all in `values` (or pi).

    Used for data such as the period "2*pi/p"; everything that depends on the motion goes through `codegen`.
    Raises `FormulaFault` if the value is not a finite number.
    """
    return evaluate_any(tree, {"pi": math.pi, **values}).real


def evaluate_any(tree: Formula, values: Mapping[str, complex]) -> complex:
    """Return the value of a formula, a vector as x + iy; `values` holds points in this form too.

    Raises `FormulaFault` if the value is not finite.
    """
    value: complex = _evaluate(tree, values)
    if not cmath.isfinite(value):
        raise FormulaFault(tree.column or 1, say("fault.V132"))
    return value


def with_points(values: Mapping[str, complex], points: Iterable[tuple[str, Formula]]) -> dict[str, complex]:
    """Return values with those of points (x + iy) that have one by them; a law of time has none, nor what depends on it."""
    found = {**values}
    for name, formula in points:
        with suppress(FormulaFault, KeyError):
            found[name] = evaluate_any(formula, found)
    return found


def _evaluate(tree: Formula, values: Mapping[str, Any]) -> Any:
    if tree.op in {"number", "name"}:
        return float(tree.name) if tree.op == "number" else values[tree.name]
    return _applied(tree, [_evaluate(arg, values) for arg in tree.args])


def _applied(tree: Formula, args: Sequence[Any]) -> Any:
    if tree.op == "neg":
        return -args[0]
    if tree.op == "part":
        return args[0].real if tree.name == "x" else args[0].imag
    try:
        if tree.op == "call":
            return float(abs(args[0]) if tree.name == "abs" else getattr(math, tree.name)(*args))
        value = ARITHMETIC[tree.op](*args)
        if tree.op == "^" and isinstance(value, complex):
            raise ValueError  # a negative number to a fractional power
        return value
    except OverflowError:
        return math.inf
    except (ArithmeticError, ValueError, TypeError) as error:
        raise (division_by_zero if isinstance(error, ZeroDivisionError) else no_number)(tree) from error


def division_by_zero(tree: Formula) -> FormulaFault:
    """Return the fault of a part that divides by zero."""
    return FormulaFault(tree.column or 1, say("fault.V103", text=spelled(tree)[:60]))


def no_number(tree: Formula) -> FormulaFault:
    """Return the fault of a part without a real value."""
    return FormulaFault(tree.column or 1, say("fault.V104", text=spelled(tree)[:60]))


def bounded(tree: Formula, args: Sequence[float]) -> float:
    """Return the value of one node of numbers only, from the values of its arguments.

    Raises `FormulaFault` if it is no number, or too large or too small for exact computation.
    """
    value: float = _applied(tree, args)
    vanished = tree.op in {"^", "*", "/"} and all(args) and abs(value) < 1 / LARGEST
    if vanished or not abs(value) <= LARGEST:
        raise FormulaFault(tree.column or 1, say("fault.V133", spelled=spelled(tree)[:60]))
    return value


ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "^": operator.pow, "pair": complex,
    "@": cmath.rect,
}  # fmt: skip
