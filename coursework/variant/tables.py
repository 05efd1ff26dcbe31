"""A tabulated law beside a variant file: two columns of a CSV inside the file's own folder.

Enters: the name of the table.  Leaves: rows of (argument, value).  Used by `reader.py`.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Mapping
from pathlib import Path

from coursework.errors import Fault
from coursework.sentences import Sentence, say
from coursework.variant.source import Source

MAX_TABLE_BYTES = 256 * 1024
MOST_NODES = 20_000
_FEWEST_NODES = 5  # the five-point formulas need five
# A node off its even place by a part of the step falsifies the slopes about it by the same part.  Nodes as a program computed
# them lie within the first, and those of a print whose arguments have digits enough within the second.
_EXACT, _ROUNDED = 1e-6, 1e-3
_NUMBER = re.compile(r"\s*[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*", re.ASCII)
Rows = tuple[tuple[float, float], ...]


class TableFault(ValueError):
    """A table cannot be used; the sentence says which line and why."""

    def __init__(self, message: Sentence) -> None:
        super().__init__(message)
        self.message = message


def read_table(name: str, source: Source, path: tuple[str | int, ...], faults: list[Fault]) -> Rows:
    """Return the rows of a table; a fault is added to `faults` and an empty table returned."""
    try:
        return _rows(name, _text(name, source))
    except TableFault as fault:
        faults.append(source.fault(path, fault.message))
        return ()


def _text(name: str, source: Source) -> str:
    if not name.lower().endswith(".csv"):
        raise TableFault(say("fault.V089"))
    try:
        raw = _on_disk(name, source.folder) if isinstance(source.folder, Path) else _in_memory(name, source.folder)
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise TableFault(say("fault.V097", name=name)) from error
    except (OSError, ValueError) as error:
        if isinstance(error, TableFault):
            raise
        reason = getattr(error, "strerror", None) or str(error)
        raise TableFault(say("fault.V098", name=name, reason=reason)) from error


def _in_memory(name: str, tables: Mapping[str, bytes]) -> bytes:
    if name not in tables:
        known = say("hint.there_is", known=tuple(sorted(tables))) if tables else ""
        raise TableFault(say("fault.V090", name=name, known=known))
    _require_size(name, len(tables[name]))
    return tables[name]


def _on_disk(name: str, folder: Path) -> bytes:
    file = (folder / name).resolve()
    if not file.is_relative_to(folder.resolve()):
        raise TableFault(say("fault.V091", name=name))
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
    """Return (argument, value) of each line; a first line of words is the header."""
    rows: list[tuple[float, float]] = []
    lines: list[int] = []
    units: list[float] = []
    for number, line in enumerate(text.splitlines(), start=1):
        cells = [cell.strip().strip('"') for cell in line.split(",")]
        if not line.strip(" ,\t") or (number == 1 and not any(map(_NUMBER.fullmatch, cells))):
            continue
        if len(cells) != 2 or not all(map(_NUMBER.fullmatch, cells)):
            raise TableFault(say("fault.V099", name=name, number=number))
        rows.append((float(cells[0]), float(cells[1])))
        lines.append(number)
        units.append(_last_place(cells[0]))
        if not all(map(math.isfinite, rows[-1])):
            raise TableFault(say("fault.V100", name=name, number=number))
    if len(rows) > MOST_NODES:
        raise TableFault(say("fault.V094", name=name, count=len(rows), most_nodes=MOST_NODES))
    if len(rows) < _FEWEST_NODES:
        raise TableFault(say("fault.V095", name=name, fewest_nodes=_FEWEST_NODES, count=len(rows)))
    steps = [later[0] - earlier[0] for earlier, later in itertools.pairwise(rows)]
    place = steps.index(min(steps)) + 1
    if min(steps) <= 0:
        later, earlier = rows[place][0], rows[place - 1][0]
        raise TableFault(say("fault.V096", name=name, lines=lines[place], later=later, earlier=earlier))
    _refuse_uneven(name, [row[0] for row in rows], units, lines)
    return tuple(rows)


def _last_place(number: str) -> float:
    """Return the place of the last digit of a printed number: 0.01 of "1.25", 100 of "3e2"."""
    digits, _, exponent = number.lower().partition("e")
    return math.pow(10.0, max(-300.0, min(float(exponent or 0) - len(digits.partition(".")[2]), 300.0)))


def _refuse_uneven(name: str, arguments: list[float], units: list[float], lines: list[int]) -> None:
    """Raise `TableFault` for a node that is off its even place by more than its printed digits explain.

    `units` are the places of the last printed digits: an argument is rounded by half of its own, and its even place by
    half of the first one's and the last one's.
    """
    first, even = arguments[0], (arguments[-1] - arguments[0]) / (len(arguments) - 1)
    ends = max(units[0], units[-1])
    for place, (argument, unit) in enumerate(zip(arguments, units, strict=True)):
        rounded = (unit + ends) / 2 * (1 + _EXACT)
        if abs(argument - first - place * even) > max(_EXACT * even, min(rounded, _ROUNDED * even)):
            steps = [later - earlier for earlier, later in itertools.pairwise(arguments)]
            usual = sorted(steps)[len(steps) // 2]
            odd = max(range(len(steps)), key=lambda place: abs(steps[place] - usual))
            raise TableFault(say("fault.V137", name=name, lines=lines[odd + 1], steps=steps[odd], usual=usual))
