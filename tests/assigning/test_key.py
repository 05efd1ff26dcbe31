"""The rows of a key have one decimal more than is asked for, the time its own."""

from types import SimpleNamespace

import numpy as np

from coursework.assigning.key import _rows


def test_a_key_shows_one_decimal_more_than_the_least():
    shown = SimpleNamespace(
        fixed=lambda value, decimals: f"{value:.{decimals}f}", times=lambda values: [f"{t:g}" for t in values]
    )
    motion = SimpleNamespace(t=np.array([0.0, 0.02]), rows=np.array([[1.23456, 2.0], [3.0, 4.0]]))
    found = _rows(SimpleNamespace(motion=motion, least_decimals=3), SimpleNamespace(numbers=shown))
    assert found == [("0", "1.2346", "2.0000"), ("0.02", "3.0000", "4.0000")]
