"""A line with velocities below a stroke, w4/w3 = 2*(…) as ratios are written -> the same with both sides times what is below.

Enters: a line, the velocities that are sought.  Leaves: the line so changed.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from functools import reduce
from itertools import islice

from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.reader import MAX_NODES
from coursework.variant.formula.tree import Formula

_MOST = 4  # different velocities, or sums of them, below strokes


def without_ratios(line: EquationLine, sought: Collection[str]) -> EquationLine:
    """Return a line without velocities below strokes, in each way of reading it; its text stays."""
    if not any("/" in text for text in (line.text, line.repaired, *(other.text for other in line.others))):
        return line
    others = tuple(replace(other, tree=multiplied_out(other.tree, sought)) for other in line.others)
    return replace(line, tree=line.tree and multiplied_out(line.tree, sought), others=others)


def multiplied_out(tree: Formula, sought: Collection[str]) -> Formula:
    """Return a line times the velocities that stand below strokes in it, the very line where none do or it were too long then.

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
    """Return what stands above a stroke and what of `below` stands under it."""
    if tree.op not in {"neg", "+", "-", "*", "/"} or (tree.op == "/" and tree.args[1] not in below):
        return tree, []
    if tree.op == "/":
        above, under = _fraction(tree.args[0], below)
        return above, [*under, tree.args[1]]
    parts = [_fraction(arg, below) for arg in tree.args]
    if tree.op == "*":
        return Formula("*", (parts[0][0], parts[1][0]), column=tree.column), [one for _, under in parts for one in under]
    common = reduce(_together, (under for _, under in parts))
    whole = tuple(reduce(_times, _together(under, common)[len(under) :], part) for part, under in parts)
    return Formula(tree.op, whole, column=tree.column), common


def _together(first: list[Formula], second: list[Formula]) -> list[Formula]:
    """Return the first factors and those of the second that they lack."""
    lacking, left = list[Formula](), list(first)
    for one in second:
        if one in left:
            left.remove(one)
        else:
            lacking.append(one)
    return [*first, *lacking]


def _times(first: Formula, second: Formula) -> Formula:
    return Formula("*", (first, second))
