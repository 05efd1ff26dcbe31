"""Stretches of time short enough for Gauss's rule, and a bound on its error over them.

Enters: enclosures of laws over stretches.  Leaves: `Resolution`.  Used by `drive.py`.
A rule evaluates points and can miss a pulse between them; here each stretch is halved until enclosures of the law
prove that the rule misses nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from coursework.motion.geometry.drives.enclosures import REACH, Enclosure
from coursework.system.arrays import Array
from coursework.system.frozen import frozen


def _gauss_legendre(count: int) -> tuple[Array, Array]:
    """Return Gauss-Legendre points and weights on (-1, 1), from the eigenvalues of the recurrence of the Legendre polynomials.

    Source: G. H. Golub, J. H. Welsch, Mathematics of Computation 23 (1969) 221.  NumPy's own function would import all of its
    polynomial package, which takes a twentieth of a run.
    """
    orders = np.arange(1, count)
    beside = np.diag(orders / np.sqrt(4.0 * orders**2 - 1), 1)
    points, vectors = np.linalg.eigh(beside + beside.T)
    return points, 2 * vectors[0] ** 2


# Gauss-Legendre with 12 points is exact to round-off for a sinusoid over a tenth of its period.
POINTS = 12
NODES, WEIGHTS = _gauss_legendre(POINTS)
# Error allowed for the integral of a law (rad or sizes of the mechanism), and relative to the whole distance that it moves.
WANTED = 1e-11
# Largest number of stretches examined; a drive of a hundred thousand oscillations takes about as many.
MOST = 1_000_000
_FIRST = 16
_SMALLEST = 4 * np.finfo(float).eps
# For a function bounded by M on an ellipse about (-1, 1) the rule errs by at most M times a power of the sum of the ellipse's
# semi-axes (L. N. Trefethen, Approximation Theory and Approximation Practice, theorem 19.3).  An ellipse with REACH as its longer
# semi-axis lies in the disc.
_SEMIAXES = REACH + np.sqrt(REACH**2 - 1)


@frozen
class Resolution:
    """Stretches of time between `edges` (s) on which the quadrature rule is accurate.

    The largest error lies at `place` (s); `met` says whether the total error is as small as wanted.
    """

    edges: Array
    place: float
    met: bool

    def shorter(self, length: float) -> tuple[Array, Array]:
        """Return begin and end (k,) of the stretches that are shorter than `length` (s)."""
        short = np.diff(self.edges) < length
        return self.edges[:-1][short], self.edges[1:][short]


def resolve(enclosed: Callable[[Array, Array], list[Enclosure]], edges: Array, sizes: Sequence[float]) -> Resolution:
    """Return stretches between `edges` (s) on which the rule gives the integrals of all laws to the accuracy wanted.

    `sizes` are what counts as 1 of each law's integral.
    """
    longest = (edges[-1] - edges[0]) / _FIRST
    counts = np.maximum(1, np.ceil(np.diff(edges) / longest)).astype(int)
    begin = np.concatenate([np.linspace(a, b, n + 1)[:-1] for a, b, n in zip(edges[:-1], edges[1:], counts, strict=True)])
    end = np.append(begin[1:], edges[-1])
    settled: list[Array] = []
    worst = (0.0, float(edges[0]))
    error = way = 0.0
    looked = count = 0
    while len(begin):
        looked, half = looked + len(begin), (end - begin) / 2
        laws = list(zip(enclosed(begin, end), sizes, strict=True))
        open_ = np.max([left_open(law, half) / size for law, size in laws], axis=0)
        moved = 2 * half * np.max([np.abs(law.middle) / size for law, size in laws], axis=0)
        allowed = WANTED * max(1.0, way + float(moved.sum())) / max(_FIRST, 2 * (len(begin) + count))
        done = (open_ <= allowed) | (half <= _SMALLEST * np.abs(end)) | (looked > MOST)
        if done.any():
            most = int(np.argmax(np.where(done, open_, -1.0)))
            worst = max(worst, (float(open_[most]), float(begin[most] + half[most])))
        error, way, count = error + float(open_[done].sum()), way + float(moved[done].sum()), count + int(done.sum())
        settled.append(begin[done])
        middle = (begin + half)[~done]
        begin, end = np.sort(np.concatenate([begin[~done], middle])), np.sort(np.concatenate([middle, end[~done]]))
    starts = np.sort(np.concatenate(settled))
    return Resolution(np.append(starts, edges[-1]), worst[1], bool(error <= WANTED * max(1.0, way)))


def left_open(law: Enclosure, half: Array, points: int = POINTS) -> Array:
    """Return a bound (n,) on the rule's error on stretches of half length `half`: by disc and rest, or by the range of values.

    With two `points` the rule is as accurate as a step of Runge-Kutta 4.
    """
    rule = 64 / 15 * _SEMIAXES ** (-2 * points) / (1 - _SEMIAXES**-2)
    with np.errstate(all="ignore"):
        off = np.fmin((rule * law.radius + 4 * law.rest) * half, (law.high - law.low) * 2 * half)
    return np.where(np.isnan(off), np.inf, off)
