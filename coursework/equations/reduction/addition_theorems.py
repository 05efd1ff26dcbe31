"""cos a cos b + sin a sin b -> cos(a - b), and its three sisters.

Enters: terms of a sum.  Leaves: fewer terms of the same value.  Used by `tidy.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import sympy as sp

from coursework.equations.reduction.sums import Atoms, Term

Rank = Callable[[sp.Expr], tuple[int, ...]]


def pair_angles(terms: list[Term], rank: Rank) -> list[Term]:
    """Join pairs of terms until none is left; `rank` is the place of a function in the author's order."""
    merged = True
    while merged:
        merged = False
        for i, first in enumerate(terms):
            for j in range(i + 1, len(terms)):
                joined = _join(first, terms[j], rank)
                if joined is not None:
                    terms = [term for k, term in enumerate(terms) if k not in {i, j}] + ([joined] if joined[0] else [])
                    merged = True
                    break
            if merged:
                break
    return terms


def _join(first: Term, second: Term, rank: Rank) -> Term | None:
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
    found = _addition(trig_a, trig_b, first[0], second[0], rank)
    if found is None:
        return None
    factor, merged = found
    coefficient, rest = merged.as_coeff_Mul()
    atoms = dict(shared)
    if rest != 1:
        atoms[rest] = atoms.get(rest, 0) + 1
    return factor * Fraction(int(coefficient.p), int(coefficient.q)), tuple(atoms.items())


def _two_angles(atoms: Atoms) -> list[tuple[str, sp.Expr]] | None:
    """Return [(sin|cos, angle), (sin|cos, angle)] of a product of exactly two such functions."""
    found = [
        (type(atom).__name__, atom.args[0])
        for atom, power in atoms.items()
        for _ in range(power)
        if isinstance(atom, (sp.sin, sp.cos))
    ]
    return found if len(found) == 2 and sum(atoms.values()) == 2 else None


def _addition(
    a: list[tuple[str, sp.Expr]], b: list[tuple[str, sp.Expr]], p: Fraction, q: Fraction, rank: Rank
) -> tuple[Fraction, sp.Expr] | None:
    angles = sorted({angle for _, angle in a}, key=lambda x: rank(sp.cos(x)))
    if {angle for _, angle in b} != set(angles):
        return None
    x, y = angles if len(angles) == 2 else (angles[0], angles[0])
    kinds = {"".join(sorted(kind for kind, _ in part)) for part in (a, b)}
    if kinds == {"coscos", "sinsin"}:
        cosines = p if a[0][0] == a[1][0] == "cos" else q
        return cosines, sp.cos(x - y) if p == q else sp.cos(x + y)
    if kinds == {"cossin"} and x != y:
        leading = p if ("sin", x) in a else q
        return leading, sp.sin(x + y) if p == q else sp.sin(x - y)
    return None
