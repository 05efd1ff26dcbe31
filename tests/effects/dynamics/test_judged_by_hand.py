"""Checks of a motion under forces, each just inside and just outside of its limit, of numbers made by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.effects.dynamics import dynamics_checks
from coursework.effects.dynamics.dynamics_checks import (
    _accuracy,
    _energy,
    _judged,
    _slopes,
    _step,
    _step_for,
    remainder,
    stiffness,
)
from coursework.effects.dynamics.energy_study import _parts, _row
from coursework.effects.friction.held import Held
from coursework.motion.schemes import SCHEMES
from coursework.words.sentences import say

EULER, HEUN, RK4 = (SCHEMES[name] for name in ("euler", "heun", "rk4"))


@pytest.mark.parametrize(("left", "exchanged", "unseen", "given", "verdict", "key", "told"), [
    ([0, 0.0499, -0.01], 1, [0, 0], 1, "PASS", "ENERGY.pass", {"row": 2, "energy": 0.0499, "exchanged": 1}),
    ([0, 0.01, 0.0501], 1, [0, 0], 1, "COARSE", "ENERGY.coarse", {"row": 3, "energy": 0.0501}),
    ([0, -0.0501, 0.01], 1, [0, 0], 1, "COARSE", "ENERGY.lost", {"row": 2, "energy": 0.0501}),
    ([0, 1], 1, [0, 0.0998], 2, "COARSE", "ENERGY.coarse", {"row": 2}),
    ([0, 1], 1, [0, 0.1002], 2, "SKIP", "POWER.coarse", {"row": 2}),
    ([0, -0.098, 0], 2, [0, 0], 1, "PASS", "ENERGY.pass", {"row": 2, "energy": -0.098}),
    ([0, 1], 1, [0, 0.0499], 1, "COARSE", "ENERGY.coarse", {"row": 2}),
    ([0, 1], 1, [0, -0.0501], 1, "SKIP", "POWER.coarse", {"row": 2}),
    ([0, 1], 1, [0, 0.0501], 1, "SKIP", "POWER.coarse", {"row": 2}), ([0], 1, [0, 0], 1, "SKIP", "no_row", {}),
    ([0, 0], 4e-12, [0, 0], 4.9e-12, "SKIP", "forces.none", {}),
    # Of 5 J in all less than 5e-12 J is nothing: what moves with 2 J must keep them.
    ([0, 0.0998], 1, [0, 0], 4.9e-12, "PASS", "ENERGY.free", {"row": 2, "energy": 2, "off": 0.0998}),
    ([0, -0.1002], 1, [0, 0], 4.9e-12, "COARSE", "ENERGY.free", {"row": 2, "off": -0.1002}),
    ([0, 0.1002], 1, [0, 0], 5.1e-12, "COARSE", "ENERGY.coarse", {"row": 2}),
    ([0, 0.0], 0.0, [0, 0], 1, "PASS", "ENERGY.pass", {"row": 1, "energy": 0.0}),
])  # fmt: skip
def test_what_energy_is_told_to_be_made_or_lost(left, exchanged, unseen, given, verdict, key, told, monkeypatch):
    """The motion has 2 J at most, springs and weights 3 J; a twentieth of what is exchanged may be left."""
    pairs = {"own": (np.array(left, dtype=float), exchanged), "exact": (np.array(unseen, dtype=float), given)}
    monkeypatch.setattr(dynamics_checks, "remainder", lambda of: pairs[of.name])
    energy = SimpleNamespace(kinetic=np.array([0.0, 2.0]), potential=np.array([-3.0, 1.0]))
    found = _energy(
        SimpleNamespace(
            own=SimpleNamespace(name="own", rows=SimpleNamespace(count=len(left))),
            exact=SimpleNamespace(name="exact", energy=energy),
        )
    )
    assert (found.verdict, found.sentence.key) == (verdict, f"check.{key}")
    assert {name: found.sentence.values[name] for name in told} == pytest.approx(told)


@pytest.mark.parametrize(
    ("known", "rows", "key"), [(0, 0, "no_row"), (1, 1, "no_row"), (0, 3, "ENERGY.open"), (1, 3, "ENERGY.open")]
)
def test_rows_that_are_there_but_have_no_power_are_not_called_missing(known, rows, key, monkeypatch):
    monkeypatch.setattr(dynamics_checks, "remainder", lambda _: (np.zeros(known), 0.0))
    found = _energy(SimpleNamespace(own=SimpleNamespace(rows=SimpleNamespace(count=rows)), exact=None))
    assert (found.verdict, found.sentence.key) == ("SKIP", f"check.{key}")
    assert key == "no_row" or f"In row {known + 1} the power" in str(found.sentence)


@pytest.mark.parametrize(("moving", "key"), [(2.9e-12, "ENERGY.rest"), (3.1e-12, "forces.none")])
def test_what_is_tense_and_stands_is_at_rest(moving, key, monkeypatch):
    monkeypatch.setattr(dynamics_checks, "remainder", lambda _: (np.zeros(2), 0.0))
    exact = SimpleNamespace(energy=SimpleNamespace(kinetic=np.array([moving]), potential=np.array([-3.0])))
    assert _energy(SimpleNamespace(own=None, exact=exact)).sentence.key == f"check.{key}"


def test_what_is_left_is_the_energy_that_no_power_gave_up_to_a_row_that_locks():
    """T = t^2, V = -3t, and powers of 2t + 1 in all: 4t more are missing at t, of 3 + 12 J that V and the powers move at 3 s."""
    t = np.arange(5.0)
    energy = SimpleNamespace(
        kinetic=t**2, potential=-3 * t, drive=2 * t, loads=0 * t + 4, friction=np.where(t > 3, np.nan, -2.0), dampers=0 * t - 1
    )
    left, exchanged = remainder(SimpleNamespace(energy=energy, rows=SimpleNamespace(motion=SimpleNamespace(t=t))))
    assert (left, exchanged) == (pytest.approx(-4 * t[:4]), pytest.approx(12.0))
    energy.potential = -30 * t
    assert remainder(SimpleNamespace(energy=energy, rows=SimpleNamespace(motion=SimpleNamespace(t=t))))[1] == pytest.approx(90.0)
    energy.kinetic = 99 * t
    assert remainder(SimpleNamespace(energy=energy, rows=SimpleNamespace(motion=SimpleNamespace(t=t))))[1] == pytest.approx(297.0)
    energy.drive = t * np.nan
    assert remainder(SimpleNamespace(energy=energy, rows=SimpleNamespace(motion=SimpleNamespace(t=t))))[0].size == 0


def test_slopes_of_the_accelerations_follow_the_links():
    """x and z are free and y = x + z: of -3u + 2w - 5x + 7y and 4u - w + y - z the slopes by u, w show, by x, z 2, 7; 1, 0."""
    linear = SimpleNamespace(
        free=(0, 2), others=(1,), kept=(2.0,), newton=lambda t, x, y, z, kept: [(x + z - y) * kept / 2],
        slope=lambda t, x, y, z, u, w: (-3 * u + 2 * w - 5 * x + 7 * y, 4 * u - w + y - z, 99.0),
    )  # fmt: skip
    by_rates, by_places = _slopes(linear, 0.5, [1.0, 3.0, 2.0], [40.0, -6.0])
    assert by_rates == pytest.approx(np.array([[-3, 2], [4, -1]]), abs=1e-6)
    assert by_places == pytest.approx(np.array([[2, 7], [1, 0]]), abs=1e-6)


@pytest.mark.parametrize(("stop", "near", "rates"), [
    (None, 0.1, (5.0, 4.0)), ("dead", 0.29, (3.0, 2.0)), ("dead", -0.29, (3.0, 2.0)), ("dead", 0.31, (5.0, 4.0)),
])  # fmt: skip
def test_the_fastest_decay_and_swing_count_but_not_near_a_dead_point_or_where_it_locks(stop, near, rates, monkeypatch):
    """Decays of 3 and 5/s, swings of 2 and 4/s; in the third row friction locks, in the second a determinant is `near` zero."""

    def slopes(dynamics, t, q, v):
        assert (q, v) == ([10 * t], [100 * t])
        if t > 1:
            raise Held("A", locked=True)
        return np.diag([-3.0, 1.0] if t == 0 else [-5.0, -1.0]), np.diag([-4.0, 1.0] if t == 0 else [-16.0, 7.0])

    monkeypatch.setattr(dynamics_checks, "_slopes", slopes)
    t = np.array([0.0, 1.0, 2.0])
    motion = SimpleNamespace(
        t=t,
        coordinates=10 * t[:, None],
        column=lambda name: 100 * t,
        stop=stop,
        scaled=np.array([[1.0, -1.0], [0.9, near], [1.0, 1.0]]),
    )
    forces = SimpleNamespace(motor=SimpleNamespace(rates=("w",)))
    exact = SimpleNamespace(
        rows=SimpleNamespace(motion=motion), equations=SimpleNamespace(variant=SimpleNamespace(forces=forces))
    )
    assert stiffness(SimpleNamespace(exact=exact, dynamics=SimpleNamespace(rubbing=None))) == pytest.approx(rates)


@pytest.mark.parametrize(("scheme", "damped", "swinging", "verdict", "key", "step"), [
    (EULER, 19.9, 0, "PASS", "pass", None), (EULER, 20.1, 0, "COARSE", "steep", 1.8 / 20.1),
    (EULER, 20.1, 99, "COARSE", "steep", 1.8 / 20.1),
    (RK4, 27.8, 0, "PASS", "pass", None), (RK4, 27.9, 0, "COARSE", "steep", 0.9 * 2.785293563 / 27.9),
    (EULER, 0, 19.9, "PASS", "pass", None), (EULER, 0, 20.1, "COARSE", "stiff", 1.8 / 20.1),
    (HEUN, 0, 20.1, "COARSE", "stiff", 1.8 / 20.1),
    (RK4, 0, 27.9, "PASS", "pass", None), (RK4, 0, 28.1, "COARSE", "stiff", 2.52 / 28.1), (None, 99, 99, "SKIP", "skip", None),
])  # fmt: skip
def test_a_step_of_a_tenth_of_a_second_is_short_enough(scheme, damped, swinging, verdict, key, step, monkeypatch):
    """Euler and Heun hold a decay up to 2/h, Runge-Kutta 4 up to 2.785/h and a swing up to 2.8/h."""
    monkeypatch.setattr(dynamics_checks, "stiffness", lambda _: (damped, swinging))
    own, exact = (SimpleNamespace(rows=SimpleNamespace(count=count)) for count in (5, 5))
    found = _step(SimpleNamespace(scheme=scheme, step=0.1, own=own, exact=exact))
    assert (found.verdict, found.sentence.key, found.step) == (verdict, f"check.STABLE.{key}", step and pytest.approx(step))
    if verdict == "COARSE":
        assert found.value == pytest.approx(0.1 * (damped if key == "steep" else swinging))
    if verdict == "PASS":
        exact.rows.count = 4
        told = _step(SimpleNamespace(scheme=scheme, step=0.1, own=own, exact=exact))
        assert (told.verdict, told.sentence.key) == ("SKIP", "check.STABLE.unknown")


@pytest.mark.parametrize(("scheme", "share", "steps", "enough", "key", "step"), [
    (EULER, 0.0999, 100, None, "step", 1 / 4), (EULER, 0.1001, 100, None, "step", 1 / 5),
    (EULER, 0.501, 100, None, "no_step", None),
    (EULER, 0.1, 50_000, None, "step", 1 / 4), (EULER, 0.1, 50_001, None, "no_step", None),
    (HEUN, 0.0999, 100, 2, "tried", 1 / 2), (HEUN, 0.0999, 100, 9, "tried", 1 / 16), (HEUN, 0.0999, 100, 17, "no_step", None),
    (RK4, 0.399, 2500, 2, "tried", 1 / 2), (RK4, 0.401, 2500, 2, "no_step", None), (RK4, 0.399, 2501, 2, "no_step", None),
    (RK4, 0.501, 100, 1, "no_step", None),
])  # fmt: skip
def test_the_step_for_half_the_limit_follows_from_the_order_and_is_tried_where_it_may_fail(
    scheme, share, steps, enough, key, step
):
    """A share falls to 1/40 by 40 times as many parts of Euler's step, the root of that of Heun's, the fourth root of RK4's."""
    evidence = SimpleNamespace(scheme=scheme, step=1.0, exact=SimpleNamespace(rows=SimpleNamespace(count=steps + 1)))
    told = _step_for(share, evidence, lambda parts: parts >= enough)
    assert told.key == f"check.dynamics.{key}"
    assert step is None or told.values["step"] == pytest.approx(step)


@pytest.mark.parametrize(("off", "rows", "verdict", "key"), [
    (0.099, 3, "PASS", "MOTION.pass"), (0.101, 3, "COARSE", "MOTION.coarse"), (-0.101, 3, "COARSE", "MOTION.coarse"),
    (0.099, 2, "SKIP", "unknown"), (0.101, 2, "COARSE", "MOTION.coarse"),
])  # fmt: skip
def test_the_motion_is_close_as_far_as_it_is_known(off, rows, verdict, key, monkeypatch):
    """In row 2 the second column, of scale 2, is off; of three rows two or all are known."""
    monkeypatch.setattr(dynamics_checks, "_scales", lambda *_: np.array([1.0, 2.0]))
    true, own = np.ones((rows, 2)), np.ones((3, 2))
    own[1] += (0.04, off)
    variant = SimpleNamespace(unit_of={"q": "rad", "w": "rad/s"}.get)
    analyses = [
        SimpleNamespace(
            rows=SimpleNamespace(count=len(one), motion=SimpleNamespace(rows=one, names=("q", "w"))),
            equations=SimpleNamespace(variant=variant),
        ) for one in (own, true)
    ]  # fmt: skip
    found = _accuracy(SimpleNamespace(scheme=EULER, own=analyses[0], exact=analyses[1]))
    assert (found.verdict, found.sentence.key) == (verdict, f"check.{key}")
    if verdict != "SKIP":
        assert (found.column, found.row, found.value) == ("w", 2, pytest.approx(abs(off) / 2))
        values = found.sentence.values
        assert (values["row"], values["off"], values["scale"], values["unit"]) == (2, pytest.approx(abs(off)), 2.0, "rad/s")


@pytest.mark.parametrize(("verdict", "is_told"), [("PASS", False), ("SKIP", False), ("COARSE", True), ("FAIL", True)])
def test_a_start_that_is_right_is_not_told_alone(verdict, is_told, monkeypatch):
    checks = [
        SimpleNamespace(finding=lambda _, code=code: SimpleNamespace(code=code, verdict=verdict)) for code in ("START", "ENERGY")
    ]
    monkeypatch.setattr(dynamics_checks, "CHECKS", checks)
    rows = SimpleNamespace(rows=SimpleNamespace(motion=SimpleNamespace(notes=(), stop=None)))
    assert [one.code for one in _judged(SimpleNamespace(own=rows, exact=rows))] == (
        ["START", "ENERGY"] if is_told else ["ENERGY"]
    )


@pytest.mark.parametrize(("scheme", "steps", "parts"), [
    (EULER, 200, [1, 2, 4, 8, 16, 32]), (EULER, 201, [1, 2, 4, 8, 16]), (RK4, 200, [1, 2, 4, 8]), (RK4, 9999, [1, 2]),
])  # fmt: skip
def test_a_step_is_divided_until_a_run_takes_more_than_6400_slopes(scheme, steps, parts):
    assert _parts(scheme, steps, 6400) == parts


@pytest.mark.parametrize("ended", ["", "dead point"])
def test_a_trial_that_ends_early_has_no_error(ended):
    tried = SimpleNamespace(ended=ended, row=7, slopes=40, energy=np.array([5.0, 1.0, 4.5]))
    row = _row(EULER, tried, np.array([5.0, 4.0, 4.0]), 2, 1.0)
    assert row.failed == (say("study.cut_off", row=7) if ended else "")
    found = (row.evaluations, row.max_error, row.end_error)
    assert found == pytest.approx((0, np.nan, np.nan) if ended else (40, 3.0, 0.5), nan_ok=True)
