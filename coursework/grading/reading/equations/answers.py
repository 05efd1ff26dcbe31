"""`name = number unit` -> an answer that a student measured in a drawing.

Enters: a line of text and the names of the rubric.  Leaves: `AnswerLine`, None if the line is not an answer.
Used by `lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal

from coursework.grading.reading.numbers import printed
from coursework.grading.reading.student_work import AnswerLine
from coursework.grading.reading.table.headers import FACTORS
from coursework.grading.reading.unit_names import fold, unit_of
from coursework.variant.formula.units import UnitFault, read_mass

_LINE = re.compile(r"\s*(?P<name>[^=:≈]{1,60}?)\s*(?:=|:|≈)(?P<rest>.*)")
_VALUE = re.compile(
    r"(?P<number>[-+−–]?\s?[0-9.,０-９]+(?:[eEеЕ][-+−]?[0-9]+)?)(?:\s*/\s*(?P<below>[0-9]{1,6}))?(?P<unit>\D.*|\s*1/.*)?"
)
_BLANK = {"", "-", "—", "–", "?", "…", "...", "_", "__", "___"}


def read_answer(text: str, names: Sequence[str]) -> AnswerLine | None:
    """Return the answer in a line, None if it has none of the `names`.

    >>> read_answer("wAB = 3/4 рад/с", ["wAB"]).value
    0.75
    """
    match = _LINE.fullmatch(text.rstrip().rstrip(";"))
    name = _name(match["name"], names) if match else None
    if match is None or name is None:
        return None
    rest = match["rest"].strip().rstrip(".").strip()
    value = _value(rest)
    state: Literal["read", "blank", "unreadable"] = "blank" if rest in _BLANK else "unreadable" if value is None else "read"
    return AnswerLine(name, value, state)


def _name(text: str, names: Sequence[str]) -> str | None:
    if text in names:
        return text
    alike = [name for name in names if _form(name) == _form(text)]
    return alike[0] if len(alike) == 1 else None


def _form(text: str) -> str:
    return re.sub(r"[\s_{}]", "", fold(text))


def _value(text: str) -> float | None:
    """Return a number in SI, None if it cannot be read; a number without a unit is in SI already."""
    match = _VALUE.fullmatch(text)
    if not match:
        return None
    number = printed(match["number"], "," if "," in match["number"] and "." not in match["number"] else ".")
    below = int(match["below"] or 1)
    return None if number.flag or not below else _in_si(number.value / below, (match["unit"] or "").strip())


def _in_si(value: float, unit: str) -> float | None:
    """Return a value in SI, None if its unit is unknown."""
    if not unit:
        return value
    if known := unit_of(unit):
        return value * FACTORS[known]
    try:
        return value * read_mass(f"1 {unit}").value
    except UnitFault:
        return None
