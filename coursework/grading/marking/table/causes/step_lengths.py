"""The lengths of step with which a table may have been made, and how one is told.

Enters: a `TableUnderTest`.  Leaves: parts of the task's step, words.  Used by `hypotheses.py`, `misconceptions.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.table.causes.claims import TableUnderTest

DEGREE = np.pi / 180
STEPS = (0.1, 0.5, 2.0, 10.0)
# Two steps are the same if they differ by at most this part.
WHOLE = 0.01
# The length of a step is read off where the velocity is at least this part of its column's largest.
_FAST = 0.2


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
    if read and all(abs(read / part - 1) > WHOLE for part in (1.0, DEGREE, 1 / DEGREE, *parts)):
        parts.append(read)
    return parts
