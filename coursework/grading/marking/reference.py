"""A variant -> its `Key`: Euler's table, the exact motion, velocities at any position and data.

Enters: a `Variant`.  Leaves: `Key`.  Used by the children of a batch, once a variant.
Variants that differ in their data only share one compiled model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.api import solve
from coursework.equations.reduction.structure import without_data
from coursework.grading.marking.key import Key
from coursework.grading.marking.table.branches import other_assemblies
from coursework.many import Solutions, solve_many
from coursework.motion.geometry.drive import breaks
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.scene.model.model import Model, model_of
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula, mapped, named, number
from coursework.variant.record.variant import Law, Variant
from coursework.words.errors import CourseworkError

_TURNING = ("sin", "cos", "tan")
_DEGREE = Formula("/", (named("pi"), number(180)))


def key_of(variant: Variant) -> Key:
    """Return the key of a variant.  Raises `InputError` where it cannot be solved at all."""
    model = model_of(variant)
    solved = _solved(model, [variant])
    rows, stop = _complete(solved.values[0]), solved.stops[0]
    given = variant.values
    assigned = model.data(given)

    def velocities_at(t: Array, q: Array, data: Mapping[str, float]) -> Array:
        return model.rates(t, q, {**given, **data} if data else assigned)

    def sets_at(t: Array, q: Array, sets: Sequence[Mapping[str, float]]) -> Array:
        if not sets:
            return np.empty((0, len(t), len(model.velocities)))
        columns = {name: np.array([data.get(name, value) for data in sets]) for name, value in given.items()}
        return model.rates(t[None], q[None], columns)

    def block_at(block: int, t: Array, q: Array, earlier: Array) -> Array:
        return model.block_velocities(block, t, q, earlier, assigned)

    return Key(
        variant, variant.time.step, rows, lambda: _exact(variant), tuple(block.unknowns for block in model.blocks),
        velocities_at, sets_at, block_at, lambda code: _rewritten(variant, code), stop.sentence if stop else "",
        lambda: other_assemblies(variant, rows),
    )  # fmt: skip


def class_tables(variants: Mapping[str, Variant]) -> dict[str, Array]:
    """Return Euler's tables of variants by name, those of one template together; without any that cannot be computed."""
    alike: dict[tuple[object, ...], dict[str, Variant]] = {}
    for name, variant in variants.items():
        key = (without_data(variant), breaks(variant), variant.time.step, variant.time.end)
        alike.setdefault(key, {})[name] = variant
    found: dict[str, Array] = {}
    for group in alike.values():
        with suppress(CourseworkError):
            model = model_of(next(iter(group.values())))
            tables = _solved(model, list(group.values())).values
            found |= {name: _complete(rows) for name, rows in zip(group, tables, strict=True)}
    return {name: found[name] for name in variants if name in found}


def _solved(model: Model, variants: Sequence[Variant]) -> Solutions:
    """Return Euler's tables of variants of one template with one step and end."""
    columns: dict[str, Any] = {name: [variant.values[name] for variant in variants] for name in model.variant.values}
    for place, coordinate in enumerate(model.variant.coordinates):
        starts = [variant.coordinates[place].start for variant in variants]
        if None not in starts:
            columns[coordinate.name] = starts
    time = variants[0].time
    return solve_many(model, columns, DEFAULT_SCHEME.name, time.step, time.end)


def _complete(rows: Array) -> Array:
    """Return the rows before a motion stopped."""
    return np.asarray(rows[~np.isnan(rows).any(axis=1)])


def _exact(variant: Variant) -> Array:
    return np.asarray(solve(variant, DEFAULT_SCHEME.name, quantities=["table"]).exact.rows)


def _rewritten(variant: Variant, code: str) -> Callable[[Array, Array], Array] | None:
    """Return the velocities of the variant with one misconception written into its formulas, None where that cannot be."""
    if code == "degree_mode" and variant.groups:
        return None  # a group's closed form has its sines inside
    changed = _in_degrees(variant) if code == "degree_mode" else _with_drive_turned(variant)
    try:
        model = model_of(changed)
    except CourseworkError:
        return None
    assigned = model.data(variant.values)
    return lambda t, q: model.rates(t, q, assigned)


def _with_drive_turned(variant: Variant) -> Variant:
    return replace(
        variant,
        drive=tuple(
            replace(
                law,
                formula=Formula("neg", (law.formula,)) if law.formula else None,
                pieces=tuple((begin, Formula("neg", (piece,))) for begin, piece in law.pieces),
                table=tuple((at, -value) for at, value in law.table),
            )
            for law in variant.drive
        ),
    )


def _in_degrees(variant: Variant) -> Variant:
    """Return the variant as a calculator set to degrees sees it: every argument of a sine is taken for degrees."""

    def laws(found: Sequence[Law]) -> tuple[Law, ...]:
        return tuple(
            replace(
                law,
                formula=_degrees(law.formula) if law.formula else None,
                pieces=tuple((begin, _degrees(piece)) for begin, piece in law.pieces),
            )
            for law in found
        )

    return replace(
        variant,
        drive=laws(variant.drive),
        functions=laws(variant.functions),
        constraints=tuple(replace(c, left=_degrees(c.left), right=_degrees(c.right)) for c in variant.constraints),
        points=tuple((name, _degrees(point)) for name, point in variant.points),
        holds=tuple(_degrees(hold) for hold in variant.holds),
    )


def _degrees(tree: Formula) -> Formula:
    turned = mapped(tree, _degrees)
    if tree.op == "@" or (tree.op == "call" and tree.name in _TURNING):
        *length, angle = turned.args
        return replace(turned, args=(*length, Formula("*", (angle, _DEGREE))))
    return turned
