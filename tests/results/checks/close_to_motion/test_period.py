"""What a column lacks after a period: the scheme's part, the motion's own and round-off make the whole."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.results.checks.close_to_motion.period import mismatch

ROWS = np.array([[1.0, 0.5], [4.0, 0.7], [1.0 + 2 * np.pi + 0.03, 0.54]])  # an angle that turned once, and a length
EXACT = {"phi1": [1.0, 4.0, 1.0 + 2 * np.pi], "s": [0.5, 0.7, 0.51]}
FINER = np.array([[1.0, 0.5], [4.0, 0.7], [1.0 + 2 * np.pi + 0.029, 0.538]], dtype=np.longdouble)


def evidence(**changed: Any) -> Any:
    motion = SimpleNamespace(stop=None, rows=ROWS, names=("phi1", "s"), coordinate_names=("phi1", "s"))
    known: dict[str, Any] = {
        "period_row": 2, "motion": motion, "exact": SimpleNamespace(column=EXACT.__getitem__), "compared": 3,
        "unit": {"phi1": "rad", "s": "m"}.__getitem__, "extended_precision": FINER,
    }  # fmt: skip
    return SimpleNamespace(**{**known, **changed})


def test_the_parts_of_a_mismatch() -> None:
    """After a turn the angle is 0.03 too large, all but 0.001 of that by the scheme; of the length's 0.04 the motion has 0.01."""
    angle, length = mismatch(evidence()) or ()
    assert (angle.name, angle.unit, angle.turns, length.turns) == ("phi1", "rad", 1, 0)
    assert (angle.first, angle.last, length.first, length.last) == pytest.approx((1.0, 1.03, 0.5, 0.54))
    assert (angle.total, angle.scheme, angle.period, angle.roundoff) == pytest.approx((0.03, 0.029, 0.0, 0.001))
    assert (length.total, length.scheme, length.period, length.roundoff) == pytest.approx((0.04, 0.028, 0.01, 0.002))


def test_without_finer_numbers_no_round_off_is_told() -> None:
    assert [(one.roundoff, one.scheme) for one in mismatch(evidence(extended_precision=None)) or ()] == [
        (0.0, pytest.approx(0.03)), (0.0, pytest.approx(0.03)),
    ]  # fmt: skip


@pytest.mark.parametrize("changed", [{"period_row": None}, {"exact": None}, {"compared": 2}])
def test_of_a_run_that_reaches_no_period_nothing_is_told(changed: dict[str, Any]) -> None:
    assert mismatch(evidence(**changed)) is None
