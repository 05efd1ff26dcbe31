"""What slides or rolls on a rail: the direction is that of the file, and how far a row stands off it is measured across."""

from __future__ import annotations

import cmath
import math

import pytest

from coursework.drawing.check_sheet.sketch import _driven
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


@pytest.mark.parametrize("degrees", [0.0, 30.0, 90.0, 135.0, -60.0, 180.0])
def test_a_driven_component_gives_the_velocity_along_the_rail_unless_the_rail_has_none(degrees: float) -> None:
    """Of a point that moves at 2 m/s along its rail one component is known: across the rail it tells nothing."""
    along = cmath.exp(1j * math.radians(degrees))
    moves = 2 * along
    for axis, part in (("x", moves.real), ("y", moves.imag)):
        found = _driven("K", {f"VK{axis}": part}, {"K": along})
        assert found == (pytest.approx(moves) if abs(part) > 1e-9 else None), axis
    assert _driven("K", {"VKx": 3.0, "VKy": -1.0}, {"K": along}) == 3 - 1j  # both are given: the rail is not asked
    assert _driven("K", {"VLx": 3.0, "VLy": 1.0}, {"K": along}) is None
    assert _driven("K", {"VKx": 3.0}, {}) is None


@pytest.mark.parametrize("sign", [1, -1])
def test_a_rail_almost_across_a_driven_component_gives_no_velocity(sign: int) -> None:
    for axis, rail in (("x", 1j + 1e-6), ("y", 1 + 1e-6j)):
        for share, is_given in ((0.9, False), (1.1, True)):
            slant = complex(rail.real * (share if axis == "x" else 1), rail.imag * (share if axis == "y" else 1))
            assert (_driven("K", {f"VK{axis}": 0.5}, {"K": sign * slant}) is not None) is is_given
