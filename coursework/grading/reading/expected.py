"""What the reader may know about the task before it opens a submission.

Enters: a variant and its Euler table.  Leaves: `Expected`, `Grid`.
Used by the readers of this room (rows and units only) and by whoever marks.
"""

from __future__ import annotations

from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant


@frozen
class GridColumn:
    """One column of the assigned table: its name, SI unit (rad, m, 1/s, m/s) and the key's values in SI; a coordinate's rate.

    The reader uses `values` only for the unit of a column whose header names none and for whole turns of an angle.  It uses the
    first row also for the distances between points, to know which length a name such as AB means.
    """

    name: str
    unit: str
    values: tuple[float, ...]
    rate: str = ""


@frozen
class Grid:
    """The assigned rows and columns: row k (from 1) is at t = (k - 1)·step, in s; a table may omit the columns in `given`."""

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
        """Return the pair (name, SI unit) of each column."""
        return tuple((column.name, column.unit) for column in self.columns)


@frozen
class Expected:
    """The grid, the variant whose names the equations use, and the names that answers may have."""

    grid: Grid
    variant: Variant
    answers: tuple[str, ...] = ()


def grid_of(variant: Variant, columns: dict[str, tuple[float, ...]], given: tuple[str, ...] = ()) -> Grid:
    """Return the grid of a variant, with the values of its Euler table.

    `columns` gives the table by column name, in SI; it has fewer rows if the motion stops.
    `given` names the columns that hold the same datum in every row.
    """
    rows = min(len(values) for values in columns.values())
    units = {name: variant.unit_of(name).replace("rad/s", "1/s") for name in variant.columns}
    rates = {coordinate.name: coordinate.rate for coordinate in variant.coordinates}
    found = tuple(GridColumn(name, unit, columns[name], rates.get(name, "")) for name, unit in units.items())
    return Grid(variant.time.step, rows, found, given)
