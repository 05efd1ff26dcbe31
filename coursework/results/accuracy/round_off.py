"""The lesson of single precision: with smaller and smaller steps, round-off cancels what the scheme gains.

Enters: a scene with its exact end.  Leaves: rows of the V-shaped curve, for t = i*h and for t += h.
Used by `run.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from coursework.motion.integration.extended_precision import march_in
from coursework.motion.integration.loops import generate_loop
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import SCHEMES
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

# Steps a row: from the coursework's step to where single precision loses more than the scheme gains, even with t = i*h.
SUBSTEPS = (1, 4, 16, 64, 256, 1024, 4096, 16384)
# The curve ends when both single-precision errors have risen to this multiple of their minimum, or beyond this many steps.
_RISEN, _MOST_STEPS = 4.0, 400_000


@frozen
class RoundOffRow:
    """Error of the last row (rad or m) after `steps` steps: in doubles, in single precision, in single precision with t += h."""

    steps: int
    double: float
    single: float
    running: float


def round_off_curve(
    rates: Rates, scheme: str, start: Sequence[float], step: float, rows: int, end: Array
) -> Iterator[RoundOffRow]:
    """Yield the curve from coarse to fine until it has turned up again; this takes some seconds in all."""
    loop = generate_loop(SCHEMES[scheme], rates)
    least = [np.inf, np.inf]
    for substeps in SUBSTEPS:
        count, h = rows * substeps, step / substeps
        if count > _MOST_STEPS:
            return
        double = np.array(loop(0.0, count, h, *start))
        found = [
            march_in(np.float32, rates, scheme, start, h, count, every=count, running_time=running)[-1].astype(float)
            for running in (False, True)
        ]
        gaps = [float(np.max(np.abs(position - end))) for position in (double, *found)]
        yield RoundOffRow(count, *gaps)
        least = [min(pair) for pair in zip(least, gaps[1:], strict=True)]
        if all(gap > _RISEN * best for gap, best in zip(gaps[1:], least, strict=True)):
            return
