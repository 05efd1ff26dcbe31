"""Change points under forces: kites end there, parallel cranks go through, a sleeve has one motion only."""

import math
import re
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import quad

import coursework
from coursework.effects.dynamics import crossings
from coursework.effects.dynamics.crossings import ended_at
from coursework.effects.dynamics.why_ended import CHANGE
from coursework.report.live.page import _words
from coursework.words.sentences import load_phrases

KITE = """format = 1
[given]
a = "0.5 m"
b = "COUPLER m"
c = "1 m"
[coordinates]
phi1 = { start = "1 rad", rate = "w1" }
phi2 = { start = "P rad", rate = "w2" }
phi3 = { start = "Q rad", rate = "w3" }
[time]
step = "0.01 s"
end = "0.7 s"
[points]
A = "(0, 0)"
B = "A + a @ phi1"
C = "B + b @ phi2"
E = "(c, 0)"
[links]
1 = { points = ["A", "B"], rate = "w1" }
2 = { points = ["B", "C"], rate = "w2" }
3 = { points = ["E", "C"], rate = "w3" }
[[constraint]]
name = "1"
closure = "a @ phi1 + b @ phi2 = (c, 0) + c @ phi3"
[frame]
hinges = ["A", "E"]
[masses]
1 = { mass = "1 kg", inertia = "rod" }
2 = { mass = "2 kg", inertia = "rod" }
3 = { mass = "1 kg", inertia = "rod" }
[motor]
rates = ["w1"]
start = { w1 = "6 rad/s" }
[ask]
quantities = ["table", "checks", "dynamics"]
"""


def placed(coupler, theta):
    """Angles of coupler and rocker of the kite by the law of cosines, and their velocities for a crank at 1 rad/s."""
    pin = 0.5 * np.exp(1j * theta)
    away = 1 - pin
    p = np.angle(away) + math.acos((coupler**2 + abs(away) ** 2 - 1) / (2 * coupler * abs(away)))
    q = np.angle(pin + coupler * np.exp(1j * p) - 1)
    return p, q, -0.5 * math.sin(theta - q) / (coupler * math.sin(p - q)), 0.5 * math.sin(theta - p) / math.sin(q - p)


def inertia(coupler, theta):
    """The inertia of three rods of 1, 2 and 1 kg, reduced to the crank."""
    p, _, k2, k3 = placed(coupler, theta)
    middle = 0.5 * np.exp(1j * theta) + k2 * coupler / 2 * np.exp(1j * p)
    return 0.25 / 3 + k3**2 / 3 + 2 * abs(middle) ** 2 + 2 * coupler**2 / 12 * k2**2


@pytest.mark.parametrize(("coupler", "kind", "told"), [
    (0.5, CHANGE, "links lie in one line at a change point: two motions meet there, and phi1 moves on in both"),
    (0.4995, "dead point", "(phi1) is at its limit"), (0.5005, None, ""),
    pytest.param(0.49999999, "dead point", "(phi1) is at its limit", marks=pytest.mark.long),
])  # fmt: skip
@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_a_crank_that_comes_to_a_change_point_does_not_turn_back(coupler, kind, told, scheme):
    """Nothing gives energy: dt = sqrt(J(theta)/J(1)) dtheta/6.  A coupler a thousandth shorter is a limit, a longer passes."""
    p, q = map(float, placed(coupler, 1.0)[:2])
    text = KITE.replace("COUPLER", repr(coupler)).replace("P rad", f"{p!r} rad").replace("Q rad", f"{q!r} rad")
    stop = coursework.solve(coursework.parse_variant(text), scheme=scheme).scene.stop
    assert (stop.kind if stop else None) == kind
    if stop is not None:
        last = math.pi if kind == CHANGE else math.acos((1.25 - (1 + coupler) ** 2) / 1.0)
        begun = inertia(coupler, 1.0)  # with theta = last - s^2, as J has no bound at a limit
        whole, _ = quad(
            lambda s: math.sqrt(inertia(coupler, last - s * s) / begun) / 3 * s,
            1e-8,
            math.sqrt(last - 1),
            epsabs=1e-11,
            limit=200,
        )
        assert ("the two motions would stay apart" in stop.meaning) == (kind == CHANGE)
        assert told in stop.cause and stop.time == pytest.approx(
            whole, abs=1e-9 if coupler == 0.4995 else 1e-6 if kind != CHANGE else 2e-8
        )


@pytest.mark.parametrize("size", ["e-6", "e-5", ""])
def test_a_kite_of_any_size_passes_its_change_point_if_its_coupler_is_a_little_longer(size):
    """Beside it round-off is more than the tolerance: with it as the limit a kite of 1 um was told to stop."""
    p, q = map(float, placed(0.5000001, 1.0)[:2])
    text = KITE.replace("COUPLER", "0.5000001").replace("P rad", f"{p!r} rad").replace("Q rad", f"{q!r} rad")
    text = re.sub(r'"([0-9.]+) m"', rf'"\g<1>{size} m"', text)
    run = coursework.solve(coursework.parse_variant(text), scheme="exact")
    end, rate = (run.table[name].iloc[-1] for name in ("phi1", "w1"))
    assert run.scene.stop is None and len(run.table) == 71 and end > math.pi + 0.3
    assert rate * math.sqrt(inertia(0.5000001, end) / inertia(0.5000001, 1.0)) == pytest.approx(6, abs=1e-7)  # energy is kept


@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_parallel_cranks_go_through_their_change_point_and_it_is_told(scheme):
    """J = 2 m a^2/3 + m2 a^2 is the same everywhere: the angle grows as w t + M/J t^2/2, and at pi all links lie in one line."""
    text = KITE.replace("COUPLER", "1.0").replace('c = "1 m"', 'c = "1 m"\nM = "2 N*m"').replace("c @ phi3", "a @ phi3")
    text = re.sub(r'start = "[PQ1] rad"', lambda found: f'start = "{0.0 if "P" in found[0] else 2.0} rad"', text)
    text = text.replace("[motor]", '[forces]\npush = { on = "1", torque = "M" }\n[motor]')
    run = coursework.solve(coursework.parse_variant(text), scheme=scheme, quantities=("table", "checks"))
    at = 2 * (math.pi - 2) / (6 + math.sqrt(36 + 4 * 2 / (2 * (2 * 0.25 / 3 + 2 * 0.25)) * (math.pi - 2)))
    assert run.stop is None
    told = re.search(r"At t = ([0-9.]+) s links lie in one line at a change point: two motions meet there", run.summary)
    assert float(told[1]) == pytest.approx(at, abs=1e-6)
    assert run.motion.notes == run.scene.passed
    assert _words(load_phrases(), run)["dead"] == "The motion is followed here up to t = {t} s only."  # it does not stop


@pytest.mark.parametrize(("scheme", "step", "rows"), [("rk4", 0.125, 8), ("euler", 0.25, 4), ("rk4", 0.13, 12)])
def test_a_slope_that_is_looked_for_just_at_a_change_point_lacks_no_shorter_step(scheme, step, rows):
    """Parallel cranks without a force turn evenly, from -1 rad at 1 rad/s: after 1 s all links lie in one line."""
    text = re.sub(r'start = "[PQ1] rad"', lambda found: f'start = "{0.0 if "P" in found[0] else -1.0} rad"', KITE)
    text = text.replace("COUPLER", "1.0").replace("c @ phi3", "a @ phi3").replace("6 rad/s", "1 rad/s")
    text = text.replace("0.01 s", f"{step} s").replace('end = "0.7 s"', 'end = "1.5 s"')
    motion = coursework.solve(coursework.parse_variant(text), scheme=scheme).motion
    assert len(motion.t) == rows and (motion.stop is None) is bool(motion.notes) is (rows == 12)
    if motion.stop is not None:
        assert (motion.stop.kind, motion.stop.time) == (CHANGE, pytest.approx(1.0, abs=1e-9))


SLEEVE = f"""format = 1
[given]
r = "0.3 m"
[coordinates]
a = {{ start = "-0.5 rad", rate = "w1" }}
b = {{ start = "{math.pi / 2 - 0.25!r} rad", rate = "w" }}
s = {{ start = "{-0.6 * math.sin(0.25)!r} m", rate = "u" }}
[time]
step = "0.01 s"
end = "0.6 s"
[points]
O = "(0, 0)"
A = "O + r @ a"
S = "(r, 0)"
E = "A + r @ b"
[links]
1 = {{ points = ["O", "A"], rate = "w1" }}
2 = {{ points = ["A", "E"], rate = "w" }}
3 = {{ points = ["S"], slides = 2, rate = "w" }}
[frame]
hinges = ["O", "S"]
[[constraint]]
name = "1"
closure = "r @ a = (r, 0) + s @ b"
[masses]
1 = {{ mass = "1 kg", inertia = "rod" }}
2 = {{ mass = "0.5 kg", inertia = "0.01 kg*m^2", centre = "A" }}
3 = {{ mass = "0.1 kg", inertia = "0.001 kg*m^2", centre = "S" }}
[forces]
push = {{ on = "1", torque = "0.02 N*m" }}
[motor]
rates = ["w1"]
start = {{ w1 = "1 rad/s" }}
"""


@pytest.mark.parametrize("step", ["0.2", pytest.param("0.01", marks=pytest.mark.long)])
def test_a_crank_whose_end_comes_to_the_pivot_of_its_sleeve_has_one_motion_only(step):
    """The angle at the circumference, b' = a'/2 throughout: J = m r^2/3 + m2 r^2 + (J2 + J3)/4.  Three rows tell it as well."""
    stop = coursework.solve(coursework.parse_variant(SLEEVE.replace("0.01 s", f"{step} s")), scheme="exact").scene.stop
    speedup = 0.02 / (0.03 + 0.045 + 0.011 / 4)
    assert stop.time == pytest.approx((math.sqrt(1 + speedup) - 1) / speedup, abs=1e-9)
    assert stop.kind == CHANGE and "Only one motion goes on" in stop.cause and "started there anew" in stop.meaning


@pytest.mark.long
def test_rows_that_pass_a_position_of_0_over_0_between_two_rows_are_told_right():
    """Of eps = M/J the angle is t + eps t^2/2 - 0.5; where the motion was looked for next to 0/0 the run was lost."""
    run = coursework.solve(coursework.parse_variant(SLEEVE.replace("0.01 s", "0.1 s")), scheme="exact")
    t = run.motion.t
    assert run.motion.column("a") == pytest.approx(t + 0.02 / (0.03 + 0.045 + 0.011 / 4) * t**2 / 2 - 0.5, abs=1e-7)
    assert len(t) == 7 and not run.motion.notes


@pytest.mark.parametrize("rates", [("w1", "w2"), ()])
def test_where_not_one_coordinate_alone_is_free_rows_end_about_where_they_end(rates):
    """A way to the change point is known along one coordinate only."""
    flow = SimpleNamespace(equations=SimpleNamespace(variant=SimpleNamespace(known_rates=rates, rates=("w1", "w2", "w3"))))
    rows = SimpleNamespace(t=np.zeros(1), scaled=np.ones((1, 2)), step=0.1)
    assert ended_at(flow, rows, None, 0.7) == (0.7, CHANGE)


@pytest.mark.parametrize("time", [0.02, 40.0])
@pytest.mark.parametrize(("off", "looks"), [(0.98e-9, 2), (-0.98e-9, 2), (1.02e-9, 3), (-1.02e-9, 3)])
def test_a_change_point_is_looked_for_until_two_looks_agree(time, off, looks, monkeypatch):
    """A coordinate that is the time itself; the change point is found at its time, then beside it."""
    found = iter([time, time * (1 + off), time * (1 + off)])
    looked = []
    monkeypatch.setattr(crossings, "branches_at", lambda *_: ())
    monkeypatch.setattr(crossings, "nearest_change_point", lambda *given: looked.append(1) or (0.0, np.array([next(found)]), 0.0))
    variant = SimpleNamespace(known_rates=("w1",), rates=("w1",))
    flow = SimpleNamespace(equations=SimpleNamespace(variant=variant), units=np.ones(1))

    def exact_at(times):
        rows = np.asarray(times)[:, None]
        return SimpleNamespace(t=rows[:, 0], coordinates=rows, velocities=np.ones(rows.shape), velocity_names=("w1",))

    told = crossings._reached(flow, exact_at, 0, 1.001 * time, time / 100)
    assert told[0] == pytest.approx(time * (1 + off), rel=1e-12) and len(looked) == looks
