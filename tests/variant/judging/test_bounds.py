"""Times given as numbers: what is no number is told, with a hint if a comma stands in it."""

import pytest

from coursework.variant.judging.bounds import number_of_seconds
from coursework.words.errors import InputError


@pytest.mark.parametrize(("value", "found"), [(2, 2.0), ("0.5", 0.5), (1e-3, 1e-3)])
def test_a_number_of_seconds(value, found):
    assert number_of_seconds(value, "step") == found


@pytest.mark.parametrize(("value", "hint"), [("0,5", True), ("half", False), (True, False), (None, False)])
def test_what_is_no_number_of_seconds_is_told(value, hint):
    with pytest.raises(InputError) as told:
        number_of_seconds(value, "step")
    assert ("Decimals are written with a point." in str(told.value)) is hint
