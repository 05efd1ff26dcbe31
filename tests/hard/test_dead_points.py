"""H01, H02, H10, H28, H33: dead points located to 1e-8 by every scheme and step, whatever the scheme itself sees."""

import json
import math

import numpy as np
import pytest

import coursework
from coursework.motion.schemes import SCHEMES
from coursework.motion.singular.search import search_event
from tests.hard.scenes import CASES, REFERENCE, V31_IMPOSSIBLE, expected, four_bar, scene, solve

LOCATED = 1e-8


def slider_driven(step: float) -> str:
    return scene(
        f'theta = {{ start = "{math.pi / 2!r} rad", rate = "w" }}\ns = {{ start = "{math.sqrt(8)!r} m", rate = "u" }}',
        given='r = "1 m"\nl = "3 m"\nv = "1 m/s"',
        drive='u = "v"',
        step=step,
        end=2.0,
        closures=["r @ theta + l @ gamma = (s, 0)"],
    ).replace("s = {", 'gamma = { start = "%r rad", rate = "wg" }\ns = {' % -math.asin(1 / 3))


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("step", [0.02, 0.06, 0.1, 0.005])
def test_h01_variant_31_with_the_wrong_phase_stops_where_it_must(scheme, step):
    run = solve(V31_IMPOSSIBLE, scheme, step=step)
    wanted = expected("H01")
    stop = run.stop
    assert stop.kind == "dead point"
    assert abs(stop.time - float(wanted["t_event"])) < LOCATED
    assert abs(stop.coordinates["phi3"] - float(wanted["phi3_event"])) < LOCATED
    assert stop.block == ("w3",)
    assert "The drive asks for 4.499 m/s" in stop.sentence
    assert np.all(run.motion.t < stop.time)
    assert np.all(np.sign(run.motion.determinants) == np.sign(run.motion.determinants[0]))
    if step == 0.02 and scheme == "euler":
        assert len(run.motion.t) - 1 == wanted["last_valid_row_dt_0.02"]


SOLVED = [
    "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))",
    "r3*w3*(2 + tan(phi3)) = VMy/cos(phi3)",
    "r3*(2*w3 + w3*tan(phi3))*cos(phi3) = VMy",
]


@pytest.mark.parametrize("solved", SOLVED)
def test_h01_solved_for_its_unknown_stops_at_the_same_dead_point(solved):
    """A denominator, or that of a tangent, is a determinant of the equation in another form."""
    asked = "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"
    assert asked in V31_IMPOSSIBLE
    stop = solve(V31_IMPOSSIBLE.replace(asked, solved)).stop
    assert (stop.kind, stop.block) == ("dead point", ("w3",))
    assert abs(stop.time - float(expected("H01")["t_event"])) < LOCATED
    unit = "9.844 (in the unit of its equation)" if solved.startswith("w3") else "4.499 m/s"
    assert f"The drive asks for {unit} there" in stop.sentence


@pytest.mark.parametrize(
    "equations", [("R*w = vs/cos(phi)", "vx + vs*tan(phi) = 0"), ("vx/sin(phi) = -R*w", "vs*tan(phi) = -vx")]
)
def test_a_motion_goes_on_where_a_denominator_of_its_equations_is_zero(equations):
    """A Scotch yoke passes 90 and 180 degrees as any other position."""
    start = f'x = {{ start = "{math.cos(0.2)!r} m", rate = "vx" }}\ns = {{ start = "{math.sin(0.2)!r} m", rate = "vs" }}'
    text = scene(
        f'phi = {{ start = "0.2 rad", rate = "w" }}\n{start}', given='R = "1 m"', drive='w = "1 rad/s"', step=0.1, end=6.0,
        equations=list(equations),
    )  # fmt: skip
    run = solve(text, "rk4")
    assert run.stop is None
    assert np.allclose(run.motion.column("x"), np.cos(0.2 + run.motion.t), atol=1e-5)
    assert np.allclose(run.motion.column("vs"), np.cos(0.2 + run.motion.t), atol=1e-5)


def test_h01_the_angle_runs_into_it_like_a_square_root():
    run = solve(V31_IMPOSSIBLE, step=0.116889254610302411 / 1000.001, end=0.1169)
    late = run.stop.time - run.exact.t[-3:]
    law = 2.96734913787954353 * np.sqrt(late)
    assert np.allclose(run.exact.column("phi3")[-3:] - run.stop.coordinates["phi3"], law, rtol=2e-2)


@pytest.mark.parametrize("scheme", ["euler", "rk4"])
@pytest.mark.parametrize("step", [0.3, 0.02, 0.001])
def test_h02_slider_driven_through_the_outer_dead_point(scheme, step):
    run = solve(slider_driven(step), scheme)
    wanted = expected("H02")
    assert run.stop.kind == "dead point"
    assert abs(run.stop.time - float(wanted["t_event"])) < LOCATED
    assert abs(run.stop.coordinates["theta"] - float(wanted["theta_event"])) < 1e-7
    assert abs(run.stop.coordinates["s"] - float(wanted["x_max"])) < LOCATED
    assert abs(run.motion.column("w")[0] - float(wanted["theta_dot_at_0"])) < 1e-12
    near = run.exact.column("theta")[-1]
    assert near > 0
    if step == 0.001:
        assert math.isclose(near, math.sqrt(1.5 * (run.stop.time - run.exact.t[-1])), rel_tol=1e-3)


@pytest.mark.parametrize("step", [0.1, 0.3, 0.01])
def test_h10_rod_square_to_its_guide(step):
    text = scene(
        f'y = {{ start = "0.3 m", rate = "vy" }}\nphi = {{ start = "{-math.asin(0.6)!r} rad", rate = "w" }}\n'
        'x = { start = "0.4 m", rate = "u" }',
        given='l = "0.5 m"\nv = "0.1 m/s"',
        drive='vy = "v"',
        step=step,
        end=3.0,
        closures=["(0, y) + l @ phi = (x, 0)"],
    )
    run = solve(text)
    wanted = expected("H10")
    assert run.stop.kind == "dead point"
    assert abs(run.stop.time - float(wanted["t_event"])) < LOCATED
    assert abs(run.stop.coordinates["phi"] - float(wanted["phi_event"])) < 1e-7
    if step == 0.1:
        # The row at t = 2 s stands on the dead point and is none; the one before it is exact.
        assert len(run.motion.t) == 20
        assert abs(run.exact.column("x")[19] - float(wanted["xB(t=1.9)"])) < 1e-12
        assert abs(run.exact.column("w")[19] - float(wanted["phi_dot(t=1.9)"])) < 1e-12


def timed(determinant: str, right: str = "1") -> str:
    return scene(
        'x = { start = "0 rad", rate = "w" }', drive=f'd = "{determinant}"', step=0.02, end=1.0, equations=[f"d*w = {right}"]
    )


@pytest.mark.parametrize("scheme", ["euler", "rk4"])
def test_h28_two_zeros_of_a_determinant_between_two_rows(scheme):
    data = CASES["H28"]["data"]
    assert "(t-0.501)(t-0.519)" in data["1x1"]
    run = solve(timed("(t - 0.501)*(t - 0.519)"), scheme)
    assert run.stop.kind == "dead point"
    assert abs(run.stop.time - 0.501) < LOCATED
    assert run.motion.t[-1] == 0.5
    # What a look at the rows alone would say: the same sign on both sides, and small.
    assert (0.50 - 0.501) * (0.50 - 0.519) > 0 < (0.52 - 0.501) * (0.52 - 0.519)


@pytest.mark.parametrize("root", [0.51, 0.3377])
def test_h28_a_double_zero_is_found_too(root):
    run = solve(timed(f"(t - {root})^2"))
    assert run.stop.kind == "dead point"
    assert abs(run.stop.time - root) < LOCATED


@pytest.mark.parametrize("step", [0.02, 0.003])
def test_h28_a_zero_that_the_right_side_shares_is_passed(step):
    """w = 3 but for the two times at which the equation says 0 = 0; with 0.003 s a row stands at both."""
    run = solve(timed("(t - 0.501)*(t - 0.519)", "3*(t - 0.501)*(t - 0.519)"), step=step)
    assert run.stop is None
    assert [passage.middle.time for passage in run.scene.search.passages] == pytest.approx([0.501, 0.519], abs=LOCATED)
    assert np.max(np.abs(run.motion.column("w") - 3)) < 1e-9
    assert len(run.motion.t) == int(run.end / step * (1 + 1e-9)) + 1


@pytest.mark.parametrize("depth", [1e-3, 1e-7, 1e-10, -1e-7, -1e-3])
def test_h28_two_crossings_of_a_driven_chain_inside_one_step(depth):
    """A dyad is stretched a little beyond its reach and back: |BD| = 2 - depth at t = 0.505, between two rows."""
    text = scene(
        f's = {{ start = "{1.5!r} m", rate = "u" }}\np = {{ start = "{math.acos(0.75)!r} rad", rate = "wp" }}\n'
        f'q = {{ start = "{math.pi - math.acos(0.75)!r} rad", rate = "wq" }}',
        given='l = "1 m"',
        drive=f'u = "{0.5 - depth!r}*2*(0.505 - t)/0.505^2"',
        step=0.02,
        end=1.0,
        closures=["l @ p = (s, 0) + l @ q"],
    )
    run = solve(text)
    event = run.scene.search.event
    if depth == 1e-10:  # nearer to a change point than any length is cut to
        assert event.kind == "change point"
        assert abs(event.time - 0.505) < 1e-7
    elif depth > 0:
        assert event is None
        assert np.all(run.exact.determinants * run.exact.determinants[0] > 0)
        assert abs(run.exact.column("s")[-1] - (1.5 + (0.5 - depth) * (1 - ((1 - 0.505) / 0.505) ** 2))) < 1e-12
    else:
        assert event.kind == "dead point"
        assert abs(event.time - (0.505 - 0.505 * math.sqrt(1 - 0.5 / (0.5 - depth)))) < LOCATED


def test_h33_location_does_not_depend_on_scheme_or_step():
    wanted = json.loads((REFERENCE / "dead_point_v31.json").read_text(encoding="utf-8"))
    found = {solve(V31_IMPOSSIBLE, scheme, step=step).stop.time for scheme in SCHEMES for step in (0.02, 0.01, 0.005, 0.0013)}
    assert len(found) == 1
    assert abs(found.pop() - float(wanted["t_star"])) < 1e-11
    naive = {entry["n"]: entry["err"] for entry in wanted["methods"] if entry["method"].startswith("Euler")}
    assert min(abs(error) for error in naive.values()) > 1e4 * LOCATED


@pytest.mark.parametrize(("tolerance", "error", "cost"), [(1e-6, 1e-5, 350), (1e-9, 1e-8, 450), (1e-12, 1e-11, 600)])
def test_h33_cost_of_the_location(tolerance, error, cost):
    scene = solve(V31_IMPOSSIBLE).scene
    flow = scene.flow
    before = flow.evaluations
    event = search_event(flow, scene.start, 0.48, tolerance=tolerance).event
    assert abs(event.time - 0.116889254610302411) < error
    assert 100 < flow.evaluations - before < cost


@pytest.mark.parametrize(
    ("lengths", "start"), [((0.4, 0.4, 0.4, 1.2), 0.0), ((0.4, 0.5, 0.3, 1.2), 0.0), ((0.4, 0.4, 0.4, 1.2), 1e-9)]
)
def test_a_linkage_that_is_stretched_and_cannot_move_says_that_and_no_more(lengths, start):
    a, b, c, d = lengths
    run = solve(four_bar(a, b, c, d, (start, 0.0, math.pi), speed="10"), quantities=("table", "checks"))
    assert run.stop.kind == "dead point"
    assert "none near it" in run.stop.sentence
    assert run.summary.endswith("The motion stops at t = 0 s. No row is computed.")


TOUCHING = {  # what touches zero where the crank is at 0.73 rad, between two rows; its other side is zero there too, or not
    "w2*(1 - cos(p - c)) = w1": "This is a dead point",
    "w2 = w1/(1 - cos(p - c))": "This is a dead point",
    "w2*(p - c)^2 = w1*cos(p)": "This is a dead point",
    "w2*(1 - cos(p - c)) = w1*sin(p - c)^2": "This is a removable singularity",
    "w2 = w1*(1 + sin(p - c)^2/(1 - cos(p - c)))": "This is a removable singularity",
    "w2*tan(p - c)^2 = w1*sin(p - c)^2": "This is a removable singularity",
}


def touching(equation: str, end: float) -> str:
    """A crank at 2 rad/s comes to 0.73 rad at 0.365 s, by its drive or by an equation of its own."""
    return scene(
        'p = { start = "0 rad", rate = "w1" }\nq = { start = "0 rad", rate = "w2" }',
        given='c = "0.73 rad"\nn = "1 rad/s"', drive='w0 = "n"', step=0.05, end=end, equations=["w1 = 2*w0", equation],
    )  # fmt: skip


@pytest.mark.parametrize(("equation", "told"), TOUCHING.items())
def test_what_only_touches_zero_ends_the_motion_at_its_time_and_by_its_cause(equation, told):
    """Before a double zero the flow stalls where it is 1e-10: 1e-5 too early, and the drive still asks for a little."""
    stop = solve(touching(equation, 1.0), "euler").stop
    assert told in stop.sentence
    assert abs(stop.time - 0.365) < LOCATED
    assert abs(stop.coordinates["p"] - 0.73) < LOCATED
    assert solve(touching(equation, 0.35), "euler").stop is None


def test_what_comes_near_zero_and_never_there_does_not_end_the_motion():
    assert solve(touching("w2 = w1/(1.001 - cos(p - c))", 1.0), "euler").stop is None


# Hooke's joint, tan(b) = cos(k) tan(a), in forms that say 0/0 at 90 degrees: there every C of tan(b) = C tan(a) meets.
NODES = ["wb*sin(2*a) = wa*sin(2*b)", "wb*sin(a)*cos(a) = wa*sin(b)*cos(b)", "wb*cos(a)^2 = wa*cos(k)*cos(b)^2"]


@pytest.mark.parametrize("speed", [0.1, 1.0, 60.0])
@pytest.mark.parametrize("form", NODES)
def test_where_all_motions_meet_none_of_them_is_followed_as_the_exact_one(form, speed):
    """At 90 degrees both sides and their derivatives are alike whatever wb is: a motion taken on from there is one of many."""
    start, time = 0.35, (math.pi / 2 - 0.35) / speed
    begin = math.atan(math.cos(0.6) * math.tan(start))
    text = scene(
        f'a = {{ start = "{start} rad", rate = "wa" }}\nb = {{ start = "{begin!r} rad", rate = "wb" }}', given='k = "0.6 rad"',
        drive=f'wa = "{speed} rad/s"', step=time / 20.5, end=3 * time, equations=[form],
    )  # fmt: skip
    run = solve(text, "rk4")
    assert "This is a removable singularity" in run.stop.sentence
    assert abs(run.stop.time / time - 1) < LOCATED
    exact = run.exact
    a = start + speed * exact.t
    assert np.max(np.abs(exact.coordinates[:, 1] - np.arctan(math.cos(0.6) * np.tan(a)))) < LOCATED
    plain = solve(text.replace(form, "wb*(1 - sin(k)^2*sin(a)^2) = wa*cos(k)"), "rk4")
    assert plain.stop is None


@pytest.mark.parametrize(("end", "is_followed"), [(0.47, True), (0.49, False)])
def test_a_coefficient_that_changes_its_sign_through_infinity_is_no_dead_point(end, is_followed):
    """tan(p) stands at a pole where p = pi/2: it is not zero there, and what both sides divide by is."""
    text = scene(
        'p = { start = "0.61 rad", rate = "w1" }\nq = { start = "0.5 rad", rate = "w2" }', drive='w1 = "2 rad/s"',
        equations=["w2*tan(p) = w1*tan(q)*(cos(q)/cos(p))^2"], step=0.01, end=end,
    )  # fmt: skip
    if is_followed:
        assert solve(text, "rk4").stop is None
    else:
        with pytest.raises(
            coursework.InputError, match=r"V512 .*cannot be followed beyond t = 0\.480398 s: a formula has no value"
        ):
            _ = solve(text, "rk4").stop
