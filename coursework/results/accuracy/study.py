"""The work-precision study of one problem.

Enters: a problem, its exact motion.  Leaves: frozen `AccuracyStudy`.
Protocol (numerics.md 2.2): the error is the maximum over the coursework's grid and all coordinates, against a reference that is
independent of the schemes; the error of the last row alone is kept beside it because it understates.
Used by `commands/accuracy.py` and `quantities.py`.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Sequence
from functools import cached_property

import numpy as np

from coursework.motion.integration.exact_motion import OutOfReach, refine
from coursework.motion.integration.following import NotReached, follow_closure
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import SCHEMES, title_of
from coursework.results.accuracy.methods import Trial, left_out, title_of_corrected, trials
from coursework.results.accuracy.problem import MOST_WORK, PAGE, TIMED, Problem
from coursework.results.accuracy.record import AccuracyStudy, StudyRow
from coursework.results.accuracy.sentences import ROUNDINGS, sentences_of, unsettled
from coursework.results.accuracy.timing import QUICK_REPEAT, REPEATS, seconds, timed_once
from coursework.results.accuracy.trace import orders_of
from coursework.results.checks.close_to_motion.rows import between
from coursework.system.arrays import Array
from coursework.system.frozen import caching
from coursework.words.sentences import say

# If closed positions and a refined run differ by more (rad or sizes), they are two motions, not two roundings of one.
SAME = 1e-9
_NO_ORDER = 0.5  # a lower order means that the error does not fall with the step, or not yet


def make_study(
    problem: Problem, exact: Motion, scheme: str,
    *, project: int = 0, gain: float = 0.0,
    timed: bool = False, overhead: Sequence[tuple[str, float]] = (), progress: Callable[[str], None] | None = None,
) -> AccuracyStudy:  # fmt: skip
    """Return the study of a table made by `scheme`, corrected by `project` Newton corrections a step or by a `gain` (1/s).

    With `timed` every trial is also timed (some 0.04 s each).
    """
    if problem.work > MOST_WORK or not len(exact.t):
        return _without_runs(say("study.no_runs", rows=problem.rows + 1, work=problem.work, most=MOST_WORK), exact, timed)
    bounds = TIMED if timed else PAGE
    try:
        other, gap, _ = refine(problem.rates, problem.start, problem.times)
    except OutOfReach:
        return _without_runs(say("study.not_followed"), exact, timed)
    reference = _Reference(problem, exact.coordinates[list(problem.marks)], other)
    floor = reference.floor
    rows: list[StudyRow] = []
    for trial in trials(problem, bounds):
        if progress:
            progress(f"{trial.method}, {trial.setting}")
        rows.append(_row(trial, reference, rows, timed=timed))
    orders, end_orders = orders_of(rows, floor, _NO_ORDER), orders_of(rows, floor, _NO_ORDER, end=True)
    # A corrected table matches no trial of its scheme, only Euler with as many projections, if anything.
    title, corrected = title_of(SCHEMES[scheme]), title_of_corrected(scheme, project, gain)
    own_row = next((row for row in rows if row.method == corrected and not row.failed), None)
    own = None if own_row is None else (own_row.method, own_row.evaluations, own_row.max_error, own_row.seconds)
    own_row = own_row or next(row for row in rows if row.method == title)
    label = exact.label
    if reference.agreement:  # without a closure, the reference is a refined run itself
        key = "study.reference" if reference.is_same else "study.own_reference"
        label = say(key, label=label, gap=gap, agreement=reference.agreement)
    told = (
        *sentences_of(rows, orders, end_orders, own_row, floor, is_own=corrected == own_row.method),
        *unsettled(rows, floor, broken=_is_broken(problem, rows)),
    )
    where = machine() if timed else {}
    return AccuracyStudy(
        tuple(rows), orders, own, floor * rows[0].size, label, told, tuple(overhead), timed, where, left_out(problem, bounds)
    )


@caching
class _Reference:
    """What errors are measured against: the `exact` rows looked at (n, m), or the `refined` ones if these are another motion.

    Derivatives of a table are not those of a curve through it: then every scheme converges to a motion of its own.
    """

    problem: Problem
    exact: Array
    refined: Array

    @cached_property
    def agreement(self) -> float:
        """Return the largest difference of the two (rad or m)."""
        return float(np.max(np.abs(self.refined - self.exact)))

    @cached_property
    def _apart(self) -> float:
        """Return the largest difference of the two as a share (rad or sizes of the mechanism)."""
        return float(np.max(np.abs(self.refined - self.exact) / self.problem.rates.sizes))

    @property
    def is_same(self) -> bool:
        """Return whether the two are one motion."""
        return self._apart < SAME

    @property
    def floor(self) -> float:
        """Return the smallest share that can be measured as an error: none below the difference of two references."""
        most = max(1.0, float(np.max(np.abs(self.rows[0]) / self.problem.rates.sizes)))
        return max(ROUNDINGS * float(np.finfo(float).eps) * most, self._apart if self.is_same else 0.0)

    @cached_property
    def rows(self) -> dict[int, Array]:
        """Return the positions in the rows looked at (0), and in all rows with some steps a row if they have been asked for."""
        looked_at = self.exact if self.is_same else self.refined
        return {0: looked_at} | ({1: looked_at} if self.problem.pace == 1 else {})

    def of(self, trial: Trial) -> Array:
        """Return the positions in the rows of a trial."""
        if trial.closed and self.is_same:  # the closure compared with itself would have no error
            return self.refined
        if trial.fine not in self.rows:
            self.rows[trial.fine] = self._finer(trial.fine)
        return self.rows[trial.fine]

    def _finer(self, fine: int) -> Array:
        """Return the positions on the finer rows of a projected run: closed positions, or those of a refined run."""
        problem = self.problem
        times = np.arange(problem.rows * fine + 1).astype(np.float64) * (problem.step / fine)
        if self.is_same and problem.closure is not None:
            return follow_closure(problem.closure, problem.rates, times)
        return refine(problem.rates, problem.start, times)[0]


def _row(trial: Trial, reference: _Reference, before: Sequence[StudyRow], *, timed: bool) -> StudyRow:
    """Return the row of one trial, whose time is compared with that of the first row."""
    try:
        (positions, evaluations), once = timed_once(trial.run)
        gaps = np.abs(positions - reference.of(trial))
    except (ArithmeticError, ValueError, np.linalg.LinAlgError, NotReached) as error:
        return StudyRow(trial.method, trial.setting, 0, np.nan, np.nan, None, say("study.failed", kind=type(error).__name__))
    spent = (once if once > REPEATS * QUICK_REPEAT else seconds(trial.run, shortest=QUICK_REPEAT)) if timed else None
    # The first trial is Euler with the table's own step: ratios to it say more than seconds on one machine.
    first = before[0].seconds if before else spent
    ratio = spent / first if spent and first else None
    columns, last = np.max(gaps, axis=0), gaps[-1]
    units, sizes = reference.problem.units, reference.problem.rates.sizes
    worst, end = int(np.argmax(columns / sizes)), int(np.argmax(last / sizes))
    return StudyRow(
        trial.method, trial.setting, evaluations, float(columns[worst]), float(last[end]), spent, "",
        units[worst], units[end], ratio, float(sizes[worst]), float(sizes[end]),
    )  # fmt: skip


def _is_broken(problem: Problem, rows: Sequence[StudyRow]) -> bool:
    """Return whether a break of the drive lies inside a step of the finest run, and so of every run."""
    end = problem.rows * problem.step
    most = max(int(row.steps_or_tolerance) for row in rows if row.steps_or_tolerance.isdigit())
    return bool(between(problem.rates.breaks, end / most, end))


def _without_runs(why: str, exact: Motion, timed: bool) -> AccuracyStudy:
    """Return a study without runs because they would take too much, with the reason `why`."""
    return AccuracyStudy((), {}, None, 0.0, exact.label, (), (), timed, {}, (why,))


def machine() -> dict[str, str]:
    """Return a description of the machine: the times mean nothing without it."""
    return {
        "system": f"{platform.system()} {platform.machine()}", "processors": str(os.cpu_count() or 1),
        "python": f"{platform.python_implementation()} {platform.python_version()}",
    }  # fmt: skip
