"""A run as a workbook: sheets Data, Euler, Exact, Checks, Graphs, Read me; the same bytes on every run.

Enters: a `SceneRun` and a language.  Leaves: the bytes of an xlsx file.  Raises `NotToBeHad` if there can be no workbook.
Used by `run.py`, `assigning/assign.py`, and by the list of formats, by name.
"""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime
from io import BytesIO
from typing import Any

from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.report.output.results import Results
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.scene.scene_run import SceneRun
from coursework.system.extras import require
from coursework.system.grouped import grouped
from coursework.takeaway.workbook.by_forces import forced_columns
from coursework.takeaway.workbook.cells import FIRST, SHEET, StepTable
from coursework.takeaway.workbook.checks import EXACT, residuals_of, write_checks, write_exact
from coursework.takeaway.workbook.columns import step_columns
from coursework.takeaway.workbook.data import TABLES, write_data
from coursework.takeaway.workbook.sheet import Book, plain
from coursework.takeaway.workbook.steps import write_first_row, write_steps
from coursework.takeaway.workbook.tables import SHEET as DATA
from coursework.takeaway.workbook.tables import Tables
from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say

# The file holds the time of its creation: always this one, so that two runs give the same bytes.
_MADE = datetime(2000, 1, 1)
_A4 = 9
_LETTERS, _LINE, _WIDE = 105, 16, 0x2E00  # letters of a line; points of its height; letters beyond this code are twice as wide
README = ("data", "steps", "laws", "determinants", "exact", "checks", "graphs", "rows", "values")
FORCED = ("data", "forces", "exact", "checks", "graphs", "rows")  # if forces move the mechanism
COLOURS = ("#1F77B4", "#D62728", "#2CA02C", "#9467BD", "#FF7F0E", "#8C564B", "#17BECF", "#7F7F7F")
HEIGHT, WIDTH = 360, 860  # px of a chart
_ROWS = 19  # height of a chart in rows of cells
_AXIS: dict[str, Any] = {
    "major_gridlines": {"visible": True, "line": {"color": "#D9D9D9"}}, "name_font": {"bold": False}, "num_format": "General",
}  # fmt: skip


def write(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield the workbook of the results."""
    yield f"{results.stem}.xlsx", workbook_of(results.run, results.language)


def workbook_of(run: SceneRun, language: str) -> bytes:
    """Return the workbook of a run."""
    book, content, table = _begun(run, language)
    residuals = list(residuals_of(book, table))
    sheets = _sheets(book, (DATA, SHEET, EXACT, "Checks", "Graphs", "Read me"))
    sheets["Graphs"].set_portrait()
    write_data(book, sheets[DATA], table.names, table.tables)
    write_steps(book, sheets[SHEET], table)
    write_exact(book, sheets[EXACT], table)
    write_checks(book, sheets["Checks"], table, residuals)
    write_graphs(book, sheets["Graphs"], table)
    _readme(book, sheets["Read me"])
    book.file.close()
    return content.getvalue()


def task_workbook(run: SceneRun, language: str, help_level: int) -> bytes:
    """Return the workbook of a task: its data, and a table whose formulas are left to the student.

    With `help_level` 1 the first row has its formulas, and so have the start values that follow from the geometry.
    """
    book, content, table = _begun(run, language)
    sheets = _sheets(book, (DATA, SHEET))
    write_data(book, sheets[DATA], table.names, table.tables, solved=help_level > 0)
    write_first_row(book, sheets[SHEET], table, help_level)
    book.file.close()
    return content.getvalue()


def _begun(run: SceneRun, language: str) -> tuple[Book, BytesIO, StepTable]:
    """Return an empty workbook and its table.  Raises `NotToBeHad` for runs that have none, and without XlsxWriter."""
    require("xlsxwriter", "xlsx", "workbook")
    if run.settings.project or run.settings.gain:
        raise NotToBeHad(say("fault.W045"))
    import xlsxwriter

    content = BytesIO()
    file = xlsxwriter.Workbook(content, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    book = Book.of(file, PageContext(run, load_words(language)))
    file.set_properties({"title": plain(book.context.variant.title), "created": _MADE})
    tables = Tables(run.scene.equations.tables, TABLES)
    return book, content, step_columns(run, tables) if run.variant.motor is None else forced_columns(run, tables)


def _bare(_sheet: Any, formula: str, *_: Any) -> str:
    """Return a formula as it is stored.  XlsxWriter would search it for newer functions: half of its time, and there are none."""
    return formula.removeprefix("{").removeprefix("=").removesuffix("}")


def _sheets(book: Book, names: tuple[str, ...]) -> dict[str, Any]:
    from xlsxwriter.worksheet import Worksheet

    plain_sheet = type("PlainSheet", (Worksheet,), {"_prepare_formula": _bare})
    sheets = {name: book.file.add_worksheet(name, plain_sheet) for name in names}
    for sheet in sheets.values():
        sheet.set_landscape()
        sheet.set_paper(_A4)
        sheet.fit_to_pages(1, 0)
    return sheets


def _readme(book: Book, sheet: Any) -> None:
    """Write explanations of where each formula comes from."""
    sheet.write_string(0, 0, plain(book.context.variant.title), book.bold)
    motion = book.run.scene.scheme_rows or book.run.motion  # beside an exact table the sheet has the rows of Euler
    title, is_other = book.context.told(book.run.scheme_title), motion.scheme != DEFAULT_SCHEME.name
    for row, key in enumerate(README if book.run.variant.motor is None else FORCED, start=2):
        text = book.say(f"readme.{'slopes' if key == 'steps' and is_other else key}", scheme=title)
        letters = sum(1 + (ord(letter) > _WIDE) for letter in text)
        sheet.set_row(row, _LINE * (1 + letters // _LETTERS))
        sheet.write_string(row, 0, text, book.wrapped)
    sheet.set_column(0, 0, _LETTERS)


def write_graphs(book: Book, sheet: Any, table: StepTable) -> None:
    """Write the charts: velocities first, then coordinates."""
    motion, run = table.motion, book.run
    by_unit = grouped((run.variant.unit_of(name), name) for name in (*motion.velocity_names, *motion.coordinate_names))
    exact = [column.head for column in table.columns[1:] if column.head in run.scene.exact.names]
    for place, (unit, names) in enumerate(by_unit.items() if table.rows > 1 else ()):
        chart = book.file.add_chart({"type": "scatter", "subtype": "straight"})
        for number, name in enumerate(names):
            colour = COLOURS[number % len(COLOURS)]
            symbol = plain(book.context.label(name))
            marker = {"type": "circle", "size": 4, "border": {"color": colour}, "fill": {"color": colour}}
            own = table.number(name)
            chart.add_series(_series(SHEET, own, table.last, symbol) | {"marker": marker, "line": {"none": True}})
            if name in exact:
                column, last = 1 + exact.index(name), FIRST + len(run.scene.exact.t) - 1
                told = f"{symbol}, {book.say('exact')}"
                line = {"line": {"color": colour, "width": 1.25}, "marker": {"type": "none"}}
                chart.add_series(_series(EXACT, column, last, told) | line)
        shown = ", ".join(plain(book.context.label(name)) for name in names)
        chart.set_y_axis({"name": f"{shown}{book.context.words.behind(book.context.words.unit(unit))}", **_AXIS})
        second = book.context.words.behind(book.context.words.unit("s"))
        chart.set_x_axis({"name": f"t{second}", "min": 0, "label_position": "low", **_AXIS})
        chart.set_size({"width": WIDTH, "height": HEIGHT})
        chart.set_legend({"position": "right"})
        sheet.insert_chart(1 + _ROWS * place, 0, chart)
    sheet.write_string(0, 0, book.say("graphs"), book.bold)


def _series(sheet: str, column: int, last: int, name: str) -> dict[str, Any]:
    return {
        "name": name, "categories": [sheet, FIRST - 1, 0, last - 1, 0], "values": [sheet, FIRST - 1, column, last - 1, column],
    }  # fmt: skip
