"""H07, H08, H11 - H17: linear systems that are badly scaled, redundant, contradictory, incomplete or not linear."""

import math
import re

import numpy as np
import pytest

from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.hard.scenes import CASES, V31, check, expected, four_bar, rates, scene, solve
from tests.hard.test_change_points import chain


def message(text: str) -> str:
    """Return what a text is refused with."""
    with pytest.raises(InputError) as caught:
        _ = solve(text).motion
    return str(caught.value)


def test_h07_a_small_determinant_of_well_posed_equations_is_solved():
    run = solve(
        scene(rates("w1", "w2"), step=0.1, end=1.0, equations=["w1 + w2 = 2", "w1 + (1 + 1e-8)*w2 = 2 + 1e-8"]),
        quantities=("table", "checks"),
    )
    wanted = expected("H07")
    found = check(run, "CONDITION")
    assert run.stop is None
    assert np.allclose(run.motion.velocities, [float(x) for x in wanted["x"]], atol=1e-7)
    assert found.rows[0][1] == pytest.approx(float(wanted["cond_2"]), rel=1e-3)
    assert found.value == pytest.approx(16 - math.log10(4e8), abs=1e-3)
    assert found.verdict == "PASS"
    matrix = run.scene.flow.system.matrix(0.0, [0.0, 0.0])[0]
    lengths = np.linalg.norm(matrix, axis=1)
    assert abs(np.linalg.det(matrix / lengths[:, None])) == pytest.approx(float(wanted["normalised_det"]), rel=1e-3)


def test_h07_six_digits_are_the_least():
    run = solve(
        scene(rates("w1", "w2"), step=0.1, end=1.0, equations=["w1 + w2 = 2", "w1 + (1 + 1e-11)*w2 = 2 + 1e-11"]),
        quantities=("table", "checks"),
    )
    assert check(run, "CONDITION").verdict == "FAIL"


def test_h08_metres_and_millimetres_give_the_same_verdict():
    metres = solve(V31, quantities=("table", "checks"))
    small = re.sub(r'"([\d.]+) (m|m/s)"', lambda m: f'"{float(m[1]) / 1000!r} {m[2]}"', V31)
    shrunk = solve(small, quantities=("table", "checks"))
    assert np.allclose(metres.motion.coordinates, shrunk.motion.coordinates, rtol=0, atol=1e-11)
    assert np.allclose(np.abs(metres.motion.scaled), np.abs(shrunk.motion.scaled), rtol=1e-11)
    block = [block.unknowns for block in metres.reduction.blocks].index(("w1", "w2"))
    assert abs(metres.motion.scaled[0, block]) == pytest.approx(float(expected("H08")["sin(phi2-phi1)_t0"]), abs=1e-14)
    assert abs(metres.motion.determinants[0, block]) / abs(shrunk.motion.determinants[0, block]) == pytest.approx(1e6)
    for one, other in zip(metres.checks, shrunk.checks, strict=True):
        assert (one.code, one.verdict) == (other.code, other.verdict)


def guides(gamma: float, *, offset: float = 1.0) -> str:
    """A crank with two slides of a PRP dyad beside it, the guides nearly parallel (H11)."""
    return scene(
        'theta = { start = "0 rad", rate = "w" }\ns1 = { rate = "u1", unit = "m" }\ns2 = { rate = "u2", unit = "m" }',
        given='r = "0.1 m"',
        drive='w = "1"',
        step=0.1,
        end=0.2,
        more='[[group]]\nkind = "crank"\nfrom = ["(0, 0)"]\nmeets = "A"\nlengths = ["r"]\ncoordinates = ["theta"]\n'
        '[[group]]\nkind = "PRP"\ncoordinates = ["s1", "s2"]\n'
        f'guides = [{{ through = "A - r @ theta", angle = "0" }}, {{ through = "(0.3, {offset!r})", angle = "{gamma!r} rad" }}]',
    )


def test_h11_nearly_parallel_guides_still_cross():
    run = solve(guides(1e-8), quantities=("table", "checks"))
    wanted = expected("H11")
    assert run.exact.column("s2")[0] == pytest.approx(float(wanted["gamma=1e-8: s2"]), rel=1e-7)
    cond = check(run, "CONDITION").rows[0][1]
    assert cond == pytest.approx(float(wanted["cond"].lstrip("~")), rel=0.2)
    assert check(run, "CONDITION").value == pytest.approx(16 - math.log10(cond))


def test_h11_parallel_guides_apart_or_on_each_other_are_refused():
    assert expected("H11")["gamma=0"].startswith("inconsistent")
    apart, same = message(guides(0.0)), message(guides(0.0, offset=0.0))
    assert "the slides are parallel" in apart
    assert "1.0000 m apart" in apart
    assert "coincide" in same


def test_h12_too_many_equations_here_too_few_there_said_by_name():
    case = CASES["H12"]
    found = message(scene(rates("w1", "w2", "w3", "w4"), equations=[e.replace("=", " = ") for e in case["data"]["equations"]]))
    over, under = case["expected"]["over"], case["expected"]["under"]
    assert "4 unknown velocities (w1, w2, w3, w4) and 3 independent equations of 4" in found
    assert case["expected"]["structural_rank"] == 3
    assert f"{', '.join(map(str, over['eqs'][:2]))} and {over['eqs'][2]} contain only {' and '.join(over['vars'])}" in found
    assert f"{' and '.join(under['vars'])} appear only in equation {under['eqs'][0]}" in found


def test_h13_a_repeated_equation_is_left_out_and_checked():
    data = CASES["H13"]["data"]
    run = solve(
        scene(
            rates("w1", "w2"),
            given=f'v = "{data["v"]} m/s"\nr1 = "{data["r1"]} m"\nf = "{data["f"]} rad"',
            step=0.1,
            equations=data["equations"],
        ),
        quantities=("table", "checks"),
    )
    wanted = expected("H13")
    assert run.table["w1"].iloc[0] == pytest.approx(float(wanted["w1"]), rel=1e-15)
    assert run.table["w2"].iloc[0] == pytest.approx(float(wanted["w2"]), rel=1e-15)
    assert len(run.reduction.used) == wanted["rank"]
    assert run.reduction.notes == ("Equation 2 says the same as 1; it is not needed and only checked.",)
    label, residual, _ = check(run, "RESIDUAL").rows[0]
    assert label.startswith("2 (not used)")
    assert residual <= 1e-12


def test_h14_two_equations_that_contradict_each_other_are_named():
    found = message(scene(rates("w1", "w2"), equations=CASES["H14"]["data"]["equations"]))
    assert "Equation 2 contradicts equation 1: the right sides differ by 0.001 at t = 0" in found
    assert "1.0005" not in found  # what least squares would have made of it


def test_h15_an_equation_that_is_not_linear_is_named_with_its_term():
    first, second = CASES["H15"]["data"]["equation"].split(", ")
    found = message(scene(rates("w1", "w2"), equations=[first, second]))
    assert "constraint 1" in found
    assert "not linear in the unknown velocities" in found
    assert "w1^2" in found
    assert "choose the sign and give the velocity itself" in found


@pytest.mark.parametrize(("sign", "root"), [("+", 0), ("-", 1)])
def test_h15_with_its_sign_declared_a_speed_can_be_driven(sign, root):
    """w1^2 + w1 w2 = 3 with w2 = 2 has the roots 1 and -3: each becomes a drive of its own once it is chosen."""
    run = solve(scene(rates("w1", "w2"), drive=f'c = "-1 {sign} sqrt(1 + 3)"', equations=["w1 = c", "w2 = 2"], step=0.1))
    assert run.table["w1"].iloc[0] == float(expected("H15")["roots_w1"][root])


def test_h16_a_link_without_length_is_refused_when_the_file_is_read():
    text = V31.replace('"0.847 m"', '"0 m"')
    without_points = text.split("# --- geometry")[0]
    in_closure = scene(
        rates("w1", "w2"), given='a = "0 m"\nb = "1 m"', closures=["a @ x1 + b @ x2 = (b, 0)"]
    )  # fmt: skip
    in_group = chain(1, 0, 2, 2, 0.3, 1.0)
    for refused, name in ((text, "r2"), (without_points, "r2"), (in_closure, "a"), (in_group, "b")):
        with pytest.raises(InputError) as caught:
            parse_variant(refused)
        assert re.search(rf"\b{name}\b", str(caught.value))
        assert "its angular velocity means nothing" in str(caught.value)
        assert caught.value.faults[0].line > 0
    with pytest.raises(InputError, match="w2 appears only beside r2"):
        parse_variant(without_points)


def test_h17_a_tiny_crank_beside_long_links_is_no_bad_condition():
    data = CASES["H17"]["data"]
    a, b, c, d, theta = (float(data[name]) for name in ("a", "b", "c", "d", "theta"))
    run = solve(chain(a, b, c, d, theta, 2 * math.pi, step=2 * math.pi / 24), quantities=("table", "checks"))
    found = check(run, "CONDITION")
    assert found.verdict == "PASS"
    assert found.rows[0][1] < 10
    assert found.value > 15
    # Independently: the rocker swings by a first-order part of the crank, q = q0 + a f(theta) + O(a^2).
    p, q = run.exact.column("p"), run.exact.column("q")
    residual = a * np.exp(1j * run.exact.column("theta")) + b * np.exp(1j * p) - d - c * np.exp(1j * q)
    assert np.max(np.abs(residual)) < 1e-15 * 8
    slope = a * np.sin(p - run.exact.column("theta")) / (c * np.sin(p - q))
    assert np.allclose(run.exact.column("wq"), slope, rtol=1e-9)
    unequal = run.scene.flow.system.matrix(0.0, run.exact.coordinates[0].tolist())[0]
    assert unequal.shape == (2, 2)


def test_h17_the_four_by_four_of_the_raw_case():
    """With the pin's velocity among the unknowns the raw matrix has entries of 1e-6 beside 1 and still all its digits."""
    data = CASES["H17"]["data"]
    start = solve(chain(float(data["a"]), 2, 1, 2, 0.7, 0.1)).exact.coordinates[0].tolist()
    text = scene(
        f'theta = {{ start = "0.7 rad", rate = "w1" }}\np = {{ start = "{start[1]!r} rad", rate = "wp" }}\n'
        f'q = {{ start = "{start[2]!r} rad", rate = "wq" }}',
        given='a = "1e-6 m"\nb = "2 m"\nc = "1 m"\nd = "2 m"',
        unknowns='vx = "m/s"\nvy = "m/s"',
        step=0.1,
        end=1.0,
        equations=[
            "vx + a*w1*sin(theta) = 0", "vy - a*w1*cos(theta) = 0", "vx - b*wp*sin(p) + c*wq*sin(q) = 0",
            "vy + b*wp*cos(p) - c*wq*cos(q) = 0", "a*w1 = 1e-6",
        ],
    )  # fmt: skip
    run = solve(text, quantities=("table", "checks"))
    raw = run.scene.flow.system.matrix(0.0, run.motion.coordinates[0].tolist())[0]
    assert np.linalg.cond(raw) > 1e5
    assert check(run, "CONDITION").rows[0][1] < 100


def test_a_determinant_of_given_data_alone_is_told_as_such():
    """Guides at an angle that the data make zero: no position of the mechanism helps."""
    equations = ["w2 + w3*cos(gamma) = w1", "w3*sin(gamma) = w1"]
    text = scene(rates("w1", "w2", "w3"), given='gamma = "0 rad"', drive='w1 = "1"', equations=equations)
    stop = solve(text).stop
    assert stop.kind == "dead point"
    assert "sin(gamma) is zero with these data, in every position" in stop.meaning


def test_one_drive_too_many_is_told():
    text = V31.replace("[drive]", '[drive]\nw1 = "2"')
    assert "or drive less: w1, VMx and VMy are prescribed" in message(text)


@pytest.mark.parametrize(
    ("drive", "told"),
    [
        ("1/(t - 0.05)", "the drive w1 has no finite value about t = 0.05 s"),
        ("sqrt(0.05 - t)", "the drive w1 has no finite value about t = 0.05 s"),
        ("log(0.05 - t)", "the drive w1 has no finite value about t = 0.05 s"),
        ("atan(tan(9*t - pi/2))", "as tan(pi/2) has none"),  # a double has a value there, what is made of the formula has not
    ],
)
def test_a_drive_without_a_value_is_named_with_its_line(drive, told):
    text = four_bar(0.4, 1.0, 0.7, 1.2, (0.0, 0.768793548991278, 1.6871299784681), speed=drive, end=0.2)
    found = message(text)
    assert told in found
    assert found[5:].startswith("variant:")


def test_a_crank_that_turns_by_turns_in_a_step_is_refused_where_nobody_knows_that_it_can():
    """Two drives: what is possible depends on both, and the motion is not followed through thousands of turns."""
    coordinates = "\n".join(
        f'{name} = {{ start = "{start} rad", rate = "{rate}" }}'
        for name, start, rate in (
            ("theta", 0, "w1"),
            ("s", 0, "w4"),
            ("p", 0.768793548991278, "wp"),
            ("q", 1.6871299784681, "wq"),
        )
    )
    text = scene(
        coordinates, given='a = "0.4 m"\nb = "1.0 m"\nc = "0.7 m"\nd = "1.1 m"\ne = "0.1 m"', end=0.2,
        drive='w1 = "1e5 + sin(t)"\nw4 = "sin(3*t)"', closures=["a @ theta + b @ p = (d, 0) + e @ s + c @ q"],
    )  # fmt: skip
    assert "the drive w1 turns its crank by 2e+03 rad in one step" in message(text)
