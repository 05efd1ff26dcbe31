"""Long and wide tables made fit for a page: rows thinned, columns split.

Enters: rows of numbers.  Leaves: `Table` parts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from coursework.report.desk import Desk
from coursework.report.lettering import numeral, runs
from coursework.report.numbers import unit_text
from coursework.report.parts import Cell, Column, Paragraph, Part, Table
from coursework.report.source import ExtraTable

MOST_ROWS = 200  # rows printed; a longer table is thinned, table.csv holds it whole
MOST_COLUMNS = 10  # columns beside row and time that fit 170 mm at a readable size
MARK = "▸"


def thinned(rows: int, keep: Sequence[int] = (), most: int = MOST_ROWS) -> list[int]:
    """Return which rows (from 0) to print: all, or every k-th with the first, the last and those to `keep`."""
    pace = pace_of(rows, most)
    if pace == 1:
        return list(range(rows))
    return sorted({*range(0, rows, pace), rows - 1, *(row for row in keep if 0 <= row < rows)})


def pace_of(rows: int, most: int = MOST_ROWS) -> int:
    """Return k where every k-th row is printed: 1, 2, 5, 10, 20, 50 …"""
    pace, factors = 1, (2, 2.5, 2)
    turn = 0
    while rows > most * pace:
        pace = int(pace * factors[turn % 3])
        turn += 1
    return pace


def row_at(desk: Desk, place: float) -> str:
    """Return where in the table (rows from 1) a place counted from 0 lies: 5.84 -> "between row 6 and row 7"."""
    nearest = round(place)
    if math.isclose(place, nearest, abs_tol=1e-6):
        return desk.words("stop.at", row=nearest + 1)
    return desk.words("stop.between", row=math.floor(place) + 1, next=math.floor(place) + 2)


def motion_parts(desk: Desk) -> list[Part]:
    """Return the table of the motion and the sentences that belong to it."""
    run, say = desk.run, desk.words
    names = run.motion.names
    units = [run.variant.unit_of(name) for name in names]
    caption = say("table.caption", scheme=run.scheme_title, step=desk.quantity(run.step, "s"))
    notes = []
    check_row = run.variant.time.check_row
    if check_row is not None and check_row <= len(run.motion.t):
        notes.append(say("table.check_row", mark=MARK, row=check_row))
    if run.stop is not None:
        time = desk.quantity(run.stop.time, "s")
        notes.append(say("table.stopped", row=len(run.motion.t), time=time))
    return _split(desk, names, units, run.motion.rows, caption, notes)


def extra_parts(desk: Desk, extra: ExtraTable) -> list[Part]:
    """Return the table of a further quantity; beside row and time where it has a line for every row."""
    if len(extra.rows) == len(desk.run.motion.t) and "t" not in extra.names:
        return _split(desk, tuple(extra.names), list(extra.units), extra.rows, "", [])
    columns = [Column(desk.symbol_runs([n]), unit_text(u)) for n, u in zip(extra.names, extra.units, strict=True)]
    kept = thinned(len(extra.rows))
    texts = [_cells(desk, extra.rows[kept, index]) for index in range(len(columns))]
    rows: list[list[Cell]] = [list(row) for row in zip(*texts, strict=True)]
    return [Table(columns, rows)]


def _cells(desk: Desk, values: Any) -> list[Cell]:
    return [numeral(text) for text in desk.numbers.column(values)]


def _split(desk: Desk, names: Sequence[str], units: Sequence[str], values: Any, caption: str, notes: list[str]) -> list[Part]:
    """Return one table, or as many as the columns need; each repeats row and time."""
    t = desk.run.motion.t
    check_row = desk.run.variant.time.check_row
    kept = thinned(len(t), keep=[check_row - 1] if check_row else [])
    heads = [Column(runs(desk.words("table.row"))), Column(desk.symbol_runs(["t"]), "s")]
    labels = [f"{MARK} {row + 1}" if row + 1 == check_row else str(row + 1) for row in kept]
    times = desk.numbers.times([float(t[row]) for row in kept])
    strong = [kept.index(check_row - 1)] if check_row and check_row <= len(t) else []
    texts = [_cells(desk, values[kept, index]) for index in range(len(names))]
    count = max(math.ceil(len(names) / MOST_COLUMNS), 1)
    width = math.ceil(len(names) / count)
    parts: list[Part] = []
    if pace_of(len(t)) > 1:
        step = pace_of(len(t))
        rows_of = {"step": step, "printed": len(kept), "rows": desk.numbers.whole(len(t))}
        parts.append(Paragraph(desk.say("table.thinned", **rows_of)))
    for part in range(count):
        some = slice(part * width, (part + 1) * width)
        columns = heads + [Column(desk.symbol_runs([n]), unit_text(u)) for n, u in zip(names[some], units[some], strict=True)]
        rows: list[list[Cell]] = [list(row) for row in zip(labels, times, *texts[some], strict=True)]
        which = desk.words("table.part", part=part + 1, parts=count) if count > 1 else ""
        note = " ".join(notes) if part == count - 1 else ""
        parts.append(Table(columns, rows, runs(f"{caption} {which}".strip()), strong, runs(note)))
    return parts
