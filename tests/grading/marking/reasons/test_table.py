"""What seems to have happened is told once, be it named or what the points were earned by."""

from types import SimpleNamespace

import pytest

from coursework.grading.marking.reasons.table import _causes
from coursework.grading.marking.table.causes.misconceptions import Misconception


@pytest.mark.parametrize(
    ("named", "earned_by", "told"),
    [
        ("heun", "heun", 1), ("heun", "midpoint", 1), ("heun", "datum_r1", 2), ("origin_phi1", "start_phi1", 1),
        ("origin_phi1", "start_phi2", 2), (None, "heun", 1),
    ],
)  # fmt: skip
def test_a_cause_is_told_once(named, earned_by, told):
    found = named and Misconception(named, 0.95, 0.5, ("midpoint",))
    earned = SimpleNamespace(rule="misconception", cause=earned_by)
    reasons = list(_causes(SimpleNamespace(), SimpleNamespace(misconception=found, earned=earned), {}))
    assert [reason.kind for reason in reasons].count("cause") == told
    assert [reason.kind for reason in reasons].count("finding") == (1 if named else 0)
