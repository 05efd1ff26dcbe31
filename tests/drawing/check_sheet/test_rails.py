"""What slides or rolls on a rail: the direction is that of the file, and how far a row stands off it is measured across."""

from __future__ import annotations

import cmath
import math

import pytest

from tests.drawing.check_sheet.checked import sketch_of

# What slides or rolls on rails in the files: the point, and the direction in which it slides in degrees.
GUIDED = {"v102": {"C": 90.0}, "v110": {"C": 0.0, "A": 45.0}, "v112": {"C": 0.0}, "31": {}}
ROLLING = {"31": 0.0, "v101": 45.0, "v107": 0.0}


@pytest.mark.parametrize("name", GUIDED)
def test_what_slides_moves_along_the_rail_of_its_file(name: str) -> None:
    sketch = sketch_of(name)
    found = {point: math.degrees(cmath.phase(along)) for point, along in sketch.pose.guided.items()}
    assert found == pytest.approx(GUIDED[name])
    assert all(abs(along) == pytest.approx(1) for along in sketch.pose.guided.values())
    assert [point for point, _ in sketch.off_rails] == (list(GUIDED[name]) or ["P"])
    assert not sketch.pose.fixed & set(GUIDED[name])
    at, start = sketch.pose.positions, sketch.start
    for point, off in sketch.off_rails:
        across = 1j * sketch.pose.guided.get(point, 1 + 0j)
        assert off == pytest.approx(((at[point] - start[point]) * across.conjugate()).real, abs=1e-12)


@pytest.mark.parametrize(("name", "angle"), ROLLING.items())
def test_where_a_wheel_rolls_on_a_rail_it_rests(name: str, angle: float) -> None:
    sketch = sketch_of(name)
    assert "P" in sketch.pose.fixed
    assert "P" not in sketch.pose.guided
    ((point, off),) = sketch.off_rails
    moved = sketch.pose.positions["P"] - sketch.start["P"]
    assert point == "P"
    assert off == pytest.approx((moved * cmath.rect(1, -math.radians(angle))).imag, abs=1e-12)
