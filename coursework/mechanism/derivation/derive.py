"""Which equations the points give, how many are independent, and whether the written equations are combinations of them.

Enters: a `Mechanism` and some rows of its motion.  Leaves: `Derivation`.  Used by `motion_equations.py`.
All equations are linear in the velocities, so at each configuration every equation is a row of numbers.  If an equation is a
combination of others at every row of the motion, it is taken to be one in general.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from coursework.mechanism.derivation.paths import Path, Projection, paths_of, projections_of
from coursework.mechanism.derivation.segments import ZERO, PointGraph, point_graph
from coursework.mechanism.mechanism import Mechanism
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate_any

SAME = 1e-8  # relative to the length of a row: far above round-off, far below the effect of a wrong sign
SIMPLE = (-1.0, 0.0, 1.0)
MOST_ROWS = 8  # about as many rows of the motion are used, fewer than twice as many
ROW_RANK = 1e-9


@frozen
class Numbered:
    """A projection with its name among the equations."""

    name: str
    projection: Projection


@frozen
class Combination:
    """An equation as a sum of others, as (coefficient, name); without terms, it follows from them with factors other than ±1."""

    name: str
    terms: tuple[tuple[int, str], ...]


@frozen
class Derivation:
    """The equations that follow from the points alone.

    `rank` is the number of independent `projections`; `dependent` projections are given as combinations of the written equations.
    `followed` names the written equations that are combinations of projections, `beyond` those that are not.
    """

    graph: PointGraph
    paths: tuple[Path, ...]
    projections: tuple[Numbered, ...]
    rank: int
    dependent: tuple[Combination, ...]
    followed: tuple[str, ...]
    beyond: tuple[str, ...]


def derive(mechanism: Mechanism, rows: Sequence[Mapping[str, float]]) -> Derivation | None:
    """Return the equations that the points give; None if there is no path between points of known velocity, or no row.

    Each of `rows` maps the coordinates to their values (rad, m) in one row of the motion.

    >>> import coursework
    >>> run = coursework.solve("31", quantities=["table"])
    >>> rows = [dict(zip(run.motion.coordinate_names, row, strict=True)) for row in run.motion.coordinates[:3].tolist()]
    >>> found = derive(run.scene.mechanism, rows)
    >>> [one.name for one in found.projections], found.rank, found.followed
    (['11', '12', '13', '14', '15', '16', '17', '18'], 4, ('11', '12', '16', '18'))
    """
    variant = mechanism.variant
    graph = point_graph(mechanism)
    paths = paths_of(graph)
    if not paths or not rows:
        return None
    resting = tuple(law.name for law in variant.drive if law.formula == ZERO)
    columns = (*variant.sought, *(law.name for law in variant.drive if law.name not in resting))
    table = _Table(columns, resting, variant.values, rows[:: max(1, len(rows) // MOST_ROWS)])
    try:
        written = {one.name: table.written(one.left, one.right) for one in mechanism.constraints if not one.is_closure}
        found = _chosen(graph, paths, table, written)
    except (FormulaFault, KeyError):  # a length contains a law of the configuration, whose value the rows do not give
        return None
    if not found:
        return None
    names = _names([row for _, row in found], written, {one.name for one in mechanism.constraints})
    numbered = tuple(Numbered(name, projection) for name, (projection, _) in zip(names, found, strict=True))
    blocks = np.array([row for _, row in found])
    unknown = blocks[:, 0, : len(variant.sought)]
    rank = int(np.linalg.matrix_rank(unknown, tol=ROW_RANK * max(float(np.abs(unknown).max()), 1e-300)))
    followed = tuple(name for name, row in written.items() if _follows(blocks, row))
    kept = {name: row.ravel() for name, row in written.items() if name in followed}
    dependent = [_combination(name, row.ravel(), kept) for name, (_, row) in zip(names, found, strict=True) if name not in kept]
    used = {name for path in paths for name in path.points}
    known = tuple(one for one in graph.known if one.point in used)
    drawn = tuple(path for path in paths if any(one.projection.path is path for one in numbered))
    beyond = tuple(name for name in written if name not in followed)
    return Derivation(
        PointGraph(known, graph.segments), drawn, numbered, rank,
        tuple(one for one in dependent if one is not None), followed, beyond,
    )  # fmt: skip


def _chosen(
    graph: PointGraph, paths: tuple[Path, ...], table: _Table, written: Mapping[str, Array]
) -> list[tuple[Projection, Array]]:
    """Return the projections that are not zero in all rows, each with its rows of numbers.

    Taken are paths from the first known point, and paths of which a projection is a multiple of a written equation.
    """
    found: list[tuple[Projection, Array]] = []
    for path in paths:
        rows = [(one, row) for one in projections_of(graph, (path,)) if np.any(np.abs(row := table.projection(one)) > SAME)]
        first = path.points[0] == paths[0].points[0]
        if first or any(_is_multiple(row.ravel(), other.ravel()) for _, row in rows for other in written.values()):
            found += rows
    return found


@frozen
class _Table:
    """Evaluates equations as arrays (configurations, velocities and drives); `resting` drives are zero."""

    columns: tuple[str, ...]
    resting: tuple[str, ...]
    values: Mapping[str, float]
    rows: Sequence[Mapping[str, float]]

    def projection(self, one: Projection) -> Array:
        """Return the coefficients of start + terms - end."""
        found = self._linear(one.start) - self._linear(one.end)
        for place, row in enumerate(self.rows):
            known = {"pi": math.pi, **self.values, **row}
            for term in one.terms:
                base = evaluate_any(term.angle.base, known).real if term.angle.base else 0.0
                angle = float(term.angle.offset) * math.pi + base
                value = math.sin(angle) if term.function == "sin" else math.cos(angle)
                length = evaluate_any(term.length, known).real if term.length is not None else 1.0
                if term.rate in self.columns:
                    found[place, self.columns.index(term.rate)] += term.sign * length * value
        return found

    def written(self, left: Formula, right: Formula) -> Array:
        """Return the coefficients of left - right."""
        return self._linear(left) - self._linear(right)

    def _linear(self, formula: Formula) -> Array:
        """Return the coefficients of a formula that is linear in the velocities."""
        inside = [(column, name) for column, name in enumerate(self.columns) if name in formula.names()]
        found = np.zeros((len(self.rows), len(self.columns)))
        for place, row in enumerate(self.rows if inside else ()):
            known = {"pi": math.pi, **self.values, **row, **dict.fromkeys((*self.columns, *self.resting), 0.0)}
            for column, name in inside:
                found[place, column] = evaluate_any(formula, known | {name: 1.0}).real
        return found


def _solved(rows: Array, wanted: Array) -> Array | None:
    """Return the coefficients with which the `rows` add up to `wanted`, None if there are none."""
    found: Array = np.linalg.lstsq(rows.T, wanted, rcond=None)[0].astype(np.float64)
    gap = np.linalg.norm(rows.T @ found - wanted)
    return found if gap <= SAME * max(float(np.linalg.norm(wanted)), 1e-300) else None


def _follows(rows: Array, wanted: Array) -> bool:
    """Return whether `wanted` is a combination of `rows` (equations, configurations, columns) at every configuration."""
    return all(_solved(rows[:, place], wanted[place]) is not None for place in range(len(wanted)))


def _combination(name: str, row: Array, written: Mapping[str, Array]) -> Combination | None:
    """Return an equation as a combination of the written ones, None if it is none."""
    if not written:
        return None
    found = _solved(np.array(list(written.values())), row)
    if found is None:
        return None
    whole = np.round(found)
    simple = bool(np.all(np.abs(found - whole) < SAME) and np.all(np.isin(whole, SIMPLE)))
    terms = tuple((int(c), other) for c, other in zip(whole, written, strict=True) if c) if simple else ()
    return Combination(name, terms)


def _names(rows: Sequence[Array], written: Mapping[str, Array], taken: set[str]) -> list[str]:
    """Return a name for each projection: that of the equal written equation, else a number that continues those, or a letter."""
    places = {
        name: [place for place, row in enumerate(rows) if _is_multiple(row.ravel(), other.ravel())]
        for name, other in written.items()
    }
    places = {name: found for name, found in places.items() if found}
    if places and all(name.isdigit() for name in places):
        shifts = [{int(name) - place for place in found} for name, found in places.items()]
        for shift in sorted(set.intersection(*shifts), reverse=True):
            numbers = [str(place + shift) for place in range(len(rows))]
            if shift >= 0 and not (set(numbers) & taken) - set(places):
                return numbers
    named: dict[int, str] = {}
    for name, found in places.items():
        named.setdefault(next((place for place in found if place not in named), found[0]), name)
    free = (letter for letter in "abcdefghijklmnopqrstuvwxyz" if letter not in taken)
    return [named.get(place) or next(free) for place in range(len(rows))]


def _is_multiple(row: Array, other: Array) -> bool:
    lengths = float(np.linalg.norm(row)) * float(np.linalg.norm(other))
    return lengths > 0 and abs(abs(float(row @ other)) - lengths) <= SAME * lengths
