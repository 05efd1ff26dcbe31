"""A table in which angles are counted clockwise: recognised, and turned back so that its signs are the task's.

Enters: a `Key`, a student's table.  Leaves: the table turned back, None if it is not clockwise.
Used by `hypotheses.py`, `grade.py`, `precheck.py`.
Signs alone do not tell a mirrored motion from a drive with the opposite sign: the values decide.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells, alike, mark_cells
from coursework.grading.marking.table.ways import ANGLES, EARLIER, KEY, StudentTable
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags

# The first rows, by which it is judged in which sense a table begins to turn.
_BEGINNING = 5
# Where this part of a column is right only when turned back, its other cells may have been put right; less is chance.
_TURNED = 0.1
# A mirrored motion must explain this part of the velocities.
_EXPLAINED = 0.93


def turned(key: Key, student: StudentTable) -> StudentTable | None:
    """Return the table with the signs of the task if it may be clockwise, right or wrong; None if nothing suggests that.

    Either all angular velocities have the opposite sign and the angles move against them, or the table begins to turn in the
    opposite sense with the angles mirrored too.
    """
    m, angular = key.m, _angular(key)
    values = student.values
    steps = np.diff(values[:, :m], axis=0)
    with np.errstate(invalid="ignore"):
        steps[~(np.abs(steps) > student.units[1:, :m])] = np.nan
    against = np.hstack([_opposite(steps, values[:-1, m : 2 * m]), _opposite(values[:, 2 * m :], key.table[:, 2 * m :])])
    if (against * angular[m:] >= 0).all() and (against[:m] * angular[:m]).any():
        return _turned(key, student, angular | _with_points(against, angular, m), mirrored=False)
    begins = slice(_BEGINNING)
    against = _opposite(values[begins, m:], key.table[begins, m:])
    if against[angular[m:]].sum() <= 0:
        return None
    back = _turned(key, student, angular | _with_points(against, angular, m), mirrored=True)
    return back if _explained(key, mark_cells(key, back)) >= _by_drive(key, mark_cells(key, student)) else None


def turned_back(key: Key, student: StudentTable) -> StudentTable | None:
    """Return a clockwise table with the signs of the task, None where it is none, or where it is too wrong to tell."""
    back = turned(key, student)
    if back is None:
        return None
    plain, cells = mark_cells(key, student), mark_cells(key, back)
    follows = _explained(key, cells)
    is_told = follows >= _EXPLAINED and follows >= _by_drive(key, plain)
    return back if is_told and cells.wrong.sum() < plain.wrong.sum() else None


def _by_drive(key: Key, cells: Cells) -> float:
    """Return the part of the velocities that a drive with the opposite sign explains, 0 if an angle begins mirrored.

    Such a drive explains its own table better than the convention does.  If both give the same numbers, as in a train of wheels,
    they cannot be told apart, and the convention is believed.
    """
    m, student, other = key.m, cells.student, key.misread("sign_drive")
    if other is None or _begins_mirrored(key, student):
        return 0.0
    allowed = np.fmax.reduce([way.tolerance[:, m:] for way in cells.ways])
    with np.errstate(invalid="ignore"):
        return _part(np.abs(student.values[:, m:] - other(key.t, student.values[:, :m])) <= allowed, ~cells.missing[:, m:])


def _angular(key: Key) -> Flags:
    """Return which columns (m + r,) are angles or angular velocities."""
    return np.array([key.variant.unit_of(name) in {"rad", "rad/s"} for name in key.names])


def _with_points(against: Array, angular: Flags, m: int) -> Flags:
    """Return the velocities of points (m + r,) if all of them are opposite too: then every velocity has the other sign."""
    points = ~angular & (np.arange(len(angular)) >= m)
    return points & bool((against[points[m:]] > 0).all())


def _turned(key: Key, student: StudentTable, signs: Flags, *, mirrored: bool) -> StudentTable:
    """Return a table with other `signs` (m + r,) of velocities; if `mirrored`, of angles too, about their first value.

    A cell that is right as it stands was put right in the table handed in, and stays, where others of its column are right only
    when turned back: however many there are of each, as one more becomes right no other one goes.
    """
    m, angular = key.m, _angular(key)[: key.m]

    def back(values: Array) -> Array:
        found = values.copy()
        found[:, m:][:, signs[m:]] *= -1
        if mirrored:
            found[:, :m] = np.where(angular, _start(key, values[0, :m]) - (values[:, :m] - values[0, :m]), values[:, :m])
        return found

    own = student.own and replace(student.own, values=back(student.own.values))
    undone = replace(student, values=back(student.values), own=own)
    right, as_turned = (alike(key, table, key.table) for table in (student, undone))
    put = right & ~as_turned & ((as_turned & ~right).mean(axis=0) >= _TURNED)
    return replace(undone, values=np.where(put, student.values, undone.values))


def _start(key: Key, first: Array) -> Array:
    """Return the first values (m,) as they are after turning back: those near the negative start are moved to the start."""
    start = key.table[0, : len(first)]
    near = _whole_turns_off(first - start) < _whole_turns_off(first + start)
    return np.where(near, first, start - _rest(first + start))


def _begins_mirrored(key: Key, student: StudentTable) -> bool:
    """Return whether an angle begins at the negative of the task's start, and not at the start itself."""
    first, start = student.values[0, : key.m], key.table[0, : key.m]
    allowed = student.units[0, : key.m]
    with np.errstate(invalid="ignore"):
        away = (_whole_turns_off(first - start) > allowed) & (_whole_turns_off(first + start) <= allowed)
    return bool((away & _angular(key)[: key.m]).any())


def _rest(angle: Array) -> Array:
    return np.asarray(angle - whole_turns(angle))


def _whole_turns_off(angle: Array) -> Array:
    return np.abs(_rest(angle))


def _opposite(printed: Array, reference: Array) -> Array:
    """Return for each column how many more numbers have the opposite sign of the reference than the same sign."""
    with np.errstate(invalid="ignore"):
        return np.asarray(-np.nansum(np.sign(printed) * np.sign(reference), axis=0))


def _explained(key: Key, cells: Cells) -> float:
    """Return the part of the velocities that follow from the key or from the table's own cells."""
    return _part(np.isin(cells.marks[:, key.m :], (KEY, ANGLES, EARLIER)), ~cells.missing[:, key.m :])


def _part(holds: Flags, of: Flags) -> float:
    return float((holds & of).sum()) / float(of.sum()) if of.any() else 0.0
