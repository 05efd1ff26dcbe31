"""What makes a set sure to move: its determinants look by look, the distance they keep, and the error of the way followed."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.equations.reduction.symbolic import TIME, symbol
from coursework.scene.model import watch
from coursework.scene.model.watch import Watch, fewest_steps, frequencies, sure_to_move


def test_what_is_known_of_a_determinant_after_four_looks():
    """Two sets: 4, 1, 2, 5 and -1, -2, 1, -4, which changes its sign."""
    seen = Watch.at(np.array([[4.0, -1.0]]))
    for looked in ([1.0, -2.0], [2.0, 1.0], [5.0, -4.0]):
        seen.look(np.array([looked]))
    assert seen.least.tolist() == [[1.0, 1.0]]
    assert seen.most.tolist() == [[5.0, 4.0]]
    assert seen.fastest.tolist() == [[3.0, 5.0]]
    assert seen.dip.tolist() == [[4.0, 8.0]]  # second differences: 4, 2 and 4, -8
    assert seen.changed.tolist() == [False, True]


def judged(error=0.0, moved=1.0, largest=1.0, **changes):
    """Return whether a set is sure whose determinant is 1 throughout, with some of what was seen changed."""
    seen = Watch.at(np.array([[1.0]]))
    for name, value in changes.items():
        setattr(seen, name, np.array([[value]]) if name != "changed" else np.array([value]))
    model = SimpleNamespace(blocks=[SimpleNamespace(largest=largest)])
    return bool(watch._judged(model, seen, np.array([error]), np.array([moved]))[0])


@pytest.mark.parametrize(("changes", "is_sure"), [
    ({"least": 0.021}, True), ({"least": 0.019}, False),
    ({"least": 0.042, "most": 2.0}, True), ({"least": 0.038, "most": 2.0}, False),
    ({"dip": 0.979}, True), ({"dip": 0.981}, False), ({"least": 0.5, "dip": 0.479}, True), ({"least": 0.5, "dip": 0.481}, False),
    # An error of the position counts thirty times, with the slope of the determinant, 4 of its size at least.
    ({"error": 0.97 / 120}, True), ({"error": 0.99 / 120}, False),
    ({"error": 0.97 / 240, "fastest": 1.0, "moved": 0.5}, True), ({"error": 0.99 / 240, "fastest": 1.0, "moved": 0.5}, False),
    ({"largest": 0.99e6}, True), ({"largest": 1.01e6}, False),
    ({"changed": True}, False), ({"error": float("nan")}, False), ({"error": float("inf")}, False),
    ({"least": float("nan")}, False),
])  # fmt: skip
def test_which_set_is_sure(changes, is_sure):
    assert judged(**changes) is is_sure


def test_a_way_that_is_a_cubic_has_no_error(monkeypatch):
    """q' = 3 t^2 + 5 (q - t^3) begins at 0 and stays t^3, which the cubic through both ends of a step is too."""
    told = {}
    monkeypatch.setattr(watch, "_judged", lambda model, seen, error, moved: told.update(error=error, moved=moved))
    model = SimpleNamespace(
        blocks=[None], breaks=(), coordinates=("q",), program=lambda t, q: [3 * t**2 + 5 * (q - t**3), 1.0 + 0 * q]
    )
    sure_to_move(model, (), np.zeros((1, 1)), 1.0, 100)
    assert told["moved"] == pytest.approx([1 - 0.99**3], rel=1e-5)
    assert told["error"] == pytest.approx([0.0], abs=1e-6)


def test_the_fastest_change_in_a_drive_is_that_of_each_set_at_any_time():
    """The arguments p t, of which the slope is p, and a t² - 8 t, whose slope 2 a t - 8 is fastest at one end or the other."""
    a, p = np.array([1.0, 3.0, 0.5]), np.array([2.0, -9.0, 1.0])
    of_time, constant = SimpleNamespace(free_symbols={TIME}), SimpleNamespace(free_symbols=set())
    model = SimpleNamespace(
        coordinates=("q",),
        compiled=lambda slopes: lambda t, q, a, p: [2 * a * t - 8 if TIME in one.free_symbols else p for one in slopes],
    )
    for slopes, fastest in (
        ((), [0, 0, 0]), ((constant,), [2, 9, 1]), ((of_time,), [8, 22, 8]), ((of_time, constant), [8, 22, 8]),
        ((constant, of_time), [8, 22, 8]),
    ):  # fmt: skip
        assert frequencies(model, slopes, (a, p), 3, 5.0).tolist() == fastest


@pytest.mark.parametrize(("waves", "driven", "end", "steps"), [
    ([0.0], ("w",), 10.0, 120), ([7.0, 1.0], ("w",), 10.0, 140), ([7.0, 1.0], (), 10.0, 140), ([0.0], ("u",), 10.0, 12),
    ([0.0], ("w",), 1.05, 13), ([0.0], ("w",), 0.95, 12), ([0.0], ("w", "v"), 1.0, 18), ([0.0], ("w",), 1000.0, 4000),
    ([np.inf], ("w",), 1000.0, 12), ([np.inf], (), 1000.0, 12), ([], (), 10.0, 12),
])  # fmt: skip
def test_in_a_step_no_drive_turns_by_more_than_half_a_radian(waves, driven, end, steps):
    """Of all sets w reaches -6 rad/s at the start, v 9 rad/s; u is a speed in m/s, and what nothing drives is not looked at."""
    values = {"w": np.array([2.0, -6.0]), "u": np.array([1000.0, 0.0]), "v": 9.0}
    by_symbol = {symbol(name): value for name, value in values.items()}
    variant = SimpleNamespace(coordinates=[SimpleNamespace(unit=unit) for unit in ("rad", "m", "rad")], rates=(*values,))
    variant.known_rates = driven
    model = SimpleNamespace(variant=variant, compiled=lambda drives: lambda t, *_: [by_symbol[one] for one in drives])
    assert fewest_steps(model, (), np.array(waves), np.zeros(3), end) == steps
