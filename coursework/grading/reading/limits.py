"""Limits on how much of a submission is read, and the exception with which a reader gives up.

Enters: nothing.  Leaves: the limits for everything that is read; `Refused`.  Used by whatever reads or collects files.
"""

from __future__ import annotations

from typing import NamedTuple

from coursework.grading.reading.student_work import Trouble
from coursework.words.sentences import say

FILE_BYTES = 4 * 1024 * 1024
INFLATED_BYTES = 20 * 1024 * 1024
FILES = 50
LINE_CHARACTERS = 20_000
EQUATION_CHARACTERS = 4000  # as typed, with commands and braces of LaTeX; as read, the limits of a formula hold
ROWS = 600
COLUMNS = 40
BLANK_ROWS = 200
SHEETS = 10
PARTS = 200
DOCUMENT_PARTS = 1000
CELL_CHARACTERS = 500


class Refused(Exception):
    """Raised if a file cannot be marked as a table; `trouble` says why and what to do."""

    def __init__(self, trouble: Trouble) -> None:
        super().__init__(str(trouble.text))
        self.trouble = trouble


def unreadable(code: str, /, **values: object) -> Refused:
    """Return the refusal of a file that cannot be read; its sentence has the key `reading.trouble.<code>`."""
    return Refused(Trouble("unreadable", code, say(f"reading.trouble.{code}", **values)))


def other_kind(key: str, /, **values: object) -> Refused:
    """Return the refusal of a file of a kind that is not read; its sentence has the key `reading.trouble.<key>`."""
    return Refused(Trouble("unreadable", "other_kind", say(f"reading.trouble.{key}", **values)))


def doubtful(code: str, /, **values: object) -> Refused:
    """Return the refusal of a file that a person must look at."""
    return Refused(Trouble("needs-review", code, say(f"reading.trouble.{code}", **values)))


class Room(NamedTuple):
    """The most `rows` and `columns` that are read of a table."""

    rows: int
    columns: int


def room_for(rows: int) -> Room:
    """Return the most rows and columns read from a file for a grid of `rows` rows (a transposed table has one column per row)."""
    return Room(max(ROWS, rows + 100), max(COLUMNS, rows + 10))
