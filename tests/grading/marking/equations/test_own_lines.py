"""Which line a table used: an edit explains rows whose residual is within what rounding allows, and a part more of them."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table.causes import own_equations
from coursework.grading.marking.table.causes.own_equations import _used


@pytest.mark.parametrize(("off", "is_used"), [(0.99, True), (1.01, False), (np.nan, False)])
def test_an_edit_explains_a_row_within_what_rounding_allows(monkeypatch, off, is_used):
    """A line that holds in no row of ten, and an edit that leaves `off` of what is allowed in each."""
    allowed = own_equations.HALF * 0.01
    monkeypatch.setattr(own_equations, "names_at", lambda *_: {})
    monkeypatch.setattr(own_equations, "value_of", lambda tree, names: tree)
    monkeypatch.setattr(own_equations, "real", lambda value, count: np.full(count, float(value)))
    monkeypatch.setattr(own_equations, "size_of", lambda tree, names: 0.0)
    monkeypatch.setattr(
        own_equations, "with_spread", lambda residuals, values, units: (residuals(values), np.full((10, 1), 0.01))
    )
    values = SimpleNamespace(after=lambda edit: np.full(10, off * allowed))
    monkeypatch.setattr(own_equations, "Values", lambda tree, names: values)
    monkeypatch.setattr(own_equations, "applied", lambda tree, edit: (tree, edit))
    student = SimpleNamespace(values=np.ones((10, 2)), units=np.ones((10, 2)))
    key = SimpleNamespace(t=np.arange(10.0), velocities=("w",), coordinates=(), m=0)
    line = SimpleNamespace(tree=7.0, edits=("edit",), is_wrong=False, name="1")
    (used,) = _used(SimpleNamespace(key=key, m=1, student=student), [line])
    assert used.tree == ((7.0, "edit") if is_used else 7.0)
