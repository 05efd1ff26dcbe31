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
    potential energy, determinants (`determinants` of them).  `rubbing` is the friction contained in both.  `sizes` are large
    corrections of the others (1 rad, m of the mechanism), `size` what large numbers are large beside: 1, or a larger length (m)
    where lengths are free.  `breaks` are the times (s) at which a force changes its formula;
    `acting` the edges (s) of stretches of time in each of which the forces vary little.
    """

    free: tuple[int, ...]
    others: tuple[int, ...]
    slope: Callable[..., tuple[float, ...]]
    newton: Callable[..., tuple[float, ...]]
    kept: tuple[float, ...]
    table: Callable[..., Any]
    determinants: int
    rubbing: Rubbing | None = None
    sizes: tuple[float, ...] = ()
    size: float = 1.0
    breaks: tuple[float, ...] = ()
    acting: Array | None = None

    @property
    def dear(self) -> int:
        """Return the cost of a slope as a multiple of one without friction."""
        return 1 if self.rubbing is None else 6
