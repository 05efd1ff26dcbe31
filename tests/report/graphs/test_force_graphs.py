"""The field of a polar diagram: it holds the origin and the whole curve, at one scale for both axes."""

from __future__ import annotations

import numpy as np
import pytest

from coursework.report.graphs.force_graphs import _square
from coursework.report.graphs.graph_paper import BOTTOM, LEFT, RIGHT, TOP


@pytest.mark.parametrize("x", [(2.0, 5.0), (-3.0, 1.0), (-9.0, -8.0), (0.0, 0.0)])
@pytest.mark.parametrize("y", [(1.0, 4.0), (-2.0, 6.0), (-700.0, -3.0), (0.0, 0.0)])
def test_the_field_holds_the_origin_and_the_curve_at_one_scale(x: tuple[float, float], y: tuple[float, float]) -> None:
    field = _square(np.array(x), np.array(y))
    across, up = (np.array([0.0, *one]) for one in (x, y))
    assert np.all((field.x(across) >= LEFT) & (field.x(across) <= field.width - RIGHT))
    assert np.all((field.y(up) >= TOP) & (field.y(up) <= field.height - BOTTOM))
    assert field.x(1.0) - field.x(0.0) == pytest.approx(field.y(0.0) - field.y(1.0))
    share = max(np.ptp(across) / (field.last - field.first), np.ptp(up) / (field.high - field.low))
    assert share == (pytest.approx(1 / 1.1) if np.ptp([*across, *up]) else 0.0)  # a tenth is left over, not more
