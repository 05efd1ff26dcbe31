"""The conclusion says what was computed: stroke times, extremes, the step that would do, what the last row says."""

from __future__ import annotations

import math
import re
from functools import cache
from typing import Any

import pytest

import coursework
from coursework.report.sections.verdict import conclusion as module
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import Words
from coursework.report.wording.closeness import evidence
from coursework.results.checks.close_to_motion.period import Split
from coursework.results.kinematics.turning_points import Stroke, turning_points
from coursework.scene.scene_run import SceneRun
from coursework.words.sentences import load_phrases
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, page_of
from tests.report.own import FIVE_BAR, SHAPER


def plain(runs: Any) -> str:
    if isinstance(runs, str):
        return runs.replace("\u00a0", " ")
    return "".join(
        run.get("t", run.get("v", "") + run.get("s", "") + run.get("c", "") + run.get("p", "")) for run in runs
    ).replace("\u00a0", " ")


def conclusion(run: SceneRun, language: str = "en") -> tuple[list[str], list[list[str]]]:
    """Return the sentences and the rows of the table; nothing where the section is not there."""
    found = [section for section in model_of(run, language).sections if section.name == "conclusion"]
    parts = [part for section in found for part in section.parts]
    told = [plain(item) for part in parts if part.kind == "bullets" for item in part.items]
    return told, [[plain(cell) for cell in row] for part in parts if part.kind == "table" for row in part.rows]


def solved(text: str, **options: Any) -> SceneRun:
    return coursework.solve(coursework.parse_variant(text), **{"quantities": ("table", "checks"), **options})


@cache
def shaper_by_euler() -> SceneRun:
    return solved(SHAPER, scheme="euler")


def conclusion_of(context: PageContext) -> list[str]:
    return [plain(item) for part in module.conclusion(context) if part.kind == "bullets" for item in part.items]


def test_the_shaper_teaches_the_ratio_of_its_stroke_times() -> None:
    told, rows = conclusion(solved(SHAPER))
    beyond = math.degrees(2 * math.asin(0.4))
    assert "S = 0.400000 m" in told[0]
    assert f"{180 + beyond:.2f}°" in told[0] and f"{180 - beyond:.2f}°" in told[0]
    assert f"is {(180 + beyond) / (180 - beyond):.3f}." in told[0]
    ends = [360 - beyond / 2, 180 + beyond / 2]  # the crank stands across the lever there
    assert [re.findall(r"φ1 = ([\d.]+)°", told[0])] == [[f"{angle:.2f}" for angle in ends]]
    assert told[-1].startswith("Row 49, t = 0.5 s, repeats row 1 in positions and velocities")
    (lever,) = (row for row in rows if row[0].startswith("φ3"))
    assert lever[1] == f"{math.pi / 2 - math.asin(0.4):.5f}" and lever[4] == f"{math.pi / 2 + math.asin(0.4):.5f}"
    assert [row[0] for row in rows] == ["φ3, rad", "s, m", "φ4, rad", "x, m"], "the crank turns round and has no extremes"


def test_an_extreme_where_the_crank_lies_along_x_has_no_rounding_error_for_an_angle() -> None:
    """In a third of a turn about the guide, the rod is stretched in the middle; without offset, that is at 0°."""
    swing = mechanism("slider-crank", ('"0 deg"', '"-60 deg"'), e="0 m", end="2*pi/(3*n)", period=None)
    (slider,) = (row for row in conclusion(solved(swing))[1] if row[0].startswith("s"))
    assert slider[4:] == [f"{0.12 + 0.41:.6f}", "0.11111", "0°"]


def test_two_drives_have_extremes_and_no_stroke() -> None:
    told, rows = conclusion(solved(FIVE_BAR))
    assert not any("stroke" in one for one in told)
    assert [row[0] for row in rows] == ["φ2, rad", "φ3, rad"]
    assert len(rows[0]) == 5, "no angle of one crank stands beside the moments"


def test_the_step_that_would_do_is_told_once_in_seconds() -> None:
    run = shaper_by_euler()
    step = next(finding.step for finding in run.checks if finding.step)
    page = re.sub(r"<[^>]+>", "", page_of(model_of(run)))
    assert page.count(f"Take h ≈ {step:.3g}") == 1
    finer = solved(SHAPER, scheme="euler", step=step)
    assert {finding.verdict for finding in finer.checks} <= {"PASS", "SKIP"}
    assert "is small enough" in " ".join(conclusion(finer)[0])


def test_the_last_row_of_31_is_off_by_scheme_and_period() -> None:
    told, _ = conclusion(coursework.solve(coursework.load("31")))
    assert "is the scheme’s error" in told[-1] and "0.48 s not being the period 0.480366 s" in told[-1]


@pytest.mark.parametrize(("part", "even"), [(0.98e-6, True), (-0.98e-6, True), (1.02e-6, False), (-1.02e-6, False)])
def test_strokes_and_returns_that_differ_by_a_millionth_are_even_at_any_size(part: float, even: bool, monkeypatch: Any) -> None:
    context, judged = PageContext(shaper_by_euler(), Words(load_phrases("en"))), shaper_by_euler().results.evidence
    assert judged.period_row == 48
    for size in (0.004, 250.0):
        end = turning_points(evidence(context), "x", "vx")[0]  # type: ignore[index]
        found = Stroke(end, end, size * (1 + part), size, math.pi, math.pi)
        off = Split("x", "m", 0, 0.0, -size, -size, part * size - size, -part * size, 0.0)
        monkeypatch.setattr(module, "stroke", lambda *_, found=found: found)
        monkeypatch.setattr(module, "splits", lambda _, off=off: (off,))
        monkeypatch.setattr(module, "unreturned", lambda _, off=off: [off])
        told = conclusion_of(context)
        assert ("Both strokes take" in told[0]) is even, told[0]
        assert ("the mechanism itself has come back" in told[-1]) is even, told[-1]


@pytest.mark.long
@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_nothing_is_concluded_that_was_not_asked_for(language: str) -> None:
    assert conclusion(solved(SHAPER, quantities=("table",)), language) == ([], [])
    assert len(conclusion(solved(SHAPER), language)[0]) == 3


def test_of_a_motion_that_stops_no_extremes_are_told() -> None:
    stops = SHAPER.replace('r1 = "0.10 m"', 'r1 = "0.25 m"')
    told, rows = conclusion(solved(stops))
    assert told[0].startswith("At t = ") and ": dead point. The table has" in told[0] and rows == []


def test_a_motion_without_a_period_is_not_said_to_have_come_back() -> None:
    halfway = (
        SHAPER.replace('period = "2*pi/n"\n', "")
        .replace('w1 = "n"', 'w1 = "n*exp(-t/T)"')
        .replace('n = "120', 'T = "9 s"\nn = "120')
    )
    told, _ = conclusion(solved(halfway, scheme="euler"))
    assert "has not come back" in told[-1] and "all of it" not in told[-1]


def test_a_motion_without_a_period_is_not_held_against_the_end_of_one() -> None:
    text = SHAPER.replace('period = "2*pi/n"\n', "").replace('end = "2*pi/n"', 'end = "1.5*pi/n"')
    told, _ = conclusion(solved(text, scheme="exact"))
    assert told[-1].endswith("the mechanism has not come back.")


def test_whole_turns_taken_off_are_told_beside_the_difference() -> None:
    """19.1 rad from the first row to the last stood in the box as 0.257 rad."""
    run = coursework.solve("example-2-motor", quantities=["table", "checks"])
    box = next(part for part in model_of(run).sections[0].parts if part.kind == "result")
    assert any("θ1 0.257 rad" in plain(line) and "Whole turns are subtracted: 3 of θ1." in plain(line) for line in box.items)
    # The largest error has one share on the page: the check under forces measures a velocity by its largest size.
    (motion,) = (one for one in run.checks if one.code == "MOTION")
    (largest,) = (line for line in conclusion(run)[0] if line.startswith("Largest relative error"))
    assert f"row {motion.row}, {100 * motion.value:.1f} %" in largest


def test_the_rows_end_at_the_last_row_and_not_at_the_stop() -> None:
    run = coursework.solve(coursework.load("31").with_data(given={"alpha": 0.02}), quantities=["table", "checks"])
    assert next(one.sentence for one in run.checks if one.code == "PERIOD-POSITION").startswith("The rows end at t = 0.1 s,")
