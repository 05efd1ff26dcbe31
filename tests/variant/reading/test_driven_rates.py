"""A constraint that only gives a rate is a drive: the same page as with the line in [drive], whatever way it is written."""

import math
import re

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.variant.record.no_value import known_value

FIVE_BAR = """
format = 1
[given]
a = "80 mm"
b = "250 mm"
c = "220 mm"
d = "60 mm"
L = "300 mm"
n1 = "90 rpm"
T = "1 s"
[coordinates]
alpha = { start = "40 deg", rate = "wa" }
beta = { start = "0.70708915440986 rad", rate = "wb" }
gamma = { start = "118.517504498272 deg", rate = "wg" }
delta = { start = "20 deg", rate = "wd" }
[time]
step = "2 ms"
end = "0.4 s"
[points]
O = "(0, 0)"
A = "a @ alpha"
P = "A + b @ beta"
Q = "(L, 0)"
B = "Q + d @ delta"
[links]
1 = { points = ["O", "A"], rate = "wa" }
2 = { points = ["A", "P"], rate = "wb" }
3 = { points = ["B", "P"], rate = "wg" }
4 = { points = ["Q", "B"], rate = "wd" }
[frame]
hinges = ["O", "Q"]
[masses]
2 = { mass = "1.2 kg", inertia = "rod" }
[forces]
gravity = "9.81 m/s^2"
[ask]
quantities = ["table", "checks", "forces"]
[[constraint]]
closure = "P = B + c @ gamma"
"""
AS_DRIVES = '[drive]\nwa = "n1"\nwd = "-2*n1*(1 + t/T)"\n'
DRIVEN = coursework.parse_variant(FIVE_BAR + AS_DRIVES)
PRECEDING = "n1 = wa", "wa - n1 = 0", "2*n1 - 2*wa = 0", "-wa = -n1", "wa/n1 = 1", "L*wa + d*n1 = L*n1 + d*n1"
MORE = (
    "wa + wa = 2*n1",
    "wa - n1 + 0*wd = 0",
    "0*wd + wa = n1",
    "L*wa - d*wa = (L - d)*n1",
    "3*(wa - n1)/L = 0",
    "2*(wa + n1) = 4*n1",
    "-3*(n1 - 2*wa)/L = 3*n1/L",
)


def written(*equations, text=FIVE_BAR):
    return coursework.parse_variant(text + "".join(f'[[constraint]]\nequation = "{one}"\n' for one in equations))


@pytest.mark.parametrize("equation", ["wa = n1", *PRECEDING, *MORE])
def test_the_law_that_a_constraint_gives_has_the_value_of_the_drive(equation):
    found = written(equation, "0 = wd/2 + n1*(1 + t/T)")
    for time in (0.0, 0.3):
        values = {**found.values, "t": time, "pi": math.pi}
        laws = {law.name: known_value(law.formula, values) for law in found.drive}
        assert laws == {"wa": pytest.approx(3 * math.pi), "wd": pytest.approx(-6 * math.pi * (1 + time))}


@pytest.mark.long
@pytest.mark.parametrize("equation", ["wa = n1", *PRECEDING, *MORE])
def test_a_rate_given_by_a_constraint_is_a_drive(equation):
    run, same = coursework.solve(written(equation, "0 = wd/2 + n1*(1 + t/T)")), coursework.solve(DRIVEN)
    assert run.variant.known_rates == same.variant.known_rates == ("wa", "wd")
    assert run.table.to_numpy() == pytest.approx(same.table.to_numpy(), rel=1e-12, abs=1e-12)
    assert [one.name for one in run.equations] == ["1x", "1y"]
    assert all(one.verdict in {"PASS", "SKIP", "COARSE"} for one in run.checks)
    assert run.scene.closure.complete


def test_the_start_that_closes_keeps_the_cranks():
    text = FIVE_BAR.replace("0.70708915440986 rad", "0.6 rad").replace("118.517504498272 deg", "110 deg")
    with pytest.raises(coursework.InputError, match=re.escape("alpha = 40 deg, beta = 0.707089")) as caught:
        coursework.solve(written("wa = n1", "wd = n1", text=text)).table  # noqa: B018
    assert "delta = 20 deg" in str(caught.value)


@pytest.mark.parametrize(
    "equations",
    [
        ("wa = n1", "wd = 2*wa"),  # gears: one drives the other
        ("wa = n1", "wd = 0"),  # a link that does not turn is held, not driven
        ("wa = n1", "wd + wg = n1"),
        ("wa = n1", "wd*cos(delta) = n1"),
        ("wa = n1", "wd = n1", "wa + wd = 2*n1"),  # nothing would be left for the third to determine
        ("wa = n1", "wd = n1", "wd = 2*n1"),  # two constraints that contradict each other are told as such
    ],
)
def test_what_is_geometry_stays_an_equation(equations):
    assert "wd" not in written(*equations).known_rates
    assert [one.right.op for one in written(*equations).constraints]


def test_lines_and_places_of_the_file_remain():
    broken = written("wa = n1*T/(t - 0.1)", "wd = n1")
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve(broken).table  # noqa: B018
    lines = [*(FIVE_BAR + '[[constraint]]\nequation = "wa').splitlines()]
    assert {fault.line for fault in caught.value.faults} == {len(lines)}


def test_a_wheel_train_of_the_catalogue():
    """The angle of the one wheel is given, that of the other follows from rolling: only the first is a drive."""
    text = coursework.load("cardan").path.read_text(encoding="utf-8")
    moved = text.replace('[drive]                        # the line of centres turns uniformly\nw1 = "w0"', "")
    assert moved != text
    variant = written("w1 = w0", text=moved)
    assert variant.known_rates == ("w1",)
    assert coursework.solve(variant).table.equals(coursework.solve("cardan").table)


def test_a_rate_times_nothing_is_refused_where_it_stands():
    with pytest.raises(coursework.InputError, match=r"V088 .*constraint 3: wd appears only beside 0"):
        written("wa = n1", "wd*0 = n1")


def test_a_rate_given_twice_alike_is_driven_once():
    run = coursework.solve(written("wa = n1", "wd = n1", "wa/2 = n1/2"))
    assert run.variant.known_rates == ("wa", "wd")
    assert run.table.equals(coursework.solve(written("wa = n1", "wd = n1")).table)


@pytest.mark.parametrize("second", ["wa = 2*n1", "2*wa + n1 = 0"])
def test_an_equation_against_a_drive_is_told_with_the_line_of_the_drive(second):
    text = FIVE_BAR.replace("[coordinates]", '[drive]\nwa = "n1"\nwd = "n1"\n[coordinates]')
    line = text.splitlines().index('wa = "n1"') + 1
    with pytest.raises(coursework.InputError, match=rf"V403 .*Equation 2 contradicts the drive wa \(:{line}\)"):
        coursework.solve(written(second, text=text)).table  # noqa: B018


@pytest.mark.parametrize("equation", ["w1 = w0", "0 = 2*w0 - 2*w1"])
def test_the_crank_of_a_chain_may_have_its_rate_in_a_constraint(equation):
    text = coursework.load("example-1").path.read_text(encoding="utf-8").replace('w1 = "w0"\n', "")
    assert coursework.solve(written(equation, text=text)).table.equals(coursework.solve("example-1").table)


@pytest.mark.parametrize(("datum", "unit"), [("400 N", "N"), ("2 kg", "kg"), ("3 Nm", "Nm")])
def test_a_unit_of_forces_is_told_where_it_is_read(datum, unit):
    text = coursework.load("31").path.read_text(encoding="utf-8").replace("[drive]", f'F = "{datum}"\n[drive]', 1)
    with pytest.raises(coursework.InputError, match=rf"V109 .*{unit} is read where the file has \[masses\]"):
        coursework.parse_variant(text)


def test_a_law_that_only_helps_is_no_drive(tmp_path):
    text = FIVE_BAR.replace("[coordinates]", '[drive]\nhelp = "n1*(1 + 0.1*sin(n1*t))"\n[coordinates]')
    (tmp_path / "own.toml").write_text(text + '[[constraint]]\nequation = "wa = help"\n[[constraint]]\nequation = "wd = n1"\n')
    assert "drives: 2\n" in CliRunner().invoke(main, ["check", str(tmp_path / "own.toml")]).stdout
