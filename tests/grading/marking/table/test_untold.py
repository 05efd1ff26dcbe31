"""How many of the cells count that the digits cannot tell: no single cell decides about many."""

import numpy as np
import pytest

from coursework.grading.marking.table.untold import but, ramp


@pytest.mark.parametrize(("share", "part"), [(0.0, 0.0), (0.8, 0.0), (0.865, 0.5), (0.93, 1.0), (1.0, 1.0)])
def test_the_part_rises_between_two_shares(share: float, part: float) -> None:
    assert ramp(share, 0.8, 0.93) == pytest.approx(part)


@pytest.mark.parametrize(("part", "left"), [(0.0, [1, 2, 4, 5]), (0.3, [4, 5]), (0.5, [4, 5]), (0.51, [5]), (1.0, [])])
def test_the_first_cells_are_left_out(part: float, left: list[int]) -> None:
    """Four of six cells: of each part as many as it begins."""
    found = np.isin(np.arange(6), [1, 2, 4, 5]).reshape(2, 3)
    assert np.flatnonzero(but(found, part)).tolist() == left
    assert np.flatnonzero(found).tolist() == [1, 2, 4, 5]
