"""A line as A·u + b at the points of a probe: what it says of the velocities, and how far it is from true.

Enters: `left - right` as a tree, a `Probe`.  Leaves: `Linear`.  Used by `equations.py`.
A residual is held against what is left after terms are collected: 1.001·ω - ω is 0.001·ω, wrong by all of itself, and
ω + 10⁶ - 10⁶ is ω.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from coursework.grading.marking.equations.numbers import NoValue, real, size_of, value_of
from coursework.grading.marking.equations.probe import Probe
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula

AFFINE = 1e-9
# Less than this part of the terms as written is their round-off: such a line says nothing.
NOTHING = 1e-12
# Rounding in the terms is so much larger in their sum, and a line that differs by less from another is that line.
NEAR = 5.0
RANK = 1e-8


@dataclass(frozen=True)
class Linear:
    """A line at the points of a probe.

    `slopes` A (n, k), `rest` b (n,), `size` (n,) of the terms as written; NaN where there is no value, and in `slopes` where
    the line is not affine in the velocities.
    """

    slopes: Array
    rest: Array
    size: Array
    probe: Probe

    @cached_property
    def _kept(self) -> Array:
        """Return A (n, k), 0 where nothing but round-off is left of it."""
        left = np.sum(np.abs(self.slopes * self.probe.scale), axis=1, keepdims=True)
        return np.where(left > NOTHING * self.size[:, None], self.slopes, 0.0)

    @property
    def is_affine(self) -> bool:
        """Return whether the line is affine in the velocities wherever it was tried."""
        return not np.isnan(self.slopes).any()

    @cached_property
    def residuals(self) -> Array:
        """Return the residual at each point (n,), as a part of its collected terms; inf where there is no value."""
        terms = self._kept * self.probe.velocities
        left = np.sum(np.abs(terms), axis=1)
        return _part(np.sum(terms, axis=1) + self.rest, np.where(left > 0, left + np.abs(self.rest), self.size))

    @property
    def residual(self) -> float:
        """Return the largest residual over the points, as a part of its collected terms."""
        return float(np.max(self.residuals, initial=0.0))

    def is_near(self, limit: float) -> bool:
        """Return whether numbers rounded by a part `limit` explain the residual: of the terms as written at every point, of what
        is collected from them, where a few points may nearly cancel, at most points by a few times that.
        """
        written = _part(np.sum(self.slopes * self.probe.velocities, axis=1) + self.rest, self.size)
        return bool(np.all(written <= limit) and np.median(self.residuals) <= NEAR * limit)

    @cached_property
    def directions(self) -> Array:
        """Return A (n, k) in the scale of the velocities, its largest 1; all 0 where the line says nothing of them."""
        scaled = self._kept * self.probe.scale
        largest = np.max(np.abs(scaled), axis=1, keepdims=True)
        return np.asarray(scaled / np.where(largest > 0, largest, 1.0))


def _part(value: Array, whole: Array) -> Array:
    with np.errstate(invalid="ignore"):  # of a line without a value somewhere
        part = np.where(whole > 0, np.abs(value) / np.where(whole > 0, whole, 1.0), 0.0)
    return np.where(np.isfinite(part), part, np.inf)


def linear(tree: Formula, probe: Probe) -> Linear:
    """Return a line at the points of a probe.  Raises `NoValue` for a vector."""
    count, k = probe.velocities.shape
    with np.errstate(all="ignore"):
        found = real(value_of(tree, probe.tried), count * (k + 2)).reshape(k + 2, count)
        rest, slopes = found[0], (found[1:-1] - found[0]).T
        terms = slopes * probe.elsewhere
        whole = np.abs(rest) + np.sum(np.abs(terms), axis=1)
        affine = np.all(np.abs(found[-1] - rest - np.sum(terms, axis=1)) <= AFFINE * np.maximum(whole, NOTHING))
        size = real(size_of(tree, probe.names), count)
    return Linear(slopes if affine else np.full_like(slopes, np.nan), rest, size, probe)


def rank(lines: Sequence[Linear]) -> int:
    """Return how many of the lines are independent, least over the points."""
    if not lines:
        return 0
    return int(np.min(np.linalg.matrix_rank(np.stack([line.directions for line in lines], axis=1), tol=RANK)))


def is_same(one: Linear, other: Linear) -> bool:
    """Return whether two lines say the same, right or wrong: each is the other times a number at every point."""
    both = np.stack([np.column_stack([line.slopes * line.probe.scale, line.rest]) for line in (one, other)], axis=1)
    if not np.isfinite(both).all():
        return False
    largest = np.max(np.abs(both), axis=2, keepdims=True)
    return int(np.max(np.linalg.matrix_rank(both / np.where(largest > 0, largest, 1.0), tol=RANK))) <= 1


def differing(trees: Sequence[Formula], probe: Probe) -> int:
    """Return how many of some wrong lines are no other's once more; one without a value is none."""
    found: list[Linear] = []
    nothing = 0
    for tree in trees:
        try:
            said = linear(tree, probe)
        except NoValue:
            nothing += 1
            continue
        if not any(is_same(said, other) for other in found):
            found.append(said)
    return len(found) + nothing


def says_more(line: Linear, than: Sequence[Linear], limit: float) -> bool:
    """Return whether a line rounded by a part `limit` says what others do not: near-copies of a line are that line."""
    own = line.directions / np.maximum(np.linalg.norm(line.directions, axis=1, keepdims=True), NOTHING)
    if than:
        others = np.stack([other.directions for other in than], axis=1)
        _, values, rows = np.linalg.svd(others, full_matrices=False)
        kept = np.where(values[..., None] > RANK, rows, 0.0)
        own = own - np.einsum("ni,nji,njk->nk", own, kept, kept)
    return float(np.median(np.linalg.norm(own, axis=1))) > NEAR * limit
