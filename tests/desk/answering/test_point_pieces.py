"""A rod with a slider on a point: as long as the point needs, away from the others, the guide as high as the point's middle."""

from __future__ import annotations

import math
import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.desk.answering.pieces import with_guide


def end(name: str, *path: complex) -> Any:
    way = np.array(path)
    middle = complex((way.real.max() + way.real.min()) / 2, (way.imag.max() + way.imag.min()) / 2)
    return SimpleNamespace(name=name, path=way, middle=middle, amplitude=float(np.abs(way - middle).max()))


@pytest.mark.parametrize(
    ("others", "angle"), [((4 + 0j,), "right"), ((-4 + 0j,), "left"), ((-9 + 0j, 4 + 0j), "left"), ((), "left")]
)
def test_the_rod_goes_where_fewer_points_are_and_ends_as_high_as_the_middle(others: tuple[complex, ...], angle: str) -> None:
    """M goes round 1 m from 0, beginning at 0 - 0.6j (0.8 aside): the rod rises by 0.6 m to the guide."""
    moving = end("M", 0.8 - 0.6j, 1j, -1 + 0j, -1j, 1 + 0j)
    every = [moving, *(end(f"O{k}", at) for k, at in enumerate(others))]
    size = max(1.0, *(np.ptp([place.real for one in every for place in one.path]) / 4,))
    length = float(f"{2.5 * size:.2g}")
    rise = round(math.degrees(math.asin(0.6 / length)))
    made = with_guide(moving, every, 3, "K")
    told = " ".join(line for lines in made.sections.values() for line in lines)
    assert f'r3 = "{length:g} m"' in told and 'K = "M + r3 @ phi3"' in told
    start = int(re.search(r'start = "(-?\d+) deg"', told)[1])  # type: ignore[index]
    assert start == (180 - rise if angle == "right" else rise)
    (rail,), (hold,) = made.entries[("frame", "rails")], made.entries[("closure", "holds")]
    assert rail == '{ through = "K", angle = "0" }' and hold == '"K.y"'
