"""Sheets Exact and Checks: the exact motion beside the table, and the residuals, which must be zero, as formulas.

Enters: a `Book` and `StepTable`.  Leaves: the sheets.  Used by `book.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from coursework.equations.algebra.expression import Expression, add
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array
from coursework.takeaway.workbook.cells import FIRST, ROW, SHEET, StepTable
from coursework.takeaway.workbook.names import letters
from coursework.takeaway.workbook.sheet import RESIDUAL, WIDTH, Book, number, plain

EXACT = "Exact"
Residual = tuple[str, str, Expression, bool]  # head, formula, expression, whether it only has to keep its first value


def write_exact(book: Book, sheet: Any, table: StepTable) -> None:
    """Write the exact motion (values), the difference of each cell of the table, and the largest one of each column."""
    run, motion = book.run, table.motion
    exact = run.scene.exact
    names, rows = run.columns() if run.scene.scheme_rows is not None else (_names(motion, exact), _rows(motion, exact))
    for place, (head, values) in enumerate(zip(("t", *names), (exact.t, *rows.T), strict=True)):
        sheet.write_string(0, place, plain(head), book.right)
        sheet.set_column(place, place, WIDTH, book.shown(values) if place else book.times(motion.step))
        sheet.write_column(1, place, values.tolist())
    both = min(len(exact.t), table.rows)
    beside = len(names) + 2
    for place, name in enumerate(names):
        if name not in motion.names or not both:
            continue
        column, own = letters(1 + place), table.place(name)
        sheet.write_string(0, beside, plain(f"Δ{name}"), book.right)
        differences = motion.column(name)[:both] - rows[:both, place]
        sheet.set_column(beside, beside, WIDTH, book.shown(differences))
        _write_small(sheet, beside, FIRST, f"{SHEET}!{own}{ROW}-{column}{ROW}", differences, None)
        _write_largest(sheet, both + 2, beside, FIRST, differences, book.shown(differences, bold=True))
        beside += 1
    sheet.write_string(both + 2, len(names) + 1, book.say("largest"), book.bold)
    sheet.set_column(len(names) + 1, len(names) + 1, WIDTH)
    sheet.repeat_rows(0)
    sheet.freeze_panes(1, 1)


def _names(motion: Motion, exact: Motion) -> tuple[str, ...]:
    return tuple(name for name in motion.names if name in exact.names)


def _rows(motion: Motion, exact: Motion) -> Any:
    return exact.rows[:, [exact.names.index(name) for name in _names(motion, exact)]]


def write_checks(book: Book, sheet: Any, table: StepTable, residuals: list[Residual]) -> None:
    """Write first and last row with their difference split as in the check PERIOD, then the residuals of every row."""
    motion, exact = table.motion, book.run.scene.exact
    sheet.write_string(0, 0, book.say("first_last"), book.bold)
    heads = [book.say(f"split.{key}") for key in ("first", "last", "change", "true", "scheme")]
    sheet.write_string(1, 0, "", book.head)
    for column, head in enumerate(heads, start=1):
        sheet.write_string(1, column, head, book.right)
        sheet.set_column(column, column, max(WIDTH, 1 + len(head)))
    row = 2
    for name in motion.names if table.rows else ():
        place, own = table.place(name), motion.column(name)
        cells = [f"{SHEET}!{place}{FIRST}", f"{SHEET}!{place}{table.last}", f"C{row + 1}-B{row + 1}"]
        values = [float(own[0]), float(own[-1]), float(own[-1] - own[0])]
        if name in exact.names and len(exact.t) == table.rows:
            there = letters(1 + _names(motion, exact).index(name))
            cells += [f"{EXACT}!{there}{table.last}-{EXACT}!{there}{FIRST}", f"D{row + 1}-E{row + 1}"]
            true = float(exact.column(name)[-1] - exact.column(name)[0])
            values += [true, values[2] - true]
        sheet.write_string(row, 0, plain(name))
        look = book.shown(own)
        for across, (cell, value) in enumerate(zip(cells, values, strict=True), start=1):
            sheet.write_formula(row, across, f"={cell}", look, number(value))
        row += 1
    _residuals(book, sheet, table, residuals, row + 1)
    sheet.set_column(0, 0, WIDTH)
    sheet.set_column(len(heads) + 1, max(len(heads) + 1, len(residuals)), WIDTH)


def _residuals(book: Book, sheet: Any, table: StepTable, columns: list[Residual], top: int) -> None:
    """Write the residuals, a column each: closure of positions, both sides of each velocity equation."""
    if not columns or not table.rows:
        return
    equations, motion = book.run.scene.equations, table.motion
    values = compile_rows(equations, [expression for _, _, expression, _ in columns], 1)(
        motion.t, motion.coordinates, motion.velocities
    )
    sheet.write_string(top, 0, book.say("zero"), book.bold)
    sheet.repeat_rows(top + 1)
    sheet.write_string(top + 1, 0, "t", book.right)
    sheet.write_string(top + 2, 0, book.say("largest"), book.bold)
    first = top + 4
    times, shown = book.times(motion.step), book.file.add_format({"num_format": RESIDUAL})
    shown_largest = book.file.add_format({"num_format": RESIDUAL, "bold": True})
    for step, at in enumerate(motion.t.tolist()):
        sheet.write_formula(top + 3 + step, 0, f"={SHEET}!A{FIRST + step}", times, at)
    for place, (head, text, _, is_kept) in enumerate(columns, start=1):
        sheet.write_string(top + 1, place, plain(head), book.right)
        column = values[:, place - 1] - (values[0, place - 1] if is_kept else 0.0)
        text = f"{text}-({text.replace(ROW, str(FIRST))})" if is_kept else text
        _write_largest(sheet, top + 2, place, first, column, shown_largest)
        _write_small(sheet, place, first, text, column, shown)


def _write_small(sheet: Any, place: int, first: int, text: str, values: Array, look: Any) -> None:
    """Write small values into a column from a row (from 1) on, each a formula over one row of the table."""
    for step, value in enumerate(values.tolist()):
        sheet.write_formula(first - 1 + step, place, f"={text.replace(ROW, str(FIRST + step))}", look, number(value))


def _write_largest(sheet: Any, row: int, place: int, first: int, values: Array, look: Any) -> None:
    """Write the largest absolute value of a column."""
    span = f"{letters(place)}{first}:{letters(place)}{first + len(values) - 1}"
    sheet.write_formula(row, place, f"=MAX(MAX({span}),-MIN({span}))", look, number(float(np.abs(values).max())))


def residuals_of(book: Book, table: StepTable) -> Iterator[Residual]:
    """Yield the residuals of every row; laws that only they use get columns in the table."""
    scene, order, motion = book.run.scene, book.run.scene.equations.order, table.motion
    if len(motion.names) < len(scene.variant.coordinates) + len(scene.variant.velocities):
        return  # without all columns no equation can be checked
    known = {"zero": False, "start": True}  # an equation for a driven coordinate is no residual
    zero = [(one.told, one.expression, known[one.target]) for one in scene.equations.positions if one.target in known]
    for one in scene.equations.equations:
        zero.append((f"({book.context.equation(one.name)})", add(*one.terms) - one.right_side, False))
    for head, expression, is_kept in zero:
        yield head, table.text(as_formula(expression, order)), expression, is_kept
