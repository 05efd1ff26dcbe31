"""What every sheet of a workbook is written with: the workbook itself, its formats, text that stays text.

Enters: a `SceneRun` and a language.  Leaves: `Book`.  Used inside `workbook/`.
"""

from __future__ import annotations

import math
import unicodedata
from typing import Any

from coursework.report.text.page_context import PageContext
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen

HEADS = "#DCE6F1"


@frozen
class Book:
    """`file` is XlsxWriter's workbook; `context` the page's words and symbols of the same run."""

    file: Any
    context: PageContext
    bold: Any
    head: Any
    right: Any
    grey: Any
    wrapped: Any

    @classmethod
    def of(cls, file: Any, context: PageContext) -> Book:
        """Return a workbook with its formats."""
        bold, grey = file.add_format({"bold": True}), file.add_format({"italic": True, "font_color": "#606060"})
        head = file.add_format({"bold": True, "bg_color": HEADS, "bottom": 1})
        right = file.add_format({"bold": True, "bg_color": HEADS, "bottom": 1, "align": "right"})
        return cls(file, context, bold, head, right, grey, file.add_format({"text_wrap": True, "valign": "top"}))

    @property
    def run(self) -> SceneRun:
        """Return the run."""
        return self.context.run

    def say(self, key: str, **values: object) -> str:
        """Return a sentence of the workbook in the language of the report."""
        return plain(self.context.words(f"workbook.{key}", **values))

    def heads(self, sheet: Any, row: int, texts: list[str], column: int = 0) -> None:
        """Write a row of heads."""
        for place, text in enumerate(texts, start=column):
            sheet.write_string(row, place, plain(text), self.head)


def plain(text: str) -> str:
    """Return a text that a cell may hold: no control characters, nothing that no program shows."""
    return "".join(letter for letter in text if not unicodedata.category(letter).startswith("C"))


def number(value: float) -> float | str:
    """Return a number as a cached value, nothing for what is none."""
    return value if math.isfinite(value) else ""
