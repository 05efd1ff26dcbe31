"""Random mechanisms, feasible and not: every run ends in a right table, a located and explained stop, or a refusal.

The suite takes 160 of them with fixed seeds; `python -m tests.hard.stress 10000` takes as many as you like.
"""

from tests.hard.stress import outcomes

CASES = 160


def test_no_outcome_is_unexplained():
    counts, faults, _ = outcomes(range(CASES))
    assert faults == []
    assert sum(counts.values()) == CASES
    # The families are made so that each outcome is met often enough to be worth testing.
    assert counts["table"] > CASES / 5
    assert counts["dead point"] > CASES / 5
    assert counts["refused"] > CASES / 50
    assert counts["change point"] > CASES / 200
