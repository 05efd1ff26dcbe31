"""Positions in the complex plane with mpmath's digits: what tests solve by triangles, without a function of the package."""

from __future__ import annotations

from typing import Any

import mpmath as mp


def e(angle: Any) -> Any:
    """Return the unit vector at an angle (rad)."""
    return mp.expj(angle)


def meeting(b: Any, d: Any, rod: Any, rocker: Any) -> Any:
    """Return the joint of a rod from b and a rocker from d, to the left of the ray from b to d."""
    way = d - b
    along = (rod**2 + abs(way) ** 2 - rocker**2) / (2 * abs(way))
    return b + way / abs(way) * mp.mpc(along, mp.sqrt(rod**2 - along**2))
