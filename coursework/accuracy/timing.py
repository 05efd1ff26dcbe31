"""How long a piece of work takes on this machine, as well as a shared machine can tell.

Enters: a call.  Leaves: seconds.  Nothing deterministic may depend on it.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable

REPEATS = 7
SHORTEST_REPEAT = 0.05  # s; a shorter repeat measures the clock and the scheduler


def seconds(work: Callable[[], object], repeats: int = REPEATS, shortest: float = SHORTEST_REPEAT) -> float:
    """Return the least time of one call (s): best of `repeats`, each at least `shortest` long, warm-up not counted."""
    work()
    begun = time.perf_counter()
    work()
    inner = max(1, int(shortest / max(time.perf_counter() - begun, 1e-9)))
    best = float("inf")
    enabled = gc.isenabled()
    gc.disable()
    try:
        for _ in range(repeats):
            begun = time.perf_counter()
            for _ in range(inner):
                work()
            best = min(best, (time.perf_counter() - begun) / inner)
    finally:
        if enabled:
            gc.enable()
    return best
