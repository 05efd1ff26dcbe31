"""The excess of energy of a torque given at equal angles, against integrals by hand."""

import math

import numpy as np
import pytest

from coursework.effects.kinetostatics.flywheel import _excess


@pytest.mark.parametrize("count", [3, 4, 7, 16])
@pytest.mark.parametrize(("begin", "turn"), [(0.0, 2 * math.pi), (0.5, -2 * math.pi), (-1.0, 4 * math.pi)])
def test_the_excess_of_a_cosine_is_twice_its_size_and_it_crosses_twice(count, begin, turn):
    """The integral of A cos(x - d) runs from -A to A; a crank that turns twice as far in a period takes twice the work."""
    x = 2 * math.pi * np.arange(count) / count
    excess, crossings = _excess(3.0 * np.cos(x - 0.3), begin, turn)
    assert excess == pytest.approx(6.0 * abs(turn) / (2 * math.pi), rel=1e-5)  # read at 2049 angles
    share = turn / (2 * math.pi)
    assert crossings == pytest.approx([begin + share * (0.3 + math.pi / 2), begin + share * (0.3 + 3 * math.pi / 2)], abs=1e-12)


def test_two_harmonics_cross_where_both_cancel():
    """cos x + cos 2x = 2 cos(3x/2) cos(x/2): zero at 60, 180 (touched) and 300 deg; sin x + sin 2x/2 at 60 deg is 3^1.5/4."""
    x = 2 * math.pi * np.arange(12) / 12
    excess, crossings = _excess(np.cos(x) + np.cos(2 * x) + 1e-9, 0.0, 2 * math.pi)
    assert excess == pytest.approx(2 * 3**1.5 / 4, rel=1e-4)
    assert crossings[0] == pytest.approx(math.pi / 3, abs=1e-8) and crossings[-1] == pytest.approx(5 * math.pi / 3, abs=1e-8)


@pytest.mark.parametrize("wave", [[0.0] * 6, [1.0, -1.0] * 3])
def test_an_even_torque_and_a_highest_harmonic_without_a_phase_have_no_excess(wave):
    assert _excess(np.array(wave), 0.0, 2 * math.pi) == (0.0, ())


@pytest.mark.long
@pytest.mark.parametrize("count", [23, 24, 25, 37])
def test_zeros_where_the_turn_begins_are_not_lost(count):
    """A sin x + B sin 2x + C sin 3x, as of a slider-crank that begins in its dead point, is zero at 0 and 180 degrees."""
    x = 2 * math.pi * np.arange(count) / count
    for size in np.random.default_rng(count).uniform(-0.1, 0.1, (20, 2)):
        wave = np.sin(x) + size[0] * np.sin(2 * x) + size[1] * np.sin(3 * x)
        excess, crossings = _excess(wave - wave.mean(), 0.0, 2 * math.pi)
        assert excess == pytest.approx(2 * (1 + size[1] / 3), rel=1e-10)
        assert len(crossings) == 2 and np.abs(np.sin(crossings)).max() < 1e-12


def test_a_zero_that_is_only_touched_from_below_takes_nothing_away():
    x = 2 * math.pi * np.arange(12) / 12
    excess, crossings = _excess(-np.cos(x) - np.cos(2 * x), 0.0, 2 * math.pi)
    assert excess == pytest.approx(2 * 3**1.5 / 4, rel=1e-12)
    assert crossings[0] == pytest.approx(math.pi / 3, abs=1e-12) and crossings[-1] == pytest.approx(5 * math.pi / 3, abs=1e-12)
