"""Times: what is no number is told, with a hint if a comma stands in it, and so is more than is computed."""

from types import SimpleNamespace

import pytest

from coursework.variant.judging.bounds import exceeded, number_of_seconds, timed
from coursework.words.errors import InputError


@pytest.mark.parametrize(("value", "found"), [(2, 2.0), ("0.5", 0.5), (1e-3, 1e-3)])
def test_a_number_of_seconds(value, found):
    assert number_of_seconds(value, "step") == found


@pytest.mark.parametrize(("value", "hint"), [("0,5", True), ("half", False), (True, False), (None, False)])
def test_what_is_no_number_of_seconds_is_told(value, hint):
    with pytest.raises(InputError) as told:
        number_of_seconds(value, "step")
    assert ("Decimals are written with a point." in str(told.value)) is hint


@pytest.mark.parametrize(("columns", "steps", "period", "end", "key"), [
    (20, 199_999, None, 1.0, None), (20, 200_000, None, 1.0, "step"), (21, 199_999, None, 1.0, "step"),
    (2, 4, 0.25, 1.0, None), (2, 4, 0.25 * (1 - 1e-10), 1.0, None), (2, 4, 0.25 * (1 - 1e-8), 1.0, "period"),
    (2, 4, 0.25, 2500.0, None), (2, 4, 0.25, 2500 * (1 + 1e-10), None), (2, 4, 0.25, 2500 * (1 + 1e-8), "end"),
])  # fmt: skip
def test_a_run_has_at_most_four_million_numbers_and_ten_thousand_periods(columns, steps, period, end, key):
    """A period lasts a step of 0.25 s at least; round-off of either is no fault."""
    time = SimpleNamespace(steps=steps, period=period, step=0.25, end=end)
    found = exceeded(SimpleNamespace(time=time, columns=("x",) * columns))
    assert [named for named, _ in found] == ([key] if key else [])


@pytest.mark.parametrize(("step", "end", "code"), [
    (0.25, 0.25, None), (0.25, 0.25 * (1 - 1e-10), None), (0.25, 0.25 * (1 - 1e-8), "C010"), (0.25, 50_000.0, None),
    (0.25, 50_000.01, "C011"), (0.0, 1.0, "C008"), (5e-324, 1e-320, None), (-0.25, 1.0, "C008"), (0.25, float("inf"), "C009"),
])  # fmt: skip
def test_times_give_from_one_step_to_two_hundred_thousand(step, end, code):
    variant = SimpleNamespace(timed=lambda *times: times)
    if code is None:
        assert timed(variant, step, end) == (step, end)
    else:
        with pytest.raises(InputError, match=code):
            timed(variant, step, end)
