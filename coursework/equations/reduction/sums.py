"""Sums of data that an author writes as one length, (R0 + R4), (L - L/k): found in his formulas, gathered after multiplying out.

Enters: formulas of a file; the terms of an expression.  Leaves: sums; terms in which each is one factor.
Used by `tidy.py`, `addition_theorems.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import combinations_with_replacement

import sympy as sp

from coursework.equations.reduction.symbolic import symbol
from coursework.variant.formula.tree import Formula

Atoms = dict[sp.Expr, int]
Term = tuple[Fraction, tuple[tuple[sp.Expr, int], ...]]
Sum = tuple[Term, ...]  # each part a product of data


def written_sums(formulas: Iterable[Formula], data: frozenset[str]) -> dict[sp.Expr, Sum]:
    """Return the sums of `data` alone that are factors or lengths in formulas, each by its expression."""
    found: dict[sp.Expr, Sum] = {}
    for formula in formulas:
        for node in formula.walk():
            for factor in node.args if node.op in {"*", "@"} else node.args[:1] if node.op == "/" else ():
                if factor.op not in {"+", "-"}:
                    continue
                parts = [*_parts(factor, 1, data)]
                whole = tuple(part for part in parts if part is not None and part[1])
                if len(whole) == len(parts):
                    found[sp.Add(*map(_expression, whole))] = whole
    return {expr: whole for expr, whole in found.items() if isinstance(expr, sp.Add) and len(expr.args) == len(whole)}


def _parts(formula: Formula, sign: int, data: frozenset[str]) -> Iterator[Term | None]:
    """Yield each part of a sum with its sign, None for a part that is no product of data."""
    if formula.op in {"+", "-"}:
        yield from _parts(formula.args[0], sign, data)
        yield from _parts(formula.args[1], -sign if formula.op == "-" else sign, data)
    else:
        part = _product(formula, data)
        yield None if part is None else (part[0] * sign, part[1])


def _product(formula: Formula, data: frozenset[str]) -> Term | None:
    """Return a product or quotient of data and whole numbers as a term, None for anything else."""
    if formula.op == "name" and formula.name in data:
        return Fraction(1), ((symbol(formula.name), 1),)
    if formula.op == "number" and formula.value.denominator == 1 and formula.value:
        return formula.value, ()
    if formula.op not in {"*", "/"}:
        return None
    first, second = (_product(part, data) for part in formula.args)
    if first is None or second is None:
        return None
    by = second if formula.op == "*" else (1 / second[0], tuple((name, -power) for name, power in second[1]))
    return _times(first, by)


def _expression(part: Term) -> sp.Expr:
    factor, atoms = part
    return sp.Mul(sp.Rational(factor.numerator, factor.denominator), *(name**power for name, power in atoms))


def gathered(terms: list[Term], sums: dict[sp.Expr, Sum]) -> list[Term]:
    """Return terms in which what a sum was multiplied out to is one term again, in the place of its first.

    >>> from sympy.abc import a, b, x
    >>> one = Fraction(1)
    >>> gathered([(one, ((a, 1), (x, 1))), (one, ((b, 1), (x, 1)))], {a + b: ((one, ((a, 1),)), (one, ((b, 1),)))})
    [(Fraction(1, 1), ((x, 1), (a + b, 1)))]
    """
    for expr, parts in sums.items():
        for power, multiplied_out in ((2, _squared(parts)), (1, parts)):
            terms = _each_gathered(terms, (expr, power), multiplied_out)
    return terms


def _each_gathered(terms: list[Term], factor: tuple[sp.Expr, int], parts: Sum) -> list[Term]:
    place = 0
    while place < len(terms):
        group = _group(terms, place, parts)
        if group is None:
            place += 1
            continue
        places, by = group
        terms = [term for k, term in enumerate(terms) if k not in places]
        terms.insert(min(places), _times(by, (Fraction(1), (factor,))))
        place = min(places) + 1
    return terms


def _squared(parts: Sum) -> Sum:
    """Return what the square of a sum is multiplied out to."""
    pairs = combinations_with_replacement(parts, 2)
    return tuple(_times(first, second if first is second else (2 * second[0], second[1])) for first, second in pairs)


def _times(first: Term, second: Term) -> Term:
    powers = dict(first[1])
    for atom, power in second[1]:
        powers[atom] = powers.get(atom, 0) + power
    return first[0] * second[0], tuple((atom, power) for atom, power in powers.items() if power)


def _group(terms: list[Term], place: int, parts: Sum) -> tuple[list[int], Term] | None:
    """Return which terms a sum was multiplied out to, that at `place` for its first part, and by what; None if one is missing."""
    lead = _without(terms[place], parts[0])
    if lead is None:
        return None
    by, places = lead[0], [place]
    for part in parts[1:]:
        wanted = (by, frozenset(lead[1]))
        others = ((k, _without(term, part)) for k, term in enumerate(terms) if k not in places)
        found = next((k for k, other in others if other is not None and (other[0], frozenset(other[1])) == wanted), None)
        if found is None:
            return None
        places.append(found)
    return places, (by, lead[1])


def _without(term: Term, part: Term) -> Term | None:
    """Return a term divided by a product that it has as a factor, None where it has not."""
    factor, atoms = term
    own, taken = dict(atoms), dict(part[1])
    if any(own.get(atom, 0) * power < power * power for atom, power in taken.items()):
        return None
    left = ((atom, power - taken.get(atom, 0)) for atom, power in atoms)
    return factor / part[0], tuple((atom, power) for atom, power in left if power)
