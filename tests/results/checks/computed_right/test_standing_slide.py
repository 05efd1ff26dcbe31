"""A slide that is zero in every row has no digits that lengths could cost: nothing is said of lengths far apart."""

import coursework
from tests.results.checks.computed_right.test_unseen_signs import slider_crank


def test_a_rod_as_long_as_its_crank_that_stays_at_the_pivot_is_computed_right():
    text = slider_crank("0 deg", ('"40 deg"', '"10 deg"'), ('mode = "+1"', 'mode = "-1"'), l="0.12 m", e="0 m", end="0.1 s")
    run = coursework.solve(coursework.parse_variant(text, "own.toml"))
    assert abs(run.motion.column("s")).max() < 1e-15
    found = next(finding for finding in run.checks if finding.code == "CONDITION")
    assert (found.verdict, found.value > 14) == ("PASS", True)
    assert "lengths" not in str(found.sentence)
