"""A slide that is zero in every row has no digits that lengths could cost: nothing is said of lengths far apart."""

import coursework
from tests.results.checks.test_unseen_signs import SLIDER, X, Y


def test_a_rod_as_long_as_its_crank_that_stays_at_the_pivot_is_computed_right():
    text = SLIDER.format(angle="0 deg", x=X, y=Y)
    for old, new in (
        ('b = "0.43 m"', 'b = "0.11 m"'), ('e = "0.05 m"', 'e = "0 m"'), ("40 deg", "10 deg"), ('end = "0.4 s"', 'end = "0.1 s"'),
        ('mode = "+1"', 'mode = "-1"'),
    ):  # fmt: skip
        assert old in text
        text = text.replace(old, new)
    run = coursework.solve(coursework.parse_variant(text, "own.toml"))
    assert abs(run.motion.column("s")).max() < 1e-15
    found = next(finding for finding in run.checks if finding.code == "CONDITION")
    assert (found.verdict, found.value > 14) == ("PASS", True)
    assert "lengths" not in str(found.sentence)
