"""Random mechanisms, feasible and not: every run ends in a right table, a located and explained stop, or a refusal.

The suite takes 70 of them with fixed seeds; `python -m tests.hard.stress 10000` takes as many as you like.
"""

import pytest

from tests.hard.stress import outcomes
from tests.sample import first


@pytest.mark.parametrize("count", first(1, (70, 160)))
def test_no_outcome_is_unexplained(count):
    counts, faults, _ = outcomes(range(count))
    assert faults == []
    assert sum(counts.values()) == count
    # The families are made so that each outcome is met often enough to be worth testing.
    assert counts["table"] > count / 5
    assert counts["dead point"] > count / 5
    assert counts["refused"] > count / 50
    assert counts["change point"] > count / 200
