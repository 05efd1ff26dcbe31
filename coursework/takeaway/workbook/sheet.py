"""What all sheets of a workbook share: the workbook itself, its formats, text that stays text.

Enters: a `SceneRun` and a language.  Leaves: `Book`.  Used inside `workbook/`.
"""

from __future__ import annotations

import math
import unicodedata
from typing import Any

import numpy as np

from coursework.report.text.page_context import PageContext
from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

HEADS = "#DCE6F1"
GREY = {"italic": True, "font_color": "#606060"}
DIGITS = 7  # shown of a column's largest number; the cells hold all digits
LEAST, MOST = 1e-4, 1e9  # outside this range a number is shown with a power of ten
WIDTH = 14  # letters of a column of numbers
RESIDUAL = "0.00E+00;-0.00E+00;0"


@frozen
class Book:
    """`file` is XlsxWriter's workbook; `context` has the page's words and symbols of the same run."""

    file: Any
    context: PageContext
    bold: Any
    head: Any
    right: Any
    unit: Any
    unit_head: Any
    wrapped: Any

    @classmethod
    def of(cls, file: Any, context: PageContext) -> Book:
        """Return a workbook with its formats."""
        bold, unit = file.add_format({"bold": True}), file.add_format({"indent": 1})
        head = file.add_format({"bold": True, "bg_color": HEADS, "bottom": 1})
        unit_head = file.add_format({"bold": True, "bg_color": HEADS, "bottom": 1, "indent": 1})
        right = file.add_format({"bold": True, "bg_color": HEADS, "bottom": 1, "align": "right"})
        return cls(file, context, bold, head, right, unit, unit_head, file.add_format({"text_wrap": True, "valign": "top"}))

    @property
    def run(self) -> SceneRun:
        """Return the run."""
        return self.context.run

    def say(self, key: str, **values: object) -> str:
        """Return a sentence of the workbook in the language of the report."""
        return plain(self.context.words(f"workbook.{key}", **values))

    def shown(self, values: Array, **look: object) -> Any:
        """Return the format of a column of numbers, with the decimals that its largest number needs."""
        largest = float(np.max(np.abs(values[np.isfinite(values)]), initial=0.0))
        if largest and not LEAST <= largest < MOST:
            return self.file.add_format({"num_format": RESIDUAL, **look})
        before = math.floor(math.log10(largest)) + 1 if largest else DIGITS
        return self.file.add_format({"num_format": f"0.{'0' * (DIGITS - before)}".removesuffix("."), **look})

    def times(self, step: float) -> Any:
        """Return the format of times, each without superfluous zeros."""
        decimals = max(DIGITS - math.floor(math.log10(step)), 1) if step else 1
        return self.file.add_format({"num_format": f"0.0{'#' * (min(decimals, WIDTH) - 1)}"})


def plain(text: str) -> str:
    """Return a text that a cell may hold, without control and other invisible characters."""
    return "".join(letter for letter in text if not unicodedata.category(letter).startswith("C"))


def number(value: float) -> float | str:
    """Return a number as a cached value, "" if it is not finite."""
    return value if math.isfinite(value) else ""
