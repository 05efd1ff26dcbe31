"""Mechanisms of a nanometre to a thousand kilometres move, and are judged, as those of a metre.

Where nothing closes the positions, where forces move the mechanism, and where a drive or a force acts for an instant, steps are
chosen by an error: it is a share of the size of the mechanism.  The truth is the motion of the same mechanism of 1 m, or a
closed form.
"""

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.run import Run
from coursework.variant.reading.reader import parse_variant

UNCLOSED = """
[given]
L = "{L!r} m"
[drive]
w = "5 rad/s"
[coordinates]
a = {{ start = "0 rad", rate = "w" }}
x = {{ start = "{x!r} m", rate = "u" }}
[time]
step = "0.25 s"
end = "5 s"
[[constraint]]
equation = "u = w*x*cos(a) + 2*w*x^2/L*sin(3*a)"
"""
PULSED = """
[given]
L = "{L!r} m"
T = "1e-9 s"
[drive]
u = "L/T*exp(-((t - 0.0333)/T)^2)"
[coordinates]
x = {{ start = "0 m", rate = "u" }}
f = {{ start = "0 rad", rate = "w" }}
[time]
step = "0.01 s"
end = "0.1 s"
[[constraint]]
equation = "u = 3*L*w*cos(f)"
[closure]
holds = ["x - 3*L*sin(f)"]
"""
FORCED = """
[given]
L = "{L!r} m"
F = "{F!r} N"
T = "0.01 ms"
[coordinates]
x = {{ start = "{x!r} m", rate = "v" }}
[time]
step = "{step!r} s"
end = "{end!r} s"
[points]
C = "(x, 0)"
K = "(0, L)"
[links]
1 = {{ points = ["C"] }}
[frame]
hinges = ["K"]
rails = [ {{ through = "C", angle = "0" }} ]
[masses]
C = "{m!r} kg"
[forces]
{acts}
[motor]
rates = ["v"]
[ask]
quantities = ["table", "checks"]
"""
SPRING = 's = {{ spring = ["C", "K"], stiffness = "300 N/m", free = "{free!r} m" }}'
PULSE = 'P = { on = "1", at = "C", force = "(F*exp(-((t - 0.0333)/T)^2), 0)" }'
SIZES = [2.0**-40, 2.0**-30, 2.0**-20, 2.0**20]  # powers of two: nothing is rounded on the way


@cache
def _unclosed(size: float) -> Run:
    return coursework.solve(parse_variant(UNCLOSED.format(L=size, x=0.3 * size)), "rk4")


@cache
def _sprung(size: float) -> Run:
    acts = SPRING.format(free=1.4 * size)
    text = FORCED.format(acts=acts, L=size, F=1.0, x=0.5 * size, m=2.0, step=0.2, end=10.0)
    return coursework.solve(parse_variant(text), "exact")


@cache
def _pulsed(size: float) -> Run:
    return coursework.solve(parse_variant(PULSED.format(L=size)), "exact")


@pytest.mark.parametrize("size", SIZES)
def test_a_motion_without_closed_positions_is_known_at_any_size(size):
    """With limits in metres it was "not known" at 1 um and at 1000 km, and at 1 nm off by a hundredth."""
    here, there = _unclosed(1.0), _unclosed(size)
    assert [one.verdict for one in there.checks] == [one.verdict for one in here.checks]
    assert there.exact.column("x") / size == pytest.approx(here.exact.column("x"), abs=1e-12)
    values = [[one.value for one in run.checks if one.code in {"ACCURACY", "CONTINUITY"}] for run in (here, there)]
    assert values[1] == pytest.approx(values[0], rel=1e-6)  # at 1 nm an error of a tenth counted as none
    known = [
        [(row.method, row.steps_or_tolerance, row.evaluations, row.failed) for row in run.accuracy.rows] for run in (here, there)
    ]
    assert known[1] == known[0]
    assert there.accuracy.orders == pytest.approx(here.accuracy.orders, abs=1e-3)  # 4.39 at 1 um, none at 1000 km
    assert there.accuracy.floor / size == pytest.approx(here.accuracy.floor, rel=1e-9)
    told = [[one.key for one in run.accuracy.sentences] for run in (here, there)]
    assert told[0] == told[1]


@pytest.mark.parametrize("size", SIZES)
def test_a_mass_on_a_spring_moves_alike_at_any_size(size):
    """Before, rows were missing at 1 um, and at 1 nm they were off by a thousandth."""
    here, there = _sprung(1.0), _sprung(size)
    assert len(there.table) == 51 and [one.verdict for one in there.checks] == [one.verdict for one in here.checks]
    assert there.table["x"].to_numpy() / size == pytest.approx(here.table["x"].to_numpy(), abs=1e-11)


@pytest.mark.parametrize("size", SIZES)
def test_a_pulse_of_the_drive_moves_any_mechanism_by_its_whole_integral(size):
    """To the digits that a time has beside a nanosecond, and at any size alike."""
    here, there = (_pulsed(one).table["x"].iloc[-1] / one for one in (1.0, size))
    assert here == pytest.approx(np.sqrt(np.pi), rel=1e-8)
    assert there == pytest.approx(here, rel=1e-13)


@pytest.mark.parametrize(("size", "mass"), [(1.0, 1.0), (1e-6, 1e-9), (1e-6, 1e-12), (1e-9, 1e-18), (1e3, 1e3)])
def test_a_blow_between_two_rows_is_seen_however_small_what_it_strikes(size, mass):
    """It gives the speed of one size a second.  A mass of a microgramme was said to rest, held by the forces."""
    force = float(mass * size / 1e-5 / np.sqrt(np.pi))
    text = FORCED.format(acts=PULSE, L=size, F=force, x=0.0, m=mass, step=0.01, end=0.1)
    run = coursework.solve(parse_variant(text), "exact")
    assert run.table["v"].iloc[-1] / size == pytest.approx(1.0, rel=1e-11)
    assert run.table["x"].iloc[-1] / size == pytest.approx(0.0667, rel=1e-11)
    assert run.stop is None and "rest" not in run.summary and "Nothing moves" not in run.summary
