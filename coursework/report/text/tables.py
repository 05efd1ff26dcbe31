"""Long and wide tables made to fit a page: rows are thinned, columns are split.

Enters: rows of numbers.  Leaves: `Table` parts.
Used by `report/`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.report.text.numbers import TIGHT, shown_column
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Column, Paragraph, Part, Table
from coursework.report.text.text_runs import numeral, runs
from coursework.report.text.words import with_own_letters
from coursework.results.kinematics.extra import ExtraTable
from coursework.scene.motion_results import given_constants
from coursework.scene.quantities import CHECKS

TABLE_FILE = "table.csv"  # holds the results table, with further columns for quantities asked for row by row
MOST_ROWS = 32  # rows printed; a longer table is thinned, and table.csv holds all rows
MOST_COLUMNS = 10  # columns besides row and time that fit 170 mm at a readable size
ONE_PAGE = 32  # rows of a table that fits on one page whatever stands around it
HALF_PAGE = 20  # the same limit for a table among others: two longer ones would leave half a page empty
RULE = 5  # rows from one thin line to the next
MARK = "▸"


def thinned(rows: int, keep: Sequence[int] = (), most: int = MOST_ROWS) -> list[int]:
    """Return which rows (from 0) to print: all, or every k-th from the first on, the last, and those in `keep`."""
    pace = pace_of(rows, most)
    if pace == 1:
        return list(range(rows))
    return sorted({*range(0, rows, pace), rows - 1, *(row for row in keep if 0 <= row < rows)})


def pace_of(rows: int, most: int = MOST_ROWS) -> int:
    """Return k such that every k-th row is printed: 1, 2, 5, 10, 20, 50 …"""
    pace, factors = 1, (2, 2.5, 2)
    turn = 0
    while rows > most * pace:
        pace = int(pace * factors[turn % 3])
        turn += 1
    return pace


def row_at(context: PageContext, place: float) -> str:
    """Return in words where in the table a place lies, which counts rows from 0: 5.84 -> "between row 6 and row 7"."""
    nearest = round(place)
    if math.isclose(place, nearest, abs_tol=1e-6):
        return context.words("stop.at", row=nearest + 1)
    return context.words("stop.between", row=math.floor(place) + 1, next=math.floor(place) + 2)


def _part(table: ExtraTable, first: int, last: int | None = None) -> ExtraTable:
    """Return a table of only the columns from `first` to before `last`."""
    kept = slice(first, last)
    names, units, rows, sizes = table.names[kept], table.units[kept], table.rows[:, kept], table.sizes[kept]
    return replace(table, names=names, units=units, rows=rows, sizes=sizes)


def rules_for(rows: int) -> list[int]:
    """Return the rows (from 0) after which a thin line helps the eye: every fifth of a long table, but not the last."""
    return list(range(RULE - 1, rows - 1, RULE)) if rows > 2 * RULE else []


def motion_parts(context: PageContext) -> list[Part]:
    """Return the table of the motion and the sentences that belong to it."""
    run, words = context.run, context.words
    constant = given_constants(run.variant, run.motion.names, run.motion.rows)
    names = [name for name in run.motion.names if name not in constant]
    units = [run.variant.unit_of(name) for name in names]
    step = context.step
    is_exact = run.tableau is None
    scheme = context.told(run.scheme_title)
    caption = words("table.caption_exact", step=step) if is_exact else words("table.caption", scheme=scheme, step=step)
    notes = []
    check_row = run.variant.time.check_row
    if check_row is not None and check_row <= len(run.motion.t):
        notes.append(words("table.check_row" if run.is_checked_by_drawing else "table.marked", mark=MARK, row=check_row))
    if run.stop is not None:
        time = context.quantity(run.stop.time, "s")
        notes.append(words("table.stopped", row=len(run.motion.t), kind=context.event(run.stop.kind), time=time))
    if constant:
        unit_of, plain = run.variant.unit_of, context.numbers.plain
        told = [f"{context.lettering(one)}{TIGHT}={TIGHT}{words.amount(plain(v), unit_of(one))}" for one, v in constant.items()]
        notes.append(words("table.constant", listed=words.listing(told)))
    rows = np.column_stack([np.zeros((len(run.motion.t), 0)), *(shown_column(run.motion, name, run.variant) for name in names)])
    return _by_row(context, ExtraTable("", tuple(names), tuple(units), rows), run.motion.t, caption, words.sentences(notes))


def extra_parts(context: PageContext, extra: ExtraTable, file: str) -> list[Part]:
    """Return the table of a further quantity, with row and time if it has a line for every row; `file` holds all its rows."""
    caption, note = (with_own_letters(context.told(text)) for text in (extra.title, extra.note))
    caption = caption.rstrip(".。") + context.words("table.stop")
    if extra.names[0] == "t":
        return _by_row(context, _part(extra, 1), extra.rows[:, 0], caption, note, HALF_PAGE, file)
    if len(extra.rows) == len(context.run.motion.t):
        return _by_row(context, extra, context.run.motion.t, caption, note, HALF_PAGE, file)
    columns, texts = _columns(context, _sized(extra), thinned(len(extra.rows)))
    return [
        Table(
            columns,
            [list(row) for row in zip(*texts, strict=True)],
            context.lettered(caption),
            note=context.lettered(note),
            whole=len(extra.rows) <= ONE_PAGE,
        )
    ]


def _sized(grid: ExtraTable) -> ExtraTable:
    """Return a table whose `sizes` also count what is round-off beside the other points: a fixed point's velocity of 1e-17."""
    known = grid.sizes or (0.0,) * len(grid.names)
    return replace(grid, sizes=tuple(max(size, largest_of(grid, index)) for index, size in enumerate(known)))


def largest_of(grid: ExtraTable, index: int) -> float:
    """Return the largest entry of all points in the unit of column `index`; 0 if that is not a point's column."""
    if "." not in grid.names[index]:
        return 0.0
    alike = [i for i, name in enumerate(grid.names) if "." in name and grid.units[i] == grid.units[index]]
    return max((abs(value) for i in alike for value in grid.rows[:, i].tolist() if math.isfinite(value)), default=0.0)


def _columns(context: PageContext, grid: ExtraTable, kept: list[int]) -> tuple[list[Column], list[list[Cell]]]:
    heads = [Column(context.symbol_runs([n]), context.unit(u)) for n, u in zip(grid.names, grid.units, strict=True)]
    texts = [context.numbers.column(grid.rows[kept, index], grid.sizes[index]) for index in range(len(heads))]
    return heads, [[numeral(text) for text in column] for column in texts]


def _by_row(
    context: PageContext, grid: ExtraTable, t: Any, caption: str, note: str, longest: int = ONE_PAGE, file: str = TABLE_FILE
) -> list[Part]:
    """Return one table, or as many as the columns need, each with the columns row and time."""
    check_row, grid = context.run.variant.time.check_row, _sized(grid)
    kept = thinned(len(t), keep=[row - 1 for row in _named_rows(context)])
    labels: list[Cell] = [f"{MARK} {row + 1}" if row + 1 == check_row else str(row + 1) for row in kept]
    times = context.numbers.times([float(t[row]) for row in kept])
    strong = [kept.index(check_row - 1)] if check_row and check_row - 1 in kept else []
    parts: list[Part] = []
    if (pace := pace_of(len(t))) > 1:
        rows_of = {"step": pace, "printed": len(kept), "rows": context.numbers.whole(len(t)), "file": file}
        parts.append(Paragraph(context.say("table.thinned", **rows_of)))
    parted = pieces(grid.names)
    # Several tables of every k-th row, each kept on one page, would leave a third of each page empty.
    for number, (first, last) in enumerate(parted, start=1):
        heads, texts = _columns(context, _part(grid, first, last), kept)
        columns = [Column(runs(context.words("table.row"))), Column(context.symbol_runs(["t"]), context.unit("s")), *heads]
        rows = [list(row) for row in zip(labels, times, *texts, strict=True)]
        which = context.words("table.part", part=number, parts=len(parted)) if len(parted) > 1 else ""
        below = context.lettered(note) if number == len(parted) else []
        parts.append(
            Table(
                columns,
                rows,
                context.lettered(context.words.sentences([caption, which])),
                strong,
                rules_for(len(rows)),
                below,
                whole=len(rows) <= longest and (pace == 1 or len(parted) == 1),
                places=[row + 1 for row in kept],
            )
        )
    return parts


def _named_rows(context: PageContext) -> Iterator[int]:
    """Yield the rows (from 1) that the box on page 1 names: of the check, farthest from the motion, after a period."""
    run = context.run
    yield run.variant.time.row_of_check
    if run.asks(CHECKS):
        yield from (one.row for one in run.checks if one.code == "ACCURACY" and one.verdict != "PASS" and one.row)
        yield (run.results.evidence.period_row or 0) + 1


def pieces(names: Sequence[str], most: int = MOST_COLUMNS) -> list[tuple[int, int]]:
    """Return (first, end) of the columns of each table: tables are about equally wide and keep a point's columns together."""
    owners = [name.partition(".")[0] if "." in name else "" for name in names]
    begins = [i for i, owner in enumerate(owners) if i == 0 or not owner or owner != owners[i - 1]]
    blocks = list(zip(begins, [*begins[1:], len(names)], strict=True))
    width = max([math.ceil(len(names) / max(math.ceil(len(names) / most), 1)), *(b - a for a, b in blocks)])
    cuts = [0]
    for begin, end in blocks:
        if end - cuts[-1] > width and begin > cuts[-1]:
            cuts.append(begin)
    return list(zip(cuts, [*cuts[1:], len(names)], strict=True))
