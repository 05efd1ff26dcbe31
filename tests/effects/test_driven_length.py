"""A length that a drive changes: the force along it, beside the couple of the crank, by two programs."""

import numpy as np
import pytest

from tests.effects.massed import of_text

# A slider-crank whose crank turns clockwise and has a driven length.
REACHING = """\
[given]
l = "50 cm"
e = "2 cm"
n = "-90 rpm"
v = "100 mm/s"
p = "2 1/s"
[drive]
w1 = "n"
vr = "v*cos(p*t)"
[coordinates]
phi1 = { start = "75 deg", rate = "w1" }
r = { start = "100 mm", rate = "vr" }
phi2 = { rate = "w2", unit = "rad" }
s = { rate = "u", unit = "m" }
[time]
step = "0.5 s"
end = "2 s"
[points]
A = "(0, 0)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r"]
coordinates = ["phi1"]
[[group]]
kind = "RRP"
from = ["B"]
guide = { through = "A", angle = "0", offset = "e" }
meets = "C"
lengths = ["l"]
coordinates = ["phi2", "s"]
mode = "+1"
[frame]
hinges = ["A"]
rails = [{ through = "C", angle = "0" }]
[masses]
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
    found = of_text(REACHING)
    assert found.drive_names == ("M1", "F3")
    drives = np.stack([found.column(name) for name in found.drive_names], axis=1)[[0, 1, 4]]
    assert drives == pytest.approx(
        np.array([[-10.05547, 13.43637], [-5.95087, -126.29129], [-5.55876, 24.44725]]), abs=2e-5, rel=1e-5
    )
