"""What `coursework check` says of equations."""

from pathlib import Path

import pytest

from tests.command import call
from tests.mechanisms.library import mechanism

pytestmark = pytest.mark.usefixtures("folder")


def test_an_angle_of_the_file_in_degrees_is_read_in_degrees():
    """In the velocities, the determinant, and where it is zero: the guides are parallel at psi = 90.75°."""
    text = mechanism("pin-between-guides", ('angle = "90 deg"', 'angle = "-89.25 deg"'), end="2 s")
    Path("own.toml").write_text(text, encoding="utf-8")
    told = call("check", "own.toml").stdout
    assert "uj = " in told and "1.557" not in told
    assert "sin(89.25° + psi): zero when the two guides are parallel" in told
    assert "become singular: sin(89.25° + psi) = 0, with psi = 1.58389 rad = 90.75°" in told


@pytest.mark.parametrize(("name", "determinant"), [("31", "r2*r1*sin(phi1 - phi2)"), ("example-4", "s2")])
def test_the_determinant_of_two_velocities_has_the_sign_of_the_page(name, determinant):
    told = call("check", name).stdout
    assert f"determinant {determinant}: zero" in told and f"determinant -{determinant}:" not in told
