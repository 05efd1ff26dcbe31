"""The parts of a workbook's table: columns with their formulas and numbers, and coefficients of blocks beside them.

Enters: formulas and numbers.  Leaves: `StepTable`.  Used inside `workbook/`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field

from coursework.motion.integration.motion import Motion
from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array
from coursework.system.frozen import changing
from coursework.takeaway.workbook.names import STEP, letters
from coursework.takeaway.workbook.tables import Tables
from coursework.variant.formula.tree import Formula

# ROW, BEFORE, NEXT, STEPS stand in formulas for the number of a row, of the one before, of the next, and of steps before it.
SHEET = "Euler"  # the name of the sheet in every language
ROW, BEFORE, NEXT, STEPS = "\x01", "\x02", "\x03", "\x04"
FIRST = 2  # the number of the row of t = 0; row 1 has the names
TIME = "t"


@changing
class Column:
    """One column: its head, the formula of its rows (None: values only), the formula of the `first` row, and its numbers.

    The last `until` rows stay empty: after the last row a further slope leads nowhere.
    """

    head: str
    formula: str | None
    values: Array
    first: str | None = None
    until: int = 0
    shown: bool = True


@changing
class Matrix:
    """The coefficients of a block in hidden columns from `column` on; each row has `size` rows of `size` + 1 `entries`."""

    column: int
    size: int
    entries: tuple[str, ...]
    values: Array
    until: int = 0

    def solved(self, unknown: int, row: int) -> str:
        """Return the formula of an unknown in a row of the table; `unknown` = `size` means the determinant."""
        top = FIRST + (row - FIRST) * self.size
        first, last, right = (letters(self.column + place) for place in (0, self.size - 1, self.size))
        block = f"${first}${top}:${last}${top + self.size - 1}"
        if unknown == self.size:
            return f"MDETERM({block})"
        return f"INDEX(MMULT(MINVERSE({block}),${right}${top}:${right}${top + self.size - 1}),{unknown + 1})"


@changing
class StepTable:
    """The table: `columns` in order, `matrices` beside them, `solved` the columns that are solved from a matrix."""

    run: SceneRun
    motion: Motion
    names: Mapping[str, str]
    tables: Tables
    columns: list[Column] = field(default_factory=list)
    matrices: list[Matrix] = field(default_factory=list)
    solved: dict[int, tuple[Matrix, int]] = field(default_factory=dict)
    text: Callable[[Formula], str] = str

    @classmethod
    def of(
        cls, run: SceneRun, motion: Motion, names: Mapping[str, str], tables: Tables, shown: tuple[Sequence[str], Array]
    ) -> StepTable:
        """Return the table with its times, and with the `shown` columns (names and rows) as values."""
        made = cls(run, motion, names, tables)
        made.add(Column(TIME, f"{STEPS}*{STEP}", motion.t))
        for name, values in zip(shown[0], shown[1].T, strict=True):
            made.add(Column(name, None, values))
        return made

    @property
    def rows(self) -> int:
        """Return how many rows the table has."""
        return len(self.motion.t)

    @property
    def last(self) -> int:
        """Return the number of the last row."""
        return FIRST + self.rows - 1

    def add(self, column: Column) -> str:
        """Add a column and return its letters."""
        self.columns.append(column)
        return letters(len(self.columns) - 1)

    def number(self, name: str) -> int:
        """Return the number, from 0, of the column with the head `name`."""
        return next(number for number, column in enumerate(self.columns) if column.head == name)

    def place(self, name: str) -> str:
        """Return the letters of the column with the head `name`."""
        return letters(self.number(name))
