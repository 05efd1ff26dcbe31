"""What a submission turned out to hold: its table on the assigned grid, its equations, its answers, and how each was read.

Enters: nothing.  Leaves: `StudentWork`, `Table`, `TableColumn`, `Reading`, `EquationLine`, `AnswerLine`, `Trouble`.
Made by the readers of this room; read by whoever marks.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any, Literal

from coursework.grading.reading.submission import Note
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# Why a cell has no number: nothing there, an error of the spreadsheet, a date it made of a number, some other text,
# a formula that was never computed.  "" = it has one.
Flag = Literal["", "missing", "error", "date", "text", "formula"]


@frozen
class TableColumn:
    """One column on the assigned grid; every tuple has one entry a row of the grid.

    `values` in SI (whole turns taken off), NaN where missing; `last_place` is u, the unit of the cell's last digit, in SI;
    `texts` as handed in; `decimals` as printed, in the unit of the file.  `at` counts the columns of the file from 1; `turns`,
    () for none, are the whole turns taken off in each row.
    """

    name: str
    at: int
    by: Literal["header", "position"]
    unit: str
    values: tuple[float, ...]
    last_place: tuple[float, ...]
    texts: tuple[str, ...]
    flags: tuple[Flag, ...]
    decimals: int
    turns: tuple[int, ...] = ()


@frozen
class Reading:
    """How a file was understood: exactly the keys of `reading` in grades.json."""

    file: str
    encoding: str
    separator: str
    decimal: str
    sheet: str | None
    transposed: bool
    header: tuple[str, ...]
    columns: Mapping[str, Mapping[str, Any]]
    rows: int
    order: Literal["given", "sorted"]

    @property
    def separated(self) -> Sentence:
        """Return what parts the cells, for a person."""
        known = self.separator if self.separator in {"cells", "tab", "blanks"} else "sign"
        return say(f"reading.separated.{known}", sign=self.separator)

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        return asdict(self) | {"header": list(self.header)}


@frozen
class OwnTimes:
    """All rows of a table whose times have a `step` (s) of their own: values and units of the last place by column, in SI."""

    step: float
    columns: Mapping[str, tuple[tuple[float, ...], tuple[float, ...]]]


@frozen
class Table:
    """A student's table on the assigned grid; `columns` in the order of the file, without those nobody handed in.

    `own` has every row where the times are not the grid's, in the order of time; `place` is where it stands in a document, None
    where the file is the table.  `strange` counts the cells that are read by position under heads that name something else;
    `asked` is why a person must look at those, unless what stands in them is right.
    """

    reading: Reading
    columns: tuple[TableColumn, ...]
    rows_present: tuple[bool, ...]
    notes: tuple[Note, ...]
    own: OwnTimes | None = None
    place: Sentence | None = None
    strange: int = 0
    asked: Sentence | None = None

    @property
    def cells(self) -> int:
        """Return how many cells of the grid have a number."""
        return sum(math.isfinite(value) for column in self.columns for value in column.values)

    @property
    def weight(self) -> float:
        """Return how much speaks for this one of several tables: its cells, strange ones a quarter."""
        return self.cells - 0.75 * self.strange

    def column(self, name: str) -> TableColumn | None:
        """Return a column by the key's name, None where it is missing."""
        return next((column for column in self.columns if column.name == name), None)


@frozen
class EquationReading:
    """One way to read a line: its `tree`, left - right, and the text that was read in its place, "" for the line as it stands.

    `guessed` where something was added that does not stand there; `is_loose` where the line may mean something else, so that it
    counts only where it is right.  `in_degrees` where the line turns degrees into radians: right beside a table in degrees.
    """

    tree: Formula
    text: str = ""
    guessed: bool = False
    is_loose: bool = False
    in_degrees: bool = False


@frozen
class EquationLine:
    """One line of equations: `text` as handed in; its `tree`, left - right, once read, else the fault and its column.

    `repaired` is the text that was read in its place, "" for the line as it stands; `guessed` where something was added;
    `others` are further ways to read the line, of which one that is right is what was meant; `relates` says of a line nobody
    could read that it names two symbols of the variant: it is an equation, and no prose.  `place` is where the line stands in
    a document, for a person; one that `may_be_datum`, as "w1 = 6.5" in a report, is an equation only where it is right.
    """

    file: str
    line: int
    text: str
    tree: Formula | None = None
    repaired: str = ""
    fault: Fault | None = None
    others: tuple[EquationReading, ...] = ()
    relates: bool = False
    place: Sentence | None = None
    may_be_datum: bool = False
    guessed: bool = False

    @property
    def difference(self) -> Formula:
        """Return left - right of a line that was read."""
        assert self.tree is not None
        return self.tree

    @property
    def where(self) -> Sentence:
        """Return where the line stands, for a person."""
        return self.place or say("reading.place.line", line=self.line)


@frozen
class AnswerLine:
    """One measured answer: its `value` in SI, None where it is blank or unreadable."""

    name: str
    value: float | None
    state: Literal["read", "blank", "unreadable"]


@frozen
class Trouble:
    """Why no table can be marked: nothing was handed in, it cannot be read, or a person must decide."""

    state: Literal["missing", "unreadable", "needs-review"]
    code: str
    text: Sentence


@frozen
class FileEntry:
    """One line of `files` in grades.json; `kinds` what stands in the file, `kind` the first of them."""

    name: str
    kind: str
    kinds: tuple[str, ...]
    bytes: int
    sha256: str

    def plain(self) -> dict[str, Any]:
        """Return the entry as grades.json writes it."""
        return asdict(self) | {"kinds": list(self.kinds)}


@frozen
class StudentWork:
    """Everything that was understood of one submission: exactly one of `table` and `trouble` is there.

    `equations` is None where no equation was handed in; `answers` has the answers that stood in the files; `unopened` says why
    some file could not be looked into that may hold what is missing.
    """

    files: tuple[FileEntry, ...]
    table: Table | None
    trouble: Trouble | None
    equations: tuple[EquationLine, ...] | None
    answers: tuple[AnswerLine, ...]
    notes: tuple[Note, ...]
    review: Sentence | None = None
    unopened: Sentence | None = None
