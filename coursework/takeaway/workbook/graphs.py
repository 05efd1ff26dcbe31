"""Sheet Graphs: native charts of the table, Euler's rows as dots and the exact motion as a line, one chart per unit.

Enters: a `Book` and `StepTable`.  Leaves: the sheet.  Used by `book.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.takeaway.workbook.cells import FIRST, SHEET, StepTable
from coursework.takeaway.workbook.checks import EXACT
from coursework.takeaway.workbook.sheet import Book, plain

COLOURS = ("#1F77B4", "#D62728", "#2CA02C", "#9467BD", "#FF7F0E", "#8C564B", "#17BECF", "#7F7F7F")
HEIGHT, WIDTH = 360, 860  # px
_ROWS = 19  # height of a chart in rows of cells


def write_graphs(book: Book, sheet: Any, table: StepTable) -> None:
    """Write the charts: velocities first, then coordinates."""
    motion, run = table.motion, book.run
    by_unit: dict[str, list[str]] = {}
    for name in (*motion.velocity_names, *motion.coordinate_names):
        by_unit.setdefault(run.variant.unit_of(name), []).append(name)
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


_AXIS: dict[str, Any] = {
    "major_gridlines": {"visible": True, "line": {"color": "#D9D9D9"}}, "name_font": {"bold": False}, "num_format": "General",
}  # fmt: skip


def _series(sheet: str, column: int, last: int, name: str) -> dict[str, Any]:
    return {
        "name": name, "categories": [sheet, FIRST - 1, 0, last - 1, 0], "values": [sheet, FIRST - 1, column, last - 1, column],
    }  # fmt: skip
