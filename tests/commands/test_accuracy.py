"""`coursework accuracy`: what it measures errors against."""

from types import SimpleNamespace

import pytest

import coursework
from coursework.commands import accuracy
from coursework.variant.reading.reader import parse_variant
from tests.hard.scenes import scene

CRANK = scene(
    'theta = { start = "0 rad", rate = "w" }', given='r = "0.1 m"', drive='w = "2 + t"', step=0.1,
    more='[[group]]\nkind = "crank"\nfrom = ["(0, 0)"]\nmeets = "A"\nlengths = ["r"]\ncoordinates = ["theta"]',
)  # fmt: skip


def test_a_crank_alone_is_measured_against_the_closed_form_of_its_group(monkeypatch):
    monkeypatch.setattr(accuracy, "timed_once", lambda what: (None, 0.0))
    monkeypatch.setattr(accuracy, "make_study", lambda problem, exact, *_, **__: (problem.closure, exact.evaluations))
    run = coursework.solve(parse_variant(CRANK), quantities=["table"])
    assert accuracy.timed_study(run) == (None, 0)


def test_without_an_exact_row_there_is_no_reference():
    run = SimpleNamespace(scene=SimpleNamespace(follows_laws=True), exact=SimpleNamespace(t=[]))
    with pytest.raises(coursework.InputError, match="C022"):
        accuracy.timed_study(run)
