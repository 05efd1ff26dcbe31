"""A short seeded class: what was put in is found, nothing else is named."""

import pytest

from tests.grading.marking.seeded import figures
from tests.sample import first


@pytest.mark.long
@pytest.mark.parametrize("count", first(1, (24, 60)))
def test_a_seeded_class_at_three_decimals_and_more(count):
    found = figures(count)
    assert found.first_found >= 0.98 * found.slips
    assert found.one_blamed >= 0.95 * found.slips
    assert found.named >= 0.95 * found.misconceptions
    assert found.without_ground == 0
    assert found.false_alarms == 0


@pytest.mark.long
@pytest.mark.parametrize("count", first(1, (18, 45)))
def test_at_two_decimals(count):
    found = figures(count, (2,))
    assert found.first_found >= 0.98 * found.slips
    assert found.false_alarms == 0
    assert found.without_ground == 0
