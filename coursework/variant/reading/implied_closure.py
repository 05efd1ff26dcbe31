"""What [frame] and [drive] hold beside [closure] or without it: hinges rest, points stay on rails, driven points move.

Enters: a `Variant` as its file has it.  Leaves: the same, with what is held.  Used by `reader.py`, `rigid.py`, `proposal.py`.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate_any, named
from coursework.variant.record.held import axis_of, closed_parts, largest_length, velocities_of_points
from coursework.variant.record.no_value import in_order
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath

_NUDGE = 1e-6  # rad or share of the size, by which a coordinate is moved to see whether what is held depends on it
_MOVES = 1e-12  # m per nudge, or share of a size below 1 m: what moves less does not depend on any coordinate
_INDEPENDENT = 1e-4  # a row of derivatives that differs less from the others, relative to itself, says nothing of its own


def with_implied_closure(variant: Variant) -> Variant:
    """Return the variant with points that its [drive] moves and, if its file holds nothing itself, with what its [frame] holds.

    What says nothing of its own at the start is left out; if a value is not known there, nothing is added.

    >>> import coursework
    >>> text = coursework.load("31").path.read_text(encoding="utf-8")
    >>> bare = coursework.parse_variant(text.replace('driven = "M"', "").replace('holds  = ["C.y"]', ""))
    >>> bare.driven, [coursework.variant.formula.tree.spelled(hold) for hold in bare.holds]
    ('M', ['P.y'])
    """
    if variant.driven or variant.groups or variant.motor:
        return variant
    written = [*variant.holds, *closed_parts(variant)]
    driven = [*velocities_of_points(variant).values()]
    if written:  # [closure] names points that are driven along both axes, and no others
        driven = [(point, axis) for point, axis in driven if [one for one, _ in driven].count(point) == 1]
    held = [] if written else [*_held(variant)]
    rows = [*written, *(_part(named(point), axis) for point, axis in driven), *(hold for _, hold in held)]
    if not driven and not held:
        return variant
    free = [one.name for one in variant.coordinates if one.rate not in variant.known_rates]
    start = {one.name: one.start_or_guess for one in variant.coordinates if one.start_or_guess is not None}
    derivatives = _derivatives(variant, rows, free, start)
    points = dict(enumerate((point for point, _ in driven), start=len(written)))
    own = _independent(derivatives, least := _least(variant))
    idle = {point for place, point in points.items() if place not in own}  # its coordinates are driven already
    moved = [[0 * one for one in row] if points.get(place) in idle else row for place, row in enumerate(derivatives)]
    own = _independent(moved, least)
    found = [*dict.fromkeys(points[place] for place in own if place in points)]
    kept = [held[place - len(rows)] for place in own if place >= len(rows) - len(held)]
    lines: dict[KeyPath, int] = {("closure", "holds", place): variant.nearest_line(*path) for place, (path, _) in enumerate(kept)}
    return replace(
        variant, driven=next(iter(found), None), also_driven=tuple(found[1:]),
        holds=variant.holds or tuple(hold for _, hold in kept), lines={**variant.lines, **lines},
    )  # fmt: skip


def stays(rows: Sequence[Formula], variant: Variant) -> bool:
    """Return whether no coordinate moves any of `rows`, tried at one position; False if a value is not known there."""
    tried = {one.name: 0.3 + 0.1 * place for place, one in enumerate(variant.coordinates)}
    moved = _derivatives(variant, rows, [*tried], tried)
    return bool(moved) and all(abs(one) <= _least(variant) for row in moved for one in row)


def _least(variant: Variant) -> float:
    return _MOVES * min(largest_length(variant), 1.0)


def _held(variant: Variant) -> Iterator[tuple[KeyPath, Formula]]:
    """Yield what stays, each with the path of the entry that says so."""
    for place, hinge in enumerate(variant.frame.hinges):
        yield from ((("frame", "hinges", place), _part(named(hinge), axis)) for axis in "xy")
    for place, (through, angle) in enumerate(variant.frame.rails):
        yield ("frame", "rails", place), across_rail(through, angle, variant)


def across_rail(through: Formula, angle: Formula, variant: Variant) -> Formula:
    """Return the distance of a point from the line through the origin along a rail."""
    if axis := axis_of(angle, variant.values):
        return _part(through, "y" if axis == "x" else "x")
    along, up = (Formula("call", (angle,), name) for name in ("cos", "sin"))
    return Formula("-", (Formula("*", (_part(through, "y"), along)), Formula("*", (_part(through, "x"), up))))


def _part(vector: Formula, axis: str) -> Formula:
    return Formula("part", (vector,), axis)


def _derivatives(
    variant: Variant, rows: Sequence[Formula], names: Sequence[str], start: Mapping[str, float]
) -> list[list[float]]:
    """Return the derivatives of `rows` by the coordinates `names` at a position; empty if a value is not known there."""
    points = dict(variant.points)
    needs = {name: points.keys() & {*formula.names()} for name, formula in points.items()}
    try:
        laws = [(law.name, law.formulas[0]) for law in in_order(variant) if law.formulas]
        order = [*laws, *((name, points[name]) for name in TopologicalSorter(needs).static_order())]
        known = {"pi": math.pi, "t": 0.0, **variant.values, **start}
        size = largest_length(variant)
        nudges = {one.name: _NUDGE * (size if one.unit == "m" else 1.0) for one in variant.coordinates}
        ends = {name: (start[name] - nudges[name], start[name] + nudges[name]) for name in names}
        moved = [[_values(rows, order, {**known, name: end}) for end in ends[name]] for name in names]
    except (FormulaFault, ArithmeticError, ValueError, TypeError, LookupError, CycleError):
        return []
    return [[after[row] - before[row] for before, after in moved] for row in range(len(rows))]


def _values(rows: Sequence[Formula], order: Sequence[tuple[str, Formula]], known: Mapping[str, complex]) -> list[float]:
    """Return the values of `rows`; `order` holds laws and points, each after those it needs."""
    values = {**known}
    for name, formula in order:
        values[name] = evaluate_any(formula, values)
    return [evaluate_any(row, values).real for row in rows]


def _independent(rows: Sequence[Sequence[float]], least: float) -> list[int]:
    """Return the places of the rows that are no sums of multiples of those before them, by Gram and Schmidt's way.

    What moves `least` or less does not move.
    """
    kept: dict[int, list[float]] = {}
    for place, row in enumerate(rows):
        rest = [*row]
        for one in kept.values():
            along = sum(map(operator.mul, one, rest))
            rest = [value - along * part for value, part in zip(rest, one, strict=True)]
        size = math.hypot(*rest)
        if size > max(_INDEPENDENT * math.hypot(*row), least):
            kept[place] = [value / size for value in rest]
    return [*kept]
