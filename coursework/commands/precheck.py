"""`coursework precheck`: how files would be read and whether they contradict themselves; no number of the key is shown.

Enters: paths, perhaps a variant.  Leaves: lines on the screen; 0 where every part could be marked, else 1.
"""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from coursework.api import load
from coursework.errors import InputError
from coursework.grading.contents import Contents
from coursework.grading.expected import Expected, grid_of
from coursework.grading.handed_in import collect_files
from coursework.grading.marking.cells import Cells, mark_cells
from coursework.grading.marking.grade import student_of
from coursework.grading.marking.key import Key
from coursework.grading.marking.points import true_steps
from coursework.grading.marking.reference import key_of
from coursework.grading.understand import understand
from coursework.sentences import say


def precheck_files(files: tuple[Path, ...], variant: str | None) -> int:
    """Return the exit status of looking at some files."""
    chosen = variant or next((str(path) for path in files if path.suffix == ".toml"), None)
    if chosen is None:
        raise InputError(say("fault.C028"))
    key = key_of(load(chosen))
    grid = grid_of(key.variant, {name: tuple(key.table[:, place].tolist()) for place, name in enumerate(key.names)})
    contents = understand(collect_files(files), Expected(grid, key.variant))
    for entry in contents.files:
        click.echo(f"{entry.name}: {entry.kind}, {entry.bytes} bytes")
    fine = _tell_table(key, contents)
    fine &= _tell_equations(contents)
    for found in contents.notes:
        click.echo(f"  {found.text}")
    return 0 if fine else 1


def _tell_table(key: Key, contents: Contents) -> bool:
    if contents.table is None:
        reason = contents.trouble.text if contents.trouble else ""
        click.echo(f"Table: not read. {reason}")
        return False
    table = contents.table
    reading = table.reading
    click.echo(
        f'Table in {reading.file}: {reading.encoding}, cells separated by "{reading.separator}", decimal mark "{reading.decimal}"'
        f"{', turned' if reading.transposed else ''}."
    )
    for column in table.columns:
        told = "its head" if column.by == "header" else "its place"
        click.echo(f"  {column.name:<8} column {column.at}, told by {told}, {column.unit}, {column.decimals} decimals")
    missing = [name for name in key.names if table.column(name) is None]
    if missing:
        click.echo(f"  Missing columns: {', '.join(missing)}.")
    click.echo(f"  Rows: {sum(table.rows_present)} of {len(key.table)}. At least {key.least_decimals} decimals are asked for.")
    cells = mark_cells(key, student_of(key, table))
    coarse = int(cells.too_coarse.sum())
    if coarse:
        click.echo(f"  {coarse} cells have too few decimals to be marked.")
    _tell_steps(key, cells)
    return not missing and not coarse and all(table.rows_present) and not cells.missing.any()


def _tell_steps(key: Key, cells: Cells) -> None:
    """Say the first row whose angles do not follow from the row before by Euler's rule."""
    m = len(key.coordinates)
    values = cells.student.values
    speaks = np.isfinite(values[1:, :m]) & np.isfinite(values[:-1, :m]) & np.isfinite(values[:-1, m : 2 * m])
    against = speaks & ~true_steps(key, cells)
    if not against.any():
        click.echo("  Every step of the angles follows from your own row before.")
        return
    row = int(np.argmax(against.any(axis=1)))
    place = int(np.argmax(against[row]))
    name, rate = key.names[place], key.velocities[place]
    before, speed = values[row, place], values[row, m + place]
    after, found = before + key.step * speed, values[row + 1, place]
    click.echo(
        f"  Row {row + 2}: {name} does not follow from your own row {row + 1} and its {rate}: "
        f"{before:.6g} + {key.step:g}·({speed:.6g}) = {after:.6g}, but {found:.6g} stands there."
    )


def _tell_equations(contents: Contents) -> bool:
    if contents.equations is None:
        click.echo("Equations: none handed in.")
        return True
    unread = [line for line in contents.equations if line.left is None]
    click.echo(f"Equations: {len(contents.equations)} lines, {len(unread)} that cannot be read.")
    for line in contents.equations:
        if line.left is None:
            click.echo(f"  line {line.line}: {line.fault.message if line.fault else 'not an equation'}")
        elif line.repaired:
            click.echo(f"  line {line.line} is read as {line.repaired}")
    return not unread
