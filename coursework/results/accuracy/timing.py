"""The time a piece of work takes on this machine, as well as a shared machine can tell.

Enters: a call.  Leaves: seconds.  Nothing deterministic may depend on it.
Used by `step_search.py` and `study.py`.
"""

from __future__ import annotations

import time
import timeit
from collections.abc import Callable
from typing import TypeVar

Made = TypeVar("Made")

REPEATS = 7
LONGEST = 2.0  # s, all repeats together; a long run needs fewer of them
SHORTEST_REPEAT = 0.05  # s; a shorter repeat would measure the clock and the scheduler
# For the many trials of a study: their minimum is as good with short repeats, and together they take two seconds.
QUICK_REPEAT = 0.004


def timed_once(work: Callable[[], Made]) -> tuple[Made, float]:
    """Return the result of a call and the time it took (s)."""
    begun = time.perf_counter()
    made = work()
    return made, time.perf_counter() - begun


def seconds(work: Callable[[], object], repeats: int = REPEATS, shortest: float = SHORTEST_REPEAT) -> float:
    """Return the shortest time of one call (s): best of at most `repeats`, each at least `shortest` long, after a warm-up."""
    work()
    timer = timeit.Timer(work, timer=time.perf_counter)  # it switches garbage collection off
    best = timer.timeit(1)
    inner = max(1, int(shortest / max(best, 1e-9)))
    spent = timer.repeat(min(repeats, int(LONGEST / max(best, 1e-9))), inner)
    return min([best, *(all_together / inner for all_together in spent)])
