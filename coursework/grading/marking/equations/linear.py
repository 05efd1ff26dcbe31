"""A line as A·u + b at the points of a probe: what it says about the velocities u, and how far from true it is.

Enters: `left - right` as a tree, a `Probe`.  Leaves: `Linear`; whether two wrong lines come from one slip.
Used by `equations.py`.
A residual is compared with the terms after they are collected: 1.001·ω - ω is 0.001·ω, and that is all wrong, while
ω + 10⁶ - 10⁶ is ω.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from coursework.grading.marking.equations.numbers import NoValue, real, size_of, value_of
from coursework.grading.marking.equations.probe import Probe
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Variant

AFFINE = 1e-9
# Collected terms smaller than this part of the terms as written are round-off: the line says nothing about the velocities.
NOTHING = 1e-12
# Rounding errors of terms may be larger by up to this factor in their sum; lines that differ by less count as the same line.
NEAR = 5.0
RANK = 1e-8
_HOLDS = 1e-6  # residual up to which an equation holds, relative to the sum of the absolute values of its terms


@dataclass(frozen=True)
class Linear:
    """A line at the points of a probe.

    `slopes` are A (n, k), `rest` is b (n,), `size` (n,) the size of the terms as written; NaN where there is no value.
    `slopes` are NaN throughout if the line is not affine in the velocities.
    """

    slopes: Array
    rest: Array
    size: Array
    probe: Probe

    @cached_property
    def _kept(self) -> Array:
        """Return A (n, k), with 0 at points where it is only round-off."""
        left = np.sum(np.abs(self.slopes * self.probe.scale), axis=1, keepdims=True)
        return np.where(left > NOTHING * self.size[:, None], self.slopes, 0.0)

    @property
    def is_affine(self) -> bool:
        """Return whether the line is affine in the velocities at all points."""
        return not np.isnan(self.slopes).any()

    @cached_property
    def residuals(self) -> Array:
        """Return the residual at each point (n,), relative to the collected terms; inf where there is no value."""
        terms = self._kept * self.probe.velocities
        left = np.sum(np.abs(terms), axis=1)
        return _part(np.sum(terms, axis=1) + self.rest, np.where(left > 0, left + np.abs(self.rest), self.size))

    @property
    def residual(self) -> float:
        """Return the largest residual over the points, relative to the collected terms."""
        return float(np.max(self.residuals, initial=0.0))

    @property
    def residual_of_scale(self) -> float:
        """Return the largest residual, relative to the terms at the usual velocities: where a slider turns back, 0 = 0 holds."""
        terms, usual = (self._kept * velocities for velocities in (self.probe.velocities, self.probe.scale))
        left = np.sum(np.abs(usual), axis=1)
        parts = _part(np.sum(terms, axis=1) + self.rest, np.where(left > 0, left + np.abs(self.rest), self.size))
        return float(np.max(parts, initial=0.0))

    def is_near(self, limit: float) -> bool:
        """Return whether numbers with relative rounding errors up to `limit` explain the residual: it is at most `limit` of the
        terms as written at every point, and `NEAR * limit` of the collected terms, which may nearly cancel, at half the points.
        """
        written = _part(np.sum(self.slopes * self.probe.velocities, axis=1) + self.rest, self.size)
        return bool(np.all(written <= limit) and np.median(self.residuals) <= NEAR * limit)

    @cached_property
    def directions(self) -> Array:
        """Return A (n, k) in units of the velocities' `scale`, divided by its largest entry; 0 where A is round-off."""
        scaled = self._kept * self.probe.scale
        largest = np.max(np.abs(scaled), axis=1, keepdims=True)
        return np.asarray(scaled / np.where(largest > 0, largest, 1.0))


def _part(value: Array, whole: Array) -> Array:
    with np.errstate(invalid="ignore"):  # of a line without a value somewhere
        part = np.where(whole > 0, np.abs(value) / np.where(whole > 0, whole, 1.0), 0.0)
    return np.where(np.isfinite(part), part, np.inf)


@lru_cache(512)  # a line is judged, compared with others and counted; the right ones come from many students
def linear(tree: Formula, probe: Probe) -> Linear:
    """Return the line of `left - right` at the points of a probe.  Raises `NoValue` for a vector."""
    count, k = probe.velocities.shape
    with np.errstate(all="ignore"):
        found = real(value_of(tree, probe.tried), count * (k + 2)).reshape(k + 2, count)
        rest, slopes = found[0], (found[1:-1] - found[0]).T
        terms = slopes * probe.elsewhere
        whole = np.abs(rest) + np.sum(np.abs(terms), axis=1)
        size = real(size_of(tree, probe.names), count)
        # of w = w1*w/w1, only round-off is left
        near = np.maximum(AFFINE * np.maximum(whole, NOTHING), NOTHING * np.nan_to_num(size, posinf=0.0))
        affine = np.all(np.abs(found[-1] - rest - np.sum(terms, axis=1)) <= near)
    return Linear(slopes if affine else np.full_like(slopes, np.nan), rest, size, probe)


def usual_size(tree: Formula, probe: Probe) -> float:
    """Return the size of the terms of `left - right` as written, in the middle of the points; 1 if there is none."""
    return float(np.median(real(size_of(tree, probe.names), probe.count))) or 1.0


def is_fulfilled(tree: Formula, probe: Probe, limit: float) -> bool:
    """Return whether `left - right` is at most `limit` of its terms as written at all points, though it may say nothing."""
    try:
        value, size = (real(found(tree, probe.names), probe.count) for found in (value_of, size_of))
    except NoValue:
        return False
    return bool(np.all(np.abs(value) <= limit * size))


def rank(lines: Sequence[Linear]) -> int:
    """Return how many of the lines are independent at the point where they are fewest."""
    if not lines:
        return 0
    return int(np.min(np.linalg.matrix_rank(np.stack([line.directions for line in lines], axis=1), tol=RANK)))


def is_same(one: Linear, other: Linear) -> bool:
    """Return whether two lines, right or wrong, say the same: at every point one is a multiple of the other."""
    both = np.stack([np.column_stack([line.slopes * line.probe.scale, line.rest]) for line in (one, other)], axis=1)
    if not np.isfinite(both).all():
        return False
    largest = np.max(np.abs(both), axis=2, keepdims=True)
    return int(np.max(np.linalg.matrix_rank(both / np.where(largest > 0, largest, 1.0), tol=RANK))) <= 1


def differing(trees: Sequence[Formula], probe: Probe) -> int:
    """Return how many different lines are among the given ones; a line without a value counts as different from all."""
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
    """Return whether a line with relative rounding errors up to `limit` says something new; a near-copy of another does not."""
    own = line.directions / np.maximum(np.linalg.norm(line.directions, axis=1, keepdims=True), NOTHING)
    if than:
        others = np.stack([other.directions for other in than], axis=1)
        _, values, rows = np.linalg.svd(others, full_matrices=False)
        kept = np.where(values[..., None] > RANK, rows, 0.0)
        own = own - np.einsum("ni,nji,njk->nk", own, kept, kept)
    return float(np.median(np.linalg.norm(own, axis=1))) > NEAR * limit


def is_one_slip(wrong: Sequence[Formula], counted: Sequence[Formula], variant: Variant, probe: Probe) -> bool:
    """Return whether wrong lines, each solved for a velocity, and the lines that count fulfil all equations of the task but one.

    Lines that are not solved do not qualify: they may be guesses at one equation, and then each wrong one is a fault.
    """
    needed = len(variant.sought)
    if len({side.name for tree in wrong for side in tree.args if side.op == "name" and side.name in variant.sought}) < len(wrong):
        return False
    try:
        lines = [linear(tree, probe) for tree in wrong]
        for tree in counted:
            more = [*lines, linear(tree, probe)]
            lines = more if rank(more) == len(more) else lines
        task = [linear(one.difference, probe) for one in variant.constraints]
    except NoValue:
        return False
    if len(lines) != needed or len(task) != needed or not all(line.is_affine for line in lines) or rank(lines) < needed:
        return False
    slopes, rest = np.stack([line.slopes for line in lines], axis=1), np.stack([line.rest for line in lines], axis=1)
    velocities = np.asarray(np.linalg.solve(slopes, -rest[..., None])[..., 0], dtype=np.float64)
    return sum(_holds(line, velocities) for line in task) == needed - 1


def _holds(line: Linear, velocities: Array) -> bool:
    terms = np.column_stack([line.slopes * velocities, line.rest])
    return bool(np.all(np.abs(terms.sum(axis=1)) <= _HOLDS * np.abs(terms).sum(axis=1)))
