"""Expression -> formula in the author's order and the textbook's compact form.

Enters: expressions of a small block.  Leaves: `Formula` for a page.  Nothing numeric reads it.
A rewrite of our own: common factors out, cos a cos b + sin a sin b -> cos(a - b) and its three sisters.
Used by `conditioning.py`, `blocks.py`, `equations.py` and `solution.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import gcd

from coursework.equations.algebra.calculus import operations, together
from coursework.equations.algebra.expression import HALF, ONE, ZERO, Expression
from coursework.equations.algebra.functions import cosine, sine
from coursework.equations.codegen.names import private, public
from coursework.equations.reduction.sums import Term, gathered, written_sums
from coursework.equations.reduction.symbolic import expanded
from coursework.variant.formula.tree import Formula, named, number, product_of
from coursework.variant.record.variant import Variant

# Beyond this many operations a formula is shown as it is: nobody reads it, and expanding it costs.
MAX_OPERATIONS = 400
Atoms = dict[Expression, int]


class Order:
    """The author's order: names and functions as they first appear in the equations; and `sums` that he writes as one."""

    def __init__(self, formulas: list[Formula], variant: Variant) -> None:
        names = [name for formula in formulas for name in formula.names()]
        names += [g.name for g in variant.given] + [law.name for law in (*variant.drive, *variant.functions)]
        names += [*variant.sought, *(c.name for c in variant.coordinates), *variant.rates]
        self._names = {private(name): place for place, name in enumerate(dict.fromkeys(names))}
        self._declared = variant.names
        calls = [node.name for formula in formulas for node in formula.walk() if node.op == "call"]
        self._calls = {name: place for place, name in enumerate(dict.fromkeys([*calls, "cos", "sin"]))}
        self.sums = written_sums(formulas, frozenset(g.name for g in variant.given))

    def rank(self, atom: Expression) -> tuple[int, ...]:
        """Return the place of a symbol, function or power: names before functions."""
        if atom.op == "symbol":
            return (0, self._names.get(atom.name, len(self._names)))
        if atom.op == "^":
            return self.rank(atom.args[0])
        if atom in self.sums:
            return min(self.rank(name) for _, names in self.sums[atom] for name, _ in names)
        inner = tuple(sorted(self._names.get(s.name, len(self._names)) for s in atom.free_symbols))
        return (1, self._calls.get(atom.op, 99), *inner)

    def public(self, symbol: Expression) -> str:
        """Return what a symbol is called in text: the declared name, or "∂r/∂phi" for a derivative."""
        return public(symbol.name, self._declared)

    def term(self, term: Term) -> tuple[tuple[int, ...], ...]:
        """Return the place of a term in a sum."""
        return tuple(sorted(self.rank(atom) for atom, _ in term[1]))


@dataclass(frozen=True, slots=True)
class Product:
    """factor * product of atoms * sum of terms (empty for 1), tidied."""

    factor: Fraction
    atoms: tuple[tuple[Expression, int], ...]
    terms: tuple[Term, ...]


def product(expr: Expression, order: Order) -> Product:
    """Return an expression as one product; a sum that cannot be taken apart becomes its terms."""
    if expr == 0:
        return Product(Fraction(0), (), ())
    if operations(expr) > MAX_OPERATIONS:
        return Product(Fraction(1), ((expr, 1),), ())
    terms = _pair_angles(_terms(expanded(expr), order), order)
    if not terms:
        return Product(Fraction(0), (), ())
    common = _common(terms)
    terms = [(factor, _divide(atoms, common)) for factor, atoms in terms]
    terms.sort(key=order.term)
    content = reduce(
        lambda a, b: Fraction(gcd(a.numerator, b.numerator), _lcm(a.denominator, b.denominator)), [abs(f) for f, _ in terms]
    )
    if terms[0][0] < 0:
        content = -content
    terms = [(factor / content, atoms) for factor, atoms in terms]
    return Product(content, tuple(common.items()), () if len(terms) == 1 else tuple(terms))


def quotient(above: Expression, bottom: Product, order: Order) -> Formula:
    """Return above / bottom with common factors cancelled."""
    top = product(above, order)
    atoms = dict(top.atoms)
    for atom, power in bottom.atoms:
        atoms[atom] = atoms.get(atom, 0) - power
    up, down = top.terms, bottom.terms
    if up == down:
        up = down = ()
    return _fraction(top.factor / bottom.factor, atoms, up, down, order)


def as_formula(expr: Expression, order: Order) -> Formula:
    """Return an expression as a formula, tidied."""
    if operations(expr) > MAX_OPERATIONS:
        return _plain(expr, order)
    # Bringing to one denominator costs more than all the rest; most expressions have none.
    divided = any(part.op == "^" and part.args[1].is_negative for part in expr.walk())
    above, below = together(expr) if divided else (expr, ONE)
    return quotient(above, product(below, order), order)


def as_sum(expr: Expression, order: Order) -> Formula:
    """Return an expression as the plain sum of its terms, as a velocity equation is written."""
    if operations(expr) > MAX_OPERATIONS:
        return _plain(expr, order)
    return _sum(tuple(sorted(_terms(expanded(expr), order), key=order.term)), order)


def _lcm(a: int, b: int) -> int:
    return a * b // gcd(a, b)


def _terms(expr: Expression, order: Order) -> list[Term]:
    return gathered([_term(part) for part in expr.terms if part is not ZERO], order.sums)


def _term(expr: Expression) -> Term:
    factor, rest = expr.split()
    atoms: Atoms = {}
    for part in rest.factors:
        base, exponent = part.base_and_power
        if exponent.value.denominator > 1:
            base, exponent = part, ONE
        if base is not ONE:
            atoms[base] = atoms.get(base, 0) + int(exponent.value)
    return factor, tuple(atoms.items())


def _common(terms: list[Term]) -> Atoms:
    first = dict(terms[0][1])
    for _, atoms in terms[1:]:
        other = dict(atoms)
        first = {atom: min(power, other[atom]) for atom, power in first.items() if atom in other}
    return {atom: power for atom, power in first.items() if power}


def _divide(atoms: tuple[tuple[Expression, int], ...], common: Atoms) -> tuple[tuple[Expression, int], ...]:
    left = {atom: power - common.get(atom, 0) for atom, power in atoms}
    return tuple((atom, power) for atom, power in left.items() if power)


def _pair_angles(terms: list[Term], order: Order) -> list[Term]:
    """Join pairs of terms by the addition theorems until none is left."""
    merged = True
    while merged:
        merged = False
        for i, first in enumerate(terms):
            for j in range(i + 1, len(terms)):
                joined = _join(first, terms[j], order)
                if joined is not None:
                    terms = [term for k, term in enumerate(terms) if k not in {i, j}] + ([joined] if joined[0] else [])
                    merged = True
                    break
            if merged:
                break
    return terms


def _join(first: Term, second: Term, order: Order) -> Term | None:
    if abs(first[0]) != abs(second[0]):
        return None
    a, b = dict(first[1]), dict(second[1])
    # A divisor of one term only is a factor that the other has more of.
    shared = {atom: power for atom in {**a, **b} if (power := min(a.get(atom, 0), b.get(atom, 0)))}
    only_a = {atom: p for atom in {**a, **b} if (p := a.get(atom, 0) - shared.get(atom, 0))}
    only_b = {atom: p for atom in {**b, **a} if (p := b.get(atom, 0) - shared.get(atom, 0))}
    trig_a, trig_b = _two_angles(only_a), _two_angles(only_b)
    if trig_a is None or trig_b is None:
        return None
    found = _addition(trig_a, trig_b, first[0], second[0], order)
    if found is None:
        return None
    factor, merged = found
    times, rest = merged.split()
    atoms = dict(shared)
    if rest is not ONE:
        atoms[rest] = atoms.get(rest, 0) + 1
    return factor * times, tuple(atoms.items())


def _two_angles(atoms: Atoms) -> list[tuple[str, Expression]] | None:
    """Return [(sin|cos, angle), (sin|cos, angle)] of a product of exactly two such functions."""
    found = [(atom.op, atom.args[0]) for atom, power in atoms.items() for _ in range(power) if atom.op in {"sin", "cos"}]
    return found if len(found) == 2 and sum(atoms.values()) == 2 else None


def _addition(
    a: list[tuple[str, Expression]], b: list[tuple[str, Expression]], p: Fraction, q: Fraction, order: Order
) -> tuple[Fraction, Expression] | None:
    angles = sorted({angle for _, angle in a}, key=lambda x: order.rank(cosine(x)))
    if {angle for _, angle in b} != set(angles):
        return None
    x, y = angles if len(angles) == 2 else (angles[0], angles[0])
    kinds = {"".join(sorted(kind for kind, _ in part)) for part in (a, b)}
    if kinds == {"coscos", "sinsin"}:
        cosines = p if a[0][0] == a[1][0] == "cos" else q
        return cosines, cosine(x - y) if p == q else cosine(x + y)
    if kinds == {"cossin"} and x != y:
        leading = p if ("sin", x) in a else q
        return leading, sine(x + y) if p == q else sine(x - y)
    return None


def _fraction(factor: Fraction, atoms: Atoms, up: tuple[Term, ...], down: tuple[Term, ...], order: Order) -> Formula:
    if factor == 0 or not (atoms or up or down):
        return number(factor)
    above = {atom: power for atom, power in atoms.items() if power > 0}
    below = {atom: -power for atom, power in atoms.items() if power < 0}
    top = _factors(abs(factor.numerator), above, up, order)
    bottom = _factors(factor.denominator, below, down, order)
    tree = Formula("/", (top, bottom)) if bottom != number(1) else top
    return Formula("neg", (tree,)) if factor < 0 else tree


def _factors(numeral: int, atoms: Atoms, terms: tuple[Term, ...], order: Order) -> Formula:
    parts = [] if numeral == 1 else [number(numeral)]
    for atom, power in sorted(atoms.items(), key=lambda item: order.rank(item[0])):
        base = _argument(atom, order) if atom in order.sums else _plain(atom, order)
        parts.append(base if power == 1 else Formula("^", (base, number(power))))
    if terms:
        parts.append(_sum(terms, order))
    return product_of(parts)


def _sum(terms: tuple[Term, ...], order: Order) -> Formula:
    total: Formula | None = None
    for factor, atoms in terms:
        part = _fraction(abs(factor), dict(atoms), (), (), order)
        if total is None:
            total = Formula("neg", (part,)) if factor < 0 else part
        else:
            total = Formula("-" if factor < 0 else "+", (total, part))
    return total or number(0)


def _plain(expr: Expression, order: Order) -> Formula:
    """Return one atom as a formula without rewriting inside."""
    match expr.op:
        case "symbol":
            return named(order.public(expr))
        case "pi":
            return named("pi")
        case "number":
            return number(expr.value)
        case "^":
            base = _plain(expr.args[0], order)
            if expr.args[1] is HALF:
                return Formula("call", (base,), "sqrt")
            return Formula("^", (base, _plain(expr.args[1], order)))
        case "+" | "*":
            return reduce(lambda a, b: _joined(a, b, expr.op == "*"), [_plain(part, order) for part in expr.args])
    return Formula("call", tuple(_argument(arg, order) for arg in expr.args), expr.op)


def _argument(expr: Expression, order: Order) -> Formula:
    """Return what stands inside a function: a positive term first, so that φ1 - φ2 is not written -φ2 + φ1."""
    terms = sorted(map(_term, expr.terms), key=lambda term: (term[0] < 0, order.term(term)))
    return _sum(tuple(terms), order)


def _joined(a: Formula, b: Formula, is_product: bool) -> Formula:
    if is_product:
        return Formula("neg", (b,)) if a == Formula("neg", (number(1),)) else Formula("*", (a, b))
    return Formula("-", (a, b.args[0])) if b.op == "neg" else Formula("+", (a, b))
