"""A table that begins elsewhere than the task says: compared with Euler's table from the student's own start values.

Enters: marked cells.  Leaves: the same cells marked against that table.  Where the geometry gives some starts, one datum or one
start changes the others, and is told alone.
Used by `misconceptions.py`, `claims.py` and `step_lengths.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.guesses import agreed
from coursework.grading.marking.table.cells import GIVEN, Cells, mark_cells
from coursework.grading.marking.table.ways import HALF, KEY, StudentTable, as_printed, near, own_ways
from coursework.motion.geometry.start import start_values
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.entries import Given
from coursework.words.errors import CourseworkError

# A start that is not printed must explain this part of all cells more than the task's start does.
_MORE = 0.1
# A start that only velocities tell must explain this part of all cells; it is taken with as few decimals as give them.
_NEARLY_ALL = 0.9
_DECIMALS = range(1, 9)
# So many rows are stepped back to row 2, and so many must say the same of it.
_BACK, _AGREE = 8, 2
_WRONG_OF_ROW = 0.5  # of the velocities of row 1 at most this part may be wrong
_ROUNDS, _DIFFERENCE = 6, 1e-4  # Newton steps to a datum, and the part of it by which its slope is taken


@frozen
class OwnStart:
    """A table marked as if the task began at its start: its `cells`, and the `names` of the starts that are not the task's.

    Starts that the geometry gives are not named if they follow from another start or from a `datum` with another value.
    """

    cells: Cells
    names: tuple[str, ...]
    datum: str = ""

    @property
    def cause(self) -> str:
        """Return the code of the cause."""
        return f"datum_{self.datum}" if self.datum else f"start_{self.names[0]}"


def begins_elsewhere(key: Key, cells: Cells) -> bool:
    """Return whether row 1 has a start value that is not the task's."""
    return bool(cells.wrong[0, : key.m].any())


def own_start(key: Key, cells: Cells) -> OwnStart | None:
    """Return the table marked from its own start, None if that is the task's or row 1 does not follow from it.

    The start may be what row 1 prints, or what stood there before it was put right or misprinted, or what the velocities of
    row 1 tell; single values may be the task's. The start that makes most cells right is taken.
    """
    m, student = key.m, cells.student
    to_print = HALF * (np.nan_to_num(student.units[0, :m]) + key.told_to)
    least = int((cells.marks == KEY).sum() + _MORE * cells.marks.size)
    best, most = None, -1
    for start in _starts(key, cells):
        in_print = near(student.values[0, :m], start, to_print).all()
        made = _marked_from(key, cells, start, most + 1 if in_print else max(least, most + 1))
        if made and (count := int((made.marks == KEY).sum())) > most and (in_print or count >= least):
            best, most = (start, made), count
    for start in _told_by_velocities(key, cells):
        made = _marked_from(key, cells, start, most + 1)
        of_both = 0.0 if made is None else ((made.marks == KEY) | (cells.marks == KEY))[cells.counted].mean()
        if made and of_both >= _NEARLY_ALL and (count := int((made.marks == KEY).sum())) > most:
            best, most = (start, made), count
    if best is None:
        return None
    start, made = best
    task = key.table[0, : len(start)]
    names = tuple(key.coordinates[place] for place in np.flatnonzero(start != task).tolist())
    one = _one_number(key, start, 2 * to_print) if len(names) > 1 else ""
    if one and one not in names:
        return OwnStart(made, (), one)
    return OwnStart(made, (one,) if one else names)


def _one_number(key: Key, start: Array, within: Array) -> str:
    """Return the coordinate or datum from another value of which the starts (m,) follow, up to `within`; "" if there is none.

    The rows follow from the start with the task's velocities: they must not depend on such a datum.
    """
    given = [place for place, one in enumerate(key.variant.coordinates) if one.start is not None]
    if len(given) == len(start):
        return ""
    other = np.flatnonzero(np.abs(start - key.table[0, : len(start)]) > within)
    changed = [place for place in given if place in other]
    if len(changed) == 1 and _is_near(_closed(key, {}, {changed[0]: float(start[changed[0]])}), start, within):
        return key.coordinates[changed[0]]
    if changed:
        return ""
    task = _closed(key, {}, {})
    for datum in _felt_by_none(key):
        value, at, slope = datum.value, task, 0.0
        for _ in range(_ROUNDS):
            beside = _closed(key, {datum.name: value * (1 + _DIFFERENCE)}, {})
            if at is None or beside is None or not (slope := float(np.sum((beside - at)[other] ** 2))):
                break
            value += value * _DIFFERENCE * float(np.dot((beside - at)[other], (start - at)[other])) / slope
            at = _closed(key, {datum.name: value}, {})
        if slope and _is_near(at, start, within):
            return datum.name
    return ""


def _felt_by_none(key: Key) -> list[Given]:
    """Return the data of which no velocity depends."""
    q = key.table[:, : key.m]
    given = key.variant.given
    task, *others = key.sets_at(key.t, q, [{}, *({one.name: one.value * (1 + _DIFFERENCE)} for one in given)])
    return [one for one, found in zip(given, others, strict=True) if np.array_equal(found, task, equal_nan=True)]


def _closed(key: Key, data: dict[str, float], starts: dict[int, float]) -> Array | None:
    """Return the closed starts (m,) with other data and other given starts, None if nothing closes."""
    variant = key.variant
    other = replace(
        variant,
        given=tuple(replace(one, value=data.get(one.name, one.value)) for one in variant.given),
        coordinates=tuple(replace(one, start=starts.get(place, one.start)) for place, one in enumerate(variant.coordinates)),
    )
    with suppress(CourseworkError, ArithmeticError, ValueError):
        return np.array(start_values(replace(key.model.equations, variant=other)))
    return None


def _is_near(made: Array | None, start: Array, within: Array) -> bool:
    return made is not None and bool(np.all(np.abs(made - start) <= within))


def _starts(key: Key, cells: Cells) -> list[Array]:
    """Return the starts (m,), other than the task's, from which a table may have been made."""
    m, values, task = key.m, cells.student.values[0], key.table[0, : key.m]
    found = []
    for table in (cells.before, cells.student, _stepped_back(key, cells)):
        if table is not None:
            start, units = table.values[0, :m], table.units[0, :m]
            is_printed = start == values[:m]
            other = np.abs(start - task) > np.where(is_printed, HALF, 1.0) * (units + key.told_to)
            found.append(np.where(other, np.where(is_printed, start, _as_typed(start, units)), task))
            start = found[-1]
            found += [np.where(np.arange(m) == place, start, task) for place in np.flatnonzero(other)]
    return [start for start in np.unique(found, axis=0) if (start != task).any()]


def _stepped_back(key: Key, cells: Cells) -> StudentTable | None:
    """Return the table with starts from which row 2 was made, where its step from row 1 is broken; None if none is.

    Row 2 was what most of the next rows say, each of them stepped back to it: it may be a misprint, or put right.
    """
    m, student, h = key.m, cells.student, key.stride
    q, rates, units = (rows[1 : 1 + _BACK] for rows in (student.values[:, :m], student.values[:, m : 2 * m], student.units))
    told = q - h * (np.cumsum(rates, axis=0) - rates)
    open_by = HALF * np.cumsum(units[:, :m] + h * units[:, m : 2 * m], axis=0)
    own_units = student.units[1, :m] + h * student.units[0, m : 2 * m]
    with np.errstate(invalid="ignore"):
        agree = (np.abs(told[:, None] - told) <= open_by[:, None] + open_by).sum(axis=1)
        row = np.take_along_axis(told, agree.argmax(axis=0)[None], axis=0)[0]
        off = np.abs(row - student.values[0, :m] - h * student.values[0, m : 2 * m])
    broken = (agree.max(axis=0) >= _AGREE) & (off > own_units)
    if not broken.any():
        return None
    values, units = student.values.copy(), student.units.copy()
    for _ in range(8):  # until it begins with its own velocities: the printed ones may have been put right
        values[0, :m][broken] = (row - h * key.velocities_at(key.t[:1], values[:1, :m])[0, :m])[broken]
    units[0, :m] = np.where(broken, own_units, units[0, :m])
    return replace(student, values=values, units=units)


def _as_typed(told: Array, within: Array) -> Array:
    """Return values with as few decimals as leave them `within` so much of what was told: a start is typed with few.

    >>> _as_typed(np.array([1.6156, 3.43681]), np.array([0.01, 1e-5])).tolist()
    [1.62, 3.43681]
    """
    found = told.copy()
    for decimals in reversed(_DECIMALS):
        rounded = np.round(told, decimals)
        found = np.where(np.abs(rounded - told) <= within, rounded, found)
    return found


def _told_by_velocities(key: Key, cells: Cells) -> Iterator[Array]:
    """Yield a start (m,) with one value more that is not the task's, where the velocities of row 1 follow from it alone."""
    m, student = key.m, cells.student
    if not cells.wrong[0, m:].any():
        return
    start = np.where(cells.wrong[0, :m], student.values[0, :m], key.table[0, :m])
    put = np.zeros_like(cells.wrong)
    put[0, :m] = ~cells.wrong[0, :m] & ~cells.missing[0, :m]
    tolerance = as_printed(key, student.units)[0, m:]
    for table, _ in agreed(key, student, own_ways(key, student), cells.wrong, put):
        told = np.isfinite(table[0, :m])
        for decimals in _DECIMALS:
            other = np.where(told, np.round(table[0, :m], decimals), start)
            made = key.velocities_at(key.t[:1], other[None])[0]
            if (near(student.values[0, m:], made, tolerance) | ~cells.wrong[0, m:]).all():
                yield other
                break


def _marked_from(key: Key, cells: Cells, start: Array, least: int) -> Cells | None:
    """Return the table marked from a start, None if row 1 mostly does not follow from it or too few cells (`least`) can be its.

    A velocity of row 1 with a slip costs what it costs in any other row.
    """
    m, table = key.m, march(key, start, key.velocities_at)
    units = cells.student.units.copy()
    units[:, :m] = np.maximum(units[:, :m], own_ways(key, cells.student).coarse)
    if (near(cells.student.values, table, as_printed(key, units)) | (cells.marks == KEY)).sum() < least:
        return None
    made = mark_cells(key, cells.student, table)
    made.marks[:1, :m][cells.marks[:1, :m] == GIVEN] = GIVEN
    made.marks[(made.wrong | made.carried) & (cells.marks == KEY)] = KEY
    return None if made.wrong[0, m:].mean() > _WRONG_OF_ROW else made


def march(
    key: Key,
    start: Array,
    velocities_at: Callable[[Array, Array], Array],
    increments: Callable[[Array, Array, Array], Array] | None = None,
) -> Array:
    """Return a table (n, m + r) from a start (m,) with the velocities of a function; NaN from where these have no value.

    `increments` (t, q, velocities) gives the steps of the coordinates; Euler's if None.
    """
    m, step = key.m, key.step
    rows = np.full(key.table.shape, np.nan)
    q = np.asarray(start, dtype=float)[None]
    for place in range(len(rows)):
        t = np.array([place * step])
        w = velocities_at(t, q)
        rows[place, :m], rows[place, m:] = q[0], w[0]
        if not np.isfinite(w).all():
            rows[place] = np.nan
            break
        q = q + (step * w[:, :m] if increments is None else increments(t, q, w))
    return rows
