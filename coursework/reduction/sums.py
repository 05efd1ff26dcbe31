"""Sums of data that an author writes as one length, (R0 + R4): found in his formulas, and gathered again after multiplying out.

Enters: formulas of a file; the terms of an expression.  Leaves: sums; terms in which each is one factor.  Used by `tidy.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

import sympy as sp

from coursework.formula.tree import Formula
from coursework.reduction.symbolic import symbol

Term = tuple[Fraction, tuple[tuple[sp.Expr, int], ...]]
Sum = tuple[tuple[int, sp.Symbol], ...]  # sign and name of each part


def written_sums(formulas: Iterable[Formula], data: frozenset[str]) -> dict[sp.Expr, Sum]:
    """Return the sums of `data` alone that are factors or lengths in formulas, each by its expression."""
    found: dict[sp.Expr, Sum] = {}
    for formula in formulas:
        for node in formula.walk():
            for factor in node.args if node.op in {"*", "@"} else node.args[:1] if node.op == "/" else ():
                if factor.op not in {"+", "-"}:
                    continue
                parts = [*_parts(factor, 1, data)]
                whole = tuple((sign, name) for sign, name in parts if name is not None)
                if len(whole) == len(parts):
                    found[sp.Add(*(sign * name for sign, name in whole))] = whole
    return {expr: whole for expr, whole in found.items() if isinstance(expr, sp.Add) and len(expr.args) == len(whole)}


def _parts(formula: Formula, sign: int, data: frozenset[str]) -> Iterator[tuple[int, sp.Symbol | None]]:
    """Yield sign and symbol of each part of a sum, None for a part that is no datum."""
    if formula.op in {"+", "-"}:
        yield from _parts(formula.args[0], sign, data)
        yield from _parts(formula.args[1], -sign if formula.op == "-" else sign, data)
    else:
        yield sign, symbol(formula.name) if formula.op == "name" and formula.name in data else None


def gathered(terms: list[Term], sums: dict[sp.Expr, Sum]) -> list[Term]:
    """Return terms in which what a sum was multiplied out to is one term again, in the place of its first.

    >>> from sympy.abc import a, b, x
    >>> one = Fraction(1)
    >>> gathered([(one, ((a, 1), (x, 1))), (one, ((b, 1), (x, 1)))], {a + b: ((1, a), (1, b))})
    [(Fraction(1, 1), ((x, 1), (a + b, 1)))]
    """
    for expr, parts in sums.items():
        place = 0
        while place < len(terms):
            group = _group(terms, place, parts)
            if group is None:
                place += 1
                continue
            places, (factor, rest) = group
            terms = [term for k, term in enumerate(terms) if k not in places]
            terms.insert(min(places), (factor, (*rest, (expr, 1))))
            place = min(places) + 1
    return terms


def _group(terms: list[Term], place: int, parts: Sum) -> tuple[list[int], Term] | None:
    """Return which terms a sum was multiplied out to, that at `place` for its first part, and by what; None if one is missing."""
    lead = _without(terms[place], parts[0][1])
    if lead is None:
        return None
    by, places = lead[0] * parts[0][0], [place]
    for sign, name in parts[1:]:
        wanted = (by * sign, frozenset(lead[1]))
        others = ((k, _without(term, name)) for k, term in enumerate(terms) if k not in places)
        found = next((k for k, other in others if other is not None and (other[0], frozenset(other[1])) == wanted), None)
        if found is None:
            return None
        places.append(found)
    return places, (by, lead[1])


def _without(term: Term, name: sp.Symbol) -> Term | None:
    """Return a term divided by a name that it has as a factor, None where it has not."""
    factor, atoms = term
    if dict(atoms).get(name, 0) < 1:
        return None
    left = ((atom, power - (atom == name)) for atom, power in atoms)
    return factor, tuple((atom, power) for atom, power in left if power)
