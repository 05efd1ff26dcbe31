"""The key of one variant: its Euler table, and its velocities at any time and position and with other data.

Enters: a `Variant`.  Leaves: `Key`.  Used by every part of this room; made once a variant and kept.
Variants that differ only in their data share one compiled model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.api import make_run
from coursework.equations.reduction.structure import without_data
from coursework.grading.marking.decimals import SHARED, SHOWN, SOLVED, decimals_asked, gap_of
from coursework.grading.marking.key.branches import other_assemblies
from coursework.grading.marking.key.kept import kept
from coursework.grading.marking.key.misread import misread
from coursework.grading.reading.expected import Grid, grid_of
from coursework.many import Solutions, solve_many
from coursework.mechanism.mechanism import build
from coursework.motion.geometry.drives.drive import breaks
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.scene.model.data import Data
from coursework.scene.model.model import Model, model_of
from coursework.scene.motion_results import given_constants
from coursework.system.arrays import Array, Flags
from coursework.variant.formula.tree import Formula
from coursework.variant.record.changes import followers
from coursework.variant.record.variant import Variant
from coursework.words.errors import CourseworkError, Fault, InputError
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.grading.marking.key.forces import ForceKey
    from coursework.grading.marking.key.free_rows import FreeRows

# Most rows lie between the quantiles _MOST and 1 - _MOST; a column with a range of over _SUDDEN times theirs has a pulse.
_MOST, _SUDDEN = 0.9, 20.0
_LAST_BIT = 1 + 1e-9
_DATA_KEPT = 32


@dataclass(frozen=True, eq=False)
class Key:
    """What a right table is.

    `table` (n, m + r) has the columns `names`: m coordinates, then r velocities (rates first), SI. `stopped` says why it is
    shorter than assigned, "" if it is not. `accepted_decimals` is how few decimals the whole class may hand in, None if the
    variant stands alone. `free` has the rows of a motion under forces, None otherwise. Cached properties are found when first
    needed. Methods return NaN where a velocity has no value.
    """

    variant: Variant
    model: Model
    table: Array
    stopped: str = ""
    accepted_decimals: int | None = None
    free: FreeRows | None = None

    def velocities_at(self, t: Array, q: Array, data: Mapping[str, float] | None = None) -> Array:
        """Return all velocities (n, r), in the table's order, at times (n,) and positions (n, m); `data` replaces some data."""
        return kept(self.model.rates, self._with(tuple(data.items())) if data else self._assigned, t, q)

    def sets_at(self, t: Array, q: Array, sets: Sequence[Mapping[str, float]]) -> Array:
        """Return the velocities (sets, n, r) with each of several `sets` of changed data."""
        if not sets:
            return np.empty((0, len(t), len(self.velocities)))
        return self.model.rates(t[None], q[None], self._assigned.with_each(sets))

    def block_at(self, block: int, t: Array, q: Array, velocities: Array) -> Array:
        """Return the velocities (n, size) of a block; those of earlier blocks are taken from `velocities` (n, r)."""
        return kept(self._blocks[block], self._assigned, t, q, velocities)

    def misread(self, code: str) -> Callable[[Array, Array], Array] | None:
        """Return the velocities as a function of t and q with one misconception in the formulas, None if it cannot be there."""
        if code not in self._misread:
            changed = misread(self.variant, self.model.equations, code)
            self._misread[code] = None
            with suppress(CourseworkError):
                if changed:
                    model = model_of(changed)
                    self._misread[code] = partial(kept, model.rates, model.data(changed.values))
        return self._misread[code]

    @cached_property
    def _misread(self) -> dict[str, Callable[[Array, Array], Array] | None]:
        return {}

    @cached_property
    def points(self) -> Sequence[tuple[str, Formula]]:
        """Return the names of the points and their formulas, points of groups included; each comes after those it refers to."""
        return build(self.variant).points

    @cached_property
    def _blocks(self) -> Sequence[Callable[..., Array]]:
        return [partial(self.model.block_velocities, block) for block in range(len(self.blocks))]

    @cached_property
    def _assigned(self) -> Data:
        return self.model.data(self.variant.values)

    @cached_property
    def _with(self) -> Callable[[tuple[tuple[str, float], ...]], Data]:
        """Return the function of changed data that gives all data, for those last asked for without reading them again."""
        return lru_cache(_DATA_KEPT)(lambda changed: self.model.data({**self.variant.values, **dict(changed)}))

    @cached_property
    def exact(self) -> Array:
        """Return the rows (n, m + r) of the exact motion; fewer than assigned if it stops."""
        return np.asarray(make_run(self.variant, DEFAULT_SCHEME.name, quantities=["table"]).exact.rows)

    @cached_property
    def forces(self) -> ForceKey | None:
        """The right values of the forces, None if the variant has no forces."""
        if self.variant.forces is None:
            return None
        from coursework.grading.marking.key.forces import ForceKey

        return ForceKey(self.variant)

    @cached_property
    def branches(self) -> Sequence[Array]:
        """Return Euler's tables of the mechanism in its other assemblies."""
        return other_assemblies(self.variant, self.table)

    @property
    def step(self) -> float:
        """Return the assigned step, s."""
        return self.variant.time.step

    @property
    def stepped(self) -> Flags:
        """Return which coordinates (m,) are integrated by Euler's rule."""
        return np.ones(self.m, dtype=bool) if self.free is None else np.isin(np.arange(self.m), self.free.state)

    @property
    def stride(self) -> float:
        """Return the step between two rows with which coordinates are integrated, s."""
        return self.step

    @cached_property
    def blocks(self) -> tuple[tuple[str, ...], ...]:
        """Return the unknown velocities in the order of solution."""
        return tuple(block.unknowns for block in self.model.blocks)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Return the names of the coordinates."""
        return self.model.coordinates

    @property
    def m(self) -> int:
        """Return the number of coordinates."""
        return len(self.model.coordinates)

    @property
    def velocities(self) -> tuple[str, ...]:
        """Return the names of the velocities: rates in the order of the coordinates, then the unknowns."""
        return self.model.velocities

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of all columns after t."""
        return self.variant.columns

    @cached_property
    def given(self) -> Mapping[str, float]:
        """Return the velocities that the task gives as constants; a table may leave out their columns, as the report does."""
        return given_constants(self.variant, self.names, self.table)

    @property
    def grid(self) -> Grid:
        """Return what the reader of submissions may know of the table."""
        return grid_of(self.variant, dict(zip(self.names, map(tuple, self.table.T.tolist()), strict=True)), tuple(self.given))

    @cached_property
    def t(self) -> Array:
        """Return the times of the rows (n,), s."""
        return np.arange(len(self.table), dtype=float) * self.step

    @cached_property
    def ranges(self) -> Array:
        """Return the range of each column (m + r,)."""
        return np.asarray(np.ptp(self.table, axis=0))

    @cached_property
    def usual_ranges(self) -> Array:
        """Return the ranges (m + r,) that tolerances are parts of: a short pulse does not widen the tolerance of other rows."""
        spread = np.subtract(*np.quantile(self.table, (_MOST, 1 - _MOST), axis=0))
        return np.asarray(np.minimum(self.ranges, _SUDDEN * spread))

    @cached_property
    def gap(self) -> float:
        """Return the one-step gap G: the largest difference of a Heun step from an Euler step, over rows and coordinates."""
        m = self.m
        if self.free is not None:
            return float(gap_of(np.zeros((1, m)), self.free.accelerations[:, :m] * self.step, self.step, self.ranges[:m]))
        here, q = self.t[:-1], self.table[:-1, :m]
        slopes = self.velocities_at(here, q)[:, :m]
        ahead = self.velocities_at(here + self.step, q + self.step * slopes)[:, :m]
        return float(gap_of(slopes, ahead, self.step, self.ranges[:m]))

    @cached_property
    def off_euler(self) -> Array:
        """Return the differences (3, n - 1, m) from Euler's step: of Heun's, and with the velocities at t + h and at t - h."""
        m, h, t, q = self.m, self.step, self.t[:-1], self.table[:-1, : self.m]
        rates = self.velocities_at(t, q)[:, :m]
        others = [self.velocities_at(at, q)[:, :m] for at in (t + h, t - h)]
        heun = (rates + self.velocities_at(t + h, q + h * rates)[:, :m]) / 2
        return np.nan_to_num(h * (np.stack([heun, *others]) - rates))

    @property
    def least_decimals(self) -> int:
        """Return how many decimals a task sheet asks for."""
        return decimals_asked(self.gap)

    @cached_property
    def told_to(self) -> Array:
        """Return the last place (m,), SI, with which the task sheet prints each start that it computes; 0 for a given start."""
        solved = followers(self.variant)
        return np.where([name in solved for name in self.coordinates], 10.0 ** -(self.least_decimals + SOLVED), 0.0)

    @cached_property
    def coarsest(self) -> Array:
        """Return the largest unit of the last place (m + r,), SI, with which a cell of each column counts as shown."""
        found = np.full(len(self.names), SHOWN * self.gap)
        found[self.m :] /= self.step
        if self.accepted_decimals is None:
            return found
        return np.asarray(np.maximum(found, np.minimum(_LAST_BIT * 10.0**-self.accepted_decimals, SHARED * found)))

    @cached_property
    def order(self) -> tuple[int, ...]:
        """Return the places of the columns in the order of work: angles, then velocities block by block, driven rates last."""
        m = self.m
        if self.free is not None:  # the state of a row, then what follows from it
            return (*self.free.state, *(place for place in range(len(self.names)) if place not in self.free.state))
        placed = [place for block in self.blocks for place in sorted(m + self.velocities.index(name) for name in block)]
        driven = [place for place in range(m, m + len(self.velocities)) if place not in placed]
        return (*range(m), *placed, *driven)


def key_of(variant: Variant, accepted_decimals: int | None = None) -> Key:
    """Return the key of a variant; `accepted_decimals` are those of its class.  Raises `InputError` if it has no solution."""
    if variant.motor is not None:
        from coursework.grading.marking.key.free_rows import FreeRows

        free = FreeRows(variant)
        return Key(variant, model_of(variant), free.table, free.stopped, accepted_decimals, free)
    model = model_of(variant)
    solved = _solved(model, [variant])
    stop = solved.stops[0]
    return Key(variant, model, _complete(solved.values[0]), stop.sentence if stop else "", accepted_decimals)


def key_to_mark_by(variant: Variant, accepted_decimals: int | None = None) -> Key:
    """Return the key of a variant.  Raises `InputError` also if its motion stops at once and the table is empty."""
    key = key_of(variant, accepted_decimals)
    if not len(key.table):
        raise InputError([Fault(say("fault.G006", stopped=key.stopped), variant.file)])
    return key


def tables_of(variants: Mapping[str, Variant]) -> dict[str, Array]:
    """Return Euler's tables by name, those of one template computed together; what cannot be computed is left out."""
    alike: dict[tuple[object, ...], dict[str, Variant]] = {}
    driven = {name: one for name, one in variants.items() if one.motor is None}  # a motion under forces is marked by its own rows
    for name, variant in driven.items():
        key = (without_data(variant), breaks(variant), variant.time.step, variant.time.end)
        alike.setdefault(key, {})[name] = variant
    found: dict[str, Array] = {}
    for group in alike.values():
        with suppress(CourseworkError):
            tables = _solved(model_of(next(iter(group.values()))), list(group.values())).values
            found |= {name: _complete(rows) for name, rows in zip(group, tables, strict=True)}
    return {name: found[name] for name in variants if name in found}


def _solved(model: Model, variants: Sequence[Variant]) -> Solutions:
    """Return Euler's solutions of variants of one template with the same step and end."""
    columns: dict[str, Any] = {name: [variant.values[name] for variant in variants] for name in model.variant.values}
    for place, coordinate in enumerate(model.variant.coordinates):
        starts = [variant.coordinates[place].start for variant in variants]
        if None not in starts:
            columns[coordinate.name] = starts
    time = variants[0].time
    return solve_many(model, columns, DEFAULT_SCHEME.name, time.step, time.end)


def _complete(rows: Array) -> Array:
    """Return the rows before the motion stopped."""
    return np.asarray(rows[~np.isnan(rows).any(axis=1)])
