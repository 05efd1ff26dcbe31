"""The small picture of a mechanism, measured: it fills its square, bars keep their lengths, guides reach past what slides."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from coursework.desk.answering.pictures import picture
from coursework.system.arrays import Complex
from tests.solved import solved

FEWEST = 20  # frames of what moves
ROUNDED = 0.15  # places have one decimal


def measured(name: str) -> tuple[list[Complex], list[Complex]]:
    """The guides, and the lines of bars, wheels and blocks with their corners in every frame: (frames, corners)."""
    guides, lines = [], []
    for node in ElementTree.fromstring(picture(solved(name).scene)):
        told = [one.get("values", "") for one in node if one.get("attributeName") == "d"] or [node.get("d", "")]
        frames = [
            [complex(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", one)] for one in told[0].split(";")
        ]
        if node.get("stroke-dasharray"):
            guides.append(np.array(frames[0]))
        elif "l-" not in told[0] and frames[0]:
            lines.append(np.array(frames))
    return guides, lines


@pytest.mark.parametrize("name", ["31", "v102"])
def test_guides_reach_half_a_margin_past_what_slides_and_bars_keep_their_lengths(name: str) -> None:
    ((begin, end),), lines = measured(name)
    along = (end - begin) / abs(end - begin)
    travels = [(corner - begin) * along.conjugate() for line in lines for corner in line.T]
    (travel, *_) = [
        one.real for one in travels if np.abs(one.imag).max() < ROUNDED and len(one) > FEWEST and np.ptp(one.real) > 1
    ]
    assert (travel.min(), abs(end - begin) - travel.max()) == pytest.approx((4.5, 4.5), abs=ROUNDED)
    moved = [line for line in lines if len(line) > FEWEST and line.shape[1] > 1]
    assert len(moved) >= 3
    for line in moved:
        assert np.ptp(np.abs(np.diff(line, axis=1)), axis=0).max() < 2 * ROUNDED
    places = np.concatenate([line.ravel() for line in lines])
    spans = np.ptp(places.real), np.ptp(places.imag)
    assert max(spans) == pytest.approx(82, abs=1)
    assert (places.real.min() + places.real.max(), places.imag.min() + places.imag.max()) == pytest.approx((100, 100), abs=9)
