"""Positions at which equations are tried: random ones off the closure and rows of the exact motion, with values of all names.

Enters: a `Key`.  Leaves: `Probe`.  Used by `equations.py` and `linear.py`; nothing here depends on a submission.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable, TableLaw
from coursework.grading.marking.equations.numbers import value_of
from coursework.grading.marking.key.key import Key
from coursework.system.arrays import Array
from coursework.variant.record.variant import Law, Variant

POINTS = 8
# Each coordinate's range is widened by this part on either side: positions off the closure, but of the same mechanism.
WIDER = 0.5
_TRIES = 50
_STRETCHED, _MOVED = 1.7, 0.3
_SEED = 20_000


@dataclass(frozen=True, eq=False)
class Probe:
    """`names` maps names to their values at `count` points; `velocities` (count, k) are the right values of those `sought`."""

    names: Mapping[str, Any]
    sought: tuple[str, ...]
    velocities: Array

    @property
    def count(self) -> int:
        """Return the number of points."""
        return len(self.velocities)

    @cached_property
    def scale(self) -> Array:
        """Return the largest absolute value (k,) of each velocity over the points; 1 if it is always zero."""
        largest = np.max(np.abs(self.velocities), axis=0, initial=0.0)
        return np.asarray(np.where(largest > 0, largest, 1.0))

    @cached_property
    def elsewhere(self) -> Array:
        """Return other velocities (n, k), at which the value of an affine equation is foretold by its coefficients."""
        return _STRETCHED * self.velocities + _MOVED

    @cached_property
    def tried(self) -> dict[str, Any]:
        """Return the names at the points, repeated for each set of velocities from which the coefficients are computed."""
        k = len(self.sought)
        sets = [np.zeros_like(self.velocities), *(np.tile(row, (self.count, 1)) for row in np.eye(k)), self.elsewhere]
        copies = {name: np.tile(value, len(sets)) if np.ndim(value) else value for name, value in self.names.items()}
        return copies | dict(zip(self.sought, np.vstack(sets).T, strict=True))


def random_probe(key: Key) -> Probe:
    """Return eight random points and the right velocities there; the same points on every machine."""
    m = key.m
    generator = np.random.Generator(np.random.PCG64(_SEED))
    low, high = key.table[:, :m].min(axis=0), key.table[:, :m].max(axis=0)
    margin = WIDER * np.maximum(high - low, 1e-3)
    rows = np.empty((0, 1 + m + len(key.velocities)))
    for _ in range(_TRIES):
        t = generator.uniform(0.0, float(key.t[-1]) or key.step, POINTS)
        q = generator.uniform(low - margin, high + margin, (POINTS, m))
        u = key.velocities_at(t, q)
        fine = np.all(np.isfinite(u), axis=1) & (np.max(np.abs(u), axis=1) < 1e6)
        rows = np.vstack([rows, np.column_stack([t, q, u])[fine]])
        if len(rows) >= POINTS:
            break
    return _probe(key, rows[:POINTS, 0], rows[:POINTS, 1 : 1 + m], rows[:POINTS, 1 + m :])


def exact_probe(key: Key) -> Probe:
    """Return at most eight rows of the exact motion, spread over the table."""
    rows = np.unique(np.linspace(0, len(key.exact) - 1, POINTS).round().astype(int))
    return _probe(key, key.t[rows], key.exact[rows, : key.m], key.exact[rows, key.m :])


def with_data(key: Key, probe: Probe, data: Mapping[str, float]) -> Probe:
    """Return the probe of the same positions for a mechanism of which some data are other ones."""
    t, q = probe.names["t"], np.column_stack([probe.names[name] for name in key.coordinates])
    return _probe(key, t, q, key.velocities_at(t, q, data), data)


def _probe(key: Key, t: Array, q: Array, u: Array, data: Mapping[str, float] | None = None) -> Probe:
    sought = key.variant.sought
    places = [key.velocities.index(name) for name in sought]
    names = names_at(key, t, q, data) | dict(zip(key.velocities, u.T, strict=True))
    return Probe(names, sought, u[:, places])


def names_at(key: Key, t: Array, q: Array, data: Mapping[str, float] | None = None) -> dict[str, Any]:
    """Return the values of all names except the unknown velocities at times (n,) and positions (n, m); points are complex.

    `data` replaces some of the variant's.
    """
    names: dict[str, Any] = {"t": t, "pi": np.pi, **key.variant.values, **(data or {})}
    names |= dict(zip(key.coordinates, q.T, strict=True))
    for law in (*key.variant.functions, *key.variant.drive):
        names[law.name] = _law(law, names)
    for name, formula in key.points:
        names[name] = np.broadcast_to(value_of(formula, names), t.shape)
    return names


def _law(law: Law, names: Mapping[str, Any]) -> Any:
    if law.table:
        table = TableLaw(law.name, law.table, law.method).function(0)
        try:
            return table(np.asarray(names[law.of or "t"], dtype=float))
        except OutsideTable:
            return np.full(np.shape(names[law.of or "t"]), np.nan)
    if law.formula is not None:
        return value_of(law.formula, names)
    values = np.zeros(np.shape(names["t"]))
    for begin, formula in law.pieces:
        values = np.where(names["t"] >= begin, value_of(formula, names), values)
    return values


def kinds(variant: Variant) -> dict[str, str]:
    """Return the kind of each name; a slip of the pen exchanges names of one kind."""
    found = {given.name: given.si for given in variant.given}
    found |= {law.name: "drive" for law in variant.drive}
    found |= {coordinate.name: coordinate.unit for coordinate in variant.coordinates}
    found |= {coordinate.rate: f"{coordinate.unit}/s" for coordinate in variant.coordinates}
    found |= {name: unit.replace("1/s", "rad/s") for name, unit in variant.unknowns}
    return found
