"""What the reader may know of the task before it looks into a submission.

Enters: a variant and its Euler table.  Leaves: `Expected`, `Grid`.
Used by the readers of this room (rows and units only) and by whoever marks.
"""

from __future__ import annotations

from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant


@frozen
class GridColumn:
    """One column of the assigned table: name, SI unit (rad, m, 1/s, m/s), the key's values in SI, of a coordinate its rate.

    The reader looks at `values` for the unit of a column without one in its header and for whole turns, for nothing else.
    """

    name: str
    unit: str
    values: tuple[float, ...]
    rate: str = ""


@frozen
class Grid:
    """The assigned rows and columns: row k (from 1) stands at t = (k - 1)·step, in s; columns of `given` may be left out."""

    step: float
    rows: int
    columns: tuple[GridColumn, ...]
    given: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the columns, in the order of the key."""
        return tuple(column.name for column in self.columns)

    @property
    def units(self) -> tuple[tuple[str, str], ...]:
        """Return (name, SI unit) of the columns."""
        return tuple((column.name, column.unit) for column in self.columns)


@frozen
class Expected:
    """The grid, the variant whose names equations are written with, the names that answers may have."""

    grid: Grid
    variant: Variant
    answers: tuple[str, ...] = ()


def grid_of(variant: Variant, columns: dict[str, tuple[float, ...]], given: tuple[str, ...] = ()) -> Grid:
    """Return the grid of a variant from its Euler table (`columns` by name, SI; fewer rows where the motion stops).

    `given` are the columns that hold the same datum in every row.
    """
    rows = min(len(values) for values in columns.values())
    units = {name: variant.unit_of(name).replace("rad/s", "1/s") for name in variant.columns}
    rates = {coordinate.name: coordinate.rate for coordinate in variant.coordinates}
    found = tuple(GridColumn(name, unit, columns[name], rates.get(name, "")) for name, unit in units.items())
    return Grid(variant.time.step, rows, found, given)
