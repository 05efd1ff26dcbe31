"""The problem that a study works on, and how much work it may do on a long table.

Enters: the right-hand side, start and rows of a run.  Leaves: `Problem`, the rows examined, the bounds `PAGE` and `TIMED`.
Used by `methods.py`, `study.py`, and by those who ask for a study.

Work is counted in operations of the generated program (some 60 ns each in Python), so that the bounds for a file are the same
on every machine.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import cached_property

import numpy as np

from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import SCHEMES
from coursework.system.arrays import Array
from coursework.system.frozen import caching, frozen

_OPERATION = re.compile(r"[-+*/(]")
# Largest work (operations) of all schemes together with the step of the table; a table that takes more is not studied.
MOST_WORK = 250e6
# Number of rows at which errors are measured: each costs the refined and the adaptive runs some hundred evaluations.
MOST_MARKS, FEWEST_MARKS = 2000, 100
_MARKS_WORK, _EVALUATIONS_A_MARK = 25e6, 126


@frozen
class Bounds:
    """The bounds of a run: the finest `substeps` a row, and the `work` if it is finer than the table or corrected."""

    substeps: int
    work: float


# For a page made beside a run only the cheap runs are made; finer ones would continue the same straight line.
PAGE = Bounds(256, 2.5e6)
# First-order schemes go up to 4096 steps a row (98 304 steps for 24 rows), where the error has fallen a thousandfold.
TIMED = Bounds(4096, 12e6)


@caching
class Problem:
    """The input of a trial: rates, start, row distance h (s), number of rows, closure if known; `units` of the coordinates."""

    rates: Rates
    start: Sequence[float]
    step: float
    rows: int
    closure: Closure | None
    units: tuple[str, ...]

    @cached_property
    def operations(self) -> int:
        """Return the number of operations in one evaluation of the right-hand side."""
        return max(1, sum(len(_OPERATION.findall(line.text)) for line in self.rates.body.lines))

    @property
    def work(self) -> float:
        """Return the number of operations for one run of every scheme with the step of the table."""
        return float(self.rows * self.operations * sum(scheme.slopes for scheme in SCHEMES.values()))

    @property
    def is_closed(self) -> bool:
        """Return whether position equations determine every coordinate."""
        return self.closure is not None and self.closure.complete

    @property
    def pace(self) -> int:
        """Return n if errors are measured in every n-th row."""
        most = _MARKS_WORK / (_EVALUATIONS_A_MARK * self.operations)
        return math.ceil(self.rows / min(MOST_MARKS, max(FEWEST_MARKS, most)))

    @cached_property
    def marks(self) -> tuple[int, ...]:
        """Return the rows (from 0) at which errors are measured: every n-th, those at a break of the drive, and the last."""
        at_breaks = [row for row in self.rates.rows_at_breaks(self.step) if row < self.rows]
        return tuple(sorted({*range(0, self.rows, self.pace), *at_breaks, self.rows}))

    @property
    def times(self) -> Array:
        """Return the times (s) of the rows at which errors are measured."""
        return np.array(self.marks).astype(np.float64) * self.step
