"""What is judged of a motion under forces: places as well as rates, energy only where the rows show the work."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.effects.dynamics.dynamics_checks import _accuracy, _areas, _scales
from coursework.words.sentences import say
from tests.effects.dynamics.test_dynamics import pushed
from tests.effects.test_rubbing import UNRUBBED
from tests.hard.scenes import check
from tests.mechanisms.library import mechanism


@pytest.mark.parametrize(("size", "scale"), [(0.9e-9, 2.0), (3e-9, 3e-9)])
def test_a_velocity_that_only_rounds_is_measured_by_the_fastest_of_its_unit(size, scale):
    """The rod between parallel cranks keeps its angle: 3e-15 rad/s were 166 % of its scale, and a right table was coarse."""
    rates = np.array([[0.0, size, -3.0], [-2.0, 0.0, 0.0]])
    motion = SimpleNamespace(
        coordinate_names=("p", "q", "s"), velocity_names=("w1", "w2", "u"), coordinates=rates, velocities=rates, step=0.1
    )
    unit = {"p": "rad", "q": "rad", "s": "m", "w1": "rad/s", "w2": "rad/s", "u": "m/s"}
    units = SimpleNamespace(unit_of=unit.get, given=())
    assert _scales(motion, units, 2)[3:] == pytest.approx([2.0, scale, 3.0])


@pytest.mark.parametrize(("turns", "verdict"), [(1, "PASS"), (2, "COARSE")])
def test_rates_that_are_right_are_no_table_whose_places_wander(turns, verdict):
    """F cos(pt) on 2 kg: Euler's u is above sin(pt) F/(2p) by h (1 - cos pt) F/4 and s runs away by the mean of it.

    After so many turns s is off by turns p h/2 pi of its swing, u by p h of its largest at most.
    """
    p, step = 40.0, 0.028 / 40
    run = pushed("q*cos(p*t)", f'[given]\nq = "1 N"\np = "{p} 1/s"\n', "euler", step=step, end=turns * 2 * math.pi / p)
    found, t = check(run, "MOTION"), run.motion.t
    off_u = np.abs(run.motion.column("u") - np.sin(p * t) / (2 * p)).max() * 2 * p
    off_s = np.abs(run.motion.column("s") - 1 - (1 - np.cos(p * t)) / (2 * p**2)).max() * p**2
    assert off_u < 0.029 and off_s == pytest.approx(turns * math.pi / 2 * p * step, rel=0.15)
    assert (found.verdict, found.column, found.value) == (verdict, "s", pytest.approx(off_s, rel=1e-2))


def test_energy_is_not_judged_where_the_rows_do_not_show_the_work():
    """A pulse of 1e-5 s in rows 0.05 s apart: no sum over rows knows what it gave."""
    given = '[given]\nq = "1 N"\nt1 = "1 s"\nw = "1e-5 s"\nt0 = "0.503 s"\n'
    for scheme in ("exact", "euler"):
        run = pushed("q*t1/(w*sqrt(pi))*exp(-((t - t0)/w)^2)", given, scheme)
        told = check(run, "ENERGY")
        assert (told.verdict, told.value) == ("SKIP", None) and "too far apart" in told.sentence
    assert check(run, "MOTION").value == pytest.approx(1.0)  # Euler's rows know nothing of it


@pytest.mark.parametrize(("scheme", "step", "way"), [("euler", 0.01, "that nothing gave it"), ("rk4", 0.2, "has lost")])
def test_a_scheme_makes_energy_or_takes_it_away(scheme, step, way):
    """A swing of p = 5/s: Euler multiplies its energy by 1 + z a step, Runge-Kutta 4 by 1 - z^3/72 + z^4/576 with z = (p h)^2."""
    run = coursework.solve(
        coursework.parse_variant(UNRUBBED.replace('start = "1 m"', 'start = "0.5 m"')), scheme=scheme, step=step, end=40 * step
    )
    told, z = check(run, "ENERGY"), (5 * step) ** 2
    kept = (1 + z if scheme == "euler" else 1 - z**3 / 72 + z**4 / 576) ** 40
    assert told.verdict == "COARSE" and way in told.sentence
    assert f"{abs(kept - 1) * 6.25:.3g} J" in told.sentence  # of 50 N/m stretched by 0.5 m


@pytest.mark.parametrize(("scheme", "share", "verdict"), [
    ("euler", 1.01, "COARSE"), ("euler", 0.99, "PASS"), ("semi-implicit", 1.01, "COARSE"), ("semi-implicit", 0.99, "PASS"),
    ("rk4", 1.38, "PASS"), ("rk4", 1.42, "COARSE"),
])  # fmt: skip
def test_a_step_that_no_swing_survives_is_not_short_enough(scheme, share, verdict):
    """A swing of p = 5/s: from p h = 2 on no step of order one keeps it within bounds, from sqrt(8) on none of Runge-Kutta 4."""
    text = UNRUBBED.replace('start = "1 m"', 'start = "0.5 m"')
    told = check(coursework.solve(coursework.parse_variant(text), scheme=scheme, step=share * 2 / 5, end=4.0), "STABLE")
    assert told.verdict == verdict
    assert ("faster than the step can follow" in str(told.sentence)) == (verdict == "COARSE")


@pytest.mark.parametrize(("scheme", "verdict"), [("rk4", "PASS"), ("euler", "COARSE")])
def test_where_no_force_works_the_energy_must_stay(scheme, verdict):
    """T = (m1/6 + m2/2) r1^2 w1^2 + m2 r2^2 w2^2/6 + m2 r1 r2 w1 w2 cos(phi1 - phi2)/2: an arm without weight, 3 and 2 kg."""
    text = mechanism(
        "falling-arm",
        ('gravity = "9.81 m/s^2"\n', ""),
        ('["w1", "w2"]', '["w1", "w2"]\nstart = { w1 = "3 rad/s", w2 = "-5 rad/s" }'),
    )
    run = coursework.solve(coursework.parse_variant(text), scheme=scheme)
    a, b, u, v = (run.motion.column(name) for name in ("phi1", "phi2", "w1", "w2"))
    energy = (3 / 6 + 2 / 2) * 0.25 * u**2 + 2 * 0.16 * v**2 / 6 + 0.2 * u * v * np.cos(a - b)
    off = np.abs(energy - energy[0]).max() / energy[0]
    told = check(run, "ENERGY")
    assert (told.verdict, told.value) == (verdict, pytest.approx(off, rel=1e-3)) and f"{energy[0]:.4g} J" in str(told.sentence)


@pytest.mark.parametrize("rows", [2, 3, 4, 9])
def test_areas_between_rows_are_those_of_a_line_and_from_four_rows_on_of_a_cubic(rows):
    t = np.linspace(1.0, 3.0, rows)
    line, cubic = 2 * t + 1, t**3
    assert _areas(line, t) == pytest.approx(np.diff(t**2 + t))
    assert (_areas(cubic, t) == pytest.approx(np.diff(t**4 / 4))) is (rows > 3)


@pytest.mark.parametrize(("scheme", "after", "parts"), [("rk4", "-0.8", 4), ("heun", "0.2", 3)])
def test_a_step_is_run_before_it_is_advised_where_a_force_breaks_between_two_rows(scheme, after, parts):
    """By its order Runge-Kutta 4 would need half the step, which is too coarse too: u3 is off by 5.9 %."""
    law = f'[functions]\ng = {{ pieces = [["0 s", "1"], ["0.503 s", "{after}"]] }}\n\n[coordinates]'
    text = mechanism("example-2-motor", ("[coordinates]", law), ('"M0 - k*w1"', '"M0*g - k*w1"'))
    variant = coursework.parse_variant(text)
    told = check(coursework.solve(variant, scheme, 0.05, end=1.5), "MOTION")
    assert told.verdict == "COARSE" and str(told.sentence).endswith(f"A step of {0.05 / parts:.10g} s does: it was tried.")
    found = coursework.solve(variant, scheme, float(f"{0.05 / parts:.10g}"), end=1.5)
    assert [one.code for one in found.checks if one.verdict == "COARSE"] == []


def test_the_energy_of_a_pendulum_in_a_field_that_leans_is_that_of_its_weight():
    """A rod of 4 kg and 0.6 m falls freely: T + V with V = -m g·r by hand, which stays, is what the scene gives in every row."""
    text = mechanism("pendulum", ("[forces]\n", '[forces]\ngravity = "(1.5, -9.5)"\n'), s=None, d=None, k=None, c=None)
    run = coursework.solve(coursework.parse_variant(text), scheme="exact")
    phi, w = (run.motion.column(name) for name in ("phi", "w"))
    by_hand = 4 * 0.6**2 / 6 * w**2 - 4 * 0.3 * (1.5 * np.cos(phi) - 9.5 * np.sin(phi))
    assert np.ptp(w) > 1 and np.ptp(by_hand) < 1e-12
    assert run.scene.energy_of(run.motion) == pytest.approx(by_hand, abs=1e-12)


@pytest.mark.parametrize(("own", "exact", "told"), [
    (1, 1, "check.no_row"), (0, 0, "check.no_row"), (1, 5, "check.no_row"), (2, 1, "check.unknown"), (5, 0, "check.unknown"),
])  # fmt: skip
def test_of_fewer_than_two_rows_in_common_it_is_told_whose_are_lacking(own, exact, told):
    """Rows that the motion itself does not reach are not known to be right; of a single row nothing is said."""
    rows = [SimpleNamespace(rows=SimpleNamespace(count=count)) for count in (own, exact)]
    found = _accuracy(SimpleNamespace(scheme="euler", own=rows[0], exact=rows[1]))
    assert (found.verdict, found.sentence) == ("SKIP", say(told))
