"""The student's velocities against the key, drawn small: dots and a line, readable without colour.

Enters: rows of a table and of the key.  Leaves: `Panel`s with the points of their SVG.  Used by `feedback.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
WIDTH, HEIGHT, EDGE = 300.0, 110.0, 6.0
MOST_POINTS = 80


@dataclass(frozen=True, slots=True)
class Panel:
    """One velocity: the key as the points of a line, the student's as places of dots, `wrong` ones apart; labels of the axis."""

    name: str
    unit: str
    line: str
    dots: tuple[tuple[str, str], ...]
    wrong: tuple[tuple[str, str], ...]
    low: str
    high: str


def panel(name: str, unit: str, t: Array, key: Array, found: Array, is_wrong: Flags) -> Panel:
    """Return the panel of one column; what lies far outside the key's range stands at the edge."""
    low, high = float(key.min()), float(key.max())
    margin = 0.25 * ((high - low) or max(abs(high), 1e-9))
    low, high = low - margin, high + margin
    span = float(t[-1] - t[0]) or 1.0
    kept = np.unique(np.linspace(0, len(t) - 1, min(len(t), MOST_POINTS)).astype(int))

    def place(row: int, value: float) -> tuple[str, str]:
        x = EDGE + (WIDTH - 2 * EDGE) * float(t[row] - t[0]) / span
        y = EDGE + (HEIGHT - 2 * EDGE) * (high - min(max(value, low), high)) / (high - low)
        return f"{x:.1f}", f"{y:.1f}"

    line = " ".join(",".join(place(row, float(key[row]))) for row in kept)
    there = [row for row in kept.tolist() if np.isfinite(found[row])]
    return Panel(
        name, unit, line,
        tuple(place(row, float(found[row])) for row in there if not is_wrong[row]),
        tuple(place(row, float(found[row])) for row in there if is_wrong[row]),
        f"{low:.3g}", f"{high:.3g}",
    )  # fmt: skip
