"""A tabulated law in a file beside the variant file: two columns of a CSV in the same folder.

Enters: the name of the table.  Leaves: rows of (argument, value).  Used by `reader.py`.
"""

from __future__ import annotations

import math
import posixpath
import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from coursework.system.arrays import Array
from coursework.system.files.links import led_to
from coursework.variant.formula.motion_units import UNITS, advised_unit
from coursework.variant.formula.units import plain_unit
from coursework.variant.record.entries import last_place
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.reasons import reason_of
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MAX_TABLE_BYTES = 256 * 1024
MOST_NODES = 20_000
_FEWEST_NODES = 5  # needed by the five-point formulas
# A node displaced by a fraction of the step changes the slopes near it by the same fraction.  The first tolerance is for
# nodes computed by a program, the second for printed arguments with enough digits.
_EXACT, _ROUNDED = 1e-6, 1e-3
# Possessive: blanks and quotes are not given back, so that a long line of them is scanned only once.
_QUOTED = r"""\s*+"*+\s*+([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s*+"*+\s*+"""
_CELL, _LINE = re.compile(_QUOTED), re.compile(f"{_QUOTED},{_QUOTED}")
_UNIT = re.compile(r"""[\[( _]([^\[\]()" _]+)[\])]?\s*"*(?=,|$)""")  # w [rpm], w (rpm), w rpm, w_rpm
Rows = tuple[tuple[float, float], ...]


class TableFault(ValueError):
    """A table cannot be used; the sentence says which line and why."""

    def __init__(self, message: Sentence) -> None:
        super().__init__(message)
        self.message = message


def read_table(name: str, source: Source, path: KeyPath, faults: list[Fault]) -> Rows:
    """Return the rows of a table; after a fault, add it to `faults` and return an empty table."""
    try:
        return _rows(name, _text(name, source))
    except TableFault as fault:
        faults.append(source.fault(path, fault.message))
        return ()


def _text(name: str, source: Source) -> str:
    if not name.lower().endswith(".csv"):
        raise TableFault(say("fault.V089"))
    try:
        if not _is_inside(name, source.folder):
            raise TableFault(say("fault.V091", name=name))
        raw = _on_disk(name, source.folder) if isinstance(source.folder, Path) else _in_memory(name, source.folder)
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise TableFault(say("fault.V097", name=name)) from error
    except (OSError, ValueError) as error:
        if isinstance(error, TableFault):
            raise
        reason = reason_of(error)
        raise TableFault(say("fault.V098", name=name, reason=reason)) from error


def _is_inside(name: str, folder: Path | Mapping[str, bytes]) -> bool:
    """Return whether a table lies in the folder of its variant, or would if the variant were a file."""
    if isinstance(folder, Path):
        return led_to(folder / name).is_relative_to(led_to(folder))
    return not posixpath.normpath(name).startswith(("../", "/"))


def _in_memory(name: str, tables: Mapping[str, bytes]) -> bytes:
    if name not in tables:
        known = say("hint.there_is", known=tuple(sorted(tables))) if tables else ""
        raise TableFault(say("fault.V090", name=name, known=known))
    _require_size(name, len(tables[name]))
    return tables[name]


def _on_disk(name: str, folder: Path) -> bytes:
    file = led_to(folder / name)
    if not file.is_file():
        raise TableFault(say("fault.V139" if file.exists() else "fault.V092", name=name))
    _require_size(name, file.stat().st_size)
    with file.open("rb") as opened:
        content = opened.read(MAX_TABLE_BYTES + 1)
    _require_size(name, len(content))
    return content


def _require_size(name: str, size: int) -> None:
    if size > MAX_TABLE_BYTES:
        raise TableFault(say("fault.V093", name=name, size=size, max_table_bytes=MAX_TABLE_BYTES))


def _rows(name: str, text: str) -> Rows:
    """Return (argument, value) of each line; a first line of words is a header."""
    rows: list[tuple[float, float]] = []
    printed: list[str] = []
    lines: list[int] = []
    for number, line in enumerate(text.splitlines(), start=1):
        found = _LINE.fullmatch(line)
        if found is None:
            if not line.strip(" ,\t"):
                continue
            if number == 1 and not any(map(_CELL.fullmatch, line.split(","))):
                _require_si(name, line)
                continue
            raise TableFault(say("fault.V099", name=name, number=number))
        argument, value = float(found[1]), float(found[2])
        if not (math.isfinite(argument) and math.isfinite(value)):
            raise TableFault(say("fault.V100", name=name, number=number))
        rows.append((argument, value))
        printed.append(found[1])
        lines.append(number)
    if len(rows) > MOST_NODES:
        raise TableFault(say("fault.V094", name=name, count=len(rows), most_nodes=MOST_NODES))
    if len(rows) < _FEWEST_NODES:
        raise TableFault(say("fault.V095", name=name, fewest_nodes=_FEWEST_NODES, count=len(rows)))
    arguments = np.array([row[0] for row in rows])
    steps = np.diff(arguments)
    place = int(steps.argmin()) + 1
    if steps[place - 1] <= 0:
        later, earlier = rows[place][0], rows[place - 1][0]
        raise TableFault(say("fault.V096", name=name, lines=lines[place], later=later, earlier=earlier))
    if _is_uneven(arguments, printed):
        usual = float(np.sort(steps)[len(steps) // 2])
        odd = int(np.abs(steps - usual).argmax())
        raise TableFault(say("fault.V137", name=name, lines=lines[odd + 1], steps=float(steps[odd]), usual=usual))
    return tuple(rows)


def _require_si(name: str, header: str) -> None:
    """Raise `TableFault` if a header gives a unit other than the SI unit in which the numbers are read."""
    for unit in _UNIT.findall(header):
        size, si = UNITS.get(plain_unit(unit), (1, ""))
        if size != 1:
            raise TableFault(say("fault.V138", name=name, unit=unit, si=advised_unit(si)))


def _is_uneven(arguments: Array, printed: list[str]) -> bool:
    """Return whether a node is off its even place by more than its printed digits explain.

    An argument may be rounded by half a unit of its last digit, its even place by half a unit of the last digits of the first
    and last arguments.
    """
    even = (arguments[-1] - arguments[0]) / (len(arguments) - 1)
    off = np.abs(arguments - arguments[0] - np.arange(len(arguments)) * even)
    if np.all(off <= _EXACT * even):
        return False
    units = np.array([last_place(number) for number in printed])
    rounded = (units + max(units[0], units[-1])) / 2 * (1 + _EXACT)
    return bool(np.any(off > np.maximum(_EXACT * even, np.minimum(rounded, _ROUNDED * even))))
