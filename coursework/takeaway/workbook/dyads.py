"""Start values that follow from the lengths: the dyads of a chain are put together by formulas, as in the tool itself.

Enters: a `SceneRun` and the names of the workbook.  Leaves: formulas of coordinates at t = 0, with intermediate values in
`Work`.  Used by `data.py`.  Source: the dyads of `mechanism/groups/`; a formula that does not reproduce the start of the run
is not used.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import field

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.mechanism.groups import group_kind
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import changing, frozen
from coursework.takeaway.workbook.formulas import spreadsheet
from coursework.takeaway.workbook.names import letters, start_of
from coursework.takeaway.workbook.tables import Tables
from coursework.variant.formula.tree import Formula, mapped, named
from coursework.variant.record.variant import Group

_NEAR = 1e-9  # rad or m: most that a formula may differ from the start of the run


@frozen
class Term:
    """A formula in a cell and its value; sums, differences, products and quotients of terms are terms."""

    text: str
    value: float

    def __add__(self, other: Term) -> Term:
        return Term(f"({self.text}+{other.text})", self.value + other.value)

    def __sub__(self, other: Term) -> Term:
        return Term(f"({self.text}-{other.text})", self.value - other.value)

    def __mul__(self, other: Term) -> Term:
        return Term(f"{self.text}*{other.text}", self.value * other.value)

    def __truediv__(self, other: Term) -> Term:
        return Term(f"{self.text}/({other.text})", self.value / other.value if other.value else math.nan)


Vector = tuple[Term, Term]


def _call(name: str, value: Callable[[float], float], term: Term) -> Term:
    return Term(f"{name}({term.text})", value(term.value))


def _root(term: Term) -> Term:
    return _call("SQRT", lambda value: math.sqrt(max(value, 0.0)), term)


def _size(term: Term) -> Term:
    return _call("ABS", abs, term)


def _cross(p: Vector, q: Vector) -> Term:
    return p[0] * q[1] - p[1] * q[0]


def _dot(p: Vector, q: Vector) -> Term:
    return p[0] * q[0] + p[1] * q[1]


def _angle(y: Term, x: Term) -> Term:
    return Term(f"ATAN2({x.text},{y.text})", math.atan2(y.value, x.value))


def _minus(p: Vector, q: Vector) -> Vector:
    return p[0] - q[0], p[1] - q[1]


@changing
class Work:
    """Cells in a hidden column of sheet Data for values that are used more than once: formula and number of each."""

    column: int
    cells: list[Term] = field(default_factory=list)

    def keep(self, term: Term) -> Term:
        """Put a term into a cell of its own; return the cell as a term."""
        self.cells.append(term)
        return Term(f"${letters(self.column)}${len(self.cells)}", term.value)


class _Known:
    """What is known before a dyad is put together, as terms: points, lengths, guides."""

    def __init__(self, run: SceneRun, names: Mapping[str, str], tables: Tables, work: Work) -> None:
        self.run, self.names, self.tables, self.work = run, names, tables, work
        self.equations = run.scene.equations
        self.laws = {law.name: law for law in run.variant.laws}

    def term(self, expression: Expression) -> Term:
        tree = self._opened(as_formula(expression, self.equations.order))
        where = {c.name: self.names[start_of(c.name)] for c in self.run.variant.coordinates}
        text = spreadsheet(tree, {**self.names, **where, "t": "0"}, lambda called, of: self.tables.value(called, where[of.name]))
        values = compile_rows(self.equations, [expression], 0)(np.zeros(1), np.array([self.run.scene.start]))
        return self.work.keep(Term(text, float(values[0, 0])))

    def _opened(self, tree: Formula) -> Formula:
        law = self.laws.get(tree.name) if tree.op == "name" else None
        if law is None:
            return mapped(tree, self._opened)
        if law.table:
            return Formula("call", (named(law.of),), f"_table_{law.name}_0")
        return self._opened(law.formula or law.pieces[0][1])

    def scalar(self, formula: Formula) -> Term:
        return self.term(self.equations.symbols.scalar(formula))

    def point(self, formula: Formula) -> Vector:
        x, y = self.equations.symbols.vector(formula)
        return self.term(x), self.term(y)

    def guide(self, group: Group, place: int) -> tuple[Vector, Vector, Term]:
        """Return a point of the line on which the pin moves, the direction of the line, and its angle."""
        guide = group.guides[place]
        angle, offset, through = self.scalar(guide.angle), self.scalar(guide.offset), self.point(guide.through)
        e = self.direction(angle)
        return (self.work.keep(through[0] - offset * e[1]), self.work.keep(through[1] + offset * e[0])), e, angle

    def direction(self, angle: Term) -> Vector:
        return self.work.keep(_call("COS", math.cos, angle)), self.work.keep(_call("SIN", math.sin, angle))


def _rrr(known: _Known, group: Group, mode: Term) -> tuple[Term, Term]:
    b, d = map(known.point, group.start_points)
    r_i, r_j = map(known.scalar, group.lengths)
    keep, two = known.work.keep, Term("2", 2.0)
    v = _minus(d, b)
    apart = keep(_root(_dot(v, v)))
    reach, gap = keep(r_i + r_j), keep(_size(r_i - r_j))
    area = (reach - apart) * (apart - gap) * (reach + apart) * (apart + gap)
    across = keep(mode * _root(area) / (two * apart))
    skew = keep((r_i - r_j) * reach / apart)
    ray = keep(_angle(v[1], v[0]))
    return ray + _angle(across, (apart + skew) / two), ray + _angle(across, (skew - apart) / two)


def _rrp(known: _Known, group: Group, mode: Term) -> tuple[Term, Term]:
    b, (k, e, angle) = known.point(group.start_points[0]), known.guide(group, 0)
    r, w = known.scalar(group.lengths[0]), _minus(b, k)
    q = known.work.keep(_cross(e, w))
    along = known.work.keep(mode * _root((r - _size(q)) * (r + _size(q))))
    return angle + _angle(Term("0", 0.0) - q, along), _dot(e, w) + along


def _rpr(known: _Known, group: Group, mode: Term) -> tuple[Term, Term]:
    b, d = map(known.point, group.start_points)
    offset, v = known.scalar(group.offset), _minus(b, d)
    apart = known.work.keep(_root(_dot(v, v)))
    s = known.work.keep(mode * _root((apart - _size(offset)) * (apart + _size(offset))))
    return _angle(v[1], v[0]) + _angle(Term("0", 0.0) - offset, s), s


def _rpp(known: _Known, group: Group, mode: Term) -> tuple[Term, Term]:
    b, (k, e, angle) = known.point(group.start_points[0]), known.guide(group, 0)
    turned = known.scalar(group.angle) if group.angle else known.work.keep(Term("PI()/2", math.pi / 2))
    sine, w = known.work.keep(_call("SIN", math.sin, turned)), _minus(b, k)
    return _cross(e, w) / sine, _cross(w, known.direction(angle + turned)) / sine


def _prp(known: _Known, group: Group, mode: Term) -> tuple[Term, Term]:
    (k_i, e_i, angle_i), (k_j, e_j, angle_j) = known.guide(group, 0), known.guide(group, 1)
    sine, w = known.work.keep(_call("SIN", math.sin, angle_j - angle_i)), _minus(k_j, k_i)
    return _cross(w, e_j) / sine, _cross(w, e_i) / sine


_DYADS = {"RRR": _rrr, "RRP": _rrp, "RPR": _rpr, "RPP": _rpp, "PRP": _prp}


def start_formulas(run: SceneRun, names: Mapping[str, str], tables: Tables, work: Work) -> dict[str, tuple[str, str]]:
    """Return formula and kind of dyad for each coordinate whose start follows from a dyad."""
    found: dict[str, tuple[str, str]] = {}
    coordinates = {one.name: one for one in run.variant.coordinates}
    start = dict(zip(coordinates, run.scene.start, strict=True))
    known = _Known(run, names, tables, work)
    for group in run.variant.groups:
        if group_kind(group.kind).driven or group.kind not in _DYADS:
            continue
        for mode in (group.mode,) if group.mode else (1, -1):
            terms = _DYADS[group.kind](known, group, Term(f"({mode})", float(mode)))
            turned = {
                name: _turned(term, start[name], coordinates[name].unit)
                for name, term in zip(group.coordinates, terms, strict=True)
            }
            if all(abs(term.value - start[name]) <= _NEAR for name, term in turned.items()):
                found |= {name: (term.text, group.kind) for name, term in turned.items()}
                break
    return {name: told for name, told in found.items() if coordinates[name].start is None}


def _turned(term: Term, near: float, unit: str) -> Term:
    """Return an angle changed by whole turns to be near another; any other term as it is."""
    if unit != "rad":
        return term
    turns = round((near - term.value) / (2 * math.pi))
    text = f"{term.text}+2*PI()*ROUND(({near!r}-{term.text})/(2*PI()),0)"
    return Term(text, term.value + 2 * math.pi * turns)
