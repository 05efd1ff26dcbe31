"""`coursework precheck`: how files would be read and whether they contradict themselves; no number of the key is shown.

Enters: paths, perhaps a variant.  Leaves: lines on the screen; 0 where every part could be marked, else 1.
Used by `cli.py`.
"""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from coursework.commands.screen import in_language, tell, tell_own_file, with_symbols
from coursework.grading.collecting.sources import collect_files
from coursework.grading.marking.key import Key, key_of
from coursework.grading.marking.student_table import student_of
from coursework.grading.marking.table.cells import Cells, mark_cells
from coursework.grading.marking.table.clockwise import turned_back
from coursework.grading.marking.table.points import true_steps
from coursework.grading.reading.expected import Expected, grid_of
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import FileEntry, StudentWork
from coursework.grading.reading.submission import note
from coursework.grading.reading.table.units import AS_READ
from coursework.variant.catalogue import load
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


def precheck_files(files: tuple[Path, ...], variant: str | None) -> int:
    """Return the exit status of looking at some files."""
    chosen = variant or next((str(path) for path in files if path.suffix == ".toml"), None)
    if chosen is None:
        raise InputError(say("fault.C028"))
    tell_own_file(chosen)
    key = key_of(load(chosen))
    grid = grid_of(key.variant, {name: tuple(key.table[:, place].tolist()) for place, name in enumerate(key.names)})
    work = read_submission(collect_files(files), Expected(grid, key.variant))
    for entry in work.files:
        tell(say("screen.file", name=entry.name, kind=_kinds(entry), bytes=entry.bytes))
    fine = _tell_table(key, work)
    fine &= _tell_equations(work)
    for found in work.notes:
        click.echo(f"  {with_symbols(in_language(found.text), key.names)}")
    return 0 if fine else 1


def _kinds(entry: FileEntry) -> Sentence:
    return joined([say(f"screen.kind.{kind}") for kind in entry.kinds], "join.comma")


def _tell_table(key: Key, work: StudentWork) -> bool:
    if work.table is None:
        reason = work.trouble.text if work.trouble else ""
        tell(say("screen.table_not_read", reason=reason))
        return False
    table = work.table
    reading = table.reading
    known = {"file": reading.file, "encoding": reading.encoding, "separator": reading.separator, "decimal": reading.decimal}
    tell(say("screen.turned" if reading.transposed else "screen.not_turned", **known))
    for column in table.columns:
        told = "screen.column_by_head" if column.by == "header" else "screen.column_by_place"
        tell(
            say(
                told,
                name=f"{with_symbols(column.name, key.names):<8}",
                at=column.at,
                unit=AS_READ.get(column.unit, column.unit),
                decimals=column.decimals,
            )
        )
    missing = [name for name in key.names if table.column(name) is None]
    if missing:
        tell(say("screen.missing_columns", missing=with_symbols(", ".join(missing), key.names)))
    tell(say("screen.rows_found", found=sum(table.rows_present), count=len(key.table), least=key.least_decimals))
    student = student_of(key, table)
    if (back := turned_back(key, student)) is not None:
        tell(note("clockwise").text)
    cells = mark_cells(key, back or student)
    coarse = int(cells.too_coarse.sum())
    if coarse:
        tell(say("screen.coarse_cells", coarse=coarse))
    _tell_steps(key, cells)
    return not missing and not coarse and all(table.rows_present) and not cells.missing.any()


def _tell_steps(key: Key, cells: Cells) -> None:
    """Say the first row whose angles do not follow from the row before by Euler's rule."""
    m = len(key.coordinates)
    values = cells.student.values
    speaks = np.isfinite(values[1:, :m]) & np.isfinite(values[:-1, :m]) & np.isfinite(values[:-1, m : 2 * m])
    against = speaks & ~true_steps(key, cells)
    if not against.any():
        tell(say("screen.steps_follow"))
        return
    row = int(np.argmax(against.any(axis=1)))
    place = int(np.argmax(against[row]))
    name, rate = (with_symbols(name, key.names) for name in (key.names[place], key.velocities[place]))
    before, speed = values[row, place], values[row, m + place]
    after, found = before + key.step * speed, values[row + 1, place]
    tell(
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


def _tell_equations(work: StudentWork) -> bool:
    if work.equations is None:
        tell(say("screen.no_equations"))
        return True
    unread = [line for line in work.equations if line.left is None]
    tell(say("screen.equations_read", count=len(work.equations), unread=len(unread)))
    for line in work.equations:
        kind, known = "place" if line.place else "line", {"line": line.line, "place": line.where}
        if line.left is None:
            tell(say(f"screen.{kind}", why=line.fault.message if line.fault else say("screen.not_equation"), **known))
        elif line.repaired:
            tell(say(f"screen.{kind}_read_as", repaired=line.repaired, **known))
        else:
            tell(say(f"screen.{kind}_read", text=line.text, **known))
    return not unread
