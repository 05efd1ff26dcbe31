"""Forces as answers: the right values on the exact rows and on the assigned table, and the value that each slip gives.

Enters: a variant with masses.  Leaves: `ForceKey`.  Imported only if a rubric asks for forces.
Used by `key.py`, `rubric.py` and `workshop.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from coursework.api import solve
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.kinetostatics.misread import slipped
from coursework.effects.scheme import read_scheme
from coursework.grading.reading.expected import Grid, GridColumn
from coursework.mechanism.mechanism import build
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.system.arrays import Array
from coursework.variant.record.variant import Variant


def force_names(variant: Variant) -> tuple[str, ...]:
    """Return the names of the forces that can be asked for: components and couples, and magnitudes (the name without x or y)."""
    names = tuple(one.name for one in read_scheme(build(variant)).unknowns)
    sizes = dict.fromkeys(name[:-1] for name in names if name[-1] in "xy" and name[0] in "RF")
    return (*names, *sizes)


@dataclass(frozen=True, eq=False)
class ForceKey:
    """The forces of a variant: in the exact motion, on the rows of the assigned scheme, and with each slip on the exact rows."""

    variant: Variant

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The forces that can be asked for."""
        return force_names(self.variant)

    @cached_property
    def _both(self) -> tuple[ForceAnalysis, ForceAnalysis]:
        results = solve(self.variant, DEFAULT_SCHEME.name, quantities=["forces"]).results
        return results.exact_forces or results.forces, results.forces

    def right(self, name: str, row: int) -> tuple[float, float, float]:
        """Return a force in `row` (from 0) of the exact motion and of the table, and the largest of its kind in that row."""
        exact, table = self._both
        values = [float(_whole(found.reactions.names, found.reactions.rows, name)[row]) for found in (exact, table)]
        couple = name[0] in "MK"
        alike = [
            abs(float(value)) for one, value in zip(exact.reactions.names, exact.reactions.rows[row], strict=True)
            if (one[0] in "MK") == couple and np.isfinite(value)
        ]  # fmt: skip
        return values[0], values[1], max(alike, default=abs(values[0]))

    def columns(self, name: str) -> tuple[Array, Array, Mapping[str, Array]]:
        """Return a force in all rows (n,): in the exact motion, in the table, and, by code, as each slip gives it."""
        exact, table = self._both
        names = exact.reactions.names
        rows = [_whole(names, found.reactions.rows, name) for found in (exact, table)]
        return rows[0], rows[1], {code: _whole(names, values, name) for code, values in self._slipped.items()}

    @cached_property
    def _slipped(self) -> dict[str, Array]:
        return slipped(self._both[0])


def _whole(names: tuple[str, ...], rows: Array, name: str) -> Array:
    if name in names:
        return np.asarray(rows[:, names.index(name)])
    return np.hypot(*(rows[:, names.index(f"{name}{axis}")] for axis in "xy"))


def with_forces(grid: Grid, key: ForceKey, names: Sequence[str]) -> Grid:
    """Return the grid of a table with the columns of forces `names` added; couples are in N·m, forces in N."""
    columns = [
        GridColumn(name, "N·m" if name[0] in "MK" else "N", tuple(key.columns(name)[1][: grid.rows].tolist())) for name in names
    ]
    return replace(grid, columns=(*grid.columns, *columns))
