"""A point that [drive] moves along one axis only, two such points, and a drive beside a rail: judged, and with forces."""

import numpy as np
import pytest

import coursework
from tests.effects.massed import of_text
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, page_of
from tests.report.reading import html_text

R, L, V, P = 0.1, 0.3, 0.2, 5.0
CRANK = mechanism("crank-driven-along-one-axis")
WRONG = CRANK.replace("+ r*w1*sin", "- r*w1*sin")


def closed(t):
    """Angles of crank and rod by the law of cosines, with M displaced by V sin(pt)/p along its line."""
    start = R * np.exp(1.2j) + L * np.exp(-0.316j)
    to_m = start + V / P * np.sin(P * t)
    angle = np.arccos((R**2 + abs(to_m) ** 2 - L**2) / (2 * R * abs(to_m)))
    phi1 = np.angle(to_m) + angle
    return phi1, np.angle(to_m - R * np.exp(1j * phi1)), to_m


def energy(t, h=1e-5):
    """Kinetic energy and height times weight, velocities by central differences of the closed positions."""
    states = [closed(t + way) for way in (-h, 0.0, h)]
    turned = [(after - before) / (2 * h) for before, after in zip(states[0], states[2], strict=True)]
    tips = [(R * np.exp(1j * phi1), to_m) for phi1, _, to_m in states]
    centres = [(tip / 2, (tip + to_m) / 2, to_m) for tip, to_m in tips]
    speeds = [abs(after - before) / (2 * h) for before, after in zip(centres[0], centres[2], strict=True)]
    kinetic = sum(m * speed**2 / 2 for m, speed in zip((1, 2, 3), speeds, strict=True))
    kinetic = kinetic + 0.001 * turned[0] ** 2 / 2 + 0.015 * turned[1] ** 2 / 2
    return kinetic + 9.81 * sum(m * at.imag for m, at in zip((1, 2, 3), centres[1], strict=True))


def test_one_driven_component_gives_rates_and_its_force():
    run = coursework.solve(coursework.parse_variant(CRANK))
    table, t, h = run.table, run.table.index.to_numpy(), 1e-6
    for name, before, after in zip(("w1", "w2"), closed(t - h)[:2], closed(t + h)[:2], strict=True):
        np.testing.assert_allclose(table[name], (after - before) / (2 * h), atol=1e-7)
    power = (energy(t + 1e-4) - energy(t - 1e-4)) / 2e-4
    force = of_text(CRANK).column("FMx")
    np.testing.assert_allclose(force * V * np.cos(P * t), power, atol=2e-4)
    assert {one.code: one.verdict for one in run.checks}["REACTIONS-SUM"] == "PASS"


@pytest.mark.parametrize("closure", ["", '[closure]\nholds = ["M.y"]\n'])
def test_a_wrong_sign_beside_one_driven_component_is_refused(closure):
    with pytest.raises(coursework.InputError, match=r"V302 .*equation 1 contradicts"):
        coursework.solve(coursework.parse_variant(WRONG + closure)).compute()


def test_a_drive_across_a_rail_leaves_forces_without_a_value_and_the_first_line_says_so():
    """The rail and the drive VMy = 0 both hold M."""
    run = coursework.solve(coursework.parse_variant(CRANK.replace("[coordinates]", 'VMy = "0"\n[coordinates]')))
    assert "some forces are not unique: 3 of 10 stay empty" in run.summary
    (total,) = [one for one in run.checks if one.code == "REACTIONS-SUM"]
    assert (total.verdict, total.sentence) == ("SKIP", "Some reactions have no value, so their sum is not known.")


FIVE_BAR = """
format = 1
[given]
a = "200 mm"
b = "35 cm"
c = "0.3 m"
d = "0.22 m"
V = "0.1 m/s"
p = "4 1/s"
[drive]
VAx = "-V*cos(p*t)"
VBy = "V*sin(p*t)"
[coordinates]
f1 = { start = "1.9 rad", rate = "w1" }
f2 = { start = "0.62 rad", rate = "w2" }
f3 = { start = "-0.9 rad", rate = "w3" }
f4 = { start = "0.4 rad", rate = "w4" }
[time]
step = "0.01 s"
end = "0.6 s"
scheme = "exact"
[[constraint]]
name = "A"
equation = "VAx = -a*w1*sin(f1)"
[[constraint]]
name = "B"
equation = "VBy = d*w4*cos(f4)"
[[constraint]]
name = "x"
equation = "a*w1*sin(f1) + b*w2*sin(f2) + c*w3*sin(f3) = d*w4*sin(f4)"
[[constraint]]
name = "y"
equation = "a*w1*cos(f1) + b*w2*cos(f2) + c*w3*cos(f3) = d*w4*cos(f4)"
[points]
O = "(0, 0)"
A = "a @ f1"
C = "A + b @ f2"
B = "C + c @ f3"
D = "B - d @ f4"
[links]
1 = { points = ["O", "A"], rate = "w1" }
2 = { points = ["A", "C"], rate = "w2" }
3 = { points = ["C", "B"], rate = "w3" }
4 = { points = ["B", "D"], rate = "w4" }
[frame]
hinges = ["O", "D"]
[masses]
1 = { mass = "1 kg", inertia = "rod" }
2 = { mass = "2 kg", inertia = "rod" }
3 = { mass = "2 kg", inertia = "rod" }
4 = { mass = "1 kg", inertia = "rod" }
[ask]
quantities = ["table", "checks", "forces"]
"""


def test_two_driven_points_each_along_one_axis():
    """A and B from their driven coordinates, C where two circles meet."""
    run = coursework.solve(coursework.parse_variant(FIVE_BAR))
    base = 0.2 * np.exp(1.9j) + 0.35 * np.exp(0.62j) + 0.3 * np.exp(-0.9j)
    foot = base - 0.22 * np.exp(0.4j)

    def angles(t):
        x = 0.2 * np.cos(1.9) - 0.1 / 4 * np.sin(4 * t)
        at_a = x + 1j * np.sqrt(0.04 - x**2)
        y = 0.22 * np.sin(0.4) + 0.1 / 4 * (1 - np.cos(4 * t))
        at_b = foot + np.sqrt(0.22**2 - y**2) + 1j * y
        apart = abs(at_b - at_a)
        along = (0.35**2 - 0.3**2 + apart**2) / (2 * apart)
        at_c = at_a + (at_b - at_a) / apart * (along + 1j * np.sqrt(0.35**2 - along**2))
        return np.angle([at_a, at_c - at_a, at_b - at_c, at_b - foot])

    t, h = run.table.index.to_numpy(), 1e-6
    for name, rate in zip(("w1", "w2", "w3", "w4"), (angles(t + h) - angles(t - h)) / (2 * h), strict=True):
        np.testing.assert_allclose(run.table[name], rate, atol=1e-6)
    verdicts = {one.code: one.verdict for one in run.checks}
    assert {verdicts[code] for code in ("AGREEMENT", "REACTIONS-SUM", "VIRTUAL-POWER", "POWER")} == {"PASS"}
    told = html_text(page_of(model_of(run)))
    assert "Point A is driven" in told and "Point B is driven" in told


@pytest.mark.parametrize(
    ("name", "right", "wrong"),
    [("A", "= -a*w1*sin(f1)", "= a*w1*sin(f1)"), ("B", "= d*w4*cos(f4)", "= d*w4*sin(f4)"), ("y", "c*w3*cos", "c*w3*sin")],
)
def test_a_slip_beside_two_driven_points_is_refused(name, right, wrong):
    with pytest.raises(coursework.InputError, match=rf"V302 .*equation {name} contradicts"):
        coursework.solve(coursework.parse_variant(FIVE_BAR.replace(right, wrong, 1))).compute()


@pytest.mark.parametrize(("right", "wrong"), [("", ""), ("= -a*w1*sin(f1)", "= -a*w1*cos(f1)"), ("= d*w4*cos", "= -d*w4*cos")])
def test_points_driven_along_one_axis_beside_a_loop_written_as_closure(right, wrong):
    foot = 0.2 * np.exp(1.9j) + 0.35 * np.exp(0.62j) + 0.3 * np.exp(-0.9j) - 0.22 * np.exp(0.4j)
    loop = FIVE_BAR[FIVE_BAR.index('[[constraint]]\nname = "x"') : FIVE_BAR.index("[points]")]
    text = FIVE_BAR.replace(loop, '[[constraint]]\nname = "loop"\nclosure = "D = (X, Y)"\n')
    text = text.replace("[drive]", f'X = "{foot.real:.15g} m"\nY = "{foot.imag:.15g} m"\n[drive]').replace(right, wrong)
    run = coursework.solve(coursework.parse_variant(text))
    if right:
        with pytest.raises(coursework.InputError, match=r"V302 .*equation [AB] contradicts"):
            run.compute()
    else:
        assert {one.code: one.verdict for one in run.checks}["AGREEMENT"] == "PASS"
        assert run.table.to_numpy() == pytest.approx(
            coursework.solve(coursework.parse_variant(FIVE_BAR)).table.to_numpy(), abs=1e-9
        )
