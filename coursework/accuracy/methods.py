"""The ways to the motion that are compared, each with its settings, evaluations and rows.

Enters: a problem.  Leaves: trials to run.  To add one, add a function here and a line in `trials`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.accuracy.trace import trace
from coursework.geometry.closure import Closure
from coursework.integration.adaptive import integrate_adaptive
from coursework.integration.following import follow_closure
from coursework.integration.integrate import Correction, march
from coursework.integration.loops import Loop, generate_loop
from coursework.integration.rates import Rates
from coursework.schemes import DEFAULT_SCHEME, SCHEMES
from coursework.sentences import say, say_count, title_of

Array = NDArray[np.float64]
# Steps a row: with the first order up to 4096 (98 304 steps for 24 rows), where the error has fallen by three orders.
USUAL_SUBSTEPS = (1, 2, 4, 8, 16, 64)
FIRST_ORDER_SUBSTEPS = (*USUAL_SUBSTEPS, 256, 1024, 4096)
MOST_SUBSTEPS = 4096
# A method takes finer steps only as long as they are at most so many in all: a long table shows its order in fewer of them.
MOST_STEPS = 100_000
# A page made beside a run takes the rows that are cheap; the rest continues the same straight line.
CHEAP_SUBSTEPS = 256
# A step with Newton corrections costs as much as this many generated steps.
PROJECTED_COST = 128
PROJECTED_SUBSTEPS = (1, 2, 4, 8)
# A step of the pair ends at each row, so that a coarser tolerance changes nothing.
TOLERANCES = (1e-5, 1e-7, 1e-9, 1e-11)


@dataclass(frozen=True, slots=True)
class Problem:
    """What a trial needs: rates, start, row distance h (s), number of rows, closure if known; `units` of the coordinates."""

    rates: Rates
    start: Sequence[float]
    step: float
    rows: int
    closure: Closure | None
    units: tuple[str, ...]

    @property
    def times(self) -> Array:
        """Return the times of the rows (s)."""
        return np.arange(self.rows + 1).astype(np.float64) * self.step


@dataclass(frozen=True, slots=True)
class Trial:
    """One method at one setting; `run` returns the rows (rows*fine + 1, m) and the evaluations of the right-hand side.

    A Newton correction counts as one evaluation (residual and Jacobian).  `closed`: the method is the one by which the exact
    motion itself is found.
    """

    method: str
    setting: str
    fine: int
    run: Callable[[], tuple[Array, int]]
    closed: bool = False


def projected_title(newton: int) -> str:
    """Return what the coursework's scheme with so many Newton projections a step is called."""
    return say_count("study.projected", newton)


def trials(problem: Problem, most: int = MOST_SUBSTEPS) -> Iterator[Trial]:
    """Yield every trial with at most `most` steps a row (and `MOST_STEPS` in all beyond one a row), method after method."""

    def is_affordable(substeps: int) -> bool:
        return substeps == 1 or (substeps <= most and substeps * problem.rows <= MOST_STEPS)

    for scheme in SCHEMES.values():
        loop = generate_loop(scheme, problem.rates)
        for substeps in (n for n in (FIRST_ORDER_SUBSTEPS if scheme.order == 1 else USUAL_SUBSTEPS) if is_affordable(n)):
            count = problem.rows * substeps
            yield Trial(title_of(scheme), f"{count}", 1, partial(_by_loop, problem, loop, substeps, count * scheme.slopes))
    if problem.closure is not None and problem.closure.complete:
        for newton in (1, 2):
            for substeps in (n for n in PROJECTED_SUBSTEPS if n * PROJECTED_COST <= most and is_affordable(n)):
                setting = f"{problem.rows * substeps}"
                yield Trial(projected_title(newton), setting, substeps, partial(_projected, problem, newton, substeps))
    for tolerance in TOLERANCES:
        yield Trial(say("study.adaptive"), say("study.tolerance", value=tolerance), 1, partial(_adaptive, problem, tolerance))
    if problem.closure is not None and problem.closure.complete:
        yield Trial(say("study.closed"), f"{problem.rows}", 1, partial(_closed, problem), closed=True)


def _by_loop(problem: Problem, loop: Loop, substeps: int, cost: int) -> tuple[Array, int]:
    return trace(loop, problem.start, problem.step, problem.rows, substeps, problem.rates.latest), cost


def _projected(problem: Problem, newton: int, substeps: int) -> tuple[Array, int]:
    correction = Correction(problem.closure, newton)
    end = problem.step * problem.rows
    motion = march(problem.rates, DEFAULT_SCHEME.name, problem.start, problem.step / substeps, end, correction)
    steps = problem.rows * substeps
    return motion.coordinates, steps * (1 + newton)


def _adaptive(problem: Problem, tolerance: float) -> tuple[Array, int]:
    size = len(problem.start)

    def field(t: float, q: Array) -> Array:
        return np.array(problem.rates.evaluate(t, *q.tolist())[:size])

    return integrate_adaptive(field, np.array(problem.start, dtype=float), problem.times, tolerance)


def _closed(problem: Problem) -> tuple[Array, int]:
    """Return the closed positions, and how often slopes or residuals were computed on the way."""
    assert problem.closure is not None
    counts: list[int] = []

    def counted(function: Callable[..., Any]) -> Callable[..., Any]:
        def called(t: Any, *q: Any) -> Any:
            counts.append(np.size(t))
            return function(t, *q)

        return called

    closure = replace(problem.closure, function=counted(problem.closure.function), rows=counted(problem.closure.rows))
    rates = replace(problem.rates, evaluate=counted(problem.rates.evaluate), rows=counted(problem.rates.rows))
    positions = follow_closure(closure, rates, problem.times, counts.append)
    return positions, sum(counts)
