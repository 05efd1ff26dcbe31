"""How a submission would be read and whether it contradicts itself, in sentences that show no number of the key.

Enters: bytes of files, a variant.  Leaves: `Prechecked`.  Used by `commands/precheck.py` and the desk.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from coursework.grading.marking.key.key import Key, key_to_mark_by
from coursework.grading.marking.student_table import lacking, student_of, with_given
from coursework.grading.marking.table.by_rows import marked
from coursework.grading.marking.table.causes.clockwise import turned_back
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.points import true_steps
from coursework.grading.marking.verdicts import telling_steps
from coursework.grading.reading.equations.formulas.equations import DASH
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import FileEntry, StudentWork
from coursework.grading.reading.submission import Submission, note
from coursework.grading.reading.table.units import AS_READ
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

Named = Callable[[str], str]
Told = Callable[[Sentence], None]


@frozen
class Prechecked:
    """`fine`: all that is there could be marked, `whole`: every part is there; `has_table`: a table was read; what to tell."""

    fine: bool
    whole: bool
    has_table: bool
    sentences: tuple[Sentence, ...]
    notes: tuple[str, ...]


def precheck(submission: Submission, variant: Variant, named: Callable[[str, tuple[str, ...]], str]) -> Prechecked:
    """Return what a student may know before handing in; `named` writes the names in a text as its reader knows them.

    Raises `InputError` if the variant has no table.
    """
    key = key_to_mark_by(variant)
    work = read_submission(submission, Expected(key.grid, key.variant))
    told: list[Sentence] = [say("screen.file", name=entry.name, kind=_kinds(entry), bytes=entry.bytes) for entry in work.files]

    def known(text: str) -> str:
        return named(text, key.names)

    fine = _table(key, work, known, told.append)
    fine &= _equations(work, told.append)
    if work.review:
        told.append(work.review)
    fine &= work.review is None
    whole = work.table is not None and (work.equations is not None or key.free is not None)  # of motion: a person marks them
    why = work.trouble.text if work.table is None and work.trouble else ""  # told beside the table that was not read
    notes = tuple(note.text for note in work.notes if not why or why not in note.text)
    return Prechecked(fine, whole, work.table is not None, tuple(told), notes)


def _kinds(entry: FileEntry) -> Sentence:
    return joined([say(f"screen.kind.{kind}") for kind in entry.kinds], "join.comma")


def _table(key: Key, work: StudentWork, named: Named, told: Told) -> bool:
    if work.table is None:
        reason = work.trouble.text if work.trouble else ""
        told(say("screen.table_not_read", reason=reason))
        return False
    table = work.table
    reading = table.reading
    known = {"file": reading.file, "encoding": reading.encoding, "separated": reading.separated, "decimal": reading.decimal}
    told(say("screen.turned" if reading.transposed else "screen.not_turned", **known))
    for column in table.columns:
        heading = "screen.column_by_head" if column.by == "header" else "screen.column_by_place"
        told(
            say(
                heading,
                name=f"{named(column.name):<8}",
                at=column.at,
                unit=AS_READ.get(column.unit, column.unit),
                decimals=column.decimals,
            )
        )
    if table.asked:
        told(table.asked)
    missing = lacking(key, table)
    if missing:
        told(say("screen.missing_columns", missing=named(", ".join(missing))))
    told(say("screen.rows_found", found=sum(table.rows_present), count=len(key.table), least=key.least_decimals))
    student = student_of(key, table)
    if (back := turned_back(key, student) if key.free is None else None) is not None:
        told(note("clockwise").text)
    cells = marked(key, with_given(key, back or student))
    coarse = int(cells.too_coarse.sum())
    if coarse:
        told(say("screen.coarse_cells", coarse=coarse))
    blank = [(row, column.name) for column in table.columns for row, value in enumerate(column.values, 1) if math.isnan(value)]
    here = sorted((row, name) for row, name in blank if table.rows_present[row - 1])
    if here:
        told(say("screen.blank_cells", number=len(here), row=here[0][0], column=named(here[0][1])))
    _steps(key, cells, named, told)
    return not missing and not table.asked and not coarse and all(table.rows_present) and not cells.missing.any()


def _steps(key: Key, cells: Cells, named: Named, told: Told) -> None:
    """Tell the first row in which a coordinate does not follow from the row before by Euler's rule, or that all do.

    Nothing is told where a step cannot be judged, since cells are missing or have too few digits.
    """
    values = cells.student.values
    telling = telling_steps(key, cells)
    against = telling & ~true_steps(key, cells)
    if not against.any():
        judged = telling & ~cells.too_coarse[1:, : key.m]
        if judged.any() and (judged | ~key.stepped).all():
            told(say("screen.steps_follow"))
        return
    row = int(np.argmax(against.any(axis=1)))
    place = int(np.argmax(against[row]))
    name, rate = (named(name) for name in (key.names[place], key.velocities[place]))
    before, speed = values[row, place], values[row, key.m + place]
    after, found = before + key.step * speed, values[row + 1, place]
    told(
        say(
            "screen.row_not_followed",
            row=row + 2,
            name=name,
            last=row + 1,
            rate=rate,
            before=float(before),
            step=key.step,
            speed=float(speed),
            after=float(after),
            found=float(found),
        )
    )


def _equations(work: StudentWork, told: Told) -> bool:
    if work.equations is None:
        told(say("screen.no_equations"))
        return True
    unread = [line for line in work.equations if line.tree is None]
    told(say("screen.equations_read", count=len(work.equations), unread=len(unread)))
    for line in work.equations:
        kind, known = "place" if line.place else "line", {"line": line.line, "place": line.where}
        if line.tree is None:
            why = line.fault.message if line.fault and not line.is_prose else say("screen.not_equation")
            told(say(f"screen.{kind}", why=why, **known))
        elif line.repaired:
            told(say(f"screen.{kind}_read_as", repaired=line.repaired, **known))
        else:
            told(say(f"screen.{kind}_read", text=line.text, **known))
    if any(DASH.match(line.text) and line.repaired and not DASH.match(line.repaired) for line in work.equations):
        told(say("screen.dash"))
    return all(line.is_prose for line in unread)
