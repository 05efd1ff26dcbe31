"""Sheet Data: data of the task, start values and step, each with a name that the other sheets use in formulas.

Enters: a `Book`, the names, the tabulated laws.  Leaves: the sheet.  Used by `book.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from coursework.equations.reduction.symbolic import break_of
from coursework.report.live.by_forces import with_weights
from coursework.report.wording.data_meanings import coordinate_meanings, meanings
from coursework.system.frozen import frozen
from coursework.takeaway.workbook.dyads import Work, start_formulas
from coursework.takeaway.workbook.formulas import spreadsheet
from coursework.takeaway.workbook.names import STEP, break_times, letters, start_of
from coursework.takeaway.workbook.sheet import WIDTH, Book, number, plain
from coursework.takeaway.workbook.tables import SHEET, Tables
from coursework.variant.formula.tree import Formula, evaluate
from coursework.variant.toml.positions import KeyPath

COLUMNS = (  # keys of the heads
    "given.quantity", "workbook.head.meaning", "workbook.head.value", "given.unit", "workbook.head.as_given",
    "workbook.head.name",
)  # fmt: skip
VALUE, UNIT = 2, 3
ORIGINAL = len(COLUMNS)  # hidden column with the values of the file: a cell that differs from it turns bold
TABLES = ORIGINAL + 2  # first column of the coefficients of tabulated laws
HEAD = 2  # the row of heads, from 0
_AT_BREAK = "(1-1E-14)"  # as in the tool itself: a row at a break uses the new formula


@frozen
class _Line:
    symbol: str
    meaning: str
    value: float
    unit: str
    written: str
    name: str
    formula: str = ""
    is_start: bool = False


def write_data(book: Book, sheet: Any, names: Mapping[str, str], tables: Tables, *, solved: bool = True) -> None:
    """Write the sheet and define its names; if not `solved`, start values from the geometry are left to the student."""
    variant = book.context.variant
    sheet.write_string(0, 0, plain(f"{variant.name}. {variant.title}"), book.bold)
    heads = [plain(book.context.words(key)) for key in COLUMNS]
    for column, text in enumerate(heads):
        sheet.write_string(HEAD, column, text, book.head)
    work = Work(tables.end + 1)
    sheet.write_string(HEAD, VALUE, heads[VALUE], book.right)
    sheet.write_string(HEAD, UNIT, heads[UNIT], book.unit_head)
    lines = [
        *_data(book, names),
        *_weights(book, names),
        *_starts(book, names, start_formulas(book.run, names, tables, work)),
        *_times(book, names),
    ]
    for row, line in enumerate(lines, start=HEAD + 1):
        for column, text in ((0, line.symbol), (1, line.meaning), (3, line.unit), (4, line.written), (5, line.name)):
            sheet.write_string(row, column, plain(text), book.unit if column == UNIT else None)
        if line.is_start and line.formula and not solved:
            sheet.write_blank(row, VALUE, None, book.head)
        elif line.formula:
            sheet.write_formula(row, VALUE, f"={line.formula}", None, line.value)
            sheet.write_formula(row, ORIGINAL, f"={line.formula}", None, line.value)
        else:
            sheet.write_number(row, VALUE, line.value)
            sheet.write_number(row, ORIGINAL, line.value)
        book.file.define_name(line.name, f"={SHEET}!$C${row + 1}")
    changed = {"type": "formula", "criteria": f"=$C{HEAD + 2}<>${letters(ORIGINAL)}{HEAD + 2}", "format": book.bold}
    sheet.conditional_format(HEAD + 1, VALUE, HEAD + len(lines), VALUE, changed)
    for column, width in enumerate((14, 46, 14, 11, 24, 18)):
        sheet.set_column(column, column, width)
    sheet.set_column(ORIGINAL, ORIGINAL, None, None, {"hidden": True})
    for row, term in enumerate(work.cells if solved else []):
        sheet.write_formula(row, work.column, f"={term.text}", None, number(term.value))
    sheet.set_column(work.column, work.column, None, None, {"hidden": True})
    for column, head, values in tables.columns():
        sheet.write_string(0, column, plain(head), book.right)
        sheet.set_column(column, column, WIDTH, book.shown(np.array(values)))
        sheet.write_column(1, column, values)
    sheet.freeze_panes(HEAD + 1, 0)
    sheet.print_area(0, 0, HEAD + len(lines), len(COLUMNS) - 1)


def _data(book: Book, names: Mapping[str, str]) -> Iterator[_Line]:
    told = meanings(book.run.scene.mechanism)
    own = {given.name: given.means for given in book.context.variant.given}
    for given in book.context.variant.given:
        meaning = own[given.name] or book.context.words.written(told[given.name])
        written = f"{given.text} {given.unit}".strip()
        yield _Line(_symbol(book, given.name), meaning, given.value, _unit(book, given.shown_si), written, names[given.name])


def _starts(book: Book, names: Mapping[str, str], formulas: dict[str, tuple[str, str]]) -> Iterator[_Line]:
    told = coordinate_meanings(book.run.scene.mechanism)
    for coordinate, value in zip(book.context.variant.coordinates, book.run.scene.start, strict=True):
        is_given = coordinate.start is not None
        formula, kind = formulas.get(coordinate.name, ("", ""))
        meaning = book.say("start", symbol=_symbol(book, coordinate.name))
        meaning += f" ({book.context.words.written(told[coordinate.name])})" if told.get(coordinate.name) else ""
        written = book.say("dyad", kind=kind) if kind else book.say("belongs")
        if is_given:
            written = f"{coordinate.text} {coordinate.written or coordinate.unit}".strip()
        name = names[start_of(coordinate.name)]
        yield _Line(_symbol(book, coordinate.name), meaning, value, _unit(book, coordinate.unit), written, name, formula, True)


def _weights(book: Book, names: Mapping[str, str]) -> Iterator[_Line]:
    """Yield masses and loads of a motion under forces, then the rates at its start."""
    variant = book.run.variant
    if variant.motor is None:
        return
    for given in with_weights(variant).given[len(variant.given) :]:
        key = "mass" if given.si == "kg" else "load"
        meaning = book.say(key, name=given.name.removeprefix("m_") if key == "mass" else given.name)
        unit = _unit(book, given.si)
        yield _Line(given.name, meaning, given.value, unit, f"{given.value:g} {unit}".strip(), names[given.name])
    start = dict(variant.motor.start)
    for rate in variant.motor.rates:
        symbol, unit, value = _symbol(book, rate), _unit(book, variant.unit_of(rate)), start.get(rate, 0.0)
        meaning = book.say("start", symbol=symbol)
        yield _Line(symbol, meaning, value, unit, f"{value:g} {unit}", names[start_of(rate)], is_start=True)


def _times(book: Book, names: Mapping[str, str]) -> Iterator[_Line]:
    variant = book.run.variant
    step = variant.time.step
    formula = _formula(book, ("time", "step"), step, names)
    yield _Line("h", book.say("step"), step, _unit(book, "s"), "", STEP, formula)
    for law, place, time in break_times(variant):
        text = _formula(book, (*variant.path_of(law), "pieces", place + 1, 0), time, names) or repr(time)
        value = time * (1 - 1e-14)
        told = book.say("break", symbol=_symbol(book, law))
        yield _Line("t", told, value, _unit(book, "s"), "", names[break_of(law, place)], f"({text})*{_AT_BREAK}")


def _formula(book: Book, path: KeyPath, value: float, names: Mapping[str, str]) -> str:
    """Return the formula of a time in terms of the data, "" if it is a plain number."""
    tree: Formula | None = book.run.variant.times.get(path)
    known = tree is not None and evaluate(tree, book.run.variant.values) == value
    return spreadsheet(tree, names) if tree is not None and known else ""


def _symbol(book: Book, name: str) -> str:
    return book.context.label(name)


def _unit(book: Book, unit: str) -> str:
    return book.context.words.unit(unit)
