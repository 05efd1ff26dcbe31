"""The exact motion prolonged: its rows go on up to the time asked for, as long as no determinant turns its sign."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.integration import finer as module
from coursework.motion.integration.finer import prolonged
from tests.grading.marking import students
from tests.solved import solved


def motion_at(time, q, step=1e-5):
    """The same angles by Runge and Kutta's fourth order from the start of variant 31."""
    count = round(time / step)
    q, h = np.array(q), time / count
    for k in range(count):
        t, f = k * h, lambda t, q: students.velocities(t, q)[:3]
        k1 = f(t, q)
        k2 = f(t + h / 2, q + h / 2 * k1)
        k3 = f(t + h / 2, q + h / 2 * k2)
        q = q + h / 6 * (k1 + 2 * k2 + 2 * k3 + f(t + h, q + h * k3))
    return q


@pytest.mark.parametrize(("end", "times"), [(0.55, [0.5, 0.52, 0.54, 0.55]), (0.52, [0.5, 0.52]), (0.49, [0.49])])
def test_rows_go_on_in_the_step_up_to_the_time(end, times):
    scene = solved("31").scene
    longer = prolonged(scene.exact, scene.rates, end)
    assert longer.t == pytest.approx([0.02 * k for k in range(25)] + times)
    last = motion_at(end, students.START, 1e-3)
    assert longer.coordinates[-1] == pytest.approx(last, abs=1e-7)
    assert longer.velocities[-1] == pytest.approx(students.velocities(end, last), abs=1e-5)
    assert longer.coordinates.shape == (25 + len(times), 3) and len(longer.determinants) == len(longer.t)
    assert np.array_equal(longer.coordinates[:25], scene.exact.coordinates)


def test_the_sign_of_a_determinant_in_the_last_row_counts():
    """Behind a passage it is another than in row 1."""
    scene = solved("31").scene
    first, last = (scene.exact.determinants.copy() for _ in range(2))
    first[0] *= -1
    last[-1, 1] *= -1
    assert prolonged(replace(scene.exact, determinants=first), scene.rates, 0.5) is not None
    assert prolonged(replace(scene.exact, determinants=last), scene.rates, 0.5) is None


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "refined"), [(0.98e-5, 0), (-0.98e-5, 0), (1.02e-5, 2), (-1.02e-5, 2)])
def test_an_interval_is_refined_if_its_end_is_off_by_more_than_a_share_of_the_range(size, part, refined, monkeypatch):
    """A coordinate that grows evenly through a range; its row in the middle is off."""
    asked = []
    exact = SimpleNamespace(step=0.1, t=np.arange(3) / 10, coordinates=size * np.array([[0.0], [0.5 + part], [1.0]]))
    rates = SimpleNamespace(slopes_of_rows=lambda _: lambda t, q: np.full(q.shape, 5 * size), equations=None)
    monkeypatch.setattr(module, "resolution", lambda *_: SimpleNamespace(shorter=lambda _: (np.zeros(0), None)))
    monkeypatch.setattr(module, "refine", lambda rates, start, t, most: asked.append(t) or (np.zeros((2, 1)), None, 0))
    module._followed(exact, rates, 2, 2, np.arange(5) / 20)
    assert len(asked) == refined
