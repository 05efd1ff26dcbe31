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
    assert shown.index("These rows are the motion itself") < shown.index("Explicit Euler goes along the tangent")
    assert "need not stand on the curve" not in shown
    assert "need not stand on the curve" in said(solved(FIVE_BAR, scheme="euler"), "results")


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
        ({"gain": 5.0}, "the gain 5\u00a01/s; gain times step is 0.1."),
        ({"project": 2}, "After each step 2 Newton corrections bring the positions back"),
        ({}, "24 evaluations of the velocities. Computed with"),
    ],
)
def test_how_the_drift_is_drawn_back_is_told(way: dict[str, Any], told: str) -> None:
    assert told in said(coursework.solve("31", "euler", quantities=["table"], **way), "method")
