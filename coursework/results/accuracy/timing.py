"""How long a piece of work takes on this machine, as well as a shared machine can tell.

Enters: a call.  Leaves: seconds.  Nothing deterministic may depend on it.
Used by `step_search.py` and `study.py`.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable

REPEATS = 7
LONGEST = 2.0  # s of all repeats; a run that is long is timed well by fewer of them
SHORTEST_REPEAT = 0.05  # s; a shorter repeat measures the clock and the scheduler


def seconds(work: Callable[[], object], repeats: int = REPEATS, shortest: float = SHORTEST_REPEAT) -> float:
    """Return the least time of one call (s): best of at most `repeats`, each at least `shortest` long, warm-up not counted."""
    work()
    begun = time.perf_counter()
    work()
    best = time.perf_counter() - begun
    inner = max(1, int(shortest / max(best, 1e-9)))
    enabled = gc.isenabled()
    gc.disable()
    try:
        for _ in range(min(repeats, int(LONGEST / max(best, 1e-9)))):
            begun = time.perf_counter()
            for _ in range(inner):
                work()
            best = min(best, (time.perf_counter() - begun) / inner)
    finally:
        if enabled:
            gc.enable()
    return best
