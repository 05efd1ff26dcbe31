"""A wheel on a crank, rolling in a ring: back after as many turns of the crank as its ratio asks for, or never."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.close_to_motion import several_periods
from tests.hard.scenes import scene
from tests.mechanisms.library import changed, mechanism
from tests.report.own import FIVE_BAR
from tests.results.checks.independent import judge
from tests.results.checks.scenes import evidence_of, finding, found, solve
from tests.results.checks.verdicts import contradictions

PERIODS = ("PERIOD-POSITION", "PERIOD-VELOCITY")
TURN = 2 * math.pi / 5


def wheel(ring, period="2*pi/w", turns=1, law="w"):
    """Return the file of a ring of 0.3 m radius times `ring`/3, a wheel of 0.3 m in it and a pin that pushes a slider."""
    return mechanism("wheel-in-a-ring", R=f"{ring} m", wc=law, end=f"{turns}*2*pi/w", period=period)


def judged(text, scheme="rk4"):
    run = solve(text, scheme)
    return [found(run, code) for code in PERIODS]


@pytest.mark.parametrize(("turns", "verdict"), [(1, "SKIP"), (2, "SKIP"), (2.9, "SKIP"), (3, "PASS"), (4, "PASS"), (6, "PASS")])
def test_seven_thirds_are_back_after_three_turns(turns, verdict):
    position, velocity = judged(wheel("0.7", turns=turns))
    assert position.verdict == velocity.verdict == verdict
    for one in (position, velocity):
        assert f"returns after 3 periods of the drive, at t = {3 * TURN:.6g} s" in one.sentence
        assert ("the table ends before" in one.sentence) == (verdict == "SKIP")
    if verdict == "PASS":
        assert position.row == {3: 121, 4: 121, 6: 241}[turns]
        assert position.value < 1e-6


def test_a_whole_ratio_is_back_after_one_turn():
    for one in judged(wheel("0.9")):
        assert one.verdict == "PASS"
        assert "returns after" not in one.sentence


@pytest.mark.parametrize("turns", [1, 3])
def test_a_ratio_that_is_no_simple_fraction_never_returns(turns):
    for one in judged(wheel(repr(0.3 * (1 + math.sqrt(2))), turns=turns)):
        assert one.verdict == "SKIP"
        assert "not a simple fraction" in one.sentence


@pytest.mark.parametrize(("most", "told"), [(21, "after 21 periods"), (20, "first 20 periods")])
def test_the_last_period_that_is_waited_for(monkeypatch, most, told):
    """Of a wheel 20/21 of a turn a lap, the pin of Cardan's with a radius 5 % larger."""
    monkeypatch.setattr(several_periods, "MOST", most)
    monkeypatch.setattr("coursework.results.checks.close_to_motion.period.MOST", most)
    for one in judged(wheel(repr(0.3 * (1 + 19 / 21)))):
        assert one.verdict == "SKIP"
        assert told in one.sentence


@pytest.mark.parametrize(("off", "is_fraction"), [(0.9, True), (1.1, False)])
def test_a_ratio_is_a_fraction_as_far_as_the_limit(off, is_fraction):
    ratio = 4 / 3 + off * several_periods.WHOLE / 3
    sentence = judged(wheel(repr(0.3 * (1 + ratio))))[0].sentence
    assert ("after 3 periods" in sentence) == is_fraction


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("off", "verdict"), [(0.029, "PASS"), (0.0301, "FAIL")])
def test_a_wrong_period_of_the_drive_is_wrong(side, off, verdict):
    """Inside the limit it is that of the drive, which returns as its whole turns say (the scale has 39 of 40 rows at least)."""
    text = wheel("0.7", repr(TURN * (1 + side * off)) + " s", turns=4)
    for one in judged(text):
        assert one.verdict == verdict, one.sentence
        assert ("Check the period" in one.sentence) == (verdict == "FAIL")
        assert (f"t = {3 * TURN:.6g} s" in one.sentence) == (verdict == "PASS")


@pytest.mark.parametrize("period", ["pi/w", "2*pi/w*4/3", "2*pi/w*1.5"])
def test_part_of_a_turn_of_the_drive_is_no_period(period):
    position = judged(wheel("0.7", period, turns=4))[0]
    assert position.verdict == "FAIL"
    assert "Check the period" in position.sentence


@pytest.mark.parametrize("end", ["2 s", "1 s"])
@pytest.mark.parametrize(("period", "again"), [("1 s", "Check the period. After 2 times as long, 2 s, it does."), ("0.9 s", "")])
def test_a_period_of_one_crank_is_told_with_that_of_both(period, again, end):
    """Two cranks at 60 and 30 rpm: a turn of the first is half of what brings both back, be it in the run or beyond."""
    position = judged(changed(FIVE_BAR, period=period, end=end))[0]
    assert position.verdict == "FAIL" and position.sentence.endswith(again or "Check the period.")


def test_a_drive_that_changes_its_speed_is_waited_for_too():
    text = wheel("0.7", turns=3, law="w*(1 + 0.3*sin(w*t))")
    assert [one.verdict for one in judged(text)] == ["PASS", "PASS"]
    assert [one.verdict for one in judged(text.replace('"2*pi/w"', '"1.04*2*pi/w"'))] == ["FAIL", "FAIL"]


def test_euler_is_judged_after_three_turns_by_what_it_strays():
    position = judged(wheel("0.7", turns=3, law="w*(1 + 0.3*sin(w*t))"), "euler")[0]
    assert position.verdict in {"PASS", "COARSE"}
    assert "after 3 periods" in position.sentence


def test_what_is_not_back_then_is_not_explained(monkeypatch):
    """Where the motion itself is not back after the turns that the wheel needs, the stated period is wrong as before."""
    run = solve(wheel("0.7", turns=3), "rk4")
    monkeypatch.setattr(several_periods, "_is_back", lambda evidence, time: False)
    assert finding("PERIOD-POSITION", evidence_of(run)).verdict == "FAIL"


@pytest.mark.long
@pytest.mark.parametrize("ring", ["0.7", "0.75", "0.9", repr(0.3 * (1 + math.sqrt(2)))])
@pytest.mark.parametrize("turns", [1, 3, 4])
def test_an_independent_integration_says_the_same(ring, turns):
    run = solve(wheel(ring, turns=turns, law="w*(1 + 0.3*sin(w*t))"), "heun")
    assert contradictions(run, judge(run)) == []


def test_a_wheel_nearly_back_is_told_the_same_by_positions_and_velocities():
    """98 % of a turn a lap: the wheel is off its start by less than 3 %, the pin's speed by more."""
    told = judged(wheel(repr(0.3 * 1.98), turns=1).replace('e = "0.1 m"', 'e = "0.5 m"'))
    assert [one.verdict for one in told] == ["SKIP", "SKIP"]
    assert all("after 50 periods" in one.sentence for one in told)


@pytest.mark.parametrize("size", ["0.1 m", "1 mm"])
def test_a_slider_on_a_slow_wheel_is_not_taken_for_one_that_travels_on(size):
    """A wheel of 1/99 of a turn a lap moves it back and forth: nearly as far in the first lap as in the second."""
    text = scene(
        'phi = { start = "0.5 rad", rate = "w" }\npsi = { start = "0.2 rad", rate = "w2" }\nx = { start = "0 m", rate = "u" }',
        given=f'r = "{size}"', drive='w = "2*pi"', step=1 / 32, equations=["w2 = w/99", "u = -r*w2*sin(psi) + r*w*cos(phi)"],
        time='period = "1 s"',
    )  # fmt: skip
    for one in judged(text):
        assert one.verdict == "SKIP"
        assert "after 99 periods" in one.sentence


@pytest.mark.parametrize(("period", "verdict"), [("10 s", "FAIL"), ("12*2*pi/w", "SKIP")])
def test_of_a_period_too_long_to_be_followed_the_drive_says_whether_it_can_be_right(period, verdict):
    positions, velocities = judged(wheel(0.9, period, law="w + w*cos(2*w*t)/2"))
    assert (positions.verdict, velocities.verdict) == ("SKIP", verdict)
    assert verdict == "SKIP" or "wc begins at 7.5 rad/s and is 7.1558 rad/s then" in velocities.sentence


@pytest.mark.parametrize(
    ("gain", "periods"),
    [(1 / 3, 3), (1 / 100, 100), (1 / 101, None), (0.5 + 0.4e-4, 2), (0.5 + 0.6e-4, None), (2 / 7, 7), (math.sqrt(0.1), None)],
)
def test_a_wheel_is_back_after_the_first_whole_number_of_turns_up_to_a_hundred_periods(monkeypatch, gain, periods):
    """Whole to a ten-thousandth of a turn: `gain` turns of the wheel a period."""
    assert later_of(monkeypatch, gain).periods == periods


@pytest.mark.parametrize("gain", [0.0, 1.0, 3 + 0.9e-4])
def test_a_wheel_that_is_back_each_period_explains_nothing(monkeypatch, gain):
    assert later_of(monkeypatch, gain) is None


@pytest.mark.parametrize(("more", "explains"), [(0.9e-4, True), (1.1e-4, False)])
def test_a_wheel_gains_the_same_each_period(monkeypatch, more, explains):
    assert (later_of(monkeypatch, 0.25, 0.25 + more) is not None) == explains


@pytest.mark.parametrize(("slid", "explains"), [(0.9e-4, True), (1.1e-4, False)])
def test_a_slide_that_travels_on_is_never_back(monkeypatch, slid, explains):
    assert (later_of(monkeypatch, 0.25, slid=slid) is not None) == explains


def later_of(monkeypatch, gain, second=None, slid=0.0):
    """Return what is told of a crank that turns once a period, a wheel that turns so much in the first two, and a slide."""
    turned = {1.0: gain, 2.0: gain + (gain if second is None else second)}
    rows = {time: np.array([time, wheel, slid * time]) * 2 * np.pi for time, wheel in turned.items()}
    monkeypatch.setattr(several_periods, "after", lambda _, time: rows.get(time))
    monkeypatch.setattr(several_periods, "missed", lambda *_: 0.0)
    monkeypatch.setattr(several_periods, "_is_back", lambda *_: True)
    names = {"crank": "rad", "wheel": "rad", "slide": "m"}
    listed = [SimpleNamespace(name=name, rate=f"of {name}", unit=unit) for name, unit in names.items()]
    variant = SimpleNamespace(coordinates=listed, driven_coordinates=listed[:1], known_rates=())
    exact = SimpleNamespace(rows=np.zeros((1, 3)), coordinate_names=tuple(names))
    return several_periods._later(
        SimpleNamespace(
            exact=exact,
            variant=variant,
            period=1.0,
            least=lambda name: 1e-10,
            unit=names.get,
            scale=dict.fromkeys(names, 2 * np.pi),
        )
    )


@pytest.mark.parametrize(("end", "missed", "is_back"), [(1.01, 0.02, True), (1.01, 0.04, False), (0.99, 0.04, True)])
def test_as_far_as_twice_the_run_every_column_must_be_back(monkeypatch, end, missed, is_back):
    monkeypatch.setattr(several_periods, "after", lambda *_: np.zeros(1))
    monkeypatch.setattr(several_periods, "missed", lambda *_: missed)
    judged = SimpleNamespace(motion=SimpleNamespace(t=np.array([0.0, end])), names=("q",))
    assert several_periods._is_back(judged, 2.0) == is_back
