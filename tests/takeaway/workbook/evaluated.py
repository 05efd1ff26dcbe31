"""A workbook computed by a few lines of its own: formulas read by openpyxl, evaluated cell by cell.

What a spreadsheet does is done by `tests/takeaway/workbook/test_libreoffice.py` in the long set; this is quick
enough for the gate.
"""

import bisect
import io
import math
import re
from functools import cache

import numpy as np
import openpyxl
from openpyxl.utils import column_index_from_string

_CELL = re.compile(r"(?:(\w+)!)?\$?([A-Z]{1,3})\$?(\d+)(?::\$?([A-Z]{1,3})\$?(\d+))?(?![\w(])")
_NAME = re.compile(r"(?<![\w.])(_\w+|step)\b")


def _index(values, row):
    return np.asarray(values).ravel()[int(row) - 1]


def _round(value, _digits):
    return math.copysign(math.floor(abs(value) + 0.5), value)


CALLS = {
    "SIN": math.sin, "COS": math.cos, "TAN": math.tan, "ASIN": math.asin, "ACOS": math.acos, "ATAN": math.atan, "SQRT": math.sqrt,
    "EXP": math.exp, "LN": math.log, "ABS": abs, "PI": lambda: math.pi, "ATAN2": lambda x, y: math.atan2(y, x),
    "IF": lambda holds, yes, no: yes() if holds else no(), "ROUND": _round,
    "MAX": lambda *values: max(map(np.max, values)), "MIN": lambda *values: min(map(np.min, values)),
    "MATCH": lambda value, among, _: bisect.bisect_right(list(np.asarray(among).ravel()), value), "INDEX": _index,
    "MMULT": np.matmul, "MINVERSE": np.linalg.inv, "MDETERM": np.linalg.det,
}  # fmt: skip


class Evaluated:
    """The cells of a workbook; `set` changes one by its defined name."""

    def __init__(self, content: bytes) -> None:
        self.book = openpyxl.load_workbook(io.BytesIO(content))
        self.names = {name: one.attr_text for name, one in self.book.defined_names.items()}
        self.known: dict[tuple[str, int, int], object] = {}

    def set(self, name: str, value: float) -> None:
        sheet, _, cell = self.names[name].partition("!")
        self.book[sheet][cell.replace("$", "")] = value
        self.known.clear()

    def value(self, sheet: str, row: int, column: int):
        key = (sheet, row, column)
        if key not in self.known:
            found = self.book[sheet].cell(row, column).value
            text = getattr(found, "text", found)
            self.known[key] = self.of(sheet, text.removeprefix("=")) if isinstance(text, str) and text.startswith("=") else found
        return self.known[key]

    def of(self, sheet: str, text: str):
        def cell(match):
            where, column, row, last_column, last_row = match.groups()
            where, place = where or sheet, (int(row), column_index_from_string(column))
            if last_column is None:
                return f"_value({where!r}, {place[0]}, {place[1]})"
            return f"_range({where!r}, {place[0]}, {place[1]}, {last_row}, {column_index_from_string(last_column)})"

        text = _NAME.sub(lambda match: self.names.get(match[1], match[1]), text)
        text = _lazy(_CELL.sub(cell, text).replace("^", "**"))
        # Text of a workbook that this suite has made itself.
        return eval(text, {**CALLS, "_value": self.value, "_range": self.ranged, "__builtins__": {}})

    def ranged(self, sheet: str, first: int, left: int, last: int, right: int):
        return np.array([[self.value(sheet, row, column) for column in range(left, right + 1)] for row in range(first, last + 1)])

    def rows(self, sheet: str, count: int, columns: int) -> np.ndarray:
        return np.array(
            [[self.value(sheet, 2 + row, 1 + column) for column in range(columns)] for row in range(count)], dtype=float
        )


def _lazy(text: str) -> str:
    """Let IF compute only the branch that holds: another one need not have a value."""
    place = text.find("IF(")
    if place < 0:
        return text
    depth, parts, begin = 0, [], place + 3
    for at in range(begin, len(text)):
        letter = text[at]
        if letter == "(":
            depth += 1
        elif letter == ")" and depth:
            depth -= 1
        elif letter in ",)" and not depth:
            parts.append(_lazy(text[begin:at]))
            begin = at + 1
            if letter == ")":
                break
    holds, yes, no = parts
    return f"{text[:place]}_IF({holds}, lambda: ({yes}), lambda: ({no})){_lazy(text[begin:])}"


CALLS["_IF"] = CALLS.pop("IF")


@cache
def opened(content: bytes) -> Evaluated:
    """Return the cells of a workbook, computed once for all who ask; nobody sets one."""
    return Evaluated(content)


@cache
def shown(content: bytes) -> openpyxl.Workbook:
    """Return a workbook as a viewer shows it which does not calculate."""
    return openpyxl.load_workbook(io.BytesIO(content), data_only=True)


def cached(content: bytes, sheet: str, count: int, columns: int) -> np.ndarray:
    """Return the numbers that a viewer shows which does not calculate."""
    found = shown(content)[sheet]
    rows = [[found.cell(2 + row, 1 + column).value for column in range(columns)] for row in range(count)]
    return np.array(rows, dtype=float).reshape(count, columns)
