"""Of several blocks, a gear on a pivot drives the one on whose line its contact lies; the force is in that mesh."""

import numpy as np
import pytest

import coursework
from tests.mechanisms.library import mechanism

TEXT = mechanism("slider-and-rack")


def test_the_gear_drives_its_rack_and_not_the_slider_beside_it() -> None:
    """Only crank and gear take in power: M w1 + 2 N m w6 = 0; the teeth, 50 mm from the axis, carry 2 N m / 50 mm."""
    run = coursework.solve(coursework.parse_variant(TEXT))
    found = run.results.forces
    assert np.allclose(found.column("M") * run.table["w1"], -2 * run.table["w6"], rtol=0, atol=1e-9)
    assert [name for name in found.reactions.names if name.startswith("T")] == ["T56"]
    assert np.allclose(np.abs(found.column("T56")), 2 / 0.05)


def test_its_sense_is_judged() -> None:
    """The rack stands to the left of the axis: it goes down as the gear turns counter-clockwise."""
    wrong = mechanism("slider-and-rack", ("R*w6 = -v", "R*w6 = v"), ("y + R*psi", "y - R*psi"))
    with pytest.raises(coursework.InputError, match=r"V309 .*link 6 turns at .*It turns just the other way round"):
        assert coursework.solve(coursework.parse_variant(wrong)).scene.closure
