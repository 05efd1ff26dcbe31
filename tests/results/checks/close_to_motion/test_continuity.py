"""A jump is a change that stays however short the time looked at; a steep slope, a turn and a break of the drive are none."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from coursework.results.checks.close_to_motion import continuity
from coursework.words.sentences import say
from tests.hard.scenes import scene
from tests.mechanisms.library import mechanism
from tests.results.checks.scenes import V31, evidence_of, found, solve


def sliding(law: str, **more):
    """A slider on a rail at a distance that follows from a crank: x = law of phi."""
    return scene(
        'phi = { start = "0.1 rad", rate = "w" }\nx = { rate = "u", unit = "m", start = "START m" }',
        given='r = "0.2 m"',
        drive='w = "3"',
        step=0.01,
        end=1.0,
        equations=[],
        more=f'[functions]\ns = "{law}"\n[[constraint]]\nname = "slide"\nclosure = "x = s"\n',
        **more,
    )


def test_a_velocity_that_jumps_where_a_formula_has_a_kink():
    """d|sin|/dt jumps by 2 r w where the crank passes a half turn: 1.2 m/s at t = (pi - 0.1)/3."""
    run = solve(sliding("r*abs(sin(phi))").replace("START", repr(0.2 * math.sin(0.1))), "rk4", end=1.5)
    jump = found(run, "CONTINUITY")
    assert (jump.verdict, jump.column) == ("FAIL", "u")
    assert jump.row == int((np.pi - 0.1) / 3 / 0.01) + 1
    assert jump.value * run.results.evidence.scale["u"] == pytest.approx(1.2, rel=1e-3)
    assert run.status() == 1
    at = float(jump.sentence.partition("at t = ")[2].partition(" s")[0])
    assert at == pytest.approx((np.pi - 0.1) / 3, abs=1e-6)


@pytest.mark.parametrize(("height", "verdict"), [(0.049, "PASS"), (0.051, "FAIL")])
def test_how_large_a_jump_is_one(height, verdict):
    """x = r sin(phi) + k|sin(phi)| - k sin(phi): u jumps by 2 k w of a range from -r w to r w cos(0.1)."""
    r = 0.2
    k = height * r * (1 + math.cos(0.1)) / 2
    law = f"r*sin(phi) + {k!r}*(abs(sin(phi)) - sin(phi))"
    run = solve(sliding(law).replace("START", repr(r * math.sin(0.1))), "rk4", end=2 * np.pi / 3)
    judged = found(run, "CONTINUITY")
    assert judged.verdict == verdict, judged


def test_a_pulse_between_two_rows_is_no_jump():
    """Between the rows w rises from 1e-11 of its peak and falls back to it: no row shows how large it becomes."""
    text = scene(
        'phi = { start = "0 rad", rate = "w" }', given='r = "0.5 m"\nT = "2e-4 s"', step=0.01, end=0.3,
        equations=["r*w = v"], drive='v = "100*exp(-((t - 0.151)/T)^2)"',
    )  # fmt: skip
    assert found(solve(text), "CONTINUITY").verdict != "FAIL"


def test_a_break_of_the_drive_is_no_jump():
    text = scene(
        'phi = { start = "0 rad", rate = "w" }', given='r = "0.5 m"', step=0.05, end=0.5, equations=["r*w = v"],
        drive='v = { pieces = [["0 s", "0"], ["0.1 s", "1"], ["0.35 s", "0"]] }',
    )  # fmt: skip
    for step in (0.05, 0.02):
        judged = found(solve(text, step=step), "CONTINUITY")
        assert judged.verdict == "PASS" and judged.sentence.startswith(
            "The exact motion jumps only in its velocities, where the drive jumps"
        )


@pytest.mark.parametrize(
    "law", [
        '"2*t"', '{ pieces = [["0 s", "2*t"], ["0.1 s", "0.2"]] }',
        '{ pieces = [["0 s", "t^2"], ["0.13 s", "0.0169 + 0.26*(t - 0.13)"]] }',
    ],
)  # fmt: skip
def test_a_drive_that_goes_on_where_it_changes_its_formula_does_not_jump(law):
    text = scene('phi = { start = "0 rad", rate = "w" }', given='r = "0.5 m"', step=0.05, end=0.5, equations=["r*w = v"],
        drive=f"v = {law}")  # fmt: skip
    for step in (0.05, 0.02):
        assert found(solve(text, step=step), "CONTINUITY").sentence.startswith("The exact motion has no jump")


@pytest.mark.parametrize("step", [0.02, 0.01, 0.005])
def test_a_steep_slope_is_no_jump(step):
    """Close to the feasible edge the curves turn sharply; looked at closely they are curves."""
    run = solve(V31.replace('alpha = "4.35 rad"', 'alpha = "1.5985 rad"'), "rk4", step=step)
    assert found(run, "CONTINUITY").verdict != "FAIL"
    assert continuity.jump_of_exact(evidence_of(run)) is None


JUMPS = {
    "a sign": ("r*abs(sin(phi))/sin(phi)", (math.pi - 0.1) / 3),
    "an angle taken back": ("r*atan(tan(phi))", (math.pi / 2 - 0.1) / 3),
    "a direction": ("r*atan2(sin(phi), cos(phi))", (math.pi - 0.1) / 3),
}


@pytest.mark.parametrize("scheme", ["exact", "rk4"])
@pytest.mark.parametrize("law", JUMPS)
def test_a_position_that_jumps_where_a_formula_does(law, scheme):
    """abs(x)/x, atan(tan(x)) and atan2 have a value on both sides of a jump: the velocities go on, no link can."""
    formula, time = JUMPS[law]
    start = {"a sign": 0.2, "an angle taken back": 0.02, "a direction": 0.02}[law]
    text = sliding(formula).replace("START", repr(start))
    after, before = (solve(text, scheme, end=end) for end in (time + 0.011, time - 0.011))
    judged = found(after, "DRIFT")
    row = int(time / 0.01) + 1
    assert (judged.verdict, judged.column, judged.row) == ("FAIL", "slide", row + 1)
    assert judged.sentence.startswith(f"The position equation slide jumps between rows {row} and {row + 1} (before t = ")
    assert after.status() == 1
    assert not judged.option
    assert (found(before, "DRIFT").verdict, before.status()) == ("PASS", 0)


@pytest.mark.parametrize("size", ["0.4", "0.04", "0.0004"])
def test_a_position_equation_that_the_velocities_do_not_keep_does_not_jump(size):
    """r sin(q) - k p with q = pi/2 + p/2 is r cos(p/2) - k p: it opens at once at the rate k; its own motion is singular there.

    The lengths r and k are not what costs the digits.
    """
    run = solve(mechanism("height-that-is-not-kept", k=f"{size} m"), "rk4")
    p = np.linspace(0, 0.5, 51)
    opened = np.abs(0.2 * (np.cos(p / 2) - 1) - float(size) * p) / min(0.2, float(size))  # of the shorter length
    row, judged = int(np.argmax(opened > 0.05)), found(run, "DRIFT")
    assert judged.verdict == "FAIL"
    told = "The velocities do not keep the position equation r*sin(q) - k*p: already from row {} on (t = {:.6g} s)"
    assert judged.sentence.startswith(told.format(row, 0.01 * (row - 1)))
    assert "lengths" not in found(run, "CONDITION").sentence
    if size == "0.4":
        assert "The velocities do not keep a position equation." in render_html(build_model(run))


@pytest.mark.parametrize(("step", "row"), [(0.02, 5), (0.03, 3)])
def test_a_drive_that_jumps_by_its_formula(step, row):
    """(t - 0.1)/abs(t - 0.1) is 0/0 at 0.1 s: refused with its line where a row stands there, else told as a jump."""
    text = scene(
        'phi = { start = "0 rad", rate = "w" }', given='r = "0.5 m"\nv0 = "1 m/s"', step=step, end=0.3,
        drive='v = "v0*(t - 0.1)/abs(t - 0.1)"', equations=["r*w = v"],
    )  # fmt: skip
    if step == 0.02:
        with pytest.raises(coursework.InputError) as caught:
            _ = solve(text).motion
        (fault,) = caught.value.faults
        assert fault.line == text[: text.index("v = ")].count("\n") + 1
        assert "no value at t = 0.1 s" in fault.message
        return
    run = solve(text)
    jump = found(run, "CONTINUITY")
    assert (jump.verdict, jump.column, jump.row) == ("FAIL", "w", row + 1)
    assert jump.value * run.results.evidence.scale["w"] == pytest.approx(4.0, rel=1e-6)


@pytest.mark.parametrize(("rows", "verdict"), [(0, "SKIP"), (1, "SKIP"), (2, "PASS")])
def test_two_rows_are_a_curve(rows, verdict, monkeypatch):
    monkeypatch.setattr(continuity, "_jumps_at_breaks", lambda _: False)
    judged = SimpleNamespace(
        compared=rows, names=("phi",), errors=np.zeros((rows, 1)), once=lambda *_: None,
        say=lambda key, **_: say(key, name="phi", share="0", row=1, next=2),
    )  # fmt: skip
    assert continuity.continuity(judged).verdict == verdict
