"""Formulas -> expressions, and their exact derivatives along the motion.

Enters: formulas of a `Mechanism`.  Leaves: expressions in private symbols.  Drives and functions stay names with separate
definitions, so that a page shows V_My and r instead of their formulas.
Used by `equations.py`, `geometry` and `integration`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from math import comb, prod

from coursework.equations.algebra.calculus import derivative, expand, piecewise, table
from coursework.equations.algebra.expression import PI, POLE, ZERO, Expression, node, number, value
from coursework.equations.algebra.functions import call, cosine, sine
from coursework.equations.codegen.names import derivative as name_of_derivative
from coursework.equations.codegen.names import private, public
from coursework.mechanism.mechanism import Mechanism
from coursework.variant.formula.tree import ARITHMETIC, Formula, FormulaFault, bounded, division_by_zero, no_number
from coursework.variant.record.variant import Law, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

Vector = tuple[Expression, Expression]


def symbol(name: str) -> Expression:
    """Return the symbol of a declared name, or of t."""
    return local(private(name))


def local(name: str) -> Expression:
    """Return the symbol of a private name."""
    return node("symbol", name=name)


TIME = symbol("t")
# A row t = i*h that is closer to a break than this fraction counts as on it and uses the new formula: 3*0.35 < 1.05 here.
_AT_BREAK = 1e-14
# Expanding (a + b + … )^8 of a few names gives more terms than can be computed in reasonable time or read.
_MOST_TERMS = 100
# Levels of points defined by points; a deeper expression would overflow the stack when differentiated or printed.
MOST_LEVELS = 100


def constants(variant: Variant) -> dict[str, float]:
    """Return the numbers that the data determine, by private name: given data, and the times at which laws change."""
    known = {private(name): value for name, value in variant.values.items()}
    for law in variant.laws:
        known |= {break_of(law.name, place): later * (1 - _AT_BREAK) for place, (later, _) in enumerate(law.pieces[1:])}
    return known


def break_of(law: str, piece: int) -> str:
    """Return the private name of the time at which a piece of a law ends."""
    return f"_end{piece}_{law}"


@contextmanager
def placed(variant: Variant, place: str, line: int) -> Iterator[None]:
    """Turn a fault in a formula into an `InputError` that says where the formula is."""
    try:
        yield
    except FormulaFault as fault:
        where = say("place.column", place=place, column=fault.column)
        raise InputError([Fault(fault.message, variant.file, line, 0, where)]) from fault


def expanded(expr: Expression) -> Expression:
    """Return an expression multiplied out, or unchanged if that would give too many terms."""
    return expand(expr) if _terms(expr) <= _MOST_TERMS else expr


def _terms(expr: Expression) -> int:
    """Return an upper bound of the number of terms of an expression after expansion."""
    if expr.op == "+":
        return sum(map(_terms, expr.args))
    if expr.op == "*":
        return prod(map(_terms, expr.args))
    if expr.op == "^" and expr.args[0].op == "+":
        by = expr.args[1].value
        power = abs(int(by)) if by.denominator == 1 else 1
        terms = _terms(expr.args[0])
        return comb(terms + power - 1, power) if power <= _MOST_TERMS else _MOST_TERMS + 1
    return max(map(_terms, expr.args), default=1) if expr.args else 1


class Definitions(Mapping[Expression, Expression]):
    """The definitions of symbols: drives, functions, and their derivatives by the symbols that `Symbols.partial` returns.

    Iteration yields the drives and functions only; a derivative must be looked up by its symbol.  So a caller that asks for a
    derivative does not change what others see.
    """

    def __init__(self, laws: Mapping[Expression, Expression], derived: Mapping[Expression, Expression]) -> None:
        self._laws, self._derived = laws, derived

    def __getitem__(self, name: Expression) -> Expression:
        return self._laws[name] if name in self._laws else self._derived[name]

    def __iter__(self) -> Iterator[Expression]:
        return iter(self._laws)

    def __len__(self) -> int:
        return len(self._laws)

    def behind(self, symbols: Iterable[Expression]) -> set[Expression]:
        """Return `symbols` and all symbols that their definitions need."""
        found: set[Expression] = set()
        waiting = [*symbols]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting += self[name].free_symbols if name in self else ()
        return found

    def without(self, names: set[Expression]) -> Definitions:
        """Return the definitions without `names`, which are given as numbers instead."""
        return Definitions(*({n: v for n, v in part.items() if n not in names} for part in (self._laws, self._derived)))


class Symbols:
    """The symbols of one mechanism, their definitions, and their derivatives."""

    def __init__(self, mechanism: Mechanism) -> None:
        variant = mechanism.variant
        self.rates = {symbol(c.name): symbol(c.rate) for c in variant.coordinates}
        defined: dict[Expression, Expression] = {}
        self._derived: dict[Expression, Expression] = {}
        self.definitions = Definitions(defined, self._derived)
        self.vectors: dict[str, Vector] = {}
        self._declared = variant.names
        self._parts: dict[str, tuple[str, str]] = {}
        self._partials: dict[tuple[Expression, Expression], Expression] = {}
        self._derivatives: dict[tuple[Expression, Expression], Expression] = {}
        for law in variant.laws:
            path = variant.path_of(law.name)
            with placed(variant, ".".join(path), variant.line_of(*path)):
                defined[symbol(law.name)] = self._law(law)
        for name, formula in mechanism.points:
            with placed(variant, f"points.{name}", variant.line_of("points", name)):
                self.vectors[name] = self.vector(formula)

    def _law(self, law: Law) -> Expression:
        if law.table:
            return node(f"_table_{law.name}_0", (symbol(law.of),))
        if law.pieces:
            pieces = [self.scalar(formula) for _, formula in law.pieces]
            ends = [local(break_of(law.name, place)) for place in range(len(pieces) - 1)]
            return piecewise(TIME, *(part for both in zip(pieces, ends, strict=False) for part in both), pieces[-1])
        assert law.formula is not None
        return self.scalar(law.formula)

    def scalar(self, tree: Formula) -> Expression:
        """Return the expression of a scalar formula."""
        if tree.op == "number":
            return number(Fraction(tree.name))
        if tree.op == "name":
            return PI if tree.name == "pi" else symbol(tree.name)
        if tree.op == "part":
            return self.vector(tree.args[0])[0 if tree.name == "x" else 1]
        args = [self.scalar(arg) for arg in tree.args]
        if not any(arg.free_symbols for arg in args):
            # After points are replaced by their formulas only numbers may be left, which would be computed exactly at any size.
            bounded(tree, [value(arg) for arg in args])
        found = self._call(tree.name, args) if tree.op == "call" else _combine(tree, args)
        if tree.op in {"call", "^"} and POLE in found.factors:
            raise no_number(tree)
        if found.depth > MOST_LEVELS:
            raise FormulaFault(tree.column or 1, say("fault.V141", most=MOST_LEVELS))
        return found

    def _call(self, name: str, args: list[Expression]) -> Expression:
        # A drive stays as its author wrote it: sin(-p*t), not -sin(p*t).
        inside = args[0].free_symbols
        asked = name not in {"sin", "cos"} or TIME not in inside or not inside.isdisjoint(self.rates)
        return call(name, *args) if asked else node(name, tuple(args))

    def vector(self, tree: Formula) -> Vector:
        """Return both components of a vector formula."""
        if tree.op == "name":
            return self.vectors[tree.name]
        if tree.op == "pair":
            return self.scalar(tree.args[0]), self.scalar(tree.args[1])
        if tree.op == "@":
            length, angle = (self.scalar(arg) for arg in tree.args)
            return length * cosine(angle), length * sine(angle)
        if tree.op == "neg":
            x, y = self.vector(tree.args[0])
            return -x, -y
        first, second = tree.args
        if tree.op in {"+", "-"}:
            (ax, ay), (bx, by) = self.vector(first), self.vector(second)
            return _combine(tree, [ax, bx]), _combine(tree, [ay, by])
        if tree.op == "*" and not self.is_vector(first):
            first, second = second, first
        x, y = self.vector(first)
        factor = self.scalar(second)
        return _combine(tree, [x, factor]), _combine(tree, [y, factor])

    def is_vector(self, tree: Formula) -> bool:
        """Return whether a formula is a vector."""
        if tree.op == "name":
            return tree.name in self.vectors
        return tree.op in {"@", "pair"} or (tree.op not in {"part", "call", "number"} and any(map(self.is_vector, tree.args)))

    def partial(self, expr: Expression, by: Expression) -> Expression:
        """Return d expr / d by, through the definitions of drives and functions."""
        if (expr, by) not in self._partials:
            self._partials[expr, by] = self._partial(expr, by)
        return self._partials[expr, by]

    def _partial(self, expr: Expression, by: Expression) -> Expression:
        total = derivative(expr, by)
        names = [name for name in expr.free_symbols if name in self.definitions]
        for name in sorted(names, key=lambda symbol: symbol.name):
            inner = self._derivative(name, by)
            if inner is not ZERO:
                total += derivative(expr, name) * inner
        return total

    def _derivative(self, name: Expression, by: Expression) -> Expression:
        """Return the symbol of d name / d by, defined at its first use; a constant derivative is returned as a number."""
        if (name, by) not in self._derivatives:
            definition = self.definitions[name]
            if definition.op.startswith("_table_"):
                value = table(definition, 1) if definition.args[0] == by else ZERO
            else:
                value = self.partial(definition, by)
            if value.free_symbols:
                derived = local(name_of_derivative(name.name, by.name, self._declared))
                self._derived[derived] = value
                law, below, told = (public(n, self._declared) for n in (name.name, by.name, derived.name))
                self._parts[told] = (law, below)
                value = derived
            self._derivatives[name, by] = value
        return self._derivatives[name, by]

    def derivatives_among(self, names: Iterable[str]) -> dict[str, tuple[str, str]]:
        """Return the derivatives among some shown names: name -> (differentiated name, by which name)."""
        return {name: self._parts[name] for name in names if name in self._parts}

    def rate(self, expr: Expression) -> Expression:
        """Return d expr / d t along the motion: the sum of partial derivatives times rates."""
        total = self.partial(expr, TIME)
        for coordinate, rate in self.rates.items():
            slope = self.partial(expr, coordinate)
            if slope is not ZERO:
                total += slope * rate
        return total


def _combine(tree: Formula, args: list[Expression]) -> Expression:
    if tree.op == "neg":
        return -args[0]
    if tree.op == "^":
        return args[0] ** args[1].value
    if tree.op == "/" and args[1] is ZERO:
        raise division_by_zero(tree)
    found: Expression = ARITHMETIC[tree.op](*args)
    return found
