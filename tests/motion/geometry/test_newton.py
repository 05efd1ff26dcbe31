"""When Newton has arrived and when it gives up, on corrections made up for it; row by row by the same rules."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.geometry.closure import Closure


@pytest.mark.parametrize(
    ("steps", "taken"),
    [
        ([9.9, 0.0], 2), ([10.1], None), ([-10.1], None), ([np.nan], None),  # no correction goes further than ten
        ([1e-3, 0.9e-15], 2), ([1e-3, 1.1e-15, 0.0], 3),  # settled
        ([0.9e-11, 0.5e-11], 2), ([0.9e-11, 0.4e-11, 0.0], 3), ([1.2e-11, 1.1e-11, 0.0], 3),  # small, and shrinks no longer
        ([1e-3] * 24 + [0.0], 25), ([1e-3] * 24 + [0.9e-9], 25), ([1e-3] * 24 + [1.1e-9], None),  # corrections run out
    ],
)  # fmt: skip
@pytest.mark.parametrize("size", [1.0, 1024.0])
def test_newton_ends_where_it_has_settled_or_runs_off(steps, taken, size):
    """Against lengths of a kilometre all is a thousand times as large."""
    steps = (size * np.array(steps)).tolist()
    assert_both(steps, None if taken is None else np.cumsum(steps)[-1], size)


def assert_both(steps, end, size=1.0):
    """The n-th correction is the n-th of the steps."""
    left = iter(steps)
    alone = SimpleNamespace(_sizes=np.array([size]), correction=lambda t, q, target: np.array([next(left)]))
    found = Closure.newton(alone, 0.0, np.zeros(1), None)
    assert (found is None) == (end is None)
    if found is not None:
        assert found[0] == end
    assert not [*left]
    again = iter(steps)
    rows = SimpleNamespace(_sizes=np.array([size]), correction=lambda t, q, target: np.full((len(q), 1), next(again)))
    q, closed = Closure.newton_rows(rows, np.zeros(2), np.zeros((2, 1)), np.zeros((2, 0)))
    assert closed.tolist() == [end is not None] * 2
    if end is not None:
        assert q.tolist() == [[end]] * 2


@pytest.mark.parametrize(("units", "size", "sizes"), [("rad m", 0.3, [1, 1]), ("rad m", 1.2, [1, 1.2]), ("m rad", 3e6, [3e6, 1])])
def test_lengths_are_corrected_to_a_share_of_the_largest_beyond_a_metre(units, size, sizes):
    coordinates = [SimpleNamespace(unit=unit) for unit in units.split()]
    closure = SimpleNamespace(scale=size, equations=SimpleNamespace(variant=SimpleNamespace(coordinates=coordinates)))
    assert Closure._sizes.func(closure).tolist() == sizes


@pytest.mark.parametrize(("by", "scale", "moved"), [
    ("w", 600.0, [1.1e-3, False]), ("w", 600.0, [0.9e-3, True]), ("v", 600.0, [0.61, False]), ("v", 600.0, [0.59, True]),
    ("VMx", 600.0, [0.61, False]), ("VMx", 600.0, [0.59, True]), ("w", 1e-6, [1.1e-3, False]), ("w", 1e-6, [0.9e-3, True]),
])  # fmt: skip
def test_a_drive_waits_while_it_turns_by_less_than_a_milliradian_or_moves_by_a_thousandth_of_the_largest_length(by, scale, moved):
    """A crank of 600 m was said to wait for the first 0.6 rad, a tiny one never."""
    far, waits = moved
    variant = SimpleNamespace(
        rates=("w", "v"), coordinates=[SimpleNamespace(unit="rad", rate="w"), SimpleNamespace(unit="m", rate="v")]
    )
    places = [variant.rates.index(by)] if by in variant.rates else []
    kept, known = (np.array([[0.0], [far]])[:, : int(is_there)] for is_there in (not places, bool(places)))
    closure = SimpleNamespace(
        targets=lambda times: (kept, known), drives=() if places else (by,), driven=places, scale=scale,
        equations=SimpleNamespace(variant=variant),
    )  # fmt: skip
    assert Closure._moved(closure, np.array([0.0, 1.0])).tolist() == [False, not waits]
