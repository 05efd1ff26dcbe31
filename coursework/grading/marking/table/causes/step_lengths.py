"""The lengths of step with which a table may have been made, and how one is told.

Enters: a `TableUnderTest`.  Leaves: parts of the task's step, words.  Used by `hypotheses.py`, `misconceptions.py`.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.starts import march
from coursework.grading.marking.table.ways import HALF
from coursework.system.arrays import Array

DEGREE = np.pi / 180
STEPS = (0.1, 0.5, 2.0, 10.0)
# Two steps are the same if they differ by at most this part.
WHOLE = 0.01
# The length of a step is read off where the velocity is at least this part of its column's largest.
_FAST = 0.2
# How many steps a row was made in is read off where Euler's error is at least _FELT of its column's largest.  The part of it that
# is left may differ by _ABOUT of itself, in all but one in five cells.
_FELT, _ABOUT, _MOSTLY = 0.2, 0.3, 0.8
# Tables with so many steps a row are computed; the errors of others lie on a curve through theirs, to within _NEAR of themselves.
_COMPUTED, _NEAR = (2, 4), 0.01
# More steps a row than _MOST are the exact motion in any digits.  Numbers of cells that differ by less than _EQUAL are equal; if
# numbers of steps that fit equally well differ by more than the factor _UNSURE, the digits tell none.
_MOST, _EQUAL, _UNSURE = 200, 0.02, 1.5


def told_step(step: float) -> str:
    """Return a step (s) with as many digits as a sentence tells."""
    return f"{step:.4g}"


def parts_of_step(printed: TableUnderTest) -> list[float]:
    """Return possible steps as parts of the task's: usual ones, the one of the table's own times, the one its steps show.

    The last one is the median of step over velocity, in seconds to two digits, as a step is typed.
    """
    h, own = printed.key.step, printed.student.own
    parts = [*STEPS, *([own.step / h] if own else [])]
    rates, steps = printed.w[:-1], np.diff(printed.q, axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        made = (steps / rates)[np.abs(rates) > _FAST * np.nanmax(np.abs(rates), axis=0, initial=0.0)]
    read = float(f"{np.median(made[np.isfinite(made)]):.2g}") / h if np.isfinite(made).any() else 1.0
    if read > 0 and all(abs(read / part - 1) > WHOLE for part in (1.0, DEGREE, 1 / DEGREE, *parts)):
        parts.append(read)
    return parts


def small_steps(key: Key, times: int, t: Array, q: Array, w: Array | None = None) -> Array:
    """Return the increments (n, m) of rows made in several Euler steps each (`times`) instead of one."""
    h, m, moved = key.step / times, q.shape[1], q
    for place in range(times):
        moved = moved + h * key.velocities_at(t + place * h, moved)[:, :m]
    return moved - q


def steps_a_row(printed: TableUnderTest) -> int:
    """Return in how many Euler steps each row was made of which only the last was handed in, 0 if this is not so.

    The error of such a table falls with the length of its steps: it is Euler's with one step a row, computed with a few, and
    with others on a curve through these.  Of several numbers that the digits do not tell apart the roundest is returned, or that
    whose step is.
    """
    key, m = printed.key, printed.m
    if not printed.closely:
        return 0
    rows = min(len(key.exact), len(key.table))
    exact = key.exact[:rows, :m]
    once, own, units = key.table[:rows, :m] - exact, printed.q[:rows] - exact, printed.q_units[:rows]
    size = np.abs(once)
    felt = np.isfinite(own) & (size > 0) & (size >= _FELT * np.nanmax(size, axis=0, initial=0.0))
    parts = own[felt] / once[felt]
    part = float(np.median(parts)) if len(parts) else 0.0
    if not 1 / _MOST < part < 1 or np.mean(np.abs(parts - part) <= _ABOUT * part + units[felt] / size[felt]) < _MOSTLY:
        return 0
    errors = [once[felt]]
    for times in _COMPUTED:
        made = march(key, key.table[0, :m], key.velocities_at, partial(small_steps, key, times))
        errors.append((made[:rows, :m] - exact)[felt])
    tried = np.arange(max(2, int((1 - _ABOUT) / part)), min(int((1 + _ABOUT) / part) + 2, _MOST + 1))
    lengths = 1.0 / np.array([1, *_COMPUTED])
    curve = np.linalg.solve(lengths[:, None] ** [1, 2, 3], np.array(errors))
    off = np.abs((1.0 / tried[:, None]) ** [1, 2, 3] @ curve - own[felt])
    held = np.sum(off <= 2 * HALF * units[felt] + _NEAR * size[felt] / tried[:, None], axis=1)
    if held.max() < _MOSTLY * len(parts):
        return 0
    near = tried[held >= held.max() - _EQUAL * len(parts)].tolist()
    if near[-1] > _UNSURE * near[0]:
        return 0
    return int(min(near, key=lambda times: (_digits(key.step, times), abs(1 / times - part))))


def _digits(step: float, times: int) -> int:
    """Return how many digits a person types for so many parts of a step, or for the length of one.

    >>> _digits(0.02, 50), _digits(0.02, 12), _digits(0.0225, 20)
    (1, 2, 1)
    """
    return min(len(text.replace(".", "").strip("0")) for text in (str(times), f"{step / times:.4e}".partition("e")[0]))
