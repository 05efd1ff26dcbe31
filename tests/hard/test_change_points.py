"""H03, H04, H05, H06, H09, H26: where equations lose rank and stay solvable; the branch is told, never guessed."""

import math
import time

import numpy as np
import pytest

from coursework.mechanism import groups
from coursework.mechanism.groups import CannotAssemble, Pair
from coursework.motion.singular.change_point import distinct
from tests.hard.scenes import check, expected, four_bar, scene, solve

LOCATED = 1e-8


def touching(start: float, step: float) -> str:
    """A slider that is driven so that the crank turns evenly: at both dead points the drive stands still."""
    ahead = f"(t + {start!r})"
    return scene(
        f'theta = {{ start = "{start!r} rad", rate = "w" }}\n'
        f's = {{ start = "{math.cos(start) + math.sqrt(9 - math.sin(start) ** 2)!r} m", rate = "u" }}',
        given='r = "1 m"\nl = "3 m"',
        drive=f'u = "-sin{ahead} - sin{ahead}*cos{ahead}/sqrt(9 - sin{ahead}^2)"',
        step=step,
        end=8.0,
        closures=["(s - r*cos(theta))^2 + (r*sin(theta))^2 = l^2"],
    )


@pytest.mark.parametrize("scheme", ["euler", "heun", "rk4"])
@pytest.mark.parametrize("step", [0.05, 0.011])
@pytest.mark.parametrize(("start", "angle"), [(-0.5, 0.0), (0.5, math.pi)])
def test_h03_a_drive_that_stands_still_at_the_dead_point(scheme, step, start, angle):
    run = solve(touching(start, step), scheme)
    assert run.stop.kind == "change point"
    assert abs(run.stop.time - (angle - start)) < LOCATED
    assert abs(run.stop.coordinates["theta"] - angle) < LOCATED
    assert sorted(branch["w"] for branch in run.stop.branches) == pytest.approx([-1, 1], abs=1e-8)
    assert "two motions meet here" in run.stop.sentence
    assert np.all(run.motion.t < run.stop.time)
    assert np.allclose(run.exact.column("theta"), run.exact.t + start, atol=1e-9)
    assert expected("H03")["theta_dot_at_event"] == "+1 or -1"


H04 = expected("H04")
PARALLEL, ANTI = {"wp": 0.0, "wq": 1.0}, {"wp": 2 / 3, "wq": -1 / 3}


def branches(run) -> list[dict[str, float]]:
    return sorted((dict(branch) for branch in run.stop.branches), key=lambda branch: branch["wp"])


@pytest.mark.parametrize("step", [0.05, (math.pi - 0.3) / 10, 0.3])
@pytest.mark.parametrize("scheme", ["euler", "rk4"])
@pytest.mark.parametrize("branch", [1, -1])
def test_h04_a_parallelogram_stops_at_its_fold_with_both_branches(branch, scheme, step):
    row = [float(number) for number in H04["table theta,(phi_b,phi_c,det)+,(phi_b,phi_c,det)-"][0]]
    start = row[1:3] if branch > 0 else row[4:6]
    run = solve(four_bar(1, 2, 1, 2, (0.3, *start), step=step, end=7.0), scheme)
    told = [value for values in (run.stop.coordinates, *run.stop.branches) for value in values.values()]
    assert all(value == 0 or abs(value) > LOCATED for value in told)  # a page prints no 8.41e-11 for a zero
    assert run.stop.kind == "change point"
    assert abs(run.stop.time - (math.pi - 0.3)) < LOCATED
    assert branches(run) == [pytest.approx(PARALLEL, abs=1e-8), pytest.approx(ANTI, abs=1e-8)]
    if len(run.motion.t):
        assert np.all(run.motion.determinants * run.motion.determinants[0] > 0)
    for theta, *numbers in H04["table theta,(phi_b,phi_c,det)+,(phi_b,phi_c,det)-"]:
        place = int(np.argmin(np.abs(run.exact.column("theta") - float(theta))))
        if abs(run.exact.column("theta")[place] - float(theta)) < 1e-12:
            wanted = [float(number) for number in (numbers[:2] if branch > 0 else numbers[3:5])]
            assert np.allclose([run.exact.column("p")[place], run.exact.column("q")[place]], wanted, atol=1e-12)


def test_h04_the_other_fold_and_a_start_that_stands_on_it():
    row = [float(number) for number in H04["table theta,(phi_b,phi_c,det)+,(phi_b,phi_c,det)-"][2]]
    run = solve(four_bar(1, 2, 1, 2, (row[0], *row[1:3]), end=4.0))
    assert run.stop.kind == "change point"
    assert abs(run.stop.time - (2 * math.pi - row[0])) < LOCATED
    at_once = solve(four_bar(1, 2, 1, 2, (0.0, 0.0, 0.0)), quantities=("table", "checks"))
    for found in (run, at_once):
        assert branches(found) == [pytest.approx({"wp": -2, "wq": -3}, abs=1e-8), pytest.approx(PARALLEL, abs=1e-8)]
    assert at_once.stop.time == 0
    assert len(at_once.motion.t) == len(at_once.exact.t) == 0
    assert check(at_once, "STOP").verdict == "FAIL"
    assert "no row is computed" in at_once.stop.sentence


def test_h05_neutral_four_bar_closes_at_its_fold_in_every_scale():
    wanted = expected("H05")
    assert wanted["float64"] == "1.0"
    for scale, argument in wanted["scales_with_arg>1 (first 5 of 420 in 0.001..2.000)"]:
        a, b, c, d = (length * scale for length in (1, 4, 2, 3))
        assert ((d - a) ** 2 + b * b - c * c) / (2 * (d - a) * b) == pytest.approx(float(argument), abs=3e-16)
    for scale in np.arange(1, 2001) / 1000:
        a, b, c, d = (length * scale for length in (1.0, 4.0, 2.0, 3.0))
        start, frame = Pair((a, 0.0), (0, 0), (0, 0)), Pair((d, 0.0), (0, 0), (0, 0))
        folded = groups.rrr(start, frame, lengths=(b, c), mode=1, positions_only=True)
        assert np.all(np.isfinite(np.array(folded.coordinates)))
    with pytest.raises(CannotAssemble, match="too long to fold"):
        groups.rrr(Pair((1.0, 0.0), (0, 0), (0, 0)), Pair((3 - 1e-12, 0.0), (0, 0), (0, 0)), lengths=(4, 2), mode=1)


@pytest.mark.parametrize("scale", [1.0, 0.1, 0.005, 1.7])
def test_h05_the_run_stops_at_the_fold(scale):
    run = solve(chain(1 * scale, 4 * scale, 2 * scale, 3 * scale, -0.5, 1.0))
    assert run.stop.kind == "change point"
    assert abs(run.stop.time - 0.5) < LOCATED
    assert len(run.stop.branches) == 2


def chain(a: float, b: float, c: float, d: float, theta: float, end: float, mode: str = "+1", step: float = 0.02) -> str:
    return scene(
        f'theta = {{ start = "{theta!r} rad", rate = "w1" }}\np = {{ rate = "wp", unit = "rad" }}\n'
        'q = { rate = "wq", unit = "rad" }',
        given="\n".join(f'{name} = "{value!r} m"' for name, value in zip("abcd", (a, b, c, d), strict=True)),
        drive='w1 = "1"',
        step=step,
        end=end,
        more='[[group]]\nkind = "crank"\nfrom = ["(0, 0)"]\nmeets = "A"\nlengths = ["a"]\ncoordinates = ["theta"]\n'
        f'[[group]]\nkind = "RRR"\nfrom = ["A", "(d, 0)"]\nmeets = "B"\nlengths = ["b", "c"]\n'
        f'coordinates = ["p", "q"]\nmode = "{mode}"',
    )


@pytest.mark.parametrize("short", [1e-2, 1e-4, 1e-6, 1e-8])
def test_h06_close_to_a_change_point_the_digits_are_told(short):
    """a, b, c, d = 1, 2, 2, 3 - short at theta = pi: the dyad is stretched but for `short`."""
    run = solve(chain(1, 2, 2, 3 - short, math.pi, 0.02), quantities=("table", "checks"))
    found = check(run, "CONDITION")
    height = math.sqrt(4 - ((4 - short) / 2) ** 2)
    between = 2 * math.asin(height / 2)  # the angle between the two links, 2 m each
    wanted = 16 - math.log10(1 / math.tan(between / 2))
    assert run.stop is None
    assert found.verdict == "PASS"
    assert abs(found.value - wanted) < 0.4
    assert "of 16 digits" in found.sentence
    assert np.isfinite(run.columns()[1]).all()


@pytest.mark.parametrize("short", [1e-16, 1e-12])
def test_h06_nearer_than_any_link_is_cut_the_motion_stops_and_says_why(short):
    """3 - 1e-16 is 3 in a computer: half of the digits of the angle are lost, and with them the branch."""
    assert 3 - 1e-16 == 3
    ahead = solve(chain(1, 2, 2, 3 - short, math.pi - 0.3, 1.0))
    at_once = solve(chain(1, 2, 2, 3 - short, math.pi, 1.0))
    assert abs(ahead.stop.time - 0.3) < LOCATED
    assert at_once.stop.time < LOCATED
    assert ahead.stop.kind == at_once.stop.kind == "change point"
    # Four links on one line: both arms satisfy the closure differentiated once and twice.
    for branch in ahead.stop.branches:
        wp, wq = branch["wp"], branch["wq"]
        assert abs(-1 + 2 * wp + 2 * wq) < 1e-8  # vertical components at theta = pi, p = 0, q = pi
        assert abs(1 - 2 * wp**2 - 2 * wq**2) < 1e-8  # horizontal ones, once more differentiated


def past_the_pivot(height: float, step: float) -> str:
    """A point driven along y = height past a pivot at the origin; the rod s @ phi follows it."""
    return scene(
        f'x = {{ start = "-0.5 m", rate = "v" }}\nphi = {{ start = "{math.atan2(height, -0.5)!r} rad", rate = "w" }}\n'
        f's = {{ start = "{math.hypot(0.5, height)!r} m", rate = "u" }}',
        given=f'h = "{height!r} m"',
        drive='v = "1"',
        step=step,
        end=1.0,
        closures=["(x, h) = s @ phi"],
    )


@pytest.mark.parametrize("height", [0.001, 0.1])
@pytest.mark.parametrize("step", [0.02, 0.0021, 0.0002])
def test_h09_the_fastest_moment_between_two_rows_is_told(height, step):
    run = solve(past_the_pivot(height, step), quantities=("table", "checks"))
    found = check(run, "PEAK")
    turned = 2 * math.atan(step / 2 / height)  # in the step about x = 0, at 1 m/s
    assert found.verdict == ("PASS" if turned <= 1 else "COARSE")
    assert found.value == pytest.approx(turned, rel=1e-4)
    assert ("which a step of at most" in found.sentence) == (found.verdict == "COARSE")
    if run.stop is not None:
        assert run.stop.kind == "step too large"
        assert turned > 1
    exact = np.arctan2(height, run.exact.column("x"))
    assert np.allclose(run.exact.column("phi"), exact, atol=1e-9)


@pytest.mark.parametrize("scheme", ["euler", "rk4", "exact"])
@pytest.mark.parametrize("step", [0.02, 0.03])
def test_h09_through_the_pivot_the_slide_changes_its_sign(scheme, step):
    """h = 0: the rod does not turn (omega = 0) and s runs through zero; a row stands there with 0.02 s, none with 0.03 s."""
    run = solve(past_the_pivot(0.0, step), scheme, ("table", "checks", "accelerations"))
    t = np.arange(math.floor(1 / step * (1 + 1e-9)) + 1) * step
    assert run.stop is None
    assert np.allclose(run.motion.t, t, rtol=1e-14)
    for name, wanted in {"s": 0.5 - t, "phi": math.pi + 0 * t, "w": 0 * t, "u": 0 * t - 1}.items():
        assert np.max(np.abs(run.motion.column(name) - wanted)) < 1e-11
    assert np.max(np.abs(run.results.accelerations)) < 1e-9
    assert {one.code for one in run.checks if one.verdict not in {"PASS", "SKIP"}} == set()
    (told,) = run.motion.notes
    assert told.startswith("At t = 0.5 s the equations do not give w and u: s = 0")
    assert "Only one motion continues there, with w = 0, u = -1; the table follows it" in told


def many_windows(count: int, theta: float, end: float, step: float) -> str:
    """The N-four-bar of the IFToMM library (A02): 2N+1 links of 1 m, N squares side by side."""
    names = ["theta", *(f"c{i}" for i in range(1, count + 1))]
    coordinates = [f'theta = {{ start = "{theta!r} rad", rate = "w" }}']
    coordinates += [f'b{i} = {{ start = "0 rad", rate = "wb{i}" }}' for i in range(1, count + 1)]
    coordinates += [f'c{i} = {{ start = "{theta!r} rad", rate = "wc{i}" }}' for i in range(1, count + 1)]
    closures = [f"l @ {names[i - 1]} + l @ b{i} = (l, 0) + l @ c{i}" for i in range(1, count + 1)]
    return scene(
        "\n".join(coordinates), given='l = "1 m"', drive='w = "-1"', step=step, end=end, closures=closures
    )  # fmt: skip


@pytest.mark.parametrize("count", [2, 40])
def test_h26_the_n_four_bar_loses_one_rank_a_window(count):
    begun = time.process_time()
    run = solve(many_windows(count, math.pi / 2, 2.0, 0.1))
    wanted = expected("H26")[f"N={count}"]
    system = run.scene.flow.system
    for theta, numbers in ((math.pi / 2, wanted["1.571"]), (0.001, wanted["0.001"]), (0.0, wanted["0.0"])):
        sizes = np.linalg.svd(system.matrix(0.0, [theta, *[0.0] * count, *[theta] * count])[0], compute_uv=False)
        assert np.sum(sizes > 1e-12) == numbers["rank(1e-12)"]
        assert abs(sizes[-1] - numbers["smin"]) < 1e-9
        if numbers["cond"]:
            assert sizes[0] / sizes[-1] == pytest.approx(numbers["cond"], rel=1e-6)
    stop = run.stop
    assert stop.kind == "change point"
    assert abs(stop.time - math.pi / 2) < LOCATED
    assert f"the rank drops from {2 * count} to {count}" in stop.sentence
    assert stop.block == ("wb1", "wc1")
    # A rhombus: the other motion turns links b and c while the crank stands still, so one only goes on with the crank.
    assert stop.branches[0]["wb1"] == pytest.approx(0, abs=1e-7)
    assert stop.branches[0]["wc1"] == pytest.approx(-1, abs=1e-7)
    assert len(run.motion.t) == 16
    assert time.process_time() - begun < 60


def test_h26_a_start_near_the_flat_position_runs_and_says_how_many_digits_it_has():
    run = solve(many_windows(2, math.pi - 0.001, 0.5, 0.01), quantities=("table", "checks"))
    cond = expected("H26")["N=2"]["0.001"]["cond"]
    assert run.stop is None
    assert abs(check(run, "CONDITION").value - (16 - math.log10(cond))) < 0.6


def test_a_flat_parallelogram_with_rounded_start_is_no_silent_passage():
    """Start values with ten digits: the closure is declared, so the motion is that of the closed mechanism."""
    run = solve(four_bar(1, 2, 1, 2, (0.3, -0.5513649171, -0.8513649171), end=4.0))
    assert run.stop.kind == "change point"
    assert abs(run.stop.time - (math.pi - 0.3)) < LOCATED


@pytest.mark.parametrize(("apart", "count"), [(0.9e-6, 1), (1.1e-6, 2)])
def test_two_motions_differ_from_a_millionth_on(apart, count):
    first = {"w": 2.0, "u": -1.0}
    for second in ({"w": 2.0 + apart, "u": -1.0}, {"w": 2.0, "u": -1.0 - apart}):
        assert len(distinct([first, second])) == count
    assert distinct([]) == ()


def test_branches_that_are_round_off_are_not_told():
    """Two links of 1e6 m on a foot of 1e-6 m: differences of the closure have no digit that says how fast they turn."""
    a, b, d, start = 1e-6, 1e6, 2e-6, 1.0
    along = math.atan2(-a * math.sin(start), d - a * math.cos(start)) + math.pi / 2
    run = solve(four_bar(a, b, b, d, (start, along, along), speed="10"), quantities=("table", "checks"))
    assert run.stop.kind == "change point"
    assert run.stop.branches == ()
    assert "not decided" in run.stop.sentence
