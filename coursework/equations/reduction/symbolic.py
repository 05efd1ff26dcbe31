"""Formulas -> SymPy expressions by constructor, and their exact derivatives along the motion.

Enters: formulas of a `Mechanism`.  Leaves: expressions in symbols of its own; drives and functions stay names with a
definition beside them, so that a page shows V_My and r, not what they stand for.
Used by `equations.py`, `geometry` and `integration`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache
from math import comb

import sympy as sp

from coursework.equations.codegen.names import derivative, private, public
from coursework.mechanism.mechanism import Mechanism
from coursework.variant.formula.tree import Formula, FormulaFault, bounded, division_by_zero, no_number
from coursework.variant.record.variant import Law, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

Vector = tuple[sp.Expr, sp.Expr]
_FUNCTIONS = {
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "asin": sp.asin, "acos": sp.acos, "atan": sp.atan, "sqrt": sp.sqrt,
    "exp": sp.exp, "log": sp.log, "abs": sp.Abs, "atan2": sp.atan2,
}  # fmt: skip


def symbol(name: str) -> sp.Symbol:
    """Return the real symbol of a declared name, or of t."""
    return local(private(name))


@lru_cache(maxsize=4096)
def local(name: str) -> sp.Symbol:
    """Return the real symbol of a private name."""
    return sp.Symbol(name, real=True)


TIME = symbol("t")
# A row t = i*h within this part of a break stands on it and takes the new formula: 3*0.35 is less than 1.05 in a computer.
_AT_BREAK = 1e-14
# Multiplied out, (a + b + … )^8 of a few names has more terms than a computer has patience; nobody reads a hundred.
_MOST_TERMS = 100


def constants(variant: Variant) -> dict[str, float]:
    """Return what is a number as soon as the data are known, by private name: given data, and the times at which laws change."""
    known = {private(name): value for name, value in variant.values.items()}
    for law in (*variant.drive, *variant.functions):
        known |= {_break(law, place): later * (1 - _AT_BREAK) for place, (later, _) in enumerate(law.pieces[1:])}
    return known


def _break(law: Law, piece: int) -> str:
    """Return the private name of the time at which a piece of a law ends."""
    return f"_end{piece}_{law.name}"


@contextmanager
def placed(variant: Variant, place: str, line: int) -> Iterator[None]:
    """Turn a fault of a formula into an `InputError` that says where the formula stands."""
    try:
        yield
    except FormulaFault as fault:
        where = say("place.column", place=place, column=fault.column)
        raise InputError([Fault(fault.message, variant.file, line, 0, where)]) from fault


def expanded(expr: sp.Expr) -> sp.Expr:
    """Return an expression multiplied out, or as it is where that would make too many terms."""
    return sp.expand(expr) if _terms(expr) <= _MOST_TERMS else expr


def _terms(expr: sp.Expr) -> int:
    """Return how many terms an expression has at most when it is multiplied out."""
    if isinstance(expr, sp.Add):
        return sum(map(_terms, expr.args))
    if isinstance(expr, sp.Mul):
        total = 1
        for arg in expr.args:
            total *= _terms(arg)
        return total
    if isinstance(expr, sp.Pow) and isinstance(expr.base, sp.Add):
        power = abs(int(expr.exp)) if expr.exp.is_Integer else 1
        terms = _terms(expr.base)
        return comb(terms + power - 1, power) if power <= _MOST_TERMS else _MOST_TERMS + 1
    return max(map(_terms, expr.args), default=1) if expr.args else 1


class Definitions(Mapping[sp.Symbol, sp.Expr]):
    """What symbols stand for: the drives and functions, and their derivatives by the symbols that `Symbols.partial` gives.

    To go through it is to go through the drives and functions; a derivative is found by whoever holds its symbol, so nobody
    who asks for one changes what another sees.
    """

    def __init__(self, laws: Mapping[sp.Symbol, sp.Expr], derived: Mapping[sp.Symbol, sp.Expr]) -> None:
        self._laws, self._derived = laws, derived

    def __getitem__(self, name: sp.Symbol) -> sp.Expr:
        return self._laws[name] if name in self._laws else self._derived[name]

    def __iter__(self) -> Iterator[sp.Symbol]:
        return iter(self._laws)

    def __len__(self) -> int:
        return len(self._laws)

    def without(self, names: set[sp.Symbol]) -> Definitions:
        """Return the definitions of all other symbols: those left out are given as numbers."""
        return Definitions(*({n: v for n, v in part.items() if n not in names} for part in (self._laws, self._derived)))


class Symbols:
    """The symbols of one mechanism, what they stand for, and how they change."""

    def __init__(self, mechanism: Mechanism) -> None:
        variant = mechanism.variant
        self.rates = {symbol(c.name): symbol(c.rate) for c in variant.coordinates}
        defined: dict[sp.Symbol, sp.Expr] = {}
        self._derived: dict[sp.Symbol, sp.Expr] = {}
        self.definitions = Definitions(defined, self._derived)
        self.vectors: dict[str, Vector] = {}
        self._declared = variant.names
        self._parts: dict[str, tuple[str, str]] = {}
        self._partials: dict[tuple[sp.Expr, sp.Symbol], sp.Expr] = {}
        self._derivatives: dict[tuple[sp.Symbol, sp.Symbol], sp.Expr] = {}
        for section, laws in (("drive", variant.drive), ("functions", variant.functions)):
            for law in laws:
                with placed(variant, f"{section}.{law.name}", variant.line_of(section, law.name)):
                    defined[symbol(law.name)] = self._law(law)
        for name, formula in mechanism.points:
            with placed(variant, f"points.{name}", variant.line_of("points", name)):
                self.vectors[name] = self.vector(formula)

    def _law(self, law: Law) -> sp.Expr:
        if law.table:
            return sp.Function(f"_table_{law.name}_0")(symbol(law.of))
        if law.pieces:
            branches = [(self.scalar(formula), local(_break(law, place)) > TIME) for place, (_, formula) in enumerate(law.pieces)]
            return sp.Piecewise(*branches[:-1], (self.scalar(law.pieces[-1][1]), True))
        assert law.formula is not None
        return self.scalar(law.formula)

    def scalar(self, tree: Formula) -> sp.Expr:
        """Return the expression of a scalar formula."""
        if tree.op == "number":
            value = Fraction(tree.name)
            return sp.Rational(value.numerator, value.denominator)
        if tree.op == "name":
            return sp.pi if tree.name == "pi" else symbol(tree.name)
        if tree.op == "part":
            return self.vector(tree.args[0])[0 if tree.name == "x" else 1]
        args = [self.scalar(arg) for arg in tree.args]
        if all(arg.is_number for arg in args):
            # Points written out may leave numbers only, which SymPy would work out exactly whatever their size.
            bounded(tree, [float(arg) for arg in args])
        value = self._call(tree.name, args) if tree.op == "call" else _combine(tree, args)
        if tree.op in {"call", "^"} and value.has(sp.zoo, sp.nan, sp.oo, sp.I):
            raise no_number(tree)
        return value

    def _call(self, name: str, args: list[sp.Expr]) -> sp.Expr:
        # SymPy looks at sin(p*t + alpha) for a millisecond to see that nothing can be made of it.
        inside = args[0].free_symbols
        asked = name not in {"sin", "cos"} or TIME not in inside or not inside.isdisjoint(self.rates)
        return _FUNCTIONS[name](*args) if asked else _FUNCTIONS[name](*args, evaluate=False)

    def vector(self, tree: Formula) -> Vector:
        """Return both components of a vector formula."""
        if tree.op == "name":
            return self.vectors[tree.name]
        if tree.op == "pair":
            return self.scalar(tree.args[0]), self.scalar(tree.args[1])
        if tree.op == "@":
            length, angle = (self.scalar(arg) for arg in tree.args)
            return length * sp.cos(angle), length * sp.sin(angle)
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

    def partial(self, expr: sp.Expr, by: sp.Symbol) -> sp.Expr:
        """Return d expr / d by, through the definitions of drives and functions."""
        if (expr, by) not in self._partials:
            self._partials[expr, by] = self._partial(expr, by)
        return self._partials[expr, by]

    def _partial(self, expr: sp.Expr, by: sp.Symbol) -> sp.Expr:
        total = sp.diff(expr, by)
        names = [name for name in expr.free_symbols if name in self.definitions]
        for name in sorted(names, key=lambda symbol: symbol.name):
            inner = self._derivative(name, by)
            if inner != 0:
                total += sp.diff(expr, name) * inner
        return total

    def _derivative(self, name: sp.Symbol, by: sp.Symbol) -> sp.Expr:
        """Return the symbol of d name / d by, defining it on first use; a constant one is returned as it is."""
        if (name, by) not in self._derivatives:
            definition = self.definitions[name]
            if isinstance(definition, sp.core.function.AppliedUndef):
                stem, _, order = definition.func.__name__.rpartition("_")
                inner = sp.Function(f"{stem}_{int(order) + 1}")(*definition.args)
                value = inner if definition.args[0] == by else sp.S.Zero
            else:
                value = self.partial(definition, by)
            if value.free_symbols:
                derived = local(derivative(name.name, by.name, self._declared))
                self._derived[derived] = value
                law, below, told = (public(n, self._declared) for n in (name.name, by.name, derived.name))
                self._parts[told] = (law, below)
                value = derived
            self._derivatives[name, by] = value
        return self._derivatives[name, by]

    def derivatives_among(self, names: Iterable[str]) -> dict[str, tuple[str, str]]:
        """Return those of some shown names that are derivatives: name -> (of what, by what)."""
        return {name: self._parts[name] for name in names if name in self._parts}

    def rate(self, expr: sp.Expr) -> sp.Expr:
        """Return d expr / d t along the motion: sum of partials times rates."""
        total = self.partial(expr, TIME)
        for coordinate, rate in self.rates.items():
            slope = self.partial(expr, coordinate)
            if slope != 0:
                total += slope * rate
        return total


def _combine(tree: Formula, args: list[sp.Expr]) -> sp.Expr:
    match tree.op:
        case "neg":
            return -args[0]
        case "+":
            return args[0] + args[1]
        case "-":
            return args[0] - args[1]
        case "*":
            return args[0] * args[1]
        case "/":
            if args[1] == 0:
                raise division_by_zero(tree)
            return args[0] / args[1]
    return args[0] ** args[1]
