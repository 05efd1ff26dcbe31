"""What a line lacks that is right and adds nothing, or is wrong by no single slip; the task is variant 31 of the lectures."""

from __future__ import annotations

import pytest

import coursework
from coursework.grading.marking.equations.lacks import lack_of, law_of
from coursework.grading.marking.equations.probe import random_probe
from coursework.grading.marking.key.key import key_of
from coursework.variant.formula.reader import parse_equation
from coursework.variant.formula.tree import Formula
from coursework.words.sentences import say

KEY = key_of(coursework.load("31"))
PROBE = random_probe(KEY)
OTHERS = [(say("feedback.lack.any_motion"), "r1*w1*cos(phi1) - r3*w3*sin(phi3) + r2*w2*cos(phi2) = 0")]


def difference(text: str) -> Formula:
    left, right = parse_equation(text)
    return Formula("-", (left, right))


@pytest.mark.parametrize(("line", "verdict", "lack"), [
    # no velocity that is sought
    ("r1*r2 = r2*r1", "right", "any_motion"), ("VMy = V1*sin(p*t + alpha)", "right", "no_velocity"),
    ("r1 = r2", "wrong", "no_velocity"),
    ("VMy = V1*cos(p*t)", "wrong", "drive"), ("phi1 = phi2", "wrong", "position"), ("phi1 = p*t", "wrong", "position"),
    ("phi1 = VMy", "wrong", "no_velocity"), ("r1*sin(phi1) = r2", "closure", "position"), ("r1 = r2", "closure", "position"),
    # one in a product, or in none in the end
    ("w1*w2 = w3", "wrong", "not_linear"), ("sin(w1) = w3", "right", "not_linear"), ("w1 - w1 = 0", "right", "any_motion"),
    # a term left out, whatever its sign, and two
    ("r3*w3*sin(phi3) - r2*w2*cos(phi2) = 0", "wrong", "term"), ("-r3*w3*sin(phi3) + r2*w2*cos(phi2) = 0", "wrong", "term"),
    ("r3*w3*sin(phi3) = 0", "wrong", ""),
    # the same as another line, and a sum of others
    ("r3*w3*sin(phi3) - r2*w2*cos(phi2) = r1*w1*cos(phi1)", "right", "repeats"),
    ("w3*(2*cos(phi3) + sin(phi3))*r3 = VMy", "right", "follows"),
])  # fmt: skip
def test_what_a_line_lacks(line: str, verdict: str, lack: str) -> None:
    found = lack_of(difference(line), verdict, [(place, difference(text)) for place, text in OTHERS], KEY.variant, PROBE)
    assert str(getattr(found, "key", found)).rpartition(".")[2] == lack
    if lack == "term":
        assert found.values["term"].replace(" ", "") == "r1*w1*cos(phi1)"  # type: ignore[union-attr]


@pytest.mark.parametrize(("line", "is_law"), [
    ("VMy = V1*sin(p*t)", True), ("VMy = 3", True), ("VMy = V1*sin(phi1)", False), ("r1 = 3", False), ("VMx = VMy", False),
])  # fmt: skip
def test_a_line_gives_a_driven_velocity_by_the_data_and_the_time_alone(line: str, is_law: bool) -> None:
    assert law_of(difference(line), KEY.variant).startswith("VMy = ") is is_law
