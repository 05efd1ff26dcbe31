"""The motion itself under forces that change at once or within less than a row, and in mechanisms of any size."""

import math

import numpy as np
import pytest

import coursework
from coursework.effects.dynamics import dynamics
from coursework.effects.dynamics.dynamics import dormand_prince_8, why_ended
from tests.effects.test_rubbing import UNRUBBED
from tests.mechanisms.library import mechanism

FREE = UNRUBBED.replace(
    'k1 = { spring = ["O", "C"], stiffness = "50 N/m", free = "1 m" }', 'F = { on = "1", at = "C", force = "(PUSH, 0)" }'
).replace('end = "12 s"', 'end = "1 s"')


def pushed(push, given, scheme="exact", **options):
    text = FREE.replace("PUSH", push).replace("[points]", f"{given}\n[points]")
    return coursework.solve(coursework.parse_variant(text), scheme=scheme, **options)


@pytest.mark.parametrize("width", [1e-2, 1e-5, 1e-7])
def test_a_pulse_of_force_between_two_rows_is_not_stepped_over(width):
    """1 N*s of a bell about t = 0.503 s moves 2 kg at 0.5 m/s from then on."""
    given = f'[given]\nq = "1 N"\nt1 = "1 s"\nw = "{width} s"\nt0 = "0.503 s"\n'
    run = pushed("q*t1/(w*sqrt(pi))*exp(-((t - t0)/w)^2)", given)
    assert run.motion.column("u")[-1] == pytest.approx(0.5, abs=1e-9)
    assert run.motion.column("s")[-1] == pytest.approx(1 + 0.5 * (1 - 0.503), abs=1e-9)


JUMPS = '[given]\nq = "1 N"\n[functions]\ng = { pieces = [["0 s", "3"], ["BREAK s", "-7"]] }\n'


@pytest.mark.parametrize("at", [0.5, 0.503])
def test_a_force_that_jumps_is_no_force_too_steep(at):
    run = pushed("q*g", JUMPS.replace("BREAK", str(at)))
    t = run.motion.t
    late = np.maximum(t - at, 0.0)
    assert run.stop is None
    assert run.motion.column("u") == pytest.approx(1.5 * np.minimum(t, at) - 3.5 * late, abs=1e-12)
    assert run.motion.column("s") == pytest.approx(1 + 0.75 * t**2 - 2.5 * late**2, abs=1e-12)


@pytest.mark.parametrize("push", ["q*t1/(t - t0)", "q*(t1/(t - t0))^2"])
def test_a_force_without_a_bound_ends_the_motion_where_it_has_none(push):
    run = pushed(push, '[given]\nq = "1 N"\nt0 = "0.51 s"\nt1 = "1 s"\n')
    assert (run.stop.kind, len(run.motion.t)) == ("too steep", 11) and run.stop.time == pytest.approx(0.51, abs=1e-6)
    told = "hardly any mass there or a motor or a load grows beyond all bounds there, jumps as abs(x)/x does, or falls"
    assert told in run.stop.sentence


@pytest.mark.parametrize("scheme", ["midpoint", "heun", "ralston", "rk4"])
def test_a_row_at_a_jump_keeps_every_scheme_of_second_order_exact_on_parabolas(scheme):
    run = pushed("q*g", JUMPS.replace("BREAK", "0.5"), scheme)
    assert run.motion.column("u")[-1] == pytest.approx(1.5 * 0.5 - 3.5 * 0.5, abs=1e-12)
    assert run.motion.column("s")[-1] == pytest.approx(1 + 0.75 - 2.5 * 0.25, abs=1e-12)


@pytest.mark.parametrize("longer", [1e-3, 1e3])
def test_a_mechanism_a_thousand_times_as_long_turns_alike(longer):
    """Lengths, and with them torques and inertias, in another size: the angles of Euler's table stay, no dead point comes."""
    text = mechanism("example-2-motor")
    for name, size, unit, power in (
        ("r1", 0.4, "m", 1), ("r2", 1.2, "m", 1), ("M0", 600, "N*m", 2), ("k", 35, "N*m*s", 2),
    ):  # fmt: skip
        old = f'"{size} {unit}"'
        assert text.count(old) == 1, name
        text = text.replace(old, f'"{size * longer**power!r} {unit}"')
    for inertia in ("0.0533", "1.5", "0.6", "5"):
        text = text.replace(f'"{inertia} kg*m^2"', f'"{float(inertia) * longer**2!r} kg*m^2"')
    text = text.replace('"9.81 m/s^2"', f'"{9.81 * longer!r} m/s^2"').replace("B + 0.4 @", f"B + {0.4 * longer} @")
    angles = [
        coursework.solve(coursework.parse_variant(one), "euler", end=0.6).motion.column("theta1")
        for one in (text, mechanism("example-2-motor"))
    ]
    assert len(angles[0]) == 61 and angles[0] == pytest.approx(angles[1], abs=1e-9)
    assert angles[0][-1] > math.pi


HEAVY = """[masses]
1 = { mass = "M1 kg", inertia = "rod" }
2 = { mass = "M2 kg", inertia = "rod" }
C = { mass = "0.1 kg", inertia = "point" }
[forces]
gravity = "9.81 m/s^2"
[motor]
rates = ["w1"]
start = { w1 = "2 rad/s" }
1 = { torque = "T N*m" }
"""


def rod_of(r, **data):
    masses = HEAVY
    for name, value in data.items():
        masses = masses.replace(name, str(value))
    crank = mechanism(
        "slider-crank", ("[drive]\n", ""), ('"0 deg"', '"0.5 rad"'), r=f"{r} m", l="0.35 m", e="0 m", n=None, w1=None,
        step="10 ms", end="0.8 s", period=None,
    )  # fmt: skip
    return crank + masses


def rod(r, **data):
    return coursework.solve(coursework.parse_variant(rod_of(r, **data)), scheme="exact")


@pytest.mark.long
def test_a_rod_shorter_than_its_crank_stops_it_where_the_rod_stands_across_its_guide():
    """0.61730816 s by SciPy's DOP853 (1e-12) from Lagrange's equations with two multipliers, which pass that place."""
    run = rod(r=0.36, M1=1, M2=2, T=0)
    assert run.stop.kind == "dead point" and run.stop.time == pytest.approx(0.61730816, abs=1e-7)
    assert len(run.motion.t) == 62


def test_what_has_no_mass_in_its_dead_position_is_no_mechanism_at_a_dead_point():
    """A crank of 1e-9 kg, shorter than its rod, may turn right round; where the slider turns back nothing has mass."""
    run = rod(r=0.1, M1=1e-9, M2=1e-9, T=6)
    assert run.stop.kind == "too steep" and "hardly any mass there" in run.stop.sentence


@pytest.mark.parametrize("most", [1, 2])
def test_as_many_steps_as_are_allowed_are_taken_between_two_rows(most, monkeypatch):
    taken, ended = [], []
    monkeypatch.setattr(dynamics, "MOST_STEPS", most)
    monkeypatch.setattr(dynamics, "dormand_prince_8", lambda *given: taken.append(1) or dormand_prince_8(*given))
    monkeypatch.setattr(dynamics, "why_ended", lambda *given: ended.append(len(taken)) or why_ended(*given))
    assert len(pushed("k*(2 - s)", '[given]\nk = "900000 N/m"\n').motion.t)
    assert ended[0] == most
