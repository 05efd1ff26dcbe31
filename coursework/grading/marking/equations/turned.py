"""A line of equations with the other sign of some velocities: what it says to one who counts turning clockwise.

Enters: a line, names.  Leaves: the line so changed.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.tree import Formula, mapped


def with_other_sign(line: EquationLine, names: Collection[str]) -> EquationLine:
    """Return a line that was read with each of the names replaced by its negative; its text stays."""
    assert line.left is not None
    assert line.right is not None
    return replace(line, left=_negated(line.left, names), right=_negated(line.right, names), others=())


def _negated(tree: Formula, names: Collection[str]) -> Formula:
    if tree.op == "name":
        return Formula("neg", (tree,), column=tree.column) if tree.name in names else tree
    return mapped(tree, lambda part: _negated(part, names))
