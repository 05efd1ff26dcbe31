"""The cells of a student's table as they are shown: aligned, with few digits; the whole text is kept elsewhere.

Enters: texts as handed in.  Leaves: columns of texts of one width.  Used by `feedback.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.report.text.numbers import FIGURE, POINT_WIDE
from coursework.words.templates import clean

DIGITS = 6  # of the largest number in a column; the sentences tell a number that matters for a mark in full
FEW = 1e-3  # below this size fixed decimals would show mostly zeros
LONGEST_CELL = 16  # characters shown of a text that is no number
_DECIMAL = re.compile(r"[-+−]?\d+([.,]\d*)?(?:[eE][-+−]?\d+)?")


def shown_column(texts: Sequence[str], mark: str) -> list[str]:
    """Return the texts of a column with their own decimals, but so few that the largest number has at most `DIGITS` digits.

    Their decimal sign is `mark`, that of the page: one row of it has one sign, whatever the student's program writes.

    >>> shown_column(["-0.5123", "12,180000000000012", "3.5", "1.23456789012345E-17", "#VALUE!", ""], ".")
    ['−0.5123', '12.1800', '3.5\u2007\u2007\u2007', '1.23457e−17', '#VALUE!', '']
    """
    numbers = [text.strip() if _DECIMAL.fullmatch(text.strip()) else "" for text in texts]
    sizes = [abs(_value(text)) for text in numbers if text]
    whole = max((len(f"{size:.0f}") for size in sizes if FEW <= size < 10**DIGITS), default=1)
    decimals = min(max(map(_decimals, numbers), default=0), DIGITS - whole)
    return [
        _number(text, decimals).replace(".", mark) if text else clean(raw, LONGEST_CELL)
        for text, raw in zip(numbers, texts, strict=True)
    ]


def _value(text: str) -> float:
    return float(text.replace(",", ".").replace("−", "-"))


def _decimals(text: str) -> int:
    """Return the decimals of a number as it was written; a power of ten shifts them."""
    head, _, power = text.lower().partition("e")
    written = len(head.replace(",", ".").partition(".")[2])
    return max(written - int(power.replace("−", "-")), 0) if power else written


def _number(text: str, decimals: int) -> str:
    value, written = _value(text), _decimals(text)
    if value and not FEW <= abs(value) < 10**DIGITS:
        shown = text.replace(",", ".") if len(text) <= DIGITS + 2 else f"{value:.{DIGITS}g}"
        return shown.replace("-", "−")
    if "e" in text.lower():
        text = f"{value:.{written}f}"
    shown = f"{value:.{decimals}f}" if written > decimals else text.lstrip("+").replace(",", ".")
    missing = decimals - min(written, decimals)
    padding = (POINT_WIDE if missing and "." not in shown else "") + FIGURE * missing
    return shown.replace("-", "−") + padding
