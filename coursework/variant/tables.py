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


def read_table(name: str, source: Source, path: tuple[str | int, ...], faults: list[Fault]) -> Rows:
    """Return the rows of a table; a fault is added to `faults` and an empty table returned."""
    try:
        return _rows(name, _text(name, source))
    except TableFault as fault:
        faults.append(source.fault(path, str(fault)))
        return ()


def _text(name: str, source: Source) -> str:
    if not name.lower().endswith(".csv"):
        raise TableFault('a table is a CSV file: "NAME.csv" beside the variant file was expected.')
    try:
        raw = _on_disk(name, source.folder) if isinstance(source.folder, Path) else _in_memory(name, source.folder)
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise TableFault(f'the table "{name}" is not UTF-8 text. Save it as "CSV UTF-8".') from error
    except (OSError, ValueError) as error:
        if isinstance(error, TableFault):
            raise
        raise TableFault(f'the table "{name}" cannot be read: {getattr(error, "strerror", None) or error}.') from error


def _in_memory(name: str, tables: Mapping[str, bytes]) -> bytes:
    if name not in tables:
        known = f" There are: {', '.join(sorted(tables))}." if tables else ""
        raise TableFault(f'the table "{name}" is not among the files beside the variant.{known}')
    _require_size(name, len(tables[name]))
    return tables[name]


def _on_disk(name: str, folder: Path) -> bytes:
    file = (folder / name).resolve()
    if not file.is_relative_to(folder.resolve()):
        raise TableFault(f'the table "{name}" lies outside the folder of the variant. Put it beside the variant file.')
    if not file.is_file():
        raise TableFault(f'there is no file "{name}" in the folder of the variant.')
    _require_size(name, file.stat().st_size)
    with file.open("rb") as opened:
        content = opened.read(MAX_TABLE_BYTES + 1)
    _require_size(name, len(content))
    return content


def _require_size(name: str, size: int) -> None:
    if size > MAX_TABLE_BYTES:
        raise TableFault(f'the table "{name}" has {size} bytes; at most {MAX_TABLE_BYTES} are read.')


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
            message = "two numbers with a comma between were expected, decimals with a point"
            raise TableFault(f"{name}:{number}: {message}.")
        rows.append((float(cells[0]), float(cells[1])))
        lines.append(number)
        units.append(_last_place(cells[0]))
        if not all(map(math.isfinite, rows[-1])):
            raise TableFault(f"{name}:{number}: finite numbers were expected.")
    if len(rows) > MOST_NODES:
        raise TableFault(f"{name}: {len(rows)} nodes; at most {MOST_NODES} are read.")
    if len(rows) < _FEWEST_NODES:
        raise TableFault(f"{name}: at least {_FEWEST_NODES} nodes were expected (the five-point formulas), found {len(rows)}.")
    steps = [later[0] - earlier[0] for earlier, later in itertools.pairwise(rows)]
    place = steps.index(min(steps)) + 1
    if min(steps) <= 0:
        found = f"{rows[place][0]:g} after {rows[place - 1][0]:g}"
        raise TableFault(f"{name}:{lines[place]}: the arguments must grow from line to line, found {found}.")
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
            raise TableFault(
                f"{name}:{lines[odd + 1]}: the arguments must be equally spaced, found a step of {steps[odd]:.9g} "
                f"where {usual:.9g} is usual."
            )
