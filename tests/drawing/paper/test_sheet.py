"""What is put on a sheet of paper: an arrow has a head that is alike on both sides, whichever way it points."""

from __future__ import annotations

import pytest

from coursework.drawing.paper.sheet import Sheet


@pytest.mark.parametrize("tip", [10 + 0j, 10j, 6 + 8j, -6 + 8j, 0.6 - 0.8j])
def test_the_head_of_an_arrow_is_alike_on_both_sides(tip: complex) -> None:
    """2.6 mm long, or as long as the arrow itself."""
    sheet, begin = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0)), 40 + 40j
    sheet.arrow(begin, begin + tip, "thin")
    (end, left), (_, right) = list(sheet.segments)[-2:]
    assert end == begin + tip
    assert abs(left - end) == pytest.approx(abs(right - end))
    neck = (left + right) / 2
    assert (end - neck) / tip * abs(tip) == pytest.approx(min(2.6, abs(tip)))
    assert ((left - right) / tip).real == pytest.approx(0.0)
    assert 0.5 < abs(left - right) / 2.6 < 1.0
