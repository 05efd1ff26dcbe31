"""A short seeded class: what was put in is found, nothing else is named."""

from tests.grading.marking.seeded import figures


def test_a_seeded_class_at_three_decimals_and_more():
    found = figures(60)
    assert found.first_found >= 0.98 * found.slips
    assert found.one_blamed >= 0.95 * found.slips
    assert found.named >= 0.95 * found.misconceptions
    assert found.without_ground == 0
    assert found.false_alarms == 0


def test_at_two_decimals():
    found = figures(45, (2,))
    assert found.first_found >= 0.98 * found.slips
    assert found.false_alarms == 0
    assert found.without_ground == 0
