"""A page of exact rows opens with them, Euler's step comes after; and a heading says a name once."""

from __future__ import annotations

from typing import Any

import pytest

import coursework
from coursework.scene.scene_run import SceneRun
from tests.report.made import model_of
from tests.report.own import FIVE_BAR, SHAPER


def solved(text: str, **options: Any) -> SceneRun:
    return coursework.solve(coursework.parse_variant(text), **{"quantities": ("table", "checks"), **options})


def said(run: SceneRun, section: str, language: str = "en") -> str:
    (found,) = (one for one in model_of(run, language).sections if one.name == section)
    told = [part.text for part in found.parts if part.kind == "paragraph"]
    told += [part.caption for part in found.parts if part.kind == "figure"]
    told += [cell for part in found.parts if part.kind == "table" for row in part.rows for cell in row]
    return " ".join("".join(one.get("t", "") for one in runs if isinstance(one, dict)) for runs in told)


def test_exact_rows_are_told_before_the_step_of_euler_and_stand_on_the_curve() -> None:
    shown = said(solved(FIVE_BAR, scheme="exact"), "results")
    assert shown.index("These rows are the motion itself") < shown.index("Explicit Euler follows the tangent")
    assert "need not lie on the curve" not in shown and "largest relative error" not in shown
    assert "need not lie on the curve" in said(solved(FIVE_BAR, scheme="euler"), "results")


@pytest.mark.long
@pytest.mark.parametrize("title", ["mine", ""])
def test_a_heading_says_a_name_once(title: str) -> None:
    run = solved(SHAPER.replace('"Shaper with a slotted lever"', f'"{title}"'))
    assert model_of(run).heading == f"Variant {run.variant.name}" if not title else "mine" in model_of(run).heading
    named = run.variant.name
    again = solved(SHAPER.replace('"Shaper with a slotted lever"', f'"{named}"'))
    assert model_of(again).heading == f"Variant {named}"


@pytest.mark.parametrize(
    ("way", "told"),
    [
        ({"gain": 5.0}, "the gain 5\u00a01/s; the gain times the step is 0.1."),
        ({"project": 2}, "After each step 2 Newton corrections close the positions again"),
        ({}, "Evaluations of the velocities: 24. Computed with"),
    ],
)
def test_how_the_drift_is_drawn_back_is_told(way: dict[str, Any], told: str) -> None:
    assert told in said(coursework.solve("31", "euler", quantities=["table"], **way), "method")


# Both cranks of the five-bar are back after 2 s; no row is there, the nearest 4 ms before.
@pytest.mark.parametrize(("period", "is_one"), [("2 s", True), ("1.7 s", False)])
def test_that_the_run_does_not_end_with_its_period_is_why_only_where_the_motion_has_it(period: str, is_one: bool) -> None:
    text = FIVE_BAR.replace('period = "2 s"', f'period = "{period}"').replace('step = "0.05 s"', 'step = "0.0499 s"')
    assert ("that alone is why" in said(solved(text, scheme="exact"), "results")) is is_one
    rows = solved(text, scheme="euler")
    assert ("due to the period" in said(rows, "results")) is is_one
    told = str([part for one in model_of(rows).sections if one.name == "conclusion" for part in one.parts])
    assert ("not being the period" in told, "has not come back" in told) == (is_one, not is_one)


@pytest.mark.long
@pytest.mark.parametrize(("time", "inside"), [("0.42 s", True), ("0.4 s", False)])
def test_a_step_inside_which_the_drive_changes_is_not_taken_for_the_bend_of_the_curve(time: str, inside: bool) -> None:
    text = FIVE_BAR.replace('w4 = "n4"', f'w4 = {{ pieces = [["0 s", "n4"], ["{time}", "-3*n4"]] }}')
    shown = said(solved(text, scheme="euler"), "results")
    assert ("A step within which the drive changes its formula is left out" in shown) is inside
    assert "the time of row 9)" not in shown


def test_where_drives_place_every_coordinate_a_row_repeats_the_first_only_if_they_do() -> None:
    """An arm that turns and grows: after a turn it points the same way and is longer."""
    arm = (
        '[drive]\nw = "2"\nu = "0.1"\n[coordinates]\nphi = { start = "0 deg", rate = "w" }\ns = { start = "0.1 m", rate = "u" }\n'
        '[unknowns]\nvx = "m/s"\n[time]\nstep = "pi/40"\nend = "pi"\n'
        '[[constraint]]\nequation = "vx = u*cos(phi) - s*w*sin(phi)"\n[ask]\nquantities = ["table", "checks"]\n'
    )
    run = solved(arm)
    told = str([part for one in model_of(run).sections if one.name == "conclusion" for part in one.parts])
    assert "which has not come back" in told and "repeats row 1" not in told


def test_a_break_inside_a_step_has_no_limit_that_it_keeps() -> None:
    """Of rows a turn at least twenty are wanted; of the part of a step after a break none is enough."""
    text = FIVE_BAR.replace('w4 = "n4"', 'w4 = { pieces = [["0 s", "n4"], ["0.42 s", "-3*n4"]] }')
    step = next(one for one in solved(text, scheme="euler").checks if one.code == "STEP")
    assert (step.verdict, round(step.value, 6), step.limit) == ("COARSE", 0.6, None)
