"""The excess of energy of a torque given at equal angles, against integrals by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.effects.kinetostatics.flywheel import _excess, find_flywheel

STEP = 2 * math.pi / 3 / 16  # of a crank at 3 rad/s


def crank(rows=17, speed=3.0, spread=0.0, torque=1.0, kind="couple", uneven=True, pin=True):
    """Return forces of a crank about 1 + 2i whose torque is 7 + 5 cos(3t) N m, rows 22.5 degrees apart from 0.5 s, 0.4 rad on.

    It has 2 kg in its centre of mass, 0.3 m from the axis, and 0.1 kg m^2 about that; delta = 1/40 is wanted.
    """
    t = STEP * np.arange(rows)
    columns = {"phi": 0.4 + speed * t, "w": speed * (1 + spread * (np.arange(rows) == 1)), "M": torque * (7 + 5 * np.cos(3 * t))}
    drive = SimpleNamespace(is_drive="w", direction=SimpleNamespace(kind=kind), on="1", off="0", at=None)
    hinge = SimpleNamespace(is_drive="", on="0", off="1", at="O")
    body = SimpleNamespace(centre="S")
    wheel = SimpleNamespace(unevenness="1/40") if uneven else None
    scheme = SimpleNamespace(
        unknowns=[drive, *([hinge] if pin else [])], by_name={"1": body}, forces=SimpleNamespace(flywheel=wheel)
    )
    places = {"S": 1 + 2.3j, "O": 1 + 2j}
    given = SimpleNamespace(
        scheme=scheme, motion=SimpleNamespace(t=0.5 + t, column=columns.__getitem__), scalar=lambda _: [0.025],
        mass=lambda _: [2.0],
        inertia=lambda _: [0.1], vector=lambda name: [places[name]],
    )  # fmt: skip
    variant = SimpleNamespace(coordinates=[SimpleNamespace(name="x", rate="v"), SimpleNamespace(name="phi", rate="w")])
    return SimpleNamespace(rows=given, equations=SimpleNamespace(variant=variant), column=columns.__getitem__, drive_names=("M",))


@pytest.mark.parametrize("rows", [17, 18, 40])
@pytest.mark.parametrize("way", [1, -1])
def test_the_flywheel_of_a_torque_by_hand(rows, way):
    """The excess is 2*5 J however many rows follow the turn, 10/(9/40) kg m^2 hold it, less 0.1 + 2*0.09 of the crank."""
    found = find_flywheel(crank(rows, 3.0 * way), 16 * STEP)
    assert (found.mean, found.excess, found.inertia, found.own) == pytest.approx((7.0, 10.0, 400 / 9, 0.28), rel=1e-9)
    assert found.needed == pytest.approx(400 / 9 - 0.28, rel=1e-9)
    assert found.crossings == pytest.approx([0.4 + way * math.pi / 2, 0.4 + way * 3 * math.pi / 2], abs=1e-12)


def test_without_a_wanted_unevenness_the_crank_alone_is_told_and_without_a_pin_it_turns_about_the_origin():
    found = find_flywheel(crank(uneven=False), 16 * STEP)
    assert (found.inertia, found.needed) == (None, None) and found.own == pytest.approx(0.28)
    assert find_flywheel(crank(pin=False), 16 * STEP).own == pytest.approx(0.1 + 2 * (1 + 2.3**2))


@pytest.mark.parametrize(("changed", "period", "is_known"), [
    ({}, 16 * STEP, True), ({"rows": 16}, 16 * STEP, False), ({"spread": 0.9e-9}, 16 * STEP, True),
    ({"spread": 1.1e-9}, 16 * STEP, False), ({}, 16 * STEP * (1 + 0.9e-9), True), ({}, 16 * STEP * (1 + 1.1e-9), False),
    ({}, 16 * STEP * (1 - 1.1e-9), False), ({}, None, False), ({"torque": math.inf}, 16 * STEP, False),
    ({"speed": 0.0}, 16 * STEP, False),
    ({}, 3 * STEP, True), ({}, 2 * STEP, False), ({"rows": 2}, 1 * STEP, False), ({"kind": "force"}, 16 * STEP, False),
])  # fmt: skip
def test_a_flywheel_is_for_a_crank_at_an_even_speed_over_a_whole_period_in_rows(changed, period, is_known):
    assert (find_flywheel(crank(**changed), period) is not None) is is_known


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


@pytest.mark.parametrize("count", [24, *(pytest.param(count, marks=pytest.mark.long) for count in (23, 25, 37))])
def test_zeros_where_the_turn_begins_are_not_lost(count):
    """A sin x + B sin 2x + C sin 3x, as of a slider-crank that begins in its dead point, is zero at 0 and 180 degrees."""
    x = 2 * math.pi * np.arange(count) / count
    for size in np.random.default_rng(count).uniform(-0.1, 0.1, (8, 2)):
        wave = np.sin(x) + size[0] * np.sin(2 * x) + size[1] * np.sin(3 * x)
        excess, crossings = _excess(wave - wave.mean(), 0.0, 2 * math.pi)
        assert excess == pytest.approx(2 * (1 + size[1] / 3), rel=1e-10)
        assert len(crossings) == 2 and np.abs(np.sin(crossings)).max() < 1e-12


def test_a_zero_that_is_only_touched_from_below_takes_nothing_away():
    x = 2 * math.pi * np.arange(12) / 12
    excess, crossings = _excess(-np.cos(x) - np.cos(2 * x), 0.0, 2 * math.pi)
    assert excess == pytest.approx(2 * 3**1.5 / 4, rel=1e-12)
    assert crossings[0] == pytest.approx(math.pi / 3, abs=1e-12) and crossings[-1] == pytest.approx(5 * math.pi / 3, abs=1e-12)
