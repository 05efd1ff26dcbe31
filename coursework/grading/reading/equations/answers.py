"""`name = number unit` -> the answers a student measured in a drawing.

Enters: a line of text and the names of the rubric.  Leaves: `AnswerLine`, None where the line is no answer.
Used by `lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.grading.reading.numbers import printed
from coursework.grading.reading.student_work import AnswerLine
from coursework.grading.reading.table.headers import PRINTED, fold, unit_of

_LINE = re.compile(r"\s*(?P<name>[^=:≈]{1,60}?)\s*(?:=|:|≈)(?P<rest>.*)")
_VALUE = re.compile(
    r"(?P<number>[-+−–]?\s?[0-9.,０-９]+(?:[eEеЕ][-+−]?[0-9]+)?)(?:\s*/\s*(?P<below>[0-9]{1,6}))?(?P<unit>\D.*|\s*1/.*)?"
)
_FACTORS = {unit: factor for units in PRINTED.values() for unit, factor in units.items()}
_BLANK = {"", "-", "—", "–", "?", "…", "...", "_", "__", "___"}


def read_answer(text: str, file: str, line: int, names: Sequence[str]) -> AnswerLine | None:
    """Return the answer in a line.

    >>> read_answer("wAB = 3/4 рад/с", "a.txt", 1, ["wAB"]).value
    0.75
    """
    match = _LINE.fullmatch(text.rstrip().rstrip(";"))
    name = _name(match["name"], names) if match else None
    if match is None or name is None:
        return None
    rest = match["rest"].strip().rstrip(".").strip()
    if rest in _BLANK:
        return AnswerLine(file, line, name, rest, None, "", "blank")
    value, unit = _value(rest)
    return AnswerLine(file, line, name, rest[:200], value, unit, "unreadable" if value is None else "read")


def _name(text: str, names: Sequence[str]) -> str | None:
    if text in names:
        return text
    alike = [name for name in names if _form(name) == _form(text)]
    return alike[0] if len(alike) == 1 else None


def _form(text: str) -> str:
    return re.sub(r"[\s_{}]", "", fold(text))


def _value(text: str) -> tuple[float | None, str]:
    """Return a number in SI and its unit as SI writes it; a number without a unit is in SI already."""
    match = _VALUE.fullmatch(text)
    if not match:
        return None, ""
    number = printed(match["number"], "," if "," in match["number"] and "." not in match["number"] else ".")
    below = int(match["below"] or 1)
    unit_text = (match["unit"] or "").strip()
    unit = unit_of(unit_text) if unit_text else ""
    if unit_text and not unit and not number.flag and below:
        return _force(number.value / below, unit_text)
    if number.flag or not below or (unit_text and not unit):
        return None, ""
    return number.value / below * _FACTORS.get(unit, 1.0), unit


def _force(value: float, unit_text: str) -> tuple[float | None, str]:
    """Return a value with a unit of force or moment in SI; nothing for a unit that is none."""
    from coursework.variant.formula.units import UnitFault, read_mass

    try:
        found = read_mass(f"1 {unit_text}")
    except UnitFault:
        return None, ""
    return value * found.value, found.si
