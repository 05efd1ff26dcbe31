"""Sheet Euler: row 1 has the names of table.csv, row k + 1 the k-th row of the table; cells are formulas with cached values.

Enters: a `Book` and `StepTable`.  Leaves: the sheet.  Used by `book.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.takeaway.workbook.cells import BEFORE, FIRST, NEXT, ROW, STEPS, Column, StepTable
from coursework.takeaway.workbook.sheet import GREY, WIDTH, Book, number, plain


def write_steps(book: Book, sheet: Any, table: StepTable) -> None:
    """Write the sheet: heads, columns, and hidden coefficients of the blocks that it solves."""
    for place, column in enumerate(table.columns):
        sheet.write_string(0, place, plain(column.head), book.right)
        look = GREY if column.formula is None else {}
        hidden = {} if column.shown else {"hidden": True}
        shown = book.shown(column.values, **look) if place else book.times(table.motion.step)
        sheet.set_column(place, place, WIDTH, shown, hidden)
        if place in table.solved:
            continue
        if column.formula is None:
            sheet.write_column(1, place, column.values.tolist())
        else:
            _formulas(sheet, place, column, table.rows)
    after = len(table.columns) + 1
    for matrix in table.matrices:
        matrix.column = after
        after += matrix.size + 1
        cells = [(text, *divmod(place, matrix.size + 1)) for place, text in enumerate(matrix.entries)]
        for step in range(table.rows - matrix.until):
            for place, (text, down, across) in enumerate(cells):
                value = number(float(matrix.values[step, place]))
                row = FIRST - 1 + step * matrix.size + down
                sheet.write_formula(row, matrix.column + across, f"={_at(text, step)}", None, value)
        sheet.set_column(matrix.column, matrix.column + matrix.size, None, None, {"hidden": True})
    for place in table.solved:
        _solved(sheet, place, table)
    sheet.repeat_rows(0)
    sheet.freeze_panes(1, 1)


def write_first_row(book: Book, sheet: Any, table: StepTable, help_level: int) -> None:
    """Write the heads and, with help, the formulas of the row t = 0 in all columns; the other rows are left to the student."""
    shown = len(table.columns) if help_level else 1 + len(table.motion.names)
    for place, column in enumerate(table.columns[:shown]):
        sheet.write_string(0, place, plain(column.head), book.right)
        if help_level and column.formula:
            _formulas(sheet, place, column, 1 + column.until)
    sheet.set_column(0, shown - 1, WIDTH)
    sheet.freeze_panes(1, 1)


def _formulas(sheet: Any, place: int, column: Column, rows: int) -> None:
    text, write = f"={column.formula}", sheet.write_formula
    for step, value in enumerate(column.values.tolist()[: rows - column.until]):
        formula = f"={column.first}" if column.first is not None and not step else _at(text, step)
        write(FIRST - 1 + step, place, formula, None, number(value))


def _solved(sheet: Any, place: int, table: StepTable) -> None:
    matrix, unknown = table.solved[place]
    values = table.columns[place].values.tolist()
    for step in range(table.rows - matrix.until):
        formula = f"{{={matrix.solved(unknown, FIRST + step)}}}"
        row = FIRST - 1 + step
        sheet.write_array_formula(row, place, row, place, formula, None, number(values[step]))


def _at(text: str, step: int) -> str:
    """Return a formula for one row, with the marks replaced by numbers."""
    row = FIRST + step
    for mark, value in ((ROW, row), (BEFORE, row - 1), (NEXT, row + 1), (STEPS, step)):
        if mark in text:
            text = text.replace(mark, str(value))
    return text
