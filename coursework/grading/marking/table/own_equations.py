"""A table made from the student's own, slightly wrong equations: how much of it follows from them.

Enters: marked equations, a `Key`, the student's table.  Leaves: a share of cells.  Used by `grade.py`.
A slip in one equation spoils every number after it; whoever then solves and steps without fault has done that work.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.grading.marking.equations.equations import EquationMarks, difference
from coursework.grading.marking.equations.numbers import NoValue, real, value_of
from coursework.grading.marking.equations.probe import names_at
from coursework.grading.marking.key import Key, sensitivity
from coursework.grading.marking.table.cells import Cells, velocity_tolerance
from coursework.grading.marking.table.claims import Claim, TableUnderTest
from coursework.grading.marking.table.misconceptions import claim_share, euler_cells
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula


def own_share(key: Key, cells: Cells, equations: EquationMarks) -> float:
    """Return the share of cells that follow the student's own equations; 0 where these cannot speak for the student.

    They can where each wrong line is a single edit from a right one and the whole system determines the velocities.
    """
    if not equations.wrong or any(mark.hint is None for mark in equations.wrong):
        return 0.0
    trees = [difference(mark.line) for mark in equations.marks if mark.verdict != "unreadable"]
    printed = TableUnderTest(key, cells.student)

    def at(q: Array) -> Array:
        return _solved(key, trees, np.tile(key.t, len(q) // len(key.t)), q)

    try:
        found = at(printed.q)
        spread = sensitivity(at, printed.q, printed.q_units)
    except NoValue:
        return 0.0
    if not np.isfinite(found).any():
        return 0.0
    tolerance = velocity_tolerance(key, printed.w_units, found, spread)
    claim = Claim("own_equations", printed.whole(None, found), printed.whole(None, tolerance), "steps")
    return claim_share(key, cells, claim, *euler_cells(key, cells))


def _solved(key: Key, trees: Sequence[Formula], t: Array, q: Array) -> Array:
    """Return the velocities (n, r) that the student's equations give, NaN where they are singular or do not fit together."""
    sought = key.variant.sought
    names = names_at(key, t, q)
    rows, count = len(t), len(sought)

    def residuals(velocities: Array) -> Array:
        known = {**names, **dict(zip(sought, velocities, strict=True))}
        return np.column_stack([real(value_of(tree, known), rows) for tree in trees])

    zero = np.zeros(count)
    rest = residuals(zero)
    matrix = np.stack([residuals(np.eye(count)[place]) - rest for place in range(count)], axis=-1)
    found = np.full((rows, len(key.velocities)), np.nan)
    usable = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(rest).all(axis=1)
    if not usable.any() or len(trees) < count:
        return found
    inverse = np.linalg.pinv(matrix[usable], rcond=1e-9)
    solved = -np.einsum("nij,nj->ni", inverse, rest[usable])
    left = np.max(np.abs(np.einsum("nij,nj->ni", matrix[usable], solved) + rest[usable]), axis=1)
    regular = np.linalg.matrix_rank(matrix[usable], tol=1e-9) == count
    fits = regular & (left <= 1e-6 * (1e-300 + np.max(np.abs(rest[usable]), axis=1)))
    places = [key.velocities.index(name) for name in sought]
    found[np.ix_(np.flatnonzero(usable)[fits], places)] = solved[fits]
    for rate in key.variant.known_rates:
        found[:, key.velocities.index(rate)] = names[rate]
    return found
