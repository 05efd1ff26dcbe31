"""The key of one variant: its Euler table, and its velocities at any time, position and data.

Enters: a `Variant`.  Leaves: `Key`.  Used by every part of this room; made once a variant and kept.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from coursework.system.arrays import Array
from coursework.variant.record.variant import Variant

# (t (n,), q (n, m), data by name) -> every velocity (n, r) in the order of the table; NaN where there is none.
Velocities = Callable[[Array, Array, Mapping[str, float]], Array]
# (block, t (n,), q (n, m), velocities (n, r) of which those of earlier blocks are read) -> those of the block (n, size).
BlockVelocities = Callable[[int, Array, Array, Array], Array]
# A table that Euler makes without error shows no gap; its digits are then judged by this part of its largest range.
_SMALLEST_GAP = 1e-3
_NO_GAP = 1e-9
# Digits that decide: a cell counts as shown up to this part of the gap; the task sheet asks for a fifth of it.
SHOWN, ASKED = 0.6, 5.0
_DIFFERENCE = 1e-6


@dataclass(frozen=True)
class Key:
    """What a right table is.

    `table` (n, m + r) by `names`: m coordinates, then r velocities (rates first), SI; `blocks` the unknown velocities in order
    of solution; `sets_at` the velocities (sets, n, r) of several sets of data at once; `rewritten` those with the signs of the
    drive turned ("sign_drive") or degrees taken for radians ("degree_mode"); `stopped` why the table is shorter than assigned,
    "" where it is not.  What few submissions need is found when it is asked for.
    """

    variant: Variant
    step: float
    table: Array
    find_exact: Callable[[], Array]
    blocks: tuple[tuple[str, ...], ...]
    velocities_at: Velocities
    sets_at: Callable[[Array, Array, Sequence[Mapping[str, float]]], Array]
    block_at: BlockVelocities
    rewritten: Callable[[str], Callable[[Array, Array], Array] | None]
    stopped: str = ""
    find_branches: Callable[[], Sequence[Array]] = tuple

    @cached_property
    def exact(self) -> Array:
        """Return the rows (n, m + r) without the scheme's error; fewer where the motion stops."""
        return self.find_exact()

    @cached_property
    def branches(self) -> Sequence[Array]:
        """Return Euler's tables of the mechanism assembled otherwise."""
        return self.find_branches()

    @cached_property
    def coordinates(self) -> tuple[str, ...]:
        """Return the names of the coordinates."""
        return tuple(coordinate.name for coordinate in self.variant.coordinates)

    @cached_property
    def velocities(self) -> tuple[str, ...]:
        """Return the names of the velocities: rates in the order of the coordinates, then the unknowns."""
        return self.variant.columns[len(self.coordinates) :]

    @property
    def names(self) -> tuple[str, ...]:
        """Return the columns after t."""
        return self.variant.columns

    @cached_property
    def t(self) -> Array:
        """Return the times of the rows (n,), s."""
        return np.arange(len(self.table), dtype=float) * self.step

    @cached_property
    def ranges(self) -> Array:
        """Return the range of each column (m + r,)."""
        return np.asarray(np.ptp(self.table, axis=0))

    @cached_property
    def gap(self) -> float:
        """Return the one-step gap G: the most by which a step of Heun leaves a step of Euler, over rows and coordinates."""
        m = len(self.coordinates)
        here, q = self.t[:-1], self.table[:-1, :m]
        slopes = self.velocities_at(here, q, {})[:, :m]
        ahead = self.velocities_at(here + self.step, q + self.step * slopes, {})[:, :m]
        return float(gap_of(slopes, ahead, self.step, self.ranges[:m]))

    @property
    def least_decimals(self) -> int:
        """Return how many decimals a task sheet asks for."""
        return decimals_asked(self.gap)

    @cached_property
    def order(self) -> tuple[int, ...]:
        """Return the places of the columns in the order of work: angles, then block by block, driven rates last."""
        m = len(self.coordinates)
        solved = [
            [m + place for place, name in enumerate(self.velocities) if name in block] for block in map(frozenset, self.blocks)
        ]
        placed = [place for block in solved for place in block]
        driven = [place for place in range(m, m + len(self.velocities)) if place not in placed]
        return (*range(m), *placed, *driven)


def gap_of(slopes: Array, ahead: Array, step: float, ranges: Array) -> Array:
    """Return the one-step gap (…) from rates (…, n, m) in the rows and after a step of Euler; `ranges` (…, m) of coordinates."""
    gaps = np.abs(step / 2 * (ahead - slopes))
    largest = np.nanmax(gaps, axis=(-2, -1), initial=0.0)
    span = np.max(ranges, axis=-1, initial=0.0)
    span = np.where(span > 0, span, 1.0)
    return np.where(largest > _NO_GAP * span, largest, _SMALLEST_GAP * span)


def decimals_asked(gap: float) -> int:
    """Return how many decimals a task sheet asks for where the one-step gap is this."""
    return max(1, math.ceil(math.log10(ASKED / gap)))


def sensitivity(function: Callable[[Array], Array], at: Array, units: Array) -> Array:
    """Return sum over j of |d function / d x_j| u_j, (n, k), for rows `at` (n, m) with digits `units` (n, m), all at once."""
    rows, width = at.shape
    size = _DIFFERENCE * np.maximum(1.0, np.abs(at))
    shifted = np.broadcast_to(at, (2 * width, rows, width)).copy()
    places = np.arange(width)
    shifted[places, :, places] += size.T
    shifted[width + places, :, places] -= size.T
    found = function(shifted.reshape(-1, width)).reshape(2, width, rows, -1)
    slopes = np.abs(found[0] - found[1]) / (2 * size.T[:, :, None])
    # What does not depend on a missing cell has slope zero there; where it does depend, the value itself is missing.
    slopes = np.where(np.isnan(slopes), 0.0, slopes) * np.where(np.isnan(units), 0.0, units).T[:, :, None]
    return np.asarray(slopes.sum(axis=0))
