"""A tabulated law beside a variant file: two columns of a CSV inside the file's own folder.

Enters: the name of the table.  Leaves: rows of (argument, value).  Used by `reader.py`.
"""

from __future__ import annotations

import csv
import itertools
import math

from coursework.errors import Fault
from coursework.variant.source import Source

MAX_TABLE_BYTES = 256 * 1024
_FEWEST_NODES = 5  # the five-point formulas need five


def read_table(name: str, source: Source, path: tuple[str | int, ...], faults: list[Fault]) -> tuple[tuple[float, float], ...]:
    """Return the rows of a table; every fault is added to `faults` and an empty table returned."""

    def say(message: str) -> tuple[tuple[float, float], ...]:
        faults.append(source.fault(path, message))
        return ()

    if source.folder is None:
        return say("a table can be read only beside a variant file on disk.")
    folder = source.folder.resolve()
    file = (folder / name).resolve()
    if not file.is_relative_to(folder) or not file.is_file() or file.stat().st_size > MAX_TABLE_BYTES:
        return say(f'the table "{name}" is not a file of at most {MAX_TABLE_BYTES} bytes inside the variant\'s folder.')
    rows: list[tuple[float, float]] = []
    try:
        lines = list(csv.reader(file.read_text(encoding="utf-8-sig").splitlines()))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        return say(f'the table "{name}" cannot be read: {error}.')
    for number, cells in enumerate(lines[1:], start=2):
        if not any(cell.strip() for cell in cells):
            continue
        try:
            argument, value = (float(cell) for cell in cells)
        except ValueError:
            return say(f'{name}:{number}: two numbers were expected, found "{",".join(cells)[:60]}".')
        if not (math.isfinite(argument) and math.isfinite(value)):
            return say(f"{name}:{number}: a finite number was expected.")
        rows.append((argument, value))
    if len(rows) < _FEWEST_NODES:
        return say(f"{name}: {len(rows)} nodes; the five-point formulas need at least {_FEWEST_NODES}.")
    steps = [later[0] - earlier[0] for earlier, later in itertools.pairwise(rows)]
    if min(steps) <= 0:
        return say(f"{name}: the arguments must grow from row to row (row {steps.index(min(steps)) + 3} does not).")
    if max(steps) - min(steps) > 1e-6 * max(steps):
        return say(f"{name}: the arguments must be equally spaced (steps from {min(steps):g} to {max(steps):g}).")
    return tuple(rows)
