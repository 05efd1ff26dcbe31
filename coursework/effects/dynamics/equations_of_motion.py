"""Equations of motion in one or two free coordinates, as plain functions.

Enters: nothing.  Leaves: the record `EquationsOfMotion`.  Used by `motion_writer.py`, which makes it, and by `dynamics.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursework.system.arrays import Array
from coursework.system.frozen import frozen

if TYPE_CHECKING:
    from coursework.effects.friction.rubbing import Rubbing


@frozen
class EquationsOfMotion:
    """Equations of motion as functions; `free` are the indices of the free coordinates, `others` those of the closed positions.

    `slope(t, *q, *v)` -> free accelerations, then the rates of the others; `newton(t, *q, *kept)` -> corrections of the others,
    with `kept` the values that positions keep; `table(t, *q, *v)` over arrays -> velocities, their derivatives, kinetic and
    potential energy, determinants (`determinants` of them).  `rubbing` is the friction contained in both.  `sizes` are what
    counts as 1 of each coordinate: 1 rad, or the size of the mechanism (m).  `breaks` are the times (s) at which a force changes
    its formula; `acting` the edges (s) of stretches of time in each of which the forces vary little.
    """

    free: tuple[int, ...]
    others: tuple[int, ...]
    slope: Callable[..., tuple[float, ...]]
    newton: Callable[..., tuple[float, ...]]
    kept: tuple[float, ...]
    table: Callable[..., Any]
    determinants: int
    sizes: tuple[float, ...]
    rubbing: Rubbing | None = None
    breaks: tuple[float, ...] = ()
    acting: Array | None = None

    @property
    def sizes_of_state(self) -> list[float]:
        """Return what counts as 1 of each free coordinate and, a second, of its rate."""
        return [self.sizes[place] for place in (*self.free, *self.free)]

    @property
    def dear(self) -> int:
        """Return the cost of a slope as a multiple of one without friction."""
        return 1 if self.rubbing is None else 6
