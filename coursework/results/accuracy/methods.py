"""The methods that are compared, each with its settings, evaluations and rows.

Enters: a problem.  Leaves: trials to run.  To add one, add a function here and a line in `trials`.
Used by `sentences.py` and `study.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from coursework.motion.integration.adaptive import integrate_adaptive
from coursework.motion.integration.following import follow_closure
from coursework.motion.integration.integrate import Correction, March
from coursework.motion.schemes import DEFAULT_SCHEME, SCHEMES, Scheme, title_of
from coursework.results.accuracy.problem import Bounds, Problem
from coursework.results.accuracy.trace import trace
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.words.sentences import say, say_count

# Steps a row; a first-order scheme needs more of them to show its order.
USUAL_SUBSTEPS = (1, 2, 4, 8, 16, 64)
FIRST_ORDER_SUBSTEPS = (*USUAL_SUBSTEPS, 256, 1024, 4096)
# Cost of a step with Newton corrections, in generated steps; cost of one correction, in operations.
PROJECTED_COST, _CORRECTION = 128, 2500
PROJECTED_SUBSTEPS = (1, 2, 4, 8)
NEWTONS = (1, 2)
# Each row ends a step of the pair, so that coarser tolerances would change nothing.
TOLERANCES = (1e-5, 1e-7, 1e-9, 1e-11)


@frozen
class Trial:
    """One method with one setting; `run` returns rows (n, m) and the evaluations of the right-hand side.

    The rows are those examined; if `fine` is not 0, they are all rows of a table with `fine` steps a row.  A Newton correction
    counts as one evaluation (residual and Jacobian).  `closed`: the exact motion itself is found by this method.
    """

    method: str
    setting: str
    fine: int
    run: Callable[[], tuple[Array, int]]
    closed: bool = False


def projected_title(newton: int) -> str:
    """Return the title of the coursework's scheme with `newton` Newton projections a step."""
    return say_count("study.projected", newton)


def title_of_corrected(scheme: str, project: int, gain: float) -> str:
    """Return the title of the method by which a table was made; "" if that method is not compared."""
    if gain or (project and scheme != DEFAULT_SCHEME.name):
        return ""
    return projected_title(project) if project else title_of(SCHEMES[scheme])


def trials(problem: Problem, bounds: Bounds) -> Iterator[Trial]:
    """Yield every trial inside the bounds, method after method; the table's own step is always included for each scheme."""
    rows = problem.rows
    for scheme in SCHEMES.values():
        for substeps in FIRST_ORDER_SUBSTEPS if scheme.order == 1 else USUAL_SUBSTEPS:
            count, cost = rows * substeps, scheme.slopes * problem.operations
            if substeps == 1 or (substeps <= bounds.substeps and count * cost <= bounds.work):
                yield Trial(title_of(scheme), f"{count}", 0, partial(_by_scheme, problem, scheme, substeps))
    for newton in NEWTONS if problem.is_closed else ():
        for substeps in (n for n in PROJECTED_SUBSTEPS if n * PROJECTED_COST <= bounds.substeps):
            if rows * substeps * newton * _CORRECTION <= bounds.work:
                setting = f"{rows * substeps}"
                yield Trial(projected_title(newton), setting, substeps, partial(_projected, problem, newton, substeps))
    field, start = problem.rates.evaluate, np.array(problem.start, dtype=float)
    for tolerance in TOLERANCES:
        yield Trial(
            say("study.adaptive"),
            say("study.tolerance", value=tolerance),
            0,
            partial(integrate_adaptive, field, start, problem.times, tolerance, problem.rates.sizes.tolist()),
        )
    if problem.is_closed:
        yield Trial(say("study.closed"), f"{rows}", 0, partial(_closed, problem), closed=True)


def left_out(problem: Problem, bounds: Bounds) -> list[str]:
    """Return sentences about what was left out because the table is long; empty for a usual table."""
    told: list[str] = []
    if problem.pace > 1:
        told.append(say("study.thinned", rows=problem.rows + 1, pace=problem.pace, marks=len(problem.marks)))
    counts = [int(trial.setting) for trial in trials(problem, bounds) if not trial.fine and trial.setting.isdecimal()]
    if max(counts) <= problem.rows:
        told.append(say("study.no_finer", steps=problem.rows))
    if problem.is_closed and problem.rows * max(NEWTONS) * _CORRECTION > bounds.work:
        told.append(say("study.no_projection", steps=problem.rows))
    return told


def _by_scheme(problem: Problem, scheme: Scheme, substeps: int) -> tuple[Array, int]:
    rows = trace(scheme, problem.rates, problem.start, problem.step, problem.marks, substeps)
    return rows, problem.rows * substeps * scheme.slopes


def _projected(problem: Problem, newton: int, substeps: int) -> tuple[Array, int]:
    assert problem.closure is not None
    made = March(problem.rates, DEFAULT_SCHEME, problem.step / substeps, Correction(problem.closure, newton))
    motion = made.until(problem.start, problem.step * problem.rows)
    steps = problem.rows * substeps
    return motion.coordinates, steps * (1 + newton)


def _closed(problem: Problem) -> tuple[Array, int]:
    """Return the closed positions, and how many slopes and residuals were computed."""
    assert problem.closure is not None
    counts: list[int] = []

    def counted(function: Callable[..., Any]) -> Callable[..., Any]:
        def called(t: Any, *q: Any) -> Any:
            counts.append(np.size(t))
            return function(t, *q)

        return called

    closure = replace(problem.closure, function=counted(problem.closure.function), rows=counted(problem.closure.rows))
    rates = replace(problem.rates, evaluate=counted(problem.rates.evaluate), rows=counted(problem.rates.rows))
    every = np.arange(problem.rows + 1).astype(np.float64) * problem.step
    positions = follow_closure(closure, rates, every, counts.append)
    return positions[list(problem.marks)], sum(counts)
