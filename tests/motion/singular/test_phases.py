"""Where phases are looked at, and how closely the ends of what is possible are told."""

import math

import pytest

import coursework
from coursework.motion.singular.explain import explain
from coursework.motion.singular.phases import _intervals, _phase_of
from coursework.motion.singular.scaled_flow import Flow
from coursework.variant.reading.set_values import with_set

TURN = 2 * math.pi
PART = TURN / 24


@pytest.mark.parametrize(
    "law, phase", [("sin(p*t + alpha)", "alpha"), ("sin(p*t - alpha)", "alpha"), ("sin(-alpha + p*t)", "alpha"), ("sin(p*t)", "")]
)
def test_the_phase_is_the_angle_that_a_wave_of_the_drive_adds_or_takes_away(law, phase):
    text = coursework.load("31").path.read_text(encoding="utf-8").replace("sin(p*t + alpha)", law)
    assert _phase_of(coursework.parse_variant(text)) == phase


def test_phases_are_looked_at_in_the_middles_of_24_equal_parts_of_a_turn():
    seen = []
    assert _intervals(lambda value: bool(seen.append(value)), PART * 10) == []
    assert seen == pytest.approx([PART * (place + 0.5) for place in range(24)], abs=1e-12)


@pytest.mark.parametrize(
    "ranges",
    [
        [(1.0, 2.0)],
        [(0.5, 1.5), (3.0, 4.0)],
        [(5.0, TURN + 1.0)],  # through the end of the turn
        [(PART * 3.49, PART * 3.51)],  # narrow, about one of the places
        [(PART * 0.4, PART * 0.6)],  # about the first place
        [(PART * 23.4, PART * 23.6)],  # about the last
        [(PART * 0.51, PART * 24.49)],  # all places but the first
        [(PART * 10.01, PART * 33.99)],  # all places, but not between two of them, where the motion stops
    ],
)
def test_each_end_is_told_from_within_and_to_a_4096th_part_of_the_distance(ranges):
    def possible(value):
        return any(low < value < high or low < value + TURN < high for low, high in ranges)

    gap = ranges[0][1], ranges[1][0] if len(ranges) > 1 else ranges[0][0] + TURN
    found = _intervals(possible, sum(gap) / 2)
    assert len(found) == len(ranges)
    for (low, high), (right_low, right_high) in zip(found, ranges, strict=True):
        assert possible(low)
        assert possible(high % TURN)
        assert 0 <= (low - right_low + 1) % TURN - 1 <= PART / 2**12
        assert 0 <= (right_high - high + 1) % TURN - 1 <= PART / 2**12
        assert 0 < high - low < TURN


def test_what_is_narrower_than_the_distance_is_found_only_about_a_place():
    assert _intervals(lambda value: PART * 3.51 < value < PART * 4.49, PART * 10) == []


def test_a_change_point_far_from_where_a_motion_stops_is_not_gone_to(monkeypatch):
    """With 0.1 m instead of 0.953 m it stops at a dead point with most phases, and its change points are a radian away."""
    looked = []
    part = Flow.part
    monkeypatch.setattr(Flow, "part", lambda flow, *values: looked.append(1) or part(flow, *values))
    run = coursework.solve(with_set(coursework.load("31"), ("r1=0.1m",), None))
    assert run.stop.kind == "dead point"
    assert "is possible for" in run.scene.phases
    assert len(looked) < 1500  # 2485 where each is gone to


@pytest.mark.parametrize(
    "speed, told",
    [("2.205", "for 0.0924 < alpha < 6.1908 (rad, modulo 2π); here alpha = 0."), ("45", "With these data no phase alpha")],
)
def test_what_is_possible_leaves_out_the_phase_at_which_the_motion_stops(speed, told):
    """At 2.2 m/s it is possible for all phases, at 2.21 m/s for those between 0.1326 and 6.1506."""
    scene = coursework.solve(with_set(coursework.load("31"), (f"V1={speed}m/s", "alpha=0rad"), None), quantities=["table"]).scene
    assert told in scene.phases


def test_a_dead_point_is_told_with_the_rows_about_it():
    """At a row if it misses it by round-off only: the fifth, 4 h, by 5e-9 h."""
    scene = coursework.solve(with_set(coursework.load("31"), ("alpha=0.02rad",), None), quantities=["table"]).scene
    steps, told = (4 - 5.1e-9, 4 - 4.9e-9, 4.0, 4 + 4.9e-9, 4 + 5.1e-9, 4.5, 0.5), []
    for number in steps:
        stop = explain(scene.search.event, scene.equations, scene.reduction, scene.search.event.time / number, None)
        told.append(str(stop.cause).partition(" s, ")[2].partition(",")[0])
    assert told == [
        "between rows 4 and 5", "at row 5", "at row 5", "at row 5", "between rows 5 and 6", "between rows 5 and 6",
        "between rows 1 and 2",
    ]  # fmt: skip
