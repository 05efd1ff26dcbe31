"""Decimals that a sheet asks for and a class may hand in, just inside and just outside where one more is needed."""

import pytest

from coursework.grading.marking.decimals import decimals_accepted, decimals_asked


@pytest.mark.parametrize(("gap", "asked"), [(0.0051, 3), (0.0049, 4), (51.0, 1), (4.9, 1)])
def test_the_last_digit_asked_for_is_a_fifth_of_the_gap_at_most(gap, asked):
    assert decimals_asked(gap) == asked


@pytest.mark.parametrize(("gap", "accepted"), [(0.0167, 2), (0.0166, 3), (1.67, 0), (1.66, 1), (20.0, 0)])
def test_the_last_digit_accepted_is_six_tenths_of_the_gap_at_most(gap, accepted):
    """The last digit may be 0.6 of the gap: 0.6*0.0167 is more than 0.01, 0.6*0.0166 less.  Never fewer than none."""
    assert decimals_accepted(gap) == accepted
