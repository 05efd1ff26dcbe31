"""Texts such as "r1=0.91 m" or "N=3" -> the variant with these values, or one sentence about the mistake.

Enters: a variant, the texts that a user has given on the command line.  Leaves: the variant read anew.  Raises `InputError`.
Used by the commands `run` and `new`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.units import UnitFault, read
from coursework.variant.record.entries import ROWS_BEFORE_N
from coursework.variant.record.variant import Variant
from coursework.words.errors import InputError
from coursework.words.sentences import closest, say

_TIMES = ("step", "end", "period")


def with_set(variant: Variant, texts: Iterable[str], check_row: int | None = None) -> Variant:
    """Return the variant with other data, start values, laws of the drive or times, and another row of the check.

    Each text is name=value; a value without a unit is in SI.  N=3 is row 5, numbered as in the guide.
    """
    data: dict[str, dict[str, Any]] = {"given": {}, "start": {}, "drive": {}, "time": {}}
    kinds = {law.name: "drive" for law in variant.drive} | {c.name: "start" for c in variant.coordinates}
    kinds |= {"N": "row", "check_row": "row", **dict.fromkeys(_TIMES, "time")} | {given.name: "given" for given in variant.given}
    rows = [] if check_row is None else [check_row]
    for text in texts:
        written, equals, value = text.partition("=")
        name = spell(written.strip())
        if not (equals and name and value.strip()):
            raise InputError(say("fault.C041", found=text[:60]))
        if name not in kinds:
            raise InputError(say("fault.C042", name=written.strip()[:40], advice=closest(name, [*kinds]), known=tuple(kinds)))
        if kinds[name] == "row":
            rows.append(_row(name, value.strip()))
        elif name in data[kinds[name]]:
            raise _twice(name)
        else:
            data[kinds[name]][name] = _spaced(value.strip())
    if len(rows) > 1:
        raise _twice("check_row")
    if not (rows or any(data.values())):
        return variant
    return variant.with_data(data["given"], data["start"], data["drive"], **data["time"], check_row=rows[0] if rows else None)


def _spaced(value: str) -> str:
    """Return "0.91 m" for "0.91m", as in a file; a text that is no quantity is returned unchanged."""
    try:
        quantity = read(value)
    except UnitFault:
        return value
    return f"{quantity.text} {quantity.unit}".rstrip()


def _twice(name: str) -> InputError:
    return InputError(say("fault.C043", name=name))


def _row(name: str, value: str) -> int:
    """Return the row (from 1) for a text."""
    if not (value.isascii() and value.isdecimal() and int(value[:9]) >= 1 and len(value) < 9):
        raise InputError(say("fault.C044", name=name, found=value[:40]))
    return int(value) + (ROWS_BEFORE_N if name == "N" else 0)
