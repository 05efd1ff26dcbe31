"""START: what the file says is zero is judged at the start values; what only they can give is said to be not judged."""

import math
import re

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from tests.mechanisms.library import changed, mechanism

# A crank and rocker of my own: its sides, and two angles of it from the cosine rule.
A, B, C, D = 0.13, 0.41, 0.29, 0.37
DIAGONAL = math.hypot(D, A)  # the crank stands upright
REACH = math.atan2(-A, D)
ROD = REACH + math.acos((B**2 + DIAGONAL**2 - C**2) / (2 * B * DIAGONAL))
ROCKER = math.atan2(A + B * math.sin(ROD), B * math.cos(ROD) - D)
LOOP = '["(R - Q - c @ phi3).x", "(R - Q - c @ phi3).y"]'
HINGE = '["(R - S).x", "S.y - R.y"]'
BY_HAND = '["R.x - Q.x - c*cos(phi3)", "R.y - Q.y - c*sin(phi3)"]'


def four_bar(holds, rocker=ROCKER, unit="rad"):
    """Return the four-bar with its rocker at an angle, ROCKER where its loop is closed."""
    return mechanism("four-bar-by-its-points", (f"{ROCKER!r} rad", f"{rocker!r} {unit}"), holds=holds)


def solved(holds, rocker=ROCKER):
    text = four_bar(holds, rocker)
    run = coursework.solve(coursework.parse_variant(text, "own.toml"), "rk4")
    return run, next(finding for finding in run.checks if finding.code == "START")


@pytest.mark.parametrize("holds", [LOOP, BY_HAND, HINGE])
def test_a_loop_that_the_file_states_judges_the_start(holds):
    run, right = solved(holds)
    assert right.verdict == "PASS"
    assert "6 of 6" in run.summary or "5 of 5" in run.summary
    run, wrong = solved(holds, ROCKER + 0.02)
    assert (wrong.verdict, wrong.row, run.status()) == ("FAIL", 1, 1)
    off = max(abs(math.cos(ROCKER + 0.02) - math.cos(ROCKER)), abs(math.sin(ROCKER + 0.02) - math.sin(ROCKER))) * C
    assert wrong.value == pytest.approx(off, rel=1e-9)
    assert f"phi3 = {ROCKER:.6f}"[:-1] in str(wrong.sentence)
    assert "rows, dead points and the exact motion are those of links that do not meet" in str(wrong.sentence)
    assert "START" in run.summary


@pytest.mark.parametrize("decimals", [2, 4, 5])
def test_a_start_rounded_to_its_digits_is_told_so_and_one_with_another_last_digit_is_wrong(decimals):
    """The rod is typed with all digits, the rocker with a few: half of its last decimal times its length is allowed."""
    typed, last = round(ROCKER, decimals), 10.0**-decimals
    further = typed + math.copysign(last, typed - ROCKER)
    for value, verdict, summary in (
        (typed, "COARSE", "as far as the digits of its data go"),
        (further, "FAIL", "not computed right"),
    ):
        run, start = solved(LOOP, float(f"{value:.{decimals}f}"))
        assert start.verdict == verdict
        assert summary in run.summary
    assert f"may open it by {last / 2 * C * max(abs(math.sin(typed)), abs(math.cos(typed))):.2g} m" in str(
        solved(LOOP, typed)[1].sentence
    )


def test_a_height_that_only_the_start_gives_is_said_to_be_not_judged():
    run, start = solved('["phi3 - phi2", "R.y - S.y"]')
    assert start.verdict == "SKIP"
    assert "; the start is not judged." in run.summary


def test_what_the_start_alone_gives_is_told_with_its_value_where_it_is_not_zero():
    """A distance between two points may be a length of the task; a height may not, so it is not told."""
    distance = "(R.x - Q.x)^2 + (R.y - Q.y)^2 - c^2"
    closed, off = (solved(f'["{distance}", "R.y - c*sin(phi3)"]', rocker)[1] for rocker in (ROCKER, ROCKER + 0.02))
    assert "R.y" not in str(closed.sentence)
    assert f"R.y - c*sin(phi3) = {C * (math.sin(ROCKER) - math.sin(ROCKER + 0.02)):.12g}"[:22] in str(off.sentence)
    assert distance not in str(off.sentence)


def test_where_no_position_closes_what_the_start_alone_keeps_is_told_with_it():
    """The coordinates of the pivot are swapped: the start, 0.25 m beside the slide, is kept there, out of reach of the rods."""
    text = mechanism("press-on-a-rocker", xC="0.25 m", yC="0.5 m")
    run = coursework.solve(coursework.parse_variant(text), quantities=["checks"])
    (start,) = (one for one in run.checks if one.code == "START")
    assert "there is no closed position near it. What the motion keeps" in str(start.sentence)
    assert "start values: D.x - xC = 0.25." in str(start.sentence)


def test_the_command_check_tells_an_open_start_too(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for rocker, status in ((ROCKER, 0), (ROCKER + 0.002, 1)):
        text = four_bar(LOOP, rocker)
        (tmp_path / "own.toml").write_text(text, encoding="utf-8")
        told = CliRunner().invoke(main, ["check", "own.toml"])
        assert (told.exit_code, "leave the mechanism open" in told.output) == (status, bool(status))
        assert ("is possible" in told.output) == (not status)


@pytest.mark.parametrize("off", [-2.7, -1.2, 1.8, 2.4])
def test_the_nearest_closed_start_is_found_from_far_and_told_without_whole_turns(off):
    """Newton alone finds none from two of these, and comes to rest some turns away from the others."""
    sentence = str(solved(LOOP, ROCKER + off)[1].sentence)
    rod, rocker = (float(value) for value in re.findall(r"phi[23] = (-?[\d.]+\d)", sentence))
    assert max(abs(rod - ROD), abs(rocker - ROCKER - off)) < math.pi
    assert math.cos(math.pi / 2) * A + math.cos(rod) * B == pytest.approx(D + math.cos(rocker) * C, abs=1e-9)
    assert A + math.sin(rod) * B == pytest.approx(math.sin(rocker) * C, abs=1e-9)


def test_the_nearest_closed_start_stands_in_the_units_of_the_file():
    """Radians copied into the place of degrees would start another motion."""
    text = four_bar(LOOP, math.degrees(ROCKER + 0.02), "deg")
    run = coursework.solve(coursework.parse_variant(text, "own.toml"), "rk4")
    told = str(next(finding for finding in run.checks if finding.code == "START").sentence)
    assert re.search(r"phi2 = [-\d.]+ rad, phi3 = [-\d.]+ deg\.$", told)


def test_a_mechanism_that_nothing_drives_is_no_table_that_passes():
    text = changed(four_bar(LOOP), w1="0")
    run = coursework.solve(coursework.parse_variant(text), "rk4")
    assert next(one for one in run.checks if one.code == "STOP").verdict == "SKIP"
    assert run.summary.startswith("Nothing moves: every velocity is zero in each of the 21 rows.")


@pytest.mark.parametrize(("turned", "moves"), [(0.5, True), (1.1e-10, True), (0.9e-10, False)])
@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_what_moves_between_two_rows_only_moves(scheme, turned, moves):
    """The crank turns so far (rad) in a pulse of a few microseconds; in every row all velocities are zero."""
    law = f"{turned!r}*exp(-((t - 0.5037)/1e-6)^2)/(1e-6*sqrt(pi))"
    run = coursework.solve(coursework.parse_variant(changed(four_bar(LOOP), w1=law, step="0.05 s", end="1 s")), scheme)
    assert not np.any(run.motion.velocities)
    assert run.summary.startswith("Nothing moves") != moves


def test_a_dead_point_at_the_start_is_no_lack_of_the_file(tmp_path):
    """There the geometry gives no velocity, and to say more in [points] or [closure] would mend nothing."""
    file = tmp_path / "arm.toml"
    file.write_text(mechanism("arm-with-relative-angle", ("1 rad", "180 deg")), encoding="utf-8")
    run = coursework.solve(file)
    found = next(check for check in run.checks if check.code == "AGREEMENT")
    assert (run.stop.time, found.verdict) == (0.0, "SKIP") and "not judged" not in run.summary
    told = CliRunner().invoke(main, ["check", str(file)]).stdout
    assert "dead point" in told and "nothing in the geometry gives" not in told


def test_a_start_that_keeps_more_than_the_sentence_lists_says_that_there_is_more():
    held = ["R.x - c*cos(phi3)", "R.y - c*sin(phi3) + d", "R.x - S.x + d"]
    for more, ending in ([], "R.x - S.x + d = 0.37. If"), (["R.y - S.y + d"], "R.x - S.x + d = 0.37, …. If"):
        _, start = solved(str([*held, *more]).replace("'", '"'))
        assert ending in str(start.sentence)


def test_a_joint_that_starts_beside_the_end_of_its_rod_leaves_the_mechanism_open():
    """Sides of 0.5, 0.5 and 0.4 m: the joint is above the middle of the base.  From where s is counted, only the start says."""
    found = [_start(jack(beside, counted)) for beside, counted in ((0.0, 0.15), (0.01, 0.15), (0.01, 0.2))]
    assert [one.verdict for one in found] == ["SKIP", "FAIL", "FAIL"]
    assert "E.x - s = 0.05." in str(found[0].sentence)
    for wrong in found[1:]:
        assert wrong.value == pytest.approx(0.01, rel=1e-9)
        nearest = dict(re.findall(r"(\w+) = ([\d.]+)", str(wrong.sentence)))
        assert math.hypot(float(nearest["x"]), float(nearest["y"])) == pytest.approx(0.5, abs=1e-10)
        assert math.hypot(float(nearest["x"]) - 0.4, float(nearest["y"])) == pytest.approx(float(nearest["l"]), abs=1e-10)
        assert float(nearest["x"]) == pytest.approx(0.5 * math.cos(float(nearest["phi1"])), abs=1e-10)
    assert float(nearest["s"]) != pytest.approx(float(nearest["x"]), abs=1e-3)  # not a length of any link, so left as it is


def jack(beside, counted):
    return mechanism("jack", ('"0.2 m"', f'"{0.2 + beside!r} m"'), ('"0.15 m"', f'"{counted!r} m"'))


def _start(text):
    return next(one for one in coursework.solve(coursework.parse_variant(text, "own.toml")).checks if one.code == "START")


def test_a_start_that_closes_all_loops_still_tells_what_it_alone_gives():
    loops = [f"({arm}).{axis}" for arm in ("E - P - r @ phi1", "E - Q - l @ phi2") for axis in "xy"]
    kept, none = (_start(changed(jack(0.0, s), holds=str([*loops, "E.x - s"]).replace("'", '"'))) for s in (0.15, 0.2))
    assert kept.verdict == none.verdict == "PASS"
    assert str(kept.sentence).startswith("The start values close the loops of the mechanism. What the motion keeps constant")
    assert "E.x - s = 0.05." in str(kept.sentence)
    assert str(none.sentence) == "The start values close the mechanism."


def test_the_angle_between_two_gears_is_no_length_that_should_be_zero():
    geared = ("[time]", 'g = { start = "1 rad", rate = "w4" }\n[time]')
    found = _start(mechanism("four-bar-by-its-points", geared, holds=LOOP[:-1] + ', "2*phi1 + g"]'))
    assert str(found.sentence) == "The start values close the mechanism."
