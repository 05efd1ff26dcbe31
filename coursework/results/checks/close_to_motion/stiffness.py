"""Stiff equations: deviations decay far faster than the motion changes, and an explicit step must be as short as their decay.

Enters: `Evidence`.  Leaves: `Stiff`, None if they are not stiff or the step is short enough.  Used by `advice.py` and `check.py`.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import SCHEMES, title_of
from coursework.results.checks.evidence import Evidence
from coursework.system.arrays import Array, distinct, median
from coursework.system.frozen import frozen
from coursework.variant.record.variant import MAX_ROWS
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

# Number of exact rows examined; half of them must be stiff, so that a single pulse does not count.
_LOOKS = 40
_FEW = 3
# Smallest number of decay times in a run: with fewer, the decay belongs to the motion itself.
_TIMES = 20.0
# Largest relative change from row to row in the slopes of a motion that is slow compared with the deviation.
_SLOW = 0.5
_APART = float(np.cbrt(np.finfo(float).eps))


@frozen
class Stiff:
    """Deviations decay at `rate` (1/s); `scheme` keeps them small with steps up to `longest` (s), `rows` of them in all."""

    rate: float
    scheme: str
    longest: float
    rows: float

    @property
    def sentence(self) -> Sentence:
        """Return what this means for the step."""
        title = title_of(SCHEMES[self.scheme])
        told = say("advice.stiff", rate=self.rate, time=1 / self.rate, title=title, step=self.longest)
        return joined([told, say("advice.implicit")]) if self.rows > MAX_ROWS else told

    def parts(self, step: float) -> int:
        """Return into how many parts a step must be divided to be short enough."""
        return math.ceil(step / self.longest)


def stiff(evidence: Evidence) -> Stiff | None:
    """Return how stiff the equations are along the exact motion, None if the scheme copes with this step."""
    motion = evidence.motion
    if motion.scheme not in SCHEMES or evidence.stop is not None or evidence.restricted:
        return None
    return evidence.once("stiff", lambda: _stiff(evidence), of_rows=True)


def _stiff(evidence: Evidence) -> Stiff | None:
    motion, exact = evidence.motion, evidence.exact
    known = exact if len(exact.t) > _FEW else None  # else only the start is sure to lie on the motion
    rows = (
        distinct(np.linspace(0, len(known.t) - 1, _LOOKS).astype(int)) if known is not None else np.arange(min(1, len(motion.t)))
    )
    on = known or motion
    rate = float(median(_dying(evidence, on.t[rows], on.coordinates[rows]))) if len(rows) else 0.0
    longest = SCHEMES[motion.scheme].damped / rate if rate > 0 else math.inf
    if motion.step <= longest or rate * evidence.variant.time.end < _TIMES or (known is not None and not _is_slow(known)):
        return None
    return Stiff(rate, motion.scheme, longest, evidence.variant.time.end / longest)


def _dying(evidence: Evidence, t: Array, q: Array) -> Array:
    """Return the fastest decay rate (n,) in 1/s of a deviation from rows `q` (n, m), 0 if none decays."""
    size = q.shape[1]
    jacobian = np.zeros((len(t), size, size))
    for place in range(size):
        apart = np.zeros_like(q)
        apart[:, place] = _APART * np.maximum(np.abs(q[:, place]), np.max(np.ptp(q, axis=0), initial=1e-9))
        ahead, behind = (_rates(evidence.rates, t, q + sign * apart)[:, :size] for sign in (1, -1))
        jacobian[:, :, place] = (ahead - behind) / (2 * apart[:, place, None])
    jacobian[~np.isfinite(jacobian).all(axis=(1, 2))] = 0.0
    values = np.linalg.eigvals(jacobian)
    dying = np.where(np.abs(values.real) >= np.abs(values.imag), -values.real, 0.0)
    return np.asarray(np.max(dying, axis=1, initial=0.0))


def _rates(rates: Rates, t: Array, q: Array) -> Array:
    """Return the velocities of rows, nan in those beside the end of a table; a motion may begin and end on its last nodes."""
    try:
        return rates.table(t, q)[0]
    except OutsideTable:
        if len(t) == 1:
            return np.full((1, q.shape[1]), np.nan)
        half = len(t) // 2
        return np.vstack([_rates(rates, t[part], q[part])[:, : q.shape[1]] for part in (slice(half), slice(half, None))])


def _is_slow(exact: Motion) -> bool:
    """Return whether the exact motion changes little from row to row, except for a transient."""
    slopes = exact.velocities[:, : exact.coordinates.shape[1]]
    sizes = median(np.abs(slopes))
    changes = median(np.abs(np.diff(slopes, axis=0)))
    turned = median(np.abs(np.diff(exact.coordinates, axis=0)))
    return bool(np.all(changes <= _SLOW * sizes + 1e-12) and np.all(turned < 1.0))
