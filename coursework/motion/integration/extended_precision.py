"""The same march in another arithmetic: single, double or extended precision, with t = i*h or a running sum.

Enters: rates, a scheme, a number type.  Leaves: positions.  Its only purpose is to show the effect of round-off.
Used by `results/accuracy/round_off.py` and `motion_results.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from inspect import unwrap
from typing import Any

import numpy as np

from coursework.motion.integration.loops import generate_loop
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import SCHEMES


def has_extended() -> bool:
    """Return whether this machine's long double is wider than a double (it is not on Windows)."""
    return bool(np.finfo(np.longdouble).eps < np.finfo(np.float64).eps)


def march_in(
    kind: Any, rates: Rates, scheme: str, start: Sequence[float], step: float, steps: int,
    *, every: int = 1, running_time: bool = False,
) -> Any:  # fmt: skip
    """Return the positions (steps // every + 1, m) computed in numbers of type `kind` (np.float32, np.longdouble …).

    `running_time` adds up t += h instead of t = i*h.
    """
    loop = unwrap(generate_loop(SCHEMES[scheme], rates, numpy=True))
    h = kind(step)
    q = tuple(map(kind, start))
    t = kind(0)
    rows = [q]
    with np.errstate(all="ignore"):
        for index in range(steps):
            looks = {"_latest": kind(rates.may_look_until((index + 1) * step))} if rates.breaks else {}
            q = tuple(map(kind, loop(t, 1, h, *q, **looks)))
            t = t + h if running_time else kind(index + 1) * h
            if (index + 1) % every == 0:
                rows.append(q)
    return np.array(rows, dtype=kind)
