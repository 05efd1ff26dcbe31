"""The shares that the ranges of the catalogue tell: a part of the draws is measured again."""

import math

import pytest

from tests.assigning import shares

DRAWS = 60


def test_there_are_ranges_for_the_kinds_of_template_that_a_course_has():
    assert {"31", "homework", "v101", "v102", "v107", "whitworth"} <= set(shares.names())


@pytest.mark.long
@pytest.mark.parametrize("name", shares.names())
def test_the_shares_of_a_part_are_those_told(name):
    feasible, banded = (share / 100 for share in shares.told(name))
    verdicts, inside = shares.measured(name, DRAWS)
    for share, count in ((feasible, sum(not one.refused for one in verdicts)), (banded, sum(inside))):
        spread = 4 * math.sqrt(share * (1 - share) / DRAWS)
        assert abs(count / DRAWS - share) <= spread + 1 / DRAWS, (share, count)
