"""A Jupyter notebook -> the tables in its outputs, from the last to the first, and the text of its Markdown and raw cells.

Enters: text.  Leaves: `Document`.  Raises `Refused`.  Code is never run, and no table comes from it: its lines are read as those
of a program, if no other cell has an equation.
Used by `read_document.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby
from typing import Any

from coursework.grading.reading.documents.document import Document, place_of
from coursework.grading.reading.documents.json_text import JsonObject, read_json
from coursework.grading.reading.documents.markdown import add_markdown
from coursework.grading.reading.equations.formulas.equations import TURNED
from coursework.grading.reading.equations.notation.signs import relates_two_sides
from coursework.grading.reading.files.html_text import text_of

_MOST_CELLS, _MOST_OUTPUTS = 2000, 200
_LEVELS = 12  # most levels of brackets; a notebook with more is refused
_ANSI = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def is_notebook(text: str) -> bool:
    """Return whether a text looks like a notebook."""
    return text.lstrip("\ufeff \r\n\t").startswith("{") and '"cells"' in text and '"nbformat"' in text


def document_of_notebook(text: str, kind: str) -> Document:
    """Return the outputs and texts of a notebook.  Raises `Refused` if it is damaged or nested too deeply."""
    document = Document(kind, first_counts=True)
    whole = read_json(text, _LEVELS)
    cells = _items(whole, "cells")[:_MOST_CELLS]
    for number, cell in enumerate(cells, start=1):
        if _text(cell, "cell_type") in {"markdown", "raw"}:
            place = place_of("cell", number=number)
            add_markdown(document, _joined(_value(cell, "source")), lambda line, place=place: place)  # type: ignore[misc]
    of_code = [(number, cell) for number, cell in enumerate(cells, start=1) if _text(cell, "cell_type") == "code"]
    shown = [(output, place_of("cell", number=number)) for number, cell in of_code for output in _outputs(cell)]
    for output, place in reversed(shown[-_MOST_OUTPUTS:]):
        document.texts.append((output, place))
        for line in output.split("\n"):
            if relates_two_sides(line) and "\t" not in line:
                document.add_line(line, place)
    code = [(number, _joined(_value(cell, "source"))) for number, cell in of_code]
    if any(TURNED.search(text) for _, text in code) and not any(TURNED.search(line.text) for line in document.lines):
        document.is_code = True
        for number, text in code:
            for line in text.split("\n"):
                document.add_line(line, place_of("cell", number=number))
    return document


def _outputs(cell: Any) -> Iterator[str]:
    """Yield the output texts of a cell; text printed in several pieces is joined."""
    for is_printed, group in groupby(_items(cell, "outputs"), lambda output: _text(output, "output_type") == "stream"):
        if is_printed:
            yield _ANSI.sub("", "".join(_joined(_value(output, "text")) for output in group))
            continue
        for output in group:
            data = _value(output, "data")
            page, plain = _joined(_value(data, "text/html")), _joined(_value(data, "text/plain"))
            formula = _joined(_value(data, "text/latex"))
            if formula:
                yield formula
            elif "<table" in page.lower():
                yield text_of(page)
            elif plain:
                yield _ANSI.sub("", plain)


def _value(of: Any, name: str) -> Any:
    return of.value(name) if isinstance(of, JsonObject) else None


def _text(of: Any, name: str) -> str:
    found = _value(of, name)
    return found if isinstance(found, str) else ""


def _items(of: Any, name: str) -> list[Any]:
    found = _value(of, name)
    return found if isinstance(found, list) else []


def _joined(value: Any) -> str:
    """Return a text of a notebook, which may be stored as a list of lines."""
    if isinstance(value, str):
        return value
    return "".join(part for part in value if isinstance(part, str)) if isinstance(value, list) else ""
