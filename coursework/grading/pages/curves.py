"""The student's velocities against the key, drawn small: dots and a line, readable without colour.

Enters: rows of a table and of the key.  Leaves: `Panel`s with the points of their SVG.  Used by `feedback.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen
from coursework.words.sentences import Phrases

WIDTH, HEIGHT, EDGE = 300.0, 110.0, 6.0
MOST_POINTS = 80
_CROSS = "m-3.5-3.5l7 7m0-7l-7 7"


@frozen
class Panel:
    """One velocity: the key as the points of a line, the student's dots and crosses as paths; the ends of the axis."""

    name: str
    unit: str
    line: str
    dots: str
    crosses: str
    low: str
    high: str


def panel(name: str, unit: str, t: Array, key: Array, found: Array, is_wrong: Flags, words: Phrases) -> Panel:
    """Return the panel of one column; what lies far outside the key's range stands at the edge."""
    low, high = float(key.min()), float(key.max())
    margin = 0.25 * ((high - low) or max(abs(high), 1e-9))
    low, high = low - margin, high + margin
    kept = np.unique(np.linspace(0, len(t) - 1, min(len(t), MOST_POINTS)).astype(int))
    x = EDGE + (WIDTH - 2 * EDGE) * (t[kept] - t[0]) / (float(t[-1] - t[0]) or 1.0)

    def places(values: Array, chosen: Flags) -> list[str]:
        y = EDGE + (HEIGHT - 2 * EDGE) * (high - np.clip(values[kept], low, high)) / (high - low)
        return [f"{across:.1f} {down:.1f}" for across, down in zip(x[chosen].tolist(), y[chosen].tolist(), strict=True)]

    there, wrong = np.isfinite(found[kept]), is_wrong[kept]
    return Panel(
        name, unit, " ".join(places(key, np.ones_like(there))),
        "".join(f"M{place}h0" for place in places(found, there & ~wrong)),
        "".join(f"M{place}{_CROSS}" for place in places(found, there & wrong)),
        *(words.number(end, ".3g").replace("-", "−") for end in (low, high)),
    )  # fmt: skip
