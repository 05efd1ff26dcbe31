"""The line along which a block slides: a guide shifted by its offset.

Enters: a `Guide`, else `ValueError`.  Leaves: points of the line and the motion of its material points.  Used by RRP, RPP, PRP.

The pin of a block moves on the line through K + h n.  Because h is constant, this point belongs to the guide.
So K + h n, with its own velocity and acceleration, can replace K everywhere, and the formulas need no h.
"""

from __future__ import annotations

from coursework.mechanism.groups.pairs import Guide
from coursework.mechanism.groups.plane import Vectors, direction, vectors
from coursework.system.arrays import Array


class Line:
    """Position and direction of the pin's line; `k` (n,) m and `e` (n,), plane vectors."""

    __slots__ = ("e", "guide", "k", "owner")

    def __init__(self, guide: Guide, owner: str) -> None:
        if not isinstance(guide, Guide):
            raise ValueError(f"{owner}: a Guide(through, angle) was expected, found {guide!r:.60}.")
        self.guide = guide
        self.owner = owner
        self.e: Vectors = direction(guide.angle)
        self.k: Vectors = vectors(guide.through.position) + 1j * guide.offset * self.e

    def point(self, s: Array) -> Vectors:
        """Return k + s e, the position of a block at `s` (m)."""
        return self.k + s * self.e

    def carried(self, s: Array) -> Vectors:
        """Return the velocity (m/s) of the guide's own point under a block at `s` (m)."""
        velocity, _ = self.guide.through.motion(self.owner)
        reach = s + 1j * self.guide.offset  # from K, in the frame of the guide
        return velocity + (1j * self.guide.rate) * reach * self.e

    def carried_acceleration(self, s: Array, ds: Array) -> Vectors:
        """Return the acceleration (m/s^2) of that point plus the Coriolis term of a block with the speed `ds` (m/s)."""
        _, acceleration = self.guide.through.motion(self.owner)
        turn = self.guide.rate
        reach = s + 1j * self.guide.offset
        return acceleration + ((1j * self.guide.acceleration - turn * turn) * reach + 2j * turn * ds) * self.e
