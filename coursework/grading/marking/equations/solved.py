"""Equations solved for velocities: two wrong ones may come from one slip in an equation from which both were derived.

Enters: lines (left - right), the variant, a `Probe`.  Leaves: whether it is one slip.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.grading.marking.equations.linear import Linear, linear, rank
from coursework.grading.marking.equations.numbers import NoValue
from coursework.grading.marking.equations.probe import Probe
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Variant

_HOLDS = 1e-6  # residual up to which an equation holds, relative to the sum of the absolute values of its terms


def is_one_slip(wrong: Sequence[Formula], counted: Sequence[Formula], variant: Variant, probe: Probe) -> bool:
    """Return whether wrong lines, each solved for a velocity, and the lines that count fulfil all equations of the task but one.

    Lines that are not solved do not qualify: they may be guesses at one equation, and then each wrong one is a fault.
    """
    needed = len(variant.sought)
    if len({side.name for tree in wrong for side in tree.args if side.op == "name" and side.name in variant.sought}) < len(wrong):
        return False
    try:
        lines = [linear(tree, probe) for tree in wrong]
        for tree in counted:
            more = [*lines, linear(tree, probe)]
            lines = more if rank(more) == len(more) else lines
        task = [linear(one.difference, probe) for one in variant.constraints]
    except NoValue:
        return False
    if len(lines) != needed or len(task) != needed or not all(line.is_affine for line in lines) or rank(lines) < needed:
        return False
    slopes, rest = np.stack([line.slopes for line in lines], axis=1), np.stack([line.rest for line in lines], axis=1)
    velocities = np.asarray(np.linalg.solve(slopes, -rest[..., None])[..., 0], dtype=np.float64)
    return sum(_holds(line, velocities) for line in task) == needed - 1


def _holds(line: Linear, velocities: Array) -> bool:
    terms = np.column_stack([line.slopes * velocities, line.rest])
    return bool(np.all(np.abs(terms.sum(axis=1)) <= _HOLDS * np.abs(terms).sum(axis=1)))
