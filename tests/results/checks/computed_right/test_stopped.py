"""Whether a motion goes on to the end: given up by the search, standing still, or stopped by the mechanism or by the step."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.motion.integration.integrate import TOO_LARGE
from coursework.results.checks.computed_right.beginning import stopped


def verdict(**changed: Any) -> str:
    motion = SimpleNamespace(stop=None, t=np.arange(4.0), velocities=np.ones((4, 1)), coordinates=np.ones((4, 1)))
    motion.__dict__.update({key: value for key, value in changed.items() if key in motion.__dict__ and key != "stop"})
    motion.stop, motion.coordinate_names = changed.get("stopped"), ("q",)
    known: Any = SimpleNamespace(
        motion=motion, exact=SimpleNamespace(t=()), search=changed.get("search"), stop=changed.get("stop"),
        restricted=changed.get("restricted", False), least=lambda name: 1e-10,
        variant=SimpleNamespace(motor=changed.get("motor"), time=SimpleNamespace(end=3.0)),
    )  # fmt: skip
    return stopped(known).verdict


@pytest.mark.parametrize(("given_up", "goes_round", "found"), [
    (None, False, "PASS"), (2.0, False, "SKIP"), (2.0, True, "PASS"), ("no search", False, "PASS"),
])  # fmt: skip
def test_where_the_search_was_given_up_before_a_turn_the_end_is_not_known(given_up: Any, goes_round: bool, found: str) -> None:
    search = None if given_up == "no search" else SimpleNamespace(given_up=given_up, goes_round=goes_round)
    assert verdict(search=search) == found


@pytest.mark.parametrize(("changed", "found"), [
    ({}, "SKIP"), ({"restricted": True}, "PASS"), ({"motor": "a motor"}, "PASS"),
    ({"coordinates": np.arange(4.0)[:, None]}, "PASS"),
    ({"velocities": np.array([[0.0], [0.0], [1.0], [0.0]])}, "PASS"),
])  # fmt: skip
def test_what_stands_still_in_all_rows_makes_no_motion(changed: dict[str, Any], found: str) -> None:
    assert verdict(**{"velocities": np.zeros((4, 1)), **changed}) == found


@pytest.mark.parametrize(("kind", "mechanism", "found"), [
    (TOO_LARGE, None, "COARSE"), (TOO_LARGE, "a dead point", "FAIL"), ("dead_point", None, "FAIL"),
])  # fmt: skip
def test_a_step_too_large_is_the_schemes_and_a_dead_point_the_mechanisms(kind: str, mechanism: str | None, found: str) -> None:
    stop = SimpleNamespace(kind=kind, row=2, time=1.5, sentence="…")
    assert verdict(stopped=stop, stop=mechanism) == found
