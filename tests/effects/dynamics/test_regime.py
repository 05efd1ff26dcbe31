"""The steady motion of a crank whose equation of motion has a solution by hand."""

import math
from types import SimpleNamespace

import pytest

import coursework
from coursework.effects.dynamics.regime import find_regime
from tests.mechanisms.library import mechanism

MIDDLE, SWING, LAG = 0.8, 0.15, 0.4  # rad/s, rad/s, rad: w = MIDDLE + SWING cos(phi - LAG)


def crank(way):
    """Return dw/dt = w*dw/dphi with dw/dphi = F cos phi - k (w - MIDDLE), F = SWING*sqrt(1 + k^2), k = cot LAG."""
    k = 1 / math.tan(LAG)
    force = SWING * math.hypot(1.0, k)

    def slope(t, phi, w):
        return (way * (way * w) * (force * math.cos(way * phi) - k * (way * w - MIDDLE)),)

    return SimpleNamespace(free=(0,), others=(), kept=(), slope=slope)


@pytest.mark.parametrize("begin", [0.0, 0.7, 3.0, -2.0])
@pytest.mark.parametrize("way", [1, -1])
def test_speed_period_and_extremes_of_the_turn_are_those_by_hand(begin, way):
    """dt = dphi/w over a turn is 2 pi/sqrt(MIDDLE^2 - SWING^2)."""
    found = find_regime(crank(way), [begin], way * 0.7)
    assert found.speed == pytest.approx(way * (MIDDLE + SWING * math.cos(way * begin - LAG)), rel=1e-10)
    mean = math.sqrt(MIDDLE**2 - SWING**2)
    assert (found.period, found.mean) == (pytest.approx(2 * math.pi / mean, rel=1e-10), pytest.approx(mean, rel=1e-10))
    assert (found.largest, found.least) == pytest.approx((way * (MIDDLE + SWING), way * (MIDDLE - SWING)), rel=1e-10)
    for at, wanted in ((found.largest_at, LAG), (found.least_at, LAG + math.pi)):
        assert 0 <= way * (at - begin) <= 2 * math.pi
        assert math.remainder(at - way * wanted, 2 * math.pi) == pytest.approx(0.0, abs=1e-8)
    assert found.delta == pytest.approx(2 * SWING / mean, rel=1e-10)


def test_of_two_swings_in_a_turn_the_larger_is_told():
    """w = 8 + cos 2 phi + cos(phi)/2: 9.5 at 0, 8.5 at a half turn; least where 4 cos phi = -1/2, 8 - 1 - 1/32 there."""

    def slope(t, phi, w):
        return (w * (-2 * math.sin(2 * phi) - math.sin(phi) / 2 - 3 * (w - 8 - math.cos(2 * phi) - math.cos(phi) / 2)),)

    found = find_regime(SimpleNamespace(free=(0,), others=(), kept=(), slope=slope), [1.0], 8.0)
    assert (found.largest, found.least) == pytest.approx((9.5, 7 - 1 / 32), rel=1e-9)
    assert (math.cos(found.largest_at), math.cos(found.least_at)) == pytest.approx((1.0, -1 / 8), abs=1e-8)


@pytest.mark.parametrize("size", [1.0, 1e-4, 1e4])
def test_an_even_turn_has_no_unevenness(size):
    even = SimpleNamespace(free=(0,), others=(), kept=(), slope=lambda t, phi, w: (0.1 * size * (3.0 * size - w),))
    found = find_regime(even, [0.2], 2.9 * size)
    told = (found.delta, found.mean / size, found.largest / size, found.least / size, found.largest_at, found.least_at)
    assert told == pytest.approx((0.0, 3.0, 3.0, 3.0, 0.2, 0.2), abs=1e-10)


@pytest.mark.parametrize("slope", [
    lambda t, phi, w: (-1.0,), lambda t, phi, w: (w,), lambda t, phi, w: (1 / (phi - 1.0),),
    lambda t, phi, w: (w * (0.2 + 0.1 * math.sin(3 * w)),),  # faster after every turn, and never by the same
])  # fmt: skip
def test_what_stands_still_only_grows_or_has_no_value_has_no_steady_motion(slope):
    assert find_regime(SimpleNamespace(free=(0,), others=(), kept=(), slope=slope), [0.0], 1.0) is None


SLED = mechanism("drawn-block")


def test_a_slider_makes_no_turns_and_has_its_speed_in_metres_a_second():
    """u was said to be so many rad/s in a steady turn."""
    run = coursework.solve(coursework.parse_variant(SLED))
    assert run.scene.regime is None and run.scene.unit_of_rates == "m/s"
    assert run.accuracy.sentences[0].endswith(" m/s.")
