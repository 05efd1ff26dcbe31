"""Which drives turn too fast for the rows, which are only a ripple on a larger motion, and what is advised."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.geometry.drives import drive
from coursework.words.errors import InputError


def scene(end=1.0, own_step=None, names=("w",)):
    time = SimpleNamespace(end=end, own_step=own_step)
    variant = SimpleNamespace(
        time=time, file="v.toml", nearest_line=lambda *_: 7, drive=[SimpleNamespace(name=name) for name in names]
    )
    return SimpleNamespace(variant=variant)


@pytest.mark.parametrize(("share", "end", "own_step", "key", "line"), [
    (1 - 2e-12, 1.0, None, None, 0), (1 + 1e-15, 1.0, None, "step_at_most", 7), (1.0, 1.0, 0.01, "step_at_most", 7),
    (1.0, 1.0, 0.02, "step_at_most", 0), (1.0, 199.9, None, "step_at_most", 7), (1.0, 200.1, None, "too_fast", 7),
])  # fmt: skip
def test_two_rows_are_wanted_in_a_period(share, end, own_step, key, line, monkeypatch):
    """In steps of 0.01 s it turns by a share of half a turn; a tenth of that is advised if the table has 200 000 rows at most."""
    monkeypatch.setattr(drive, "_is_ripple", lambda *_: False)
    if key is None:
        return drive.refuse_aliasing(scene(end, own_step), 0.01, share * math.pi / 0.01)
    with pytest.raises(InputError) as told:
        drive.refuse_aliasing(scene(end, own_step), 0.01, share * math.pi / 0.01)
    (fault,) = told.value.faults
    values = fault.message.values
    assert (fault.code, fault.line, values["advice"].key) == ("C021", line, f"hint.{key}")
    assert values["turned"] == pytest.approx(share * math.pi)
    assert key != "step_at_most" or values["advice"].values["most"] == pytest.approx(1e-3)
    monkeypatch.setattr(drive, "_is_ripple", lambda *_: True)
    return drive.refuse_aliasing(scene(end, own_step), 0.01, share * math.pi / 0.01)


@pytest.mark.parametrize("stretches", [1, 9_999, 30_001])
@pytest.mark.parametrize(("height", "is_ripple"), [(6.2, True), (6.4, False)])
def test_a_ripple_turns_back_and_forth_by_less_than_a_fiftieth_of_the_motion(height, is_ripple, stretches, monkeypatch):
    """Its height times 0.01 s/pi is held against a fiftieth of 1 rad; a second drive turns far and has no ripple."""
    monkeypatch.setattr(drive, "integrals", lambda _, names, times: np.column_stack([times, 50 * times]))
    monkeypatch.setattr(drive, "resolution", lambda _: SimpleNamespace(edges=np.linspace(0.0, 1.0, stretches + 1)))
    shape = lambda times: np.where((times % 1e-3 < 5e-4) if stretches > 1 else times < 0.5, 0.0, height)  # noqa: E731
    monkeypatch.setattr(drive, "drive_values", lambda _, names, times: np.column_stack([shape(times), 0 * times]))
    assert drive._is_ripple(scene(names=("w", "v")), 0.01) is is_ripple


def test_a_drive_without_a_value_is_no_ripple(monkeypatch):
    def without_value(*_):
        raise InputError([])

    monkeypatch.setattr(drive, "integrals", without_value)
    assert not drive._is_ripple(scene(), 0.01)
