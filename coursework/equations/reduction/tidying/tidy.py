"""Expression -> formula in the author's order and in the compact form of a textbook.

Enters: expressions of a small block.  Leaves: `Formula` for a page.  No computation uses it.
The rewriting takes out common factors and joins angles by `addition_theorems.py`.
Used by `conditioning.py`, `blocks.py`, `equations.py` and `solution.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce

from coursework.equations.algebra.calculus import content, together
from coursework.equations.algebra.expression import HALF, MINUS, ONE, ZERO, Expression, multiply, number
from coursework.equations.algebra.expression import power as raised
from coursework.equations.codegen.names import private, public
from coursework.equations.reduction.symbolic import expanded
from coursework.equations.reduction.tidying.addition_theorems import common, pair_angles
from coursework.equations.reduction.tidying.sums import gathered, written_sums
from coursework.system.frozen import frozen
from coursework.variant.formula.made import product_of, summed
from coursework.variant.formula.tree import Formula, named
from coursework.variant.formula.tree import number as in_digits
from coursework.variant.record.variant import Variant

# A formula with more parts (some 400 operations) is shown as it is: nobody reads it, and expanding it is slow.
MOST_PARTS = 1000
_ONE = Fraction(1)


class Order:
    """The author's order of names and functions, as they first appear in the equations; `sums` that the author writes as one.

    `has_decimals`: the author writes lengths as 0.02, so factors are shown this way too, not as 1/50; 0.5 alone does not count.
    """

    def __init__(self, formulas: list[Formula], variant: Variant) -> None:
        names = [name for formula in formulas for name in formula.names()]
        names += [*variant.values, *(law.name for law in variant.laws)]
        names += [*variant.sought, *(c.name for c in variant.coordinates), *variant.rates]
        self._names = {private(name): place for place, name in enumerate(dict.fromkeys(names))}
        self._declared = variant.names
        calls = [node.name for formula in formulas for node in formula.walk() if node.op == "call"]
        self._calls = {name: place for place, name in enumerate(dict.fromkeys([*calls, "cos", "sin"]))}
        written = {node.name for formula in formulas for node in formula.walk() if node.op == "number"}
        self.has_decimals = any(Fraction(name).denominator > 2 for name in written)
        self.sums = written_sums(formulas, frozenset(g.name for g in variant.given))

    def rank(self, atom: Expression) -> tuple[int, ...]:
        """Return the sort key of a symbol, function or power: names come before functions."""
        if atom in self.sums:
            return min(self.rank(name) for name in self.sums[atom].free_symbols)
        if atom.op == "symbol":
            return (0, self._names.get(atom.name, len(self._names)))
        if atom.op == "^":
            return self.rank(atom.args[0])
        inner = tuple(sorted(self._names.get(s.name, len(self._names)) for s in atom.free_symbols))
        return (1, self._calls.get(atom.op, 99), *inner)

    def public(self, symbol: Expression) -> str:
        """Return the name of a symbol in text: the declared name, or "∂r/∂phi" for a derivative."""
        return public(symbol.name, self._declared)

    def term(self, term: Expression) -> tuple[tuple[int, ...], ...]:
        """Return the sort key of a term in a sum."""
        return tuple(sorted(self.rank(base) for base, _ in _powers(term)))


@frozen
class Product:
    """factor * product of `common` factors * sum of `terms` (1 if empty), tidied."""

    factor: Fraction
    common: Expression
    terms: tuple[Expression, ...]


def product(expr: Expression, order: Order) -> Product:
    """Return an expression as one product; a sum that cannot be factored becomes its `terms`."""
    if expr.size > MOST_PARTS:
        return Product(_ONE, expr, ())
    terms = pair_angles(_terms(expr, order), order.rank)
    if not terms:
        return Product(Fraction(0), ONE, ())
    shared = common(terms)
    if shared is not ONE:
        inverse = 1 / shared
        terms = [multiply(term, inverse) for term in terms]
    terms.sort(key=order.term)
    whole = content(term.split()[0] for term in terms) * (-1 if terms[0].split()[0] < 0 else 1)
    return Product(whole, shared, () if len(terms) == 1 else tuple(terms) if whole == 1 else _times(1 / whole, terms))


def _terms(expr: Expression, order: Order) -> list[Expression]:
    return gathered([term for term in expanded(expr).terms if term is not ZERO], order.sums)


def _times(factor: Fraction, terms: Sequence[Expression]) -> tuple[Expression, ...]:
    return tuple(multiply(number(factor), term) for term in terms)


def quotient(above: Expression, bottom: Product, order: Order) -> Formula:
    """Return above / bottom with common factors cancelled."""
    top = product(above, order)
    up, down = ((), ()) if top.terms == bottom.terms else (top.terms, bottom.terms)
    times, shared = (top.common / bottom.common).split()
    (above_all, up), (below_all, down) = _as_given(top.factor * times, up, order), _as_given(bottom.factor, down, order)
    return _fraction(above_all, shared, up, down, order, below_all)


def _as_given(factor: Fraction, terms: tuple[Expression, ...], order: Order) -> tuple[Fraction, tuple[Expression, ...]]:
    """Return factor and terms; with decimal lengths, multiply unequal terms by the factor: 0.02 and 0.25, not 0.01, 2, 25."""
    if not order.has_decimals or all(abs(term.split()[0]) == 1 for term in terms):
        return factor, terms
    return Fraction(1 if factor > 0 else -1), _times(abs(factor), terms)


def as_formula(expr: Expression, order: Order) -> Formula:
    """Return an expression as a tidied formula."""
    if expr.size > MOST_PARTS:
        return _plain(expr, order)
    # Finding a common denominator costs more than everything else; most expressions need none.
    divided = any(part.op == "^" and part.args[1].is_negative for part in expr.walk())
    above, below = together(expr) if divided else (expr, ONE)
    return quotient(above, product(below, order), order)


def as_sum(expr: Expression, order: Order) -> Formula:
    """Return an expression as the plain sum of its terms, the form of a velocity equation."""
    if expr.size > MOST_PARTS:
        return _plain(expr, order)
    return _sum(sorted(_terms(expr, order), key=order.term), order)


def _powers(term: Expression) -> list[tuple[Expression, Fraction]]:
    """Return bases and powers of a product without its number; a root counts as a base."""
    rest = term.split()[1]
    return [_root(part) for part in rest.factors] if rest is not ONE else []


def _root(part: Expression) -> tuple[Expression, Fraction]:
    """Return base and power; of x^(-1/2) the root of x and -1, so that it stands in a denominator as a root."""
    base, exponent = part.base_and_power
    if exponent.denominator == 1:
        return base, exponent
    return (raised(base, -exponent), -_ONE) if exponent < 0 else (part, _ONE)


def _fraction(
    factor: Fraction, shared: Expression, up: Sequence[Expression], down: Sequence[Expression], order: Order, by: Fraction = _ONE
) -> Formula:
    value = factor / by
    if value == 0 or not (shared is not ONE or up or down):
        return in_digits(value)
    powers = _powers(shared)
    above = {base: power for base, power in powers if power > 0}
    below = {base: -power for base, power in powers if power < 0}
    numeral, divisor = _numerals(abs(factor), abs(by)) if order.has_decimals else _integers(abs(value))
    top, bottom = _factors(numeral, above, up, order), _factors(divisor, below, down, order)
    tree = Formula("/", (top, bottom)) if bottom != in_digits(1) else top
    return Formula("neg", (tree,)) if value < 0 else tree


def _integers(value: Fraction) -> tuple[Formula, Formula]:
    return in_digits(value.numerator), in_digits(value.denominator)


def _numerals(factor: Fraction, by: Fraction) -> tuple[Formula, Formula]:
    """Return decimals for numerator and denominator, or their quotient if that is a decimal: 0.4, or 0.08 and 0.27."""
    for above, below in ((factor / by, _ONE), (factor, by)):
        if all(in_digits(part).op == "number" for part in (above, below)):
            return in_digits(above), in_digits(below)
    return _integers(factor / by)


def _factors(numeral: Formula, powers: Mapping[Expression, Fraction], terms: Sequence[Expression], order: Order) -> Formula:
    parts = [] if numeral == in_digits(1) else [numeral]
    for base, power in sorted(powers.items(), key=lambda item: order.rank(item[0])):
        parts.append(_plain(base, order) if power == 1 else Formula("^", (_plain(base, order), in_digits(power))))
    return product_of([*parts, _sum(terms, order)] if terms else parts)


def _sum(terms: Sequence[Expression], order: Order) -> Formula:
    parts = [term.split() for term in terms]
    return summed((_fraction(abs(factor), rest, (), (), order), -1 if factor < 0 else 1) for factor, rest in parts)


def _plain(expr: Expression, order: Order) -> Formula:
    """Return one atom as a formula, not rewritten inside."""
    match expr.op:
        case "symbol" if expr in order.sums:
            return _argument(order.sums[expr], order)
        case "symbol":
            return named(order.public(expr))
        case "pi":
            return named("pi")
        case "number":
            return in_digits(expr.value)
        case "^":
            base = _plain(expr.args[0], order)
            if expr.args[1] is HALF:
                return Formula("call", (base,), "sqrt")
            return Formula("^", (base, _plain(expr.args[1], order)))
        case "*" if expr.split()[0] < 0:
            return Formula("neg", (_plain(multiply(MINUS, expr), order),))
        case "+" | "*":
            return reduce(lambda a, b: _joined(a, b, expr.op == "*"), [_plain(part, order) for part in expr.args])
    return Formula("call", tuple(_argument(arg, order) for arg in expr.args), expr.op)


def _argument(expr: Expression, order: Order) -> Formula:
    """Return the argument of a function with a positive term first, so that φ1 - φ2 is not written -φ2 + φ1."""
    return _sum(sorted(expr.terms, key=lambda term: (term.split()[0] < 0, order.term(term))), order)


def _joined(a: Formula, b: Formula, is_product: bool) -> Formula:
    if is_product:
        return Formula("*", (a, b))
    return Formula("-", (a, b.args[0])) if b.op == "neg" else Formula("+", (a, b))
