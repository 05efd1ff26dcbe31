"""Whether the exact motion opens an equation by itself or jumps out of it, of a coordinate that a drive places at q = t."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.close_to_motion import drift


@pytest.mark.parametrize(("rate", "after", "found"), [
    (1.0, 2.2, (2, 0, "jump")), (1.00009, 2.2, (2, 0, "jump")), (1.00021, 2.2, (1, 0, "opened")),
    (0.99979, 2.2, (1, 0, "opened")),
    (0.0, 2.2, (1, 0, "opened")), (1.0, 2.09, None), (1.0, 2.11, (2, 0, "jump")), (1.0, 1.89, (2, 0, "jump")),
])  # fmt: skip
def test_an_equation_is_opened_by_velocities_that_do_not_keep_it(rate, after, found, monkeypatch):
    """Of a length of 2 m a twentieth is a gap; a rate off by a ten-thousandth of it a second does not keep the equation."""
    monkeypatch.setattr(drift, "gaps", lambda closure, times, at, targets: at - targets)
    exact = SimpleNamespace(
        t=np.array([0.0, 1.0, 2.0]), coordinates=np.array([[0.0], [1.0], [after]]), velocities=np.full((3, 1), rate), step=1.0
    )
    closure = SimpleNamespace(targets=lambda times: (np.asarray(times)[:, None], None))
    assert drift._jump(SimpleNamespace(exact=exact), closure, np.array([2.0])) == found


def test_what_is_open_from_the_start_or_has_no_exact_motion_is_not_asked(monkeypatch):
    monkeypatch.setattr(drift, "gaps", lambda closure, times, at, targets: at - targets)
    exact = SimpleNamespace(t=np.arange(2.0), coordinates=np.array([[0.2], [1.3]]), velocities=np.ones((2, 1)), step=1.0)
    closure = SimpleNamespace(targets=lambda times: (np.asarray(times)[:, None], None))
    assert drift._jump(SimpleNamespace(exact=exact), closure, np.array([2.0])) is None
    assert drift._jump(SimpleNamespace(exact=SimpleNamespace(t=())), closure, np.array([2.0])) is None
