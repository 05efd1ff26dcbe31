"""Expression -> formula in the author's order and the textbook's compact form.

Enters: expressions of a small block.  Leaves: `Formula` for a page.  Nothing numeric reads it.
A rewrite of our own: common factors out, and angles together by `addition_theorems.py`.
Used by `conditioning.py`, `blocks.py`, `equations.py` and `solution.py`.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce

from coursework.equations.algebra.calculus import content, together
from coursework.equations.algebra.expression import HALF, ONE, ZERO, Expression
from coursework.equations.codegen.names import private, public
from coursework.equations.reduction.addition_theorems import pair_angles
from coursework.equations.reduction.sums import Atoms, Term, gathered, written_sums
from coursework.equations.reduction.symbolic import expanded
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named, number, product_of
from coursework.variant.record.variant import Variant

# A formula of more parts, some 400 operations, is shown as it is: nobody reads it, and expanding it costs.
MOST_PARTS = 1000
_ONE = Fraction(1)


class Order:
    """The author's order: names and functions as they first appear in the equations; and `sums` that he writes as one.

    `has_decimals`: lengths stand in his formulas as 0.02, so a factor is written so too, and not as 1/50; 0.5 is any half.
    """

    def __init__(self, formulas: list[Formula], variant: Variant) -> None:
        names = [name for formula in formulas for name in formula.names()]
        names += [g.name for g in variant.given] + [law.name for law in (*variant.drive, *variant.functions)]
        names += [*variant.sought, *(c.name for c in variant.coordinates), *variant.rates]
        self._names = {private(name): place for place, name in enumerate(dict.fromkeys(names))}
        self._declared = variant.names
        calls = [node.name for formula in formulas for node in formula.walk() if node.op == "call"]
        self._calls = {name: place for place, name in enumerate(dict.fromkeys([*calls, "cos", "sin"]))}
        written = {node.name for formula in formulas for node in formula.walk() if node.op == "number"}
        self.has_decimals = any(Fraction(name).denominator > 2 for name in written)
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


@frozen
class Product:
    """factor * product of atoms * sum of terms (empty for 1), tidied."""

    factor: Fraction
    atoms: tuple[tuple[Expression, int], ...]
    terms: tuple[Term, ...]


def product(expr: Expression, order: Order) -> Product:
    """Return an expression as one product; a sum that cannot be taken apart becomes its terms."""
    if expr is ZERO:
        return Product(Fraction(0), (), ())
    if expr.size > MOST_PARTS:
        return Product(Fraction(1), ((expr, 1),), ())
    terms = pair_angles(_terms(expanded(expr), order), order.rank)
    if not terms:
        return Product(Fraction(0), (), ())
    common = _common(terms)
    terms = [(factor, _divide(atoms, common)) for factor, atoms in terms]
    terms.sort(key=order.term)
    whole = content(factor for factor, _ in terms) * (-1 if terms[0][0] < 0 else 1)
    terms = [(factor / whole, atoms) for factor, atoms in terms]
    return Product(whole, tuple(common.items()), () if len(terms) == 1 else tuple(terms))


def quotient(above: Expression, bottom: Product, order: Order) -> Formula:
    """Return above / bottom with common factors cancelled."""
    top = product(above, order)
    atoms = dict(top.atoms)
    for atom, power in bottom.atoms:
        atoms[atom] = atoms.get(atom, 0) - power
    up, down = top.terms, bottom.terms
    if up == down:
        up = down = ()
    (above_all, up), (below_all, down) = _as_given(top.factor, up, order), _as_given(bottom.factor, down, order)
    return _fraction(above_all, atoms, up, down, order, below_all)


def _as_given(factor: Fraction, terms: tuple[Term, ...], order: Order) -> tuple[Fraction, tuple[Term, ...]]:
    """Return a factor put back into a sum of different ones where lengths are decimals: 0.02 and 0.25, not 0.01, 2 and 25."""
    if not order.has_decimals or all(abs(own) == 1 for own, _ in terms):
        return factor, terms
    return Fraction(1 if factor > 0 else -1), tuple((own * abs(factor), atoms) for own, atoms in terms)


def as_formula(expr: Expression, order: Order) -> Formula:
    """Return an expression as a formula, tidied."""
    if expr.size > MOST_PARTS:
        return _plain(expr, order)
    # Bringing to one denominator costs more than all the rest; most expressions have none.
    divided = any(part.op == "^" and part.args[1].is_negative for part in expr.walk())
    above, below = together(expr) if divided else (expr, ONE)
    return quotient(above, product(below, order), order)


def as_sum(expr: Expression, order: Order) -> Formula:
    """Return an expression as the plain sum of its terms, as a velocity equation is written."""
    if expr.size > MOST_PARTS:
        return _plain(expr, order)
    return _sum(tuple(sorted(_terms(expanded(expr), order), key=order.term)), order)


def _terms(expr: Expression, order: Order) -> list[Term]:
    return gathered([_term(part) for part in expr.terms if part is not ZERO], order.sums)


def _term(expr: Expression) -> Term:
    factor, rest = expr.split()
    atoms: Atoms = {}
    for part in rest.factors:
        base, exponent = part.base_and_power
        if exponent.denominator > 1:
            base, exponent = part, _ONE
        if base is not ONE:
            atoms[base] = atoms.get(base, 0) + int(exponent)
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


def _fraction(
    factor: Fraction, atoms: Atoms, up: tuple[Term, ...], down: tuple[Term, ...], order: Order, by: Fraction = _ONE
) -> Formula:
    value = factor / by
    if value == 0 or not (atoms or up or down):
        return number(value)
    above = {atom: power for atom, power in atoms.items() if power > 0}
    below = {atom: -power for atom, power in atoms.items() if power < 0}
    numeral, divisor = _numerals(abs(factor), abs(by)) if order.has_decimals else _integers(abs(value))
    top, bottom = _factors(numeral, above, up, order), _factors(divisor, below, down, order)
    tree = Formula("/", (top, bottom)) if bottom != number(1) else top
    return Formula("neg", (tree,)) if value < 0 else tree


def _integers(value: Fraction) -> tuple[Formula, Formula]:
    return number(value.numerator), number(value.denominator)


def _numerals(factor: Fraction, by: Fraction) -> tuple[Formula, Formula]:
    """Return a factor above and one below as decimals, the quotient of the two where it is one: 0.4; 0.08 and 0.27."""
    for above, below in ((factor / by, _ONE), (factor, by)):
        if all(number(part).op == "number" for part in (above, below)):
            return number(above), number(below)
    return _integers(factor / by)


def _factors(numeral: Formula, atoms: Atoms, terms: tuple[Term, ...], order: Order) -> Formula:
    parts = [] if numeral == number(1) else [numeral]
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
