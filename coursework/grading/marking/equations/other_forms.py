"""A line in another form: without velocities in a denominator, as in w4/w3 = 2*(…), or with the sign of some velocities turned.

Enters: a line, names of velocities.  Leaves: the line so changed.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from functools import reduce
from itertools import islice

from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.made import product_of
from coursework.variant.formula.reader import MAX_NODES
from coursework.variant.formula.tree import Formula, with_names

_MOST = 4  # different denominators with velocities in a line


def without_ratios(line: EquationLine, sought: Collection[str]) -> EquationLine:
    """Return a line with no sought velocity in a denominator, in each of its readings; its text does not change."""
    if not any("/" in text for text in (line.text, line.repaired, *(other.text for other in line.others))):
        return line
    others = tuple(replace(other, tree=multiplied_out(other.tree, sought)) for other in line.others)
    return replace(line, tree=line.tree and multiplied_out(line.tree, sought), others=others)


def multiplied_out(tree: Formula, sought: Collection[str]) -> Formula:
    """Return a line times its denominators with velocities; unchanged if there is none or the result would be too long.

    >>> from coursework.variant.formula.reader import parse
    >>> from coursework.variant.formula.tree import spelled
    >>> spelled(multiplied_out(parse("w4/w3 - 2*k"), {"w3", "w4"})), spelled(multiplied_out(parse("w4 - w3/k"), {"w3", "w4"}))
    ('w4 - 2*k*w3', 'w4 - w3/k')
    """
    below = {node.args[1] for node in tree.walk() if node.op == "/" and not {*sought}.isdisjoint(node.args[1].names())}
    if not 0 < len(below) <= _MOST:
        return tree
    made = _fraction(tree, below)[0]
    return tree if any(islice(made.walk(), MAX_NODES, None)) else made


def _fraction(tree: Formula, below: Collection[Formula]) -> tuple[Formula, list[Formula]]:
    """Return the numerator of a formula and the list of its denominators that are in `below`."""
    if tree.op not in {"neg", "+", "-", "*", "/"} or (tree.op == "/" and tree.args[1] not in below):
        return tree, []
    if tree.op == "/":
        above, under = _fraction(tree.args[0], below)
        return above, [*under, tree.args[1]]
    parts = [_fraction(arg, below) for arg in tree.args]
    if tree.op == "*":
        return Formula("*", (parts[0][0], parts[1][0]), column=tree.column), [one for _, under in parts for one in under]
    common = reduce(_together, (under for _, under in parts))
    whole = tuple(product_of([part, *_together(under, common)[len(under) :]]) for part, under in parts)
    return Formula(tree.op, whole, column=tree.column), common


def _together(first: list[Formula], second: list[Formula]) -> list[Formula]:
    """Return the first list of factors, extended by those of the second that it lacks."""
    lacking, left = list[Formula](), list(first)
    for one in second:
        if one in left:
            left.remove(one)
        else:
            lacking.append(one)
    return [*first, *lacking]


def with_other_sign(line: EquationLine, names: Collection[str]) -> EquationLine:
    """Return a line in which each of the names is replaced by its negative; its text does not change."""

    def turned(name: Formula) -> Formula:
        return Formula("neg", (name,), column=name.column) if name.name in names else name

    return replace(line, tree=with_names(line.difference, turned), others=())
