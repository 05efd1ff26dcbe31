"""A table in which angles are counted clockwise: recognised, and turned back so that its signs are the task's.

Enters: a `Key`, a student's table.  Leaves: the table turned back, None if it is not clockwise.
Used by `hypotheses.py`, `grade.py`, `precheck.py`.
Signs alone do not tell a mirrored motion from a drive with the opposite sign: the values decide.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells, mark_cells
from coursework.grading.marking.table.ways import ANGLES, EARLIER, KEY, LEAST, StudentTable
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags

# In every column this part of the cells with a sign must have the opposite one; the others may be slips.
_SIGNS = 0.9
# A mirrored motion must explain this part of the velocities.
_EXPLAINED = 0.93


def turned_back(key: Key, student: StudentTable) -> StudentTable | None:
    """Return a clockwise table with the signs of the task, None if it is not clockwise.

    Either all angular velocities have the opposite sign while the angles move as the key's, or the angles are mirrored too.
    """
    m = len(key.coordinates)
    if not _opposite(student.values[:, m:], key.table[:, m:], key, _angular(key)[m:]):
        return None
    plain = mark_cells(key, student)
    turned = _turned(key, student, mirrored=False)
    reference = key.velocities_at(key.t, turned.values[:, :m])
    if _steps_agree(key, turned, reference) and _opposite(student.values[:, m:], reference, key, _angular(key)[m:]):
        return turned if mark_cells(key, turned).wrong.sum() < plain.wrong.sum() else None
    mirrored = _turned(key, student, mirrored=True)
    cells = mark_cells(key, mirrored)
    follows = _explained(key, cells)
    # A drive with the opposite sign explains its own table as well, and better.  If both give the same numbers, as in a train of
    # wheels, they cannot be told apart, and the convention is believed.
    other = key.misread("sign_drive")
    driven = np.abs(student.values[:, m:] - other(key.t, student.values[:, :m])) if other else None
    by_drive = 0.0
    if driven is not None and not _begins_mirrored(key, student):
        allowed = np.fmax.reduce([way.tolerance[:, m:] for way in plain.ways])
        with np.errstate(invalid="ignore"):
            by_drive = _part(driven <= allowed, ~cells.missing[:, m:])
    return mirrored if follows >= _EXPLAINED and follows >= by_drive and cells.wrong.sum() < plain.wrong.sum() else None


def _angular(key: Key) -> Flags:
    """Return which columns (m + r,) are angles or angular velocities."""
    return np.array([key.variant.unit_of(name) in {"rad", "rad/s"} for name in key.names])


def _turned(key: Key, student: StudentTable, *, mirrored: bool) -> StudentTable:
    """Return a table with the sign of angular velocities changed; if `mirrored`, the angles too, about their first value."""
    m, angular = len(key.coordinates), _angular(key)

    def back(values: Array) -> Array:
        found = values.copy()
        found[:, m:][:, angular[m:]] *= -1
        if mirrored:
            found[:, :m] = np.where(angular[:m], _start(key, values[0, :m]) - (values[:, :m] - values[0, :m]), values[:, :m])
        return found

    own = student.own and replace(student.own, values=back(student.own.values))
    return replace(student, values=back(student.values), own=own)


def _start(key: Key, first: Array) -> Array:
    """Return the first values (m,) as they are after turning back: those near the negative start are moved to the start."""
    start = key.table[0, : len(first)]
    near = _whole_turns_off(first - start) < _whole_turns_off(first + start)
    return np.where(near, first, start + _rest(first + start))


def _begins_mirrored(key: Key, student: StudentTable) -> bool:
    """Return whether an angle begins at the negative of the task's start, and not at the start itself."""
    m = len(key.coordinates)
    first, start = student.values[0, :m], key.table[0, :m]
    allowed = student.units[0, :m]
    with np.errstate(invalid="ignore"):
        away = (_whole_turns_off(first - start) > allowed) & (_whole_turns_off(first + start) <= allowed)
    return bool((away & _angular(key)[:m]).any())


def _rest(angle: Array) -> Array:
    return np.asarray(angle - whole_turns(angle))


def _whole_turns_off(angle: Array) -> Array:
    return np.abs(_rest(angle))


def _opposite(printed: Array, reference: Array, key: Key, columns: Flags) -> bool:
    """Return whether printed velocities (n, r) have the opposite sign in each of the `columns` that has signs, at least one."""
    least = LEAST * np.max(np.abs(key.table[:, len(key.coordinates) :]), axis=0)[: len(columns)]
    with np.errstate(invalid="ignore"):
        speaks = np.isfinite(printed) & (np.abs(reference) > least) & columns
        other = speaks & (printed * reference < 0)
    spoken = speaks.sum(axis=0)
    return bool(spoken.any() and np.all(other.sum(axis=0) >= _SIGNS * spoken))


def _steps_agree(key: Key, turned: StudentTable, reference: Array) -> bool:
    """Return whether the angles move as the reference velocities (n, r) say, where their digits can show a step."""
    m = len(key.coordinates)
    angular = _angular(key)[:m]
    steps = np.diff(turned.values[:, :m], axis=0)
    with np.errstate(invalid="ignore"):
        steps[~(key.step * np.abs(reference[:-1, :m]) > turned.units[:-1, :m])] = np.nan
    return _opposite(-steps, reference[:-1, :m], key, angular) if angular.any() and len(steps) else True


def _explained(key: Key, cells: Cells) -> float:
    """Return the part of the velocities that follow from the key or from the table's own cells."""
    m = len(key.coordinates)
    return _part(np.isin(cells.marks[:, m:], (KEY, ANGLES, EARLIER)), ~cells.missing[:, m:])


def _part(holds: Flags, of: Flags) -> float:
    return float((holds & of).sum()) / float(of.sum()) if of.any() else 0.0
