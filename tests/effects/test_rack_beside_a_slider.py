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


@pytest.mark.parametrize(("rails", "guide"), [("", "K05"), (', { through = "S2", angle = "90 deg" }', "N05_2")])
def test_a_rack_given_by_two_points_turns_no_more_than_one_given_by_one(rails: str, guide: str) -> None:
    """A second point straight above the first, on no rail or on one of its own: the teeth had no force, the drive another one."""
    text = mechanism(
        "slider-and-rack", ("S = ", 'S2 = "T + (0, l2)"\nS = '), ('points = ["T"] }', 'points = ["T", "S2"] }'),
        ('angle = "90 deg" } ]', f'angle = "90 deg" }}{rails} ]'), ("[forces]", '5 = { mass = "1 kg" }\n[forces]'),
    )  # fmt: skip
    found = coursework.solve(coursework.parse_variant(text)).results.forces
    assert [name for name in found.reactions.names if name[1:].startswith(("05", "56"))] == ["N05", guide, "T56"]
    assert np.allclose(np.abs(found.column("T56")), 2 / 0.05)
