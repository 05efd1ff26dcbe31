"""A length that a drive changes: the force along it, beside the couple of the crank, by two programs."""

import numpy as np
import pytest

from tests.effects.massed import of_text
from tests.mechanisms.library import mechanism

# A slider-crank whose crank turns clockwise and has a driven length.
REACHING = mechanism(
    "slider-crank", ("[time]", 'r = { start = "100 mm", rate = "vr" }\n[time]'), ('"0 deg"', '"75 deg"'),
    ("[drive]", 'v = "100 mm/s"\np = "2 1/s"\n[drive]\nvr = "v*cos(p*t)"'), r=None, l="50 cm", e="2 cm", n="-90 rpm",
    step="0.5 s", end="2 s", period=None,
)  # fmt: skip
HEAVY = """[masses]
1 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
2 = { mass = "1 kg", inertia = "rod" }
3 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
4 = { mass = "1 kg" }
[forces]
gravity = "9.81 m/s^2"
F1 = { on = "4", at = "C", force = "(-100, 0)" }
"""


def test_both_drives_of_a_crank_of_driven_length_are_those_of_lagrange():
    """Couple and force along the crank at 0, 0.5 and 2 s: Lagrange's equations of (phi1, r) by differences, another program."""
    found = of_text(REACHING + HEAVY)
    assert found.drive_names == ("M1", "F3")
    drives = np.stack([found.column(name) for name in found.drive_names], axis=1)[[0, 1, 4]]
    assert drives == pytest.approx(
        np.array([[-10.05547, 13.43637], [-5.95087, -126.29129], [-5.55876, 24.44725]]), abs=2e-5, rel=1e-5
    )
