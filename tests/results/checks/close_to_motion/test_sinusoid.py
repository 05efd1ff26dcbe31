"""What counts as an oscillation, and where none is judged."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.close_to_motion import sinusoid
from tests.results.checks.scenes import evidence_of, finding, solve


def test_where_the_exact_motion_is_not_known_between_rows_no_oscillation_is_judged(monkeypatch):
    monkeypatch.setattr(sinusoid, "_dense", lambda *_: None)
    judged = finding("SINUSOID", evidence_of(solve("31")))
    assert (judged.verdict, judged.sentence.key) == ("SKIP", "check.unknown")


@pytest.mark.parametrize("size", [1e-3, 1.0, -1e3])
@pytest.mark.parametrize(("off", "quiet"), [(0.9e-12, True), (1.2e-12, False)])
def test_an_oscillation_of_a_trillionth_of_a_column_is_round_off(size, off, quiet):
    """Of 1 + off (-1)^n no harmonic carries anything, of 1 + off cos(2t) the second all."""
    t = np.linspace(0.0, 2 * math.pi, 65)
    columns = {"a": size * (1 + off * (-1.0) ** np.arange(65)), "b": size * (1 + off * np.cos(2 * t))}
    motion = SimpleNamespace(t=t, step=t[1], column=columns.__getitem__)
    assert sinusoid.shares(motion, ("a",), (1.0,), 7.0)["a"] == pytest.approx(1.0 if quiet else 0.0, abs=0.1)
    assert sinusoid.harmonics(motion, ("b",), (1.0,), 7.0)["b"] == pytest.approx((1, 0, 0) if quiet else (0, 1, 0), abs=1e-3)
