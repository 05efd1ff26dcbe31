"""Sums of data that an author writes as one length, (R0 + R4), (L - L/k): found in the formulas, restored after expansion.

Enters: formulas of a file; the terms of an expression.  Leaves: sums; terms in which each sum is one factor with a name.
Used by `tidy.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from coursework.equations.algebra.calculus import expand
from coursework.equations.algebra.expression import Expression, add, multiply, number
from coursework.equations.reduction.symbolic import local, symbol
from coursework.variant.formula.tree import Formula, signed


def written_sums(formulas: Iterable[Formula], data: frozenset[str]) -> dict[Expression, Expression]:
    """Return the sums of `data` alone that are factors or lengths in formulas, each under a name."""
    found: dict[Expression, None] = {}
    for formula in formulas:
        for node in formula.walk():
            for factor in node.args if node.op in {"*", "@"} else node.args[:1] if node.op == "/" else ():
                parts = [(_product(part, data), sign) for part, sign in signed(factor)]
                kept = [part * sign for part, sign in parts if part is not None and part.free_symbols]
                whole = add(*kept)
                if whole.op == "+" and len(whole.args) == len(kept) == len(parts):
                    found[whole] = None
    return {local(f"_sum{place}"): whole for place, whole in enumerate(found)}


def _product(formula: Formula, data: frozenset[str]) -> Expression | None:
    """Return a product or quotient of data and whole numbers, None for any other formula."""
    if formula.op == "name" and formula.name in data:
        return symbol(formula.name)
    if formula.op == "number" and formula.value.denominator == 1 and formula.value:
        return number(formula.value)
    if formula.op not in {"*", "/"}:
        return None
    first, second = (_product(part, data) for part in formula.args)
    if first is None or second is None:
        return None
    return first * second if formula.op == "*" else first / second


def gathered(terms: list[Expression], sums: Mapping[Expression, Expression]) -> list[Expression]:
    """Return terms in which each expanded sum is one term again, at the place of its first part.

    >>> a, b, x = map(symbol, "abx")
    >>> gathered([a * x, b * x], {local("_sum0"): a + b})
    [*(_sum0, v_x)]
    """
    for name, whole in sums.items():
        for power in (2, 1):
            parts, place = expand(whole**power).terms, 0
            while place < len(terms):
                if _divides(parts[0], terms[place]):
                    by = terms[place] / parts[0]
                    wanted = [multiply(by, part) for part in parts]
                    if set(wanted) <= set(terms) and all(map(_divides, parts, wanted)):
                        place = min(map(terms.index, wanted))
                        terms = [term for term in terms if term not in wanted]
                        terms.insert(place, multiply(by, name**power))
                place += 1
    return terms


def _divides(part: Expression, term: Expression) -> bool:
    """Return whether a term contains each factor and each divisor of a product."""
    own = dict(factor.base_and_power for factor in term.factors)
    powers = (factor.base_and_power for factor in part.split()[1].factors)
    return all(own.get(base, 0) * power >= power * power for base, power in powers)
