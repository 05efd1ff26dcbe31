"""What lengths far apart cost, how stiff equations are told, and a scheme that leaves the motion: against closed forms."""

import math
import re

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import coursework
from coursework.motion.schemes import SCHEMES
from coursework.results.checks.result import percent
from coursework.variant.reading.reader import parse_variant
from tests.hard.drives import ANSWERS, Law, four_bar, with_sides
from tests.hard.edges import of_four_bar
from tests.hard.scenes import check, scene, solve


def far(base: float, scheme: str = "exact") -> str:
    """Return a four-bar of two links of a micrometre and two of `base` (m)."""
    text = four_bar(Law("steady", "n", {"n": "3 rad/s"}, lambda t: 3 * t), scheme=scheme, start=1.0)
    return with_sides(text, (1e-6, base, 2e-6, base))


@pytest.mark.parametrize(("base", "verdict"), [(1e-3, "PASS"), (1e3, "PASS"), (1e4, "FAIL"), (3e5, "FAIL")])
def test_digits_lost_to_lengths_far_apart_are_known(base, verdict):
    mp.mp.dps = 50
    run = coursework.solve(parse_variant(far(base)))
    found = check(run, "CONDITION")
    law = Law("", "", {}, lambda t: 3 * t)
    true = of_four_bar(tuple(mp.mpf(one) for one in (1e-6, base, 2e-6, base)), law, lambda t: mp.mpf(3), mp.mpf(1))
    places = range(0, 101, 5)
    apart = max(
        abs(float(mp.mpf(float(run.motion.column("phi3")[i])) - true(mp.mpf(float(run.motion.t[i])))["phi3"])) for i in places
    )
    assert found.verdict == verdict
    assert found.value - 1.5 < -math.log10(apart)  # it never says many more digits than there are
    assert ("differ so much in size" in found.sentence) == (found.value < 13)
    assert found.value >= 13 or f"row {found.row} (" in found.sentence


def test_lengths_of_one_size_are_told_as_before():
    text = four_bar(Law("steady", "n", {"n": "3 rad/s"}, lambda t: 3 * t))
    assert "The equations leave 15" in check(coursework.solve(parse_variant(text)), "CONDITION").sentence


def equations(first: str, second: str, given: str, *, step: float, end: float, scheme: str) -> str:
    """Return two equations of two turning things that start at 2 rad and 0 rad."""
    return (
        f'format = 1\n[given]\n{given}\n[coordinates]\nx = {{ start = "2 rad", rate = "u", unit = "rad" }}\n'
        f'y = {{ start = "0 rad", rate = "v", unit = "rad" }}\n[time]\nstep = "{step!r} s"\nend = "{end!r} s"\n'
        f'scheme = "{scheme}"\n[[constraint]]\nname = "1"\nequation = "{first}"\n'
        f'[[constraint]]\nname = "2"\nequation = "{second}"\n{ANSWERS}'
    )


def van_der_pol(mu: float, *, step: float = 0.01, end: float = 2.0, scheme: str = "euler") -> str:
    return equations(
        "u = y*w", "v = (mu*(1 - x^2)*y - x)*w", f'w = "1 rad/s"\nmu = "{mu!r}"', step=step, end=end, scheme=scheme
    )  # fmt: skip


@pytest.mark.parametrize(("scheme", "longest"), [("euler", 2 / 3000), ("rk4", 2.785 / 3000)])
def test_stiff_equations_are_told_as_such_with_a_step_that_does(scheme, longest):
    run = coursework.solve(parse_variant(van_der_pol(1000.0, end=1.0, scheme=scheme)))
    assert run.summary.startswith("The equations are stiff: a deviation dies out within 0.000333 s (rate 3e+03 1/s)")
    found = check(run, "STOP")
    assert found.verdict == "COARSE"  # the mechanism goes on: it is the scheme that stops
    assert found.step is not None
    assert found.step < longest
    better = coursework.solve(parse_variant(van_der_pol(1000.0, step=found.step, end=1.0, scheme=scheme)))
    assert check(better, "ACCURACY").verdict == "PASS"
    assert "stiff" not in better.summary


@pytest.mark.parametrize(("mu", "is_stiff"), [(10.0, False), (1000.0, True)])
def test_what_the_scheme_bears_is_not_called_stiff(mu, is_stiff):
    run = coursework.solve(parse_variant(van_der_pol(mu)))
    assert ("stiff" in run.summary) == is_stiff


def test_a_motion_too_stiff_to_be_followed_is_said_to_be_that():
    text = equations("u = k*(cos(w*t) - x)", "v = w*y", 'k = "1000 1/s"\nw = "1 1/s"', step=0.01, end=2.0, scheme="euler")
    run = coursework.solve(parse_variant(text))
    assert check(run, "ACCURACY").verdict != "PASS"
    assert "stiff" in run.summary
    assert "steps up to 0.002 s" in run.summary


def test_a_turning_four_bar_is_not_stiff_however_coarse():
    for step in (0.05, 0.2, 1.0):
        text = four_bar(Law("steady", "n", {"n": "5 rad/s"}, lambda t: 5 * t), step=step, end=10.0, scheme="euler")
        assert "stiff" not in coursework.solve(parse_variant(text)).summary


def test_how_far_a_scheme_damps():
    known = {"euler": 2.0, "midpoint": 2.0, "heun": 2.0, "ralston": 2.0, "rk4": 2.785293563405282}
    assert {name: scheme.damped for name, scheme in SCHEMES.items()} == pytest.approx(known)


@pytest.mark.parametrize("place", [0.5835, 1 / 12 + 1e-3])
def test_a_refinement_that_jumps_about_is_noticed(place):
    """A switch between two rows: Runge-Kutta is off by where it stands between its slopes, by nothing a sixth behind a row.

    By order four half the step would do, and it does by chance; what is finer does not, and is told.
    """
    at = 0.9 + 0.1 * place
    text = scene(
        'x = { start = "0 rad", rate = "w" }', given=f'k = "1 1/s"\nat = "{at!r} s"\nT = "1e-6 s"', step=0.1, end=1.0,
        equations=["w = k*(0.5 + atan((t - at)/T)/pi)"],
    )  # fmt: skip

    def share(parts):
        """The error of Runge-Kutta 4 in the last row of (1 - at) rad: there the switch is sharp."""
        h = 0.1 / parts
        part = (at / h) % 1.0
        return abs((part - 1 / 6 if part < 0.5 else part - 5 / 6) * h / (1 - at))

    assert share(1) > 0.05 > 4 * share(2)
    found = check(solve(text, "rk4", quantities=("table", "checks")), "ACCURACY")
    assert found.value == pytest.approx(share(1), rel=1e-3)
    told = re.search(r"Take --step h/(\d+) .*: with h/(\d+) the table is off by ([\d.]+)", found.sentence.replace("\xa0", " "))
    advised, worse, told = (float(one) for one in told.groups())
    assert share(advised) < 0.05 < share(worse) == pytest.approx(told / 100, rel=0.02)
    assert advised > worse > 2


@pytest.mark.parametrize(
    ("share", "told"),
    [(9.99, "999.0 %"), (10, "1,000 %"), (99.9, "9,990 %"), (100, "more than 10,000 %"), (5170, "more than 10,000 %")],
)
def test_an_error_is_no_number_of_a_hundred_digits(share, told):
    assert percent(share).replace("\xa0", " ") == told.replace("\xa0", " ")


@pytest.mark.parametrize(
    ("step", "verdict", "told"),
    [
        (
            0.1,
            "PASS",
            r"Equation 1 divides by cos\(a\), which passes zero at t = 1\.5708 s, between rows 16 and 17: .* Write it without",
        ),
        (
            math.pi / 20,
            "FAIL",
            r"Equation 1 divides by cos\(a\), which is zero in row 11 \(t = 1\.5708 s\): there it divides by zero",
        ),
    ],
)
def test_an_equation_that_is_nothing_by_nothing_is_told_with_its_time(step, verdict, told):
    """A universal joint: both shafts stand at 90 degrees at once, and the square of a cosine shows no side."""
    shafts = 'a = { start = "0 rad", rate = "wa" }\nb = { start = "0 rad", rate = "wb" }'
    text = scene(
        shafts, given='k = "0.5 rad"', drive='wa = "1 rad/s"', step=step, end=3.0, equations=["wb = wa*cos(k)*(cos(b)/cos(a))^2"]
    )
    found = check(solve(text), "CONDITION")
    assert found.verdict == verdict
    assert re.search(told, found.sentence)
    assert re.match(told, found.headline)
    plain = solve(text.replace("wb = wa*cos(k)*(cos(b)/cos(a))^2", "wb*(1 - sin(k)^2*sin(a)^2) = wa*cos(k)"))
    assert "divides" not in check(plain, "CONDITION").sentence


@pytest.mark.parametrize(
    ("form", "is_known"),
    [
        ("wb = wa*cos(k)*(cos(b)/cos(a))^2", False),
        ("wb*(1 + tan(b)^2) = wa*cos(k)*(1 + tan(a)^2)", False),
        ("wb*(1 - sin(k)^2*sin(a)^2) = wa*cos(k)", True),
        ("wb = wa*(1.5 + sin((a - 1)^2)/(a - 1)^2)", True),  # what is divided does not depend on b: one motion goes on
    ],
)
def test_a_division_at_which_all_motions_of_an_equation_meet_leaves_the_exact_one_unknown(form, is_known):
    """tan(b) = C tan(a) comes to 90 degrees for every C; what was followed from there was another motion, 218 % off."""
    for end, known in ((1.4, True), (2.4, is_known)):
        text = scene(
            'a = { start = "0.1 rad", rate = "wa" }\nb = { start = "0.0826219 rad", rate = "wb" }', given='k = "0.6 rad"',
            drive='wa = "1 rad/s"', step=0.04, end=end, equations=[form],
        )  # fmt: skip
        run = solve(text, "rk4", quantities=("table", "checks"))
        judged = check(run, "ACCURACY")
        assert judged.verdict == ("PASS" if known else "SKIP")
        if not known:
            assert re.match(
                r"Equation 1 divides by cos\(a\), which is zero at t = 1\.4708 s: many of its motions may", judged.sentence
            )
            assert {check(run, code).verdict for code in ("PERIOD-POSITION", "PERIOD-VELOCITY", "CONTINUITY")} == {"SKIP"}
            assert "divides by cos(a)" in run.summary and "not known" in run.summary


def test_a_division_leaves_the_exact_motion_known_where_a_position_equation_tells_it():
    """tan(b) = cos(k) tan(a): the table leaves it at 90 degrees, however good the scheme; no length is to blame."""
    text = scene(
        'a = { start = "0.1 rad", rate = "wa" }\nb = { start = "0.08263225806 rad", rate = "wb" }', given='k = "0.6 rad"',
        drive='wa = "1 rad/s"', step=0.04, end=2.4, equations=["wb = wa*cos(k)*(cos(b)/cos(a))^2"],
        more='[closure]\nholds = ["sin(b)*cos(a) - cos(k)*sin(a)*cos(b)"]',
    )  # fmt: skip
    run = solve(text.replace("0.08263225806", repr(math.atan(math.cos(0.6) * math.tan(0.1)))), "rk4", ("table", "checks"))
    a = run.exact.column("a")
    assert run.exact.column("b") == pytest.approx(np.arctan2(math.cos(0.6) * np.sin(a), np.cos(a)), abs=1e-12)
    assert check(run, "ACCURACY").verdict == "COARSE"
    assert "divides by cos(a)" in run.summary and "lengths" not in check(run, "CONDITION").sentence


@pytest.mark.parametrize(
    ("end", "told"), [(0.55, None), (2.1, None), (2.2, r"tan\(1 \+ a\), which passes zero at t = 2\.14159 s")]
)
def test_a_denominator_that_passes_a_pole_passes_no_zero(end, told):
    """tan(1 + a) changes its sign at pi/2 - 1 through infinity, where nothing is divided by zero, and at pi - 1 through zero."""
    text = scene(
        'a = { start = "0 rad", rate = "wa" }\nb = { start = "0 rad", rate = "wb" }', drive='wa = "1 rad/s"', step=0.05, end=end,
        equations=["wb = wa*(3 + 0.1*sin(1/tan(1 + a)))"],
    )  # fmt: skip
    found = check(solve(text, "euler"), "CONDITION")
    assert re.search(told, found.sentence) if told else "divides" not in found.sentence


@pytest.mark.parametrize(("end", "is_known"), [(10.0, True), (25.0, False)])
def test_a_chaotic_motion_is_known_as_long_as_doubles_know_it(end, is_known):
    """Lorenz: what is off grows by 0.9 a second, from 1e-16 to 1e-6 in 25 s, and then nobody's rows are the motion."""
    coordinates = "\n".join(f'{name} = {{ start = "1 rad", rate = "w{name}" }}' for name in "xyz")
    written = ["wx = k*10*(y - x)", "wy = k*(x*(28 - z) - y)", "wz = k*(x*y - 8/3*z)"]
    text = scene(coordinates, given='k = "1 1/s"', step=0.001, end=end, equations=written)
    run = solve(text, "rk4", quantities=("table", "checks"))
    found = check(run, "ACCURACY")
    assert (found.verdict == "SKIP") is not is_known
    if is_known:
        field = lambda t, q: [10 * (q[1] - q[0]), q[0] * (28 - q[2]) - q[1], q[0] * q[1] - 8 / 3 * q[2]]  # noqa: E731
        other = solve_ivp(field, (0, end), [1.0] * 3, "DOP853", run.motion.t[::200], rtol=1e-13, atol=1e-14).y.T
        off = np.max(np.abs(run.motion.coordinates[::200] - other))
        assert off <= found.value * 2 * math.pi * 1.001 + 1e-6
        assert np.max(np.abs(run.exact.coordinates[::200] - other)) < 1e-6
