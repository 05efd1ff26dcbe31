"""What `coursework check` says of equations."""

from pathlib import Path

import pytest

from coursework.words.data_folders import folder
from tests.command import call
from tests.mechanisms.library import mechanism
from tests.variant.judging.test_advice_followed import FORCES, SAW

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


def test_the_term_of_an_equation_that_contradicts_is_named_and_others_are_not(tmp_path, monkeypatch):
    """`run` and `check` name what differs, in two equations at once; what no slip explains is to be derived anew."""
    monkeypatch.chdir(tmp_path)
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8")
    slips = text.replace("cos(phi3) - r3", "cos(phi3) + r3").replace("r2*w2*sin(phi2)", "r2*w2*cos(phi2)")
    (tmp_path / "slips.toml").write_text(slips, encoding="utf-8")
    (tmp_path / "wild.toml").write_text(text.replace("cos(phi3) - r3", "sin(phi2)/3 + r1"), encoding="utf-8")
    for command in ("run", "check"):
        told = call(command, "slips")
        assert told.exit_code == 2
        assert (
            "equation 11 contradicts" in told.stderr and "One slip would explain it: the sign of r3*w3*sin(phi3)" in told.stderr
        )
        assert "One slip would explain it: sine and cosine are exchanged in cos(phi2)" in told.stderr
        assert "no single slip that would explain it was found" in call(command, "wild").stderr


@pytest.mark.parametrize(
    ("name", "told"),
    [
        (
            "gears-and-crank",
            "= 2, but 1 freedom is driven. The equations determine every velocity, so [links] and [frame] leave out",
        ),
        (
            "parallel-cranks",
            "= 0, but 1 freedom is driven. The equations determine every velocity: the mechanism moves thanks to its",
        ),
    ],
)
def test_freedoms_that_do_not_agree_are_told_with_what_to_do(name, told):
    Path("own.toml").write_text(mechanism(name), encoding="utf-8")
    assert told in call("check", "own.toml").stdout


@pytest.mark.parametrize(
    ("right", "wrong", "code"),
    [('inertia = "rod"', 'inertia = "disc"', "V726"), ('rails = [ { through = "B", angle = "0" } ]', "", "V722"), ("", "", "")],
)
def test_what_a_run_would_find_wrong_with_forces_is_told_before_it(right, wrong, code):
    asked = '[ask]\nquantities = ["table", "forces"]\n'
    Path("own.toml").write_text((SAW + FORCES + asked).replace(right, wrong, 1), encoding="utf-8")
    told, ran = call("check", "own"), call("run", "own", "--format", "csv")
    assert told.exit_code == ran.exit_code == (2 if code else 0), told.output
    assert code in told.stderr and code in ran.stderr
