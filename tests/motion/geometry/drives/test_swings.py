"""How fast a tabulated drive swings, against the sines it was made of; and which laws do not swing."""

from contextlib import nullcontext
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.geometry.drives import drive, swings
from coursework.motion.geometry.drives.swings import swinging
from coursework.words.errors import InputError

T = np.linspace(0, 1, 201)


@pytest.mark.parametrize("phase", np.linspace(0, 6, 13))
@pytest.mark.parametrize("periods", [1.6, 2.0, 3.3, 7.0])
def test_a_sine_whose_ends_are_cut_anywhere(periods, phase):
    w = 2 * np.pi * periods
    assert swinging(T, np.sin(w * T + phase)) == pytest.approx(w, rel=0.02)


@pytest.mark.parametrize("decimals", [1, 2])
def test_rounding_changes_little(decimals):
    assert swinging(T, np.round(4.5 * np.sin(13 * T + 4.35), decimals)) == pytest.approx(13, rel=0.05)


@pytest.mark.parametrize(("size", "wanted"), [(0.2, 6.3), (0.4, 63)])
def test_the_faster_of_two_waves_counts_from_a_twentieth_of_the_power_on(size, wanted):
    assert swinging(T, np.sin(6.3 * T) + size * np.sin(63 * T)) == pytest.approx(wanted, rel=0.15)


def test_a_wave_that_grows_faster_is_measured_where_it_is_fastest():
    assert swinging(T, np.sin(40 * T**2)) == pytest.approx(80, rel=0.25)


@pytest.mark.parametrize("law", [
    np.zeros(201), np.full(201, 3.0), T, T**3, np.exp(-5 * T), np.tanh(20 * (T - 0.5)), np.round(0.3 * T, 1),
    10 + 0.4 * np.sin(60 * T), np.round(10 + 1e-3 * np.cos(7 * T), 1), np.sin(1.2 * T), np.where(T < 0.5, 1.0, -1.0),
])  # fmt: skip
def test_laws_that_do_not_swing_back_and_forth(law):
    assert swinging(T, law) == 0.0


def test_one_slow_hump_wants_no_more_than_ten_rows_of_its_width():
    assert swinging(T, np.sin(np.pi * T)) == pytest.approx(1.5 * np.pi, rel=0.01)


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "turns"), [(0.98e-9, True), (1.02e-9, False)])
def test_a_crank_turns_evenly_but_for_a_share_of_its_speed(size, part, turns, monkeypatch):
    """In a run too short for a whole turn."""
    monkeypatch.setattr(swings, "_looks", lambda _: [np.linspace(0, 1e-3, 3)])
    monkeypatch.setattr(swings, "drive_values", lambda *_: size * np.array([[1.0], [1.0 - part], [1.0]]))
    crank = SimpleNamespace(name="phi", rate="w", unit="rad")
    equations = SimpleNamespace(variant=SimpleNamespace(coordinates=[crank], known_rates=("w",)))
    assert swings.turning_cranks(equations) == ({"phi": size} if turns else {})


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("times", "endless"), [(0.98e4, False), (1.02e4, True), (np.nan, True)])
def test_a_drive_is_endless_beyond_ten_thousand_times_its_usual_size(size, times, endless, monkeypatch):
    monkeypatch.setattr(drive, "drive_values", lambda *_: size * np.array([[1.0]] * 33 + [[times], [1.0], [1.0]]))
    variant = SimpleNamespace(
        drive=[SimpleNamespace(name="u")], time=SimpleNamespace(end=1.0, step=0.1), coordinates=[], file="", line_of=lambda *_: 1
    )
    with pytest.raises(InputError, match="V323") if endless else nullcontext():
        drive.refuse_endless(SimpleNamespace(variant=variant), 0.5)
