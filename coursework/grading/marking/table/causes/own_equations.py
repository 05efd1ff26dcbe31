"""A table made from slightly wrong equations: the single slips in equations from which it follows, handed in or not.

Enters: a `TableUnderTest`, marked equations.  Leaves: `Claim`s.  Used by `hypotheses.py`, `misconceptions.py`,
`whole.py`, `earning.py`.
A slip in one equation spoils every number after it; a student who then solves and steps without fault has done that work.  Each
equation is tried by itself on the student's own numbers, so that slips in several equations are found as well as in one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from coursework.grading.marking.equations.edits import Edit, Values, applied, edits, places
from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.equations.numbers import NoValue, real, size_of, value_of
from coursework.grading.marking.equations.probe import kinds, names_at
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.sensitivity import with_spread
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.ways import HALF, SLACK
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named, number

# A line was used as it stands if it holds in _HOLDS of the rows; with a slip, if that holds in _BETTER more of them.
_HOLDS, _BETTER = 0.9, 0.1
_SINGULAR = 1e-9
_FAR = 3.0  # a row farther off than so many tolerances counts as no farther
OWN = "own_equations"
_AT_START = "(0)"


@frozen
class Line:
    """One line of a system: its name, left - right, all its single edits; `is_wrong` if it was handed in and is wrong."""

    name: str
    tree: Formula
    edits: tuple[Edit, ...]
    is_wrong: bool = False


@frozen
class Used:
    """A line as a table uses it; it `holds` in this part of the rows; `slip` is the line's name if it is wrong, else ""."""

    tree: Formula
    holds: float
    slip: str


def equation_claims(printed: TableUnderTest, marks: EquationMarks | None) -> Iterator[Claim]:
    """Yield claims that the velocities solve the task's equations, or those handed in, with slips in single lines."""
    yield from _claim(printed, "equation", _used(printed, _task_lines(printed.key)))
    if marks is None or any(mark.hint is None for mark in marks.wrong):
        return
    alike = kinds(printed.key.variant)
    own = [
        Line(str(mark.line.line), tree, tuple(edits(tree, alike)), mark.verdict == "wrong")
        for mark in marks.marks
        if mark.verdict != "unreadable"
        for tree in [mark.line.difference]
    ]
    yield from _claim(printed, OWN, _used(printed, own))


def _task_lines(key: Key) -> tuple[Line, ...]:
    """Return the equations of the task, written or derived from its geometry, except those with terms that have no name."""

    def found() -> tuple[Line, ...]:
        equations, alike = key.model.equations, kinds(key.variant)
        known = {*key.variant.names, "pi", *(name for name, _ in key.variant.points)}
        trees = [(one.name, Formula("-", one.shown(equations.order))) for one in equations.equations]
        return tuple(
            Line(name, tree, (*edits(tree, alike), *_left_out(tree, key.coordinates)))
            for name, tree in trees
            if {*tree.names()} <= known
        )

    return key.model.equations.once("lines and their single edits", found)


def _left_out(tree: Formula, coordinates: Sequence[str]) -> Iterator[Edit]:
    """Yield edits of a right equation: a term left out, or a coordinate kept at its start value in one place."""
    for path, node, is_term, _ in places(tree):
        if is_term and path:
            yield Edit("factor", path, number(0), 0)
        if node.op == "name" and node.name in coordinates:
            yield Edit("name", path, named(node.name + _AT_START), 0)


def _names(key: Key, t: Array, q: Array) -> dict[str, Any]:
    """Return the values of all names at times (n,) and positions (n, m), and the start values of the coordinates."""
    starts = {name + _AT_START: key.table[0, place] for place, name in enumerate(key.coordinates)}
    return {**names_at(key, t, q), **starts}


def _claim(printed: TableUnderTest, code: str, used: Sequence[Used]) -> Iterator[Claim]:
    slips = tuple(dict.fromkeys(line.slip for line in used if line.slip))
    if not slips:
        return
    trees = [line.tree for line in sorted(used, key=lambda line: -line.holds)]

    def at(t: Array, q: Array) -> Array:
        return _solved(printed.key, trees, t, q)

    try:
        name = code if code == OWN else f"{code}_{slips[0]}"
        yield from printed.velocity_claim(name, at, names=slips)
    except NoValue:
        return


def _used(printed: TableUnderTest, lines: Sequence[Line]) -> list[Used]:
    """Return each line as the table uses it: as it stands, or with the single slip that explains clearly more rows."""
    key, m, student = printed.key, printed.m, printed.student
    if not lines:
        return []

    def values_of(cells: Array) -> dict[str, Any]:
        names = _names(key, np.tile(key.t, len(cells) // len(key.t)), cells[:, :m])
        return {**names, **dict(zip(key.velocities, cells[:, m:].T, strict=True))}

    def residuals(cells: Array) -> Array:
        names = values_of(cells)
        return np.column_stack([real(value_of(line.tree, names), len(cells)) for line in lines])

    try:
        names = values_of(student.values)
        here, spread = with_spread(residuals, student.values, student.units)
        rows = np.isfinite(here)
        sizes = np.column_stack([real(size_of(line.tree, names), len(rows)) for line in lines])
        allowed = HALF * spread + SLACK * sizes
    except NoValue:
        return []
    found = []
    for place, line in enumerate(lines):
        there, limit = rows[:, place], allowed[:, place]
        if not there.any():
            continue
        holds = float(np.mean(np.abs(here[there, place]) <= limit[there]))
        slip = _with_slip(line, names, limit, holds, int(there.sum())) if holds < _HOLDS else None
        found.append(slip or Used(line.tree, holds, line.name if line.is_wrong else ""))
    return found


def _with_slip(line: Line, names: Mapping[str, Any], limit: Array, holds: float, count: int) -> Used | None:
    """Return a line with the single slip that explains clearly more of `count` rows than it `holds` in; None if none does."""
    values = Values(line.tree, names)
    made = [(edit, after) for edit in line.edits if (after := values.after(edit)) is not None and not np.iscomplexobj(after)]
    every = np.empty((len(made), len(limit)))
    for place, (_, after) in enumerate(made):
        every[place] = after
    every = np.abs(every) / limit  # nan where there is no value: such a row does not hold
    shares = np.count_nonzero(every <= 1.0, axis=1) / count
    # With few digits several edits fit every row: the nearest one is taken.
    found = [
        (float(share), -float(np.nanmean(np.minimum(off, _FAR) ** 2)), edit)
        for share, off, (edit, _) in zip(shares, every, made, strict=True)
        if share > holds + _BETTER
    ]
    if not found:
        return None
    share, _, edit = max(found, key=lambda one: one[:2])
    return Used(applied(line.tree, edit), share, line.name)


def _solved(key: Key, trees: Sequence[Formula], t: Array, q: Array) -> Array:
    """Return the velocities (n, r) from the first independent equations, NaN where these are singular."""
    sought = key.variant.sought
    names = _names(key, t, q)
    rows, count = len(t), len(sought)

    # All velocities zero, then each one alone equal to 1: (count + 1, rows) at once.
    known = {**names, **dict(zip(sought, np.eye(count + 1, count, -1).T[..., None], strict=True))}
    rest, *others = np.stack([real(value_of(tree, known), count + 1, rows) for tree in trees], axis=-1)
    matrix = np.stack([one - rest for one in others], axis=-1)
    found = np.full((rows, len(key.velocities)), np.nan)
    usable = np.flatnonzero(np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(rest).all(axis=1))
    taken = _independent(matrix[usable])
    if len(taken) < count:
        return found
    matrix, rest = matrix[usable][:, taken], rest[usable][:, taken]
    sizes = np.linalg.svd(matrix, compute_uv=False)
    regular = sizes[:, -1] > _SINGULAR * sizes[:, 0]
    solved = np.linalg.solve(matrix[regular], -rest[regular][..., None])[..., 0]
    for place, name in enumerate(sought):
        found[usable[regular], key.velocities.index(name)] = solved[:, place]
    for rate in key.variant.known_rates:
        found[:, key.velocities.index(rate)] = names[rate]
    return found


def _independent(matrix: Array) -> list[int]:
    """Return the places of the first independent lines in matrices (n, lines, k), judged at most of a few of the n points."""
    if not len(matrix):
        return []
    points = matrix[np.linspace(0, len(matrix) - 1, min(5, len(matrix))).round().astype(int)]
    taken: list[int] = []
    for place in range(points.shape[1]):
        ranks = np.linalg.matrix_rank(points[:, [*taken, place]], tol=None)
        if np.median(ranks) > len(taken):
            taken.append(place)
    return taken
