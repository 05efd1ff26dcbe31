"""One file -> the table in it, whatever program wrote the file; and whether two tables agree.

Enters: the name of a file, an `Archive` or a decoded text, the `Grid`.  Leaves: `Part`s, `Table`.  Raises `Refused`.
Used by `read_submission.py`, `read_document.py` and `opened.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.files import ods, xlsx
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.files.encoding import Decoded
from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import Refused, doubtful, room_for, unreadable
from coursework.grading.reading.numbers import ROUNDED
from coursework.grading.reading.student_work import Table, TableColumn
from coursework.grading.reading.submission import note
from coursework.grading.reading.table.parts import Origin, Part, parts_of
from coursework.grading.reading.table.table import read_parts, weight
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_FORMULA, _ROWS = re.compile(r"[^=].*\b(?:sin|cos)\s*[(\[]"), 2


def is_spreadsheet(archive: Archive) -> bool:
    """Return whether an archive is an xlsx or ods file."""
    return xlsx.WORKBOOK in archive.parts or ods.CONTENT in archive.parts


def read_spreadsheet(archive: Archive, name: str, grid: Grid) -> tuple[tuple[Part, Table] | None, list[Sheet]]:
    """Return the table of a spreadsheet (None if no sheet has one) and its sheets.  Raises `Refused`."""
    given: Iterable[Sheet]
    if xlsx.WORKBOOK in archive.parts:
        given, kind = xlsx.sheets_of(archive, room_for(grid.rows)), "xlsx"
    else:
        given, kind = ods.sheets_of(archive, room_for(grid.rows)), "ods"
    parts: list[Part] = []
    refused: list[Refused] = []
    sheets: list[Sheet] = []
    try:
        for sheet in given:
            sheets.append(sheet)
            try:
                lines = [[cell.text for cell in row if cell.text] for row in sheet.rows]
                if any(lines) and all(len(line) < 2 for line in lines):  # a CSV that was not taken apart when it was opened
                    text = Decoded("\n".join(map("".join, lines)), kind, False)
                    parts += [replace(part, sheet=sheet.name) for part in parts_of_text(text, name, grid)]
                else:
                    parts += parts_of(sheet, Origin(name, kind, "cells"), grid)
            except Refused as error:  # its decimal mark is ambiguous
                refused.append(error)
    except Refused:  # a fault behind the table does no harm
        if not any(isinstance(table, Table) for _, table in read_parts(parts, grid)):
            raise
    found = _best(parts, grid)
    if found is None and refused:
        raise refused[0]
    if found and found[0].sheet != sheets[0].name:
        told = note("ignored_file", "sheet", sheet=found[0].sheet or "")
        found = found[0], replace(found[1], notes=(told, *found[1].notes))
    return found, sheets


def _best(parts: Sequence[Part], grid: Grid) -> tuple[Part, Table] | None:
    """Return the table with the greatest weight, None if there is none.

    Raises `Refused` if the heaviest one is refused, or if another sheet has one as heavy with other numbers, and neither sheet
    is called after the scheme that is asked for.
    """
    read = read_parts(parts, grid)
    if not read:
        return None
    part, table = max(read, key=lambda entry: (weight(entry[0], entry[1], grid), _stands(entry[1]), _is_named(entry[0])))
    if isinstance(table, Refused):
        raise table
    equal = [
        one.sheet for one, other in read if isinstance(other, Table) and other.weight == table.weight and not alike(other, table)
    ]
    if not _is_named(part) and (rivals := [sheet for sheet in equal if sheet != part.sheet]):
        names = [say("reading.place.in_file", file=part.origin.file, place=sheet or "") for sheet in (part.sheet, *rivals)]
        raise doubtful("two_tables", names=tuple(names))
    return part, table


def _is_named(part: Part) -> bool:
    """Return whether a sheet is called after the scheme that is asked for, as in the workbook of a run."""
    return DEFAULT_SCHEME.name in (part.sheet or "").casefold()


def _stands(found: Table | Refused) -> bool:
    """Return whether a result is preferred to others of equal weight: a table, or one not computed or for a person to decide."""
    return isinstance(found, Table) or found.trouble.code == "formulas" or found.trouble.state == "needs-review"


def table_of_text(decoded: Decoded, name: str, grid: Grid) -> tuple[Part, Table] | None:
    """Return the table of a text, None if it has none.  Raises `Refused`."""
    return _best(parts_of_text(decoded, name, grid), grid)


def parts_of_text(decoded: Decoded, name: str, grid: Grid, place: Sentence | None = None) -> list[Part]:
    """Return the tables in a text; `place` says where in a document the text is.  Raises `Refused`."""
    found = split(decoded.text, room_for(grid.rows))
    if found is None:
        return []
    if found.has_pairs:
        raise unreadable("comma_twice")
    formulas = [any(map(_FORMULA.match, row)) for row in found.rows]  # a matrix has zeros but is no table; one row may be a head
    rows = [row for row, is_formula in zip(found.rows, formulas, strict=True) if not is_formula or sum(formulas) < _ROWS]
    sheet = Sheet(None, tuple(tuple(map(Cell, row)) for row in rows))
    notes = (note("encoding"),) if decoded.had_nuls else ()
    return parts_of(sheet, Origin(name, decoded.encoding, found.separator, notes, place), grid)


def alike(first: Table, second: Table) -> bool:
    """Return whether two tables agree; if one is from a report, which may round to other digits, up to the rounding."""
    digits = ROUNDED if first.place or second.place else 0.0
    both = [(column, other) for column in first.columns if (other := second.column(column.name))]
    return len(both) == len(first.columns) == len(second.columns) and all(_same(*pair, digits) for pair in both)


def _same(column: TableColumn, other: TableColumn, digits: float) -> bool:
    return all(
        math.isfinite(value) is math.isfinite(same)
        and (not math.isfinite(value) or abs(value - same) <= digits * (unit + other_unit))
        for value, unit, same, other_unit in zip(column.values, column.last_place, other.values, other.last_place, strict=True)
    )
