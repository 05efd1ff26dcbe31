"""The contents of a submission: its table on the assigned grid, its equations, its answers, and how each was read.

Enters: nothing.  Leaves: `StudentWork`, `Table`, `TableColumn`, `Reading`, `EquationLine`, `AnswerLine`, `Trouble`.
Made by the readers of this room; read by whoever marks.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, replace
from typing import Any, Literal

from coursework.grading.reading.submission import Note
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# Why a cell has no number: it is empty, an error of the spreadsheet, a number that the spreadsheet made a date, other text, or
# a formula that was never computed.  "" = it has a number.
Flag = Literal["", "missing", "error", "date", "text", "formula"]


@frozen
class TableColumn:
    """One column on the assigned grid; every tuple has one entry per row of the grid.

    `values` are in SI without whole turns, NaN where missing; `last_place` is u, the unit of each cell's last digit, in SI.
    `texts` are as handed in; `decimals` is their number as printed, in the unit of the file.  `at` is the number of the column in
    the file, from 1.  `turns` are the whole turns subtracted in each row, () if none.
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
    """How a file was read: exactly the keys of `reading` in grades.json."""

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
        """Return the name of the separator between cells, for a person."""
        known = self.separator if self.separator in {"cells", "tab", "blanks"} else "sign"
        return say(f"reading.separated.{known}", sign=self.separator)

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        return asdict(self) | {"header": list(self.header)}


@frozen
class OwnTimes:
    """All rows of a table that uses its own time `step` (s): for each column its values and units of the last place, in SI."""

    step: float
    columns: Mapping[str, tuple[tuple[float, ...], tuple[float, ...]]]


@frozen
class Table:
    """A student's table on the assigned grid; `columns` are in the order of the file, missing ones are left out.

    `rows` has for each row of the grid the number of the file's row of numbers (from 1), 0 if it has none.
    `own` has all rows in the order of time if the student's step differs from the grid's.  `place` says where in a document the
    table stands, None if the file is the table.  `strange` counts the cells read by position under heads that name something
    else; `asked` is the question to a person about columns whose heads are not understood, needed unless their cells are right.
    `in_order` is the table with its rows in the order of the file, if its times are not the grid's. `unsure` is the question to a
    person about rows that contradict each other, whatever is right; `is_cut` is True if dots stand for rows or columns.
    """

    reading: Reading
    columns: tuple[TableColumn, ...]
    rows: tuple[int, ...]
    notes: tuple[Note, ...]
    own: OwnTimes | None = None
    place: Sentence | None = None
    strange: int = 0
    asked: Sentence | None = None
    in_order: Table | None = None
    unsure: Sentence | None = None
    is_cut: bool = False

    @property
    def rows_present(self) -> tuple[bool, ...]:
        """Return for each row of the grid whether the file has it."""
        return tuple(map(bool, self.rows))

    @property
    def cells(self) -> int:
        """Return how many cells of the grid have a number."""
        return sum(math.isfinite(value) for column in self.columns for value in column.values)

    @property
    def weight(self) -> float:
        """Return the weight of the table in the choice between several: its number of cells, strange cells counting a quarter."""
        return self.cells - 0.75 * self.strange

    def column(self, name: str) -> TableColumn | None:
        """Return the column with this name of the key, None if it is missing."""
        return next((column for column in self.columns if column.name == name), None)


@frozen
class EquationReading:
    """One way to read a line: `tree` is left - right; `text` is the repaired text that was read, "" if the line as it stands.

    `guessed` is True if something was added that the line does not contain.  `is_loose` is True if the line may mean something
    else, so that the reading counts only if it is right; if it `asks`, a person must say even then that it is meant.
    One that `is_partial` leaves out a side of a chain a = b = c, which may say more; `sides` are what its other sides say.
    """

    tree: Formula
    text: str = ""
    guessed: bool = False
    is_loose: bool = False
    asks: bool = False
    is_partial: bool = False
    sides: tuple[EquationReading, ...] = ()


@frozen
class EquationLine:
    """One line of equations: `text` as handed in, and its `tree` (left - right), or the `fault` if it could not be read.

    `repaired` is the text that was read instead, "" if the line as it stands; `guessed` is True if something was added to it.
    `others` are further ways to read the line; if one of them is right, that one was meant.  `relates` is True for an unread line
    that names two symbols of the variant: it is an equation; `is_prose` for one that is a sentence.  `place` says where the line
    stands in a document, for a person.  A line that `may_be_datum`, such as "w1 = 6.5" in a report, counts as an equation only if
    it is right.  One that was `passed_over` as a comment or the like is told only if equations are missing; so is one that
    `is_partial`, a chain a = b = c of which a side could not be read; `sides` are the other equations that it says.
    `source` are the lines of the file from `line` on, if `text` is a part of these or was made from them, else "".
    """

    file: str
    line: int
    text: str
    tree: Formula | None = None
    repaired: str = ""
    fault: Fault | None = None
    others: tuple[EquationReading, ...] = ()
    relates: bool = False
    is_prose: bool = False
    place: Sentence | None = None
    may_be_datum: bool = False
    guessed: bool = False
    passed_over: bool = False
    is_partial: bool = False
    sides: tuple[EquationReading, ...] = ()
    source: str = ""

    @property
    def may_be_one(self) -> bool:
        """Return whether the line may be an equation of the variant's names: it was read, or it names two of them."""
        return self.tree is not None or (self.relates and not self.passed_over)

    @property
    def difference(self) -> Formula:
        """Return left - right; the line must have been read."""
        assert self.tree is not None
        return self.tree

    def read_as(self, reading: EquationReading, **changes: Any) -> EquationLine:
        """Return the line in another of its readings, with further changes."""
        read = {"tree": reading.tree, "repaired": reading.text, "guessed": reading.guessed, "is_partial": reading.is_partial}
        return replace(self, **{**read, "sides": reading.sides, **changes})

    @property
    def where(self) -> Sentence:
        """Return where the line stands, for a person."""
        return self.place or say("reading.place.line", line=self.line)


@frozen
class AnswerLine:
    """One measured answer: its `value` in SI, None if it is blank or unreadable."""

    name: str
    value: float | None
    state: Literal["read", "blank", "unreadable"]


@frozen
class Trouble:
    """Why no table can be marked: none was handed in, it cannot be read, or a person must decide."""

    state: Literal["missing", "unreadable", "needs-review"]
    code: str
    text: Sentence


@frozen
class FileEntry:
    """One entry of `files` in grades.json; `kinds` lists what the file contains, `kind` is the first of them."""

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
    """Everything found in one submission; exactly one of `table` and `trouble` is None.

    `equations` is None if no equation was handed in; `answers` are those found in the files.  `unopened` says why a file that may
    hold the missing part could not be opened; `pictured` says that it may be in pictures.
    """

    files: tuple[FileEntry, ...]
    table: Table | None
    trouble: Trouble | None
    equations: tuple[EquationLine, ...] | None
    answers: tuple[AnswerLine, ...]
    notes: tuple[Note, ...]
    review: Sentence | None = None
    unopened: Sentence | None = None
    pictured: Sentence | None = None
