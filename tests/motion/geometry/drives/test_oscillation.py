"""How fast a drive oscillates: its highest harmonic of more than 5 % of the power of the strongest."""

import math

import numpy as np
import pytest

import coursework
from coursework.equations.reduction.symbolic import symbol
from coursework.motion.geometry.drives.drive import argument_slopes
from coursework.motion.geometry.drives.oscillation import _common, fastest
from coursework.words.data_folders import folder

BASE = (folder("variants") / "31.toml").read_text(encoding="utf-8")
P = 13.08


def frequency(tmp_path, law, more=""):
    text = BASE.replace('"V1*sin(p*t + alpha)"', f'"{law}"').replace("VMx = ", f"{more}VMx = ")
    (tmp_path / "v.toml").write_text(text, encoding="utf-8")
    return fastest(coursework.solve(tmp_path / "v.toml").scene.equations)


@pytest.mark.parametrize(
    ("law", "wanted"),
    [
        ("V1*sin(p*t + alpha)", P),
        ("V1*sin(2*pi*t)^3", 6 * math.pi),  # 3 sin x - sin 3x: a ninth of the power
        ("V1*abs(sin(pi*t))", 2 * math.pi),  # 1/3, 1/15 …: the second harmonic has a 25th of the power
        ("V1*sin(p*t)^2", 2 * P),
        ("V1*sin(p*t)*cos(3*p*t)", 4 * P),
        ("V1*(sin(p*t) + 0.22*sin(5*p*t))", P),  # 4.8 % of the power
        ("V1*(sin(p*t) + 0.23*sin(5*p*t))", 5 * P),  # 5.3 %
        ("V1*(sin(p*t) + sin(1.25*p*t))", 1.25 * P),
        ("V1*sin(p*t)*sin(1.4142135623730951*p*t)", (1 + math.sqrt(2)) * P),
        ("V1*(sin(p*t) + sin(1.4142135623730951*p*t)^2)", 2 * math.sqrt(2) * P),
        ("V1*exp(-t*2*p)*sin(p*t)", P),
        ("V1*sin(p*t + 0.3*sin(10*p*t))", 10 * P),  # arguments that do not grow evenly: the steepest slope of all
        ("V1*1.0e-12*sin(p*t)^2", 2 * P),  # V1 = 4.5 m/s: a wave of a quarter of this counts from 1e-12 m/s on
        ("V1*0.8e-12*sin(p*t)^2", P),
        ("V1*p*t", 0.0),
        ("V1", 0.0),
    ],
)
def test_highest_harmonic(law, wanted, tmp_path):
    assert frequency(tmp_path, law) == pytest.approx(wanted, rel=1e-6)


def test_an_argument_written_by_another_drive(tmp_path):
    """sin(f) with f = p t + … elsewhere oscillates as sin of what f stands for."""
    assert frequency(tmp_path, "V1*sin(f)", 'f = "3*p*t + alpha"\n') == pytest.approx(3 * P, rel=1e-9)


def test_pieces_each_for_itself(tmp_path):
    text = BASE.replace('"V1*sin(p*t + alpha)"', '{ pieces = [["0 s", "V1*sin(p*t)"], ["0.1 s", "V1*sin(2*p*t)^2"]] }')
    (tmp_path / "v.toml").write_text(text, encoding="utf-8")
    assert fastest(coursework.solve(tmp_path / "v.toml").scene.equations) == pytest.approx(4 * P, rel=1e-9)


def test_the_check_and_the_refusal_use_it(tmp_path):
    """Of sin cubed with 50 rows a period the third harmonic has 17: fewer than twenty."""
    text = BASE.replace("V1*sin(p*t + alpha)", "0.1*V1*sin(p*t + alpha)^3").replace('step      = "0.02 s"', 'step = "2*pi/p/50"')
    (tmp_path / "v.toml").write_text(text, encoding="utf-8")
    step = next(check for check in coursework.solve(tmp_path / "v.toml").checks if check.code == "STEP")
    assert step.value == pytest.approx(50 / 3, rel=1e-9)
    assert step.verdict == "COARSE"


def test_only_arguments_that_move_oscillate():
    """sin(p t + alpha) turns by p; a sine of the phase alone does not turn."""
    text = coursework.load("31").path.read_text(encoding="utf-8").replace('VMx = "0"', 'VMx = "V1*cos(alpha)"')
    assert "V1*cos(alpha)" in text
    assert argument_slopes(coursework.solve(coursework.parse_variant(text)).scene.equations) == [symbol("p")]


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "is_known"), [(0.98e-9, True), (-0.98e-9, True), (1.02e-9, False), (-1.02e-9, False)])
def test_frequencies_are_multiples_of_one_but_for_a_share_of_each(size, part, is_known):
    """Of 2 and 3, which are multiples of 1."""
    assert _common(size * np.array([2.0, 3.0 * (1 + part)])) == (pytest.approx(size) if is_known else 0.0)
