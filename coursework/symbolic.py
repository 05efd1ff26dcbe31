"""Formulas -> SymPy expressions by constructor, and their exact derivatives along the motion.

Enters: formulas of a `Mechanism`.  Leaves: expressions in symbols of its own; drives and functions stay names with a
definition beside them, so that a page shows V_My and r, not what they stand for.
Used by `equations.py` and `lower.py`.
"""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from coursework.formula import Formula
from coursework.mechanism import Mechanism
from coursework.variant.record import Law

Vector = tuple[sp.Expr, sp.Expr]
_FUNCTIONS = {
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "asin": sp.asin, "acos": sp.acos, "atan": sp.atan, "sqrt": sp.sqrt,
    "exp": sp.exp, "log": sp.log, "abs": sp.Abs, "atan2": sp.atan2,
}  # fmt: skip


def symbol(name: str) -> sp.Symbol:
    """Return the real symbol of a name."""
    return sp.Symbol(name, real=True)


TIME = symbol("t")


class Symbols:
    """The symbols of one mechanism, what they stand for, and how they change."""

    def __init__(self, mechanism: Mechanism) -> None:
        variant = mechanism.variant
        self.rates = {symbol(c.name): symbol(c.rate) for c in variant.coordinates}
        self.definitions: dict[sp.Symbol, sp.Expr] = {}
        self.vectors: dict[str, Vector] = {}
        self._derivatives: dict[tuple[sp.Symbol, sp.Symbol], sp.Expr] = {}
        for law in (*variant.drive, *variant.functions):
            self.definitions[symbol(law.name)] = self._law(law)
        for name, formula in mechanism.points:
            self.vectors[name] = self.vector(formula)

    def _law(self, law: Law) -> sp.Expr:
        if law.table:
            return sp.Function(f"table_{law.name}_0")(symbol(law.of))
        if law.pieces:
            branches = [
                (self.scalar(formula), sp.Float(later[0]) > TIME)
                for (_, formula), later in zip(law.pieces, law.pieces[1:], strict=False)
            ]
            return sp.Piecewise(*branches, (self.scalar(law.pieces[-1][1]), True))
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
        return _FUNCTIONS[tree.name](*args) if tree.op == "call" else _combine(tree.op, args)

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
            return _combine(tree.op, [ax, bx]), _combine(tree.op, [ay, by])
        if tree.op == "*" and not self.is_vector(first):
            first, second = second, first
        x, y = self.vector(first)
        factor = self.scalar(second)
        return _combine(tree.op, [x, factor]), _combine(tree.op, [y, factor])

    def is_vector(self, tree: Formula) -> bool:
        """Return whether a formula is a vector."""
        if tree.op == "name":
            return tree.name in self.vectors
        return tree.op in {"@", "pair"} or (tree.op not in {"part", "call", "number"} and any(map(self.is_vector, tree.args)))

    def partial(self, expr: sp.Expr, by: sp.Symbol) -> sp.Expr:
        """Return d expr / d by, through the definitions of drives and functions."""
        total = sp.diff(expr, by)
        for name in sorted(expr.free_symbols & set(self.definitions), key=str):
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
                derived = symbol(f"{name}_{by}")
                self.definitions[derived] = value
                value = derived
            self._derivatives[name, by] = value
        return self._derivatives[name, by]

    def rate(self, expr: sp.Expr) -> sp.Expr:
        """Return d expr / d t along the motion: sum of partials times rates."""
        total = self.partial(expr, TIME)
        for coordinate, rate in self.rates.items():
            slope = self.partial(expr, coordinate)
            if slope != 0:
                total += slope * rate
        return total


def _combine(op: str, args: list[sp.Expr]) -> sp.Expr:
    match op:
        case "neg":
            return -args[0]
        case "+":
            return args[0] + args[1]
        case "-":
            return args[0] - args[1]
        case "*":
            return args[0] * args[1]
        case "/":
            return args[0] / args[1]
    return args[0] ** args[1]
