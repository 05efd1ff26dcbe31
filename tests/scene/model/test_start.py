"""Where a four-bar without a written mode begins with other data: in the branch of its file's start, in the same turn."""

import math

import numpy as np
import pytest

import coursework
from coursework.scene.model.start import _least, start_of
from tests.mechanisms.library import mechanism

CRANKS = np.array([0.1, 0.12, 0.9, 0.2])


def angles(a, side):
    """Return phi2 and phi3 of the coupler and the rocker of a crank (m) at 40 degrees, C on one side of the line from B to D."""
    crank = a * np.exp(1j * math.radians(40))
    base = 0.4 - crank
    at_a = math.acos((0.35**2 + abs(base) ** 2 - 0.25**2) / (2 * 0.35 * abs(base)))
    point = crank + 0.35 * np.exp(1j * (np.angle(base) + side * at_a))
    return float(np.angle(point - crank)), float(np.angle(point - 0.4))


def four_bar(coupler, rocker, mode):
    """Return that four-bar with the angles at which its coupler and its rocker begin."""
    return mechanism(
        "four-bar", ('"0 deg"', '"40 deg"'), ("phi2 = {", f'phi2 = {{ start = "{coupler}",'),
        ("phi3 = {", f'phi3 = {{ start = "{rocker}",'), mode=mode,
    )  # fmt: skip


@pytest.mark.parametrize("is_written", [True, False])
@pytest.mark.parametrize(("side", "turns"), [(1, 0), (-1, 0), (1, 1), (-1, -2)])
def test_a_group_is_put_together_in_the_branch_and_the_turn_of_the_file(side, turns, is_written):
    begin = np.array(angles(0.1, side)) + 2 * math.pi * turns
    text = four_bar(*(f"{float(angle)!r} rad" for angle in begin), mode=f"{side:+d}" if is_written else None)
    model = coursework.compile_model(coursework.parse_variant(text, "own.toml"))
    data = model.data({"r1": CRANKS})
    with np.errstate(all="ignore"):
        found = start_of(model, data, model.numbers(data))
    assert found.doubtful.tolist() == [False, False, True, False]  # a crank of 0.9 m leaves no triangle
    for index in np.flatnonzero(~found.doubtful):
        wanted = np.array(angles(CRANKS[index], side))
        assert found.begin[0, index] == pytest.approx(math.radians(40))
        assert found.begin[1:, index] == pytest.approx(
            wanted + 2 * math.pi * np.round((begin - wanted) / (2 * math.pi)), abs=1e-12
        )
    assert found.closed is found.begin


@pytest.mark.parametrize(("matrix", "right", "found"), [
    ([[2.0, 0.0], [0.0, 4.0]], [2.0, 2.0], [1.0, 0.5]), ([[1.0, 2.0]], [5.0], [1.0, 2.0]),  # the smallest of all that fit
    ([[1.0], [1.0], [1.0]], [1.0, 2.0, 6.0], [3.0]),  # the mean is nearest
    ([[1.0, 1.0], [1.0, 1.0]], [1.0, 1.0], None), ([[1.0, math.inf]], [1.0], None),
    ([[1.0, 0.0], [0.0, 1.0]], [math.nan, 1.0], None),
])  # fmt: skip
def test_the_smallest_correction_that_comes_nearest(matrix, right, found):
    """Beside a set that has one, a set without leaves it alone."""
    good = np.eye(len(matrix), len(matrix[0]))
    both = _least(np.array([matrix, good]), np.array([right, np.ones(len(right))]))
    assert both[0] == pytest.approx([math.nan] * len(matrix[0]) if found is None else found, nan_ok=True)
    assert both[1] == pytest.approx(np.linalg.pinv(good) @ np.ones(len(right)))
