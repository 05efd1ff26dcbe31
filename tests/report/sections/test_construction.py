"""One line of the graph-analytical check: what was read, how the value follows, how far it is from the table's."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest

from coursework.report.sections.construction import reading_row
from coursework.report.text.numbers import NOTHING
from coursework.report.text.text_runs import ITALIC
from coursework.report.text.words import load_words


def row(**changes: Any) -> list[Any]:
    reading = {
        "name": "ω3", "length": "pm", "images": "pm", "read": 42.04, "computed": None, "relation": "pm 0.02 = 0.84", "found": 2.5,
        "table": 2.4, "unit": "rad/s", "difference": 0.0416, "explained": 0.0119, "rests": True,
    }  # fmt: skip
    one: Any = SimpleNamespace(**(reading | changes))
    return reading_row(load_words("en"), one, lambda text: [{"t": f"rich {text}"}], lambda text: [{"t": f"plan {text}"}])


def said(cells: list[Any]) -> list[str]:
    return [cell[0]["t"] if isinstance(cell, list) else cell for cell in cells]


def test_images_on_a_plan_are_set_as_points_and_other_lengths_as_symbols() -> None:
    slanted = "".join(f"{ITALIC[0]}{letter}{ITALIC[1]}" for letter in "pm")
    assert said(row())[:3] == ["rich ω3", f"plan {slanted} = 42.0", f"plan {slanted} 0.02 = 0.84"]
    assert said(row(images="", length="CM"))[:3] == ["rich ω3", "rich CM = 42.0", "rich pm 0.02 = 0.84"]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({}, "4.16 (±1.19)"), ({"difference": -1e-6}, "0.00 (±1.19)"), ({"difference": -0.02}, "−2.00 (±1.19)"),
        ({"rests": False}, NOTHING), ({"difference": math.nan}, NOTHING),
    ],
)  # fmt: skip
def test_how_far_apart_is_told_of_what_rests_on_a_reading(changes: dict[str, Any], told: str) -> None:
    assert row(**changes)[5] == told


def test_what_is_not_read_is_computed_or_given_and_what_the_table_has_not_is_nothing() -> None:
    computed = said(row(read=None, computed=7.25, images=""))[1]
    assert "7.2" in computed or "7.3" in computed
    assert said(row(read=None, computed=None, images=""))[1] == f"rich {load_words('en')('graph.given', length='pm')}"
    assert row(table=math.nan)[4] == NOTHING != row()[4]
