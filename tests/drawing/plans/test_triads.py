"""Groups of class III by special points: velocities and accelerations beside a motion solved in the test, every pair of legs."""

from __future__ import annotations

import csv
import itertools
import re
from dataclasses import replace

import numpy as np
import pytest

from coursework import solve
from coursework.drawing.check_sheet.graph_check import GraphCheck
from coursework.drawing.check_sheet.instant_centres import Centre
from coursework.drawing.check_sheet.layout import CROSS, Layout, lay_out
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.plans.given import given_points
from coursework.drawing.plans.known import Driven
from coursework.drawing.plans.moving import kinematics_of
from coursework.drawing.plans.polygons import polygons
from coursework.drawing.plans.special_points import FAR, Leg, special_name, special_points
from coursework.drawing.plans.vectors import ACCELERATION, POLE, VELOCITY, Line, Polygons
from coursework.mechanism.structure import read_structure
from coursework.report.output.tables import run_tables
from coursework.variant.reading.reader import parse_variant
from tests.drawing import measured
from tests.drawing.plans.triads import TRIADS, derivative, places, run_of, text_of

# Of the ternary link: what its legs hold, and the pairs of which the special point lies near enough.
LEGS = {"bars": "XYZ", "guide": "XYZ", "slot": "XYZ", "sleeve": "XYN"}
PAIRS = [(name, "".join(pair)) for name, legs in LEGS.items() for pair in itertools.combinations(legs, 2)]
ACROSS = {  # what leads to each: the other end of a bar, or the angle of a guide in row 4
    "bars": {"X": "B", "Y": "C", "Z": 0.5 - 0.2j}, "guide": {"X": 0.3, "Y": "B", "Z": "C"},
    "slot": {"X": float(np.radians(20) - 0.09), "Y": "B", "Z": 0.5 - 0.2j}, "sleeve": {"X": "B", "Y": "C", "N": "ω₄"},
}  # fmt: skip
TIME = 0.03


def checked(name: str) -> GraphCheck:
    found = run_of(name).graph_check
    assert found is not None
    return found


@pytest.mark.parametrize("name", TRIADS)
def test_the_ternary_link_and_its_legs_are_read_off_the_plan(name: str) -> None:
    run, check = run_of(name), checked(name)
    structure = read_structure(run.scene.mechanism)
    assert structure is not None
    assert [group.group_class for group in structure.groups if len(group.links) > 2] == ["III"]
    assert check.plan is not None
    assert check.plan.solved == set(), "no point is computed from all links together"
    known = places(name, TIME)
    wanted = {f"V_{key}": abs(derivative(name, key, TIME)) for key in known if key.isascii()}
    wanted |= {key: abs(derivative(name, key, TIME)) for key in known if not key.isascii()}
    read = {one.name: one for one in check.readings}
    assert wanted.keys() <= read.keys()
    for key, one in read.items():
        assert one.table == pytest.approx(wanted.get(key, one.table), rel=1e-7), key
        assert abs(one.found - one.table) <= one.table * one.explained * (1 + one.explained) + 1e-12, key
        assert one.computed is None
        assert "all links together" not in str(one.relation)
    assert read["V_S"].read is not None
    assert read["ω₄"].rests
    assert 0 < read["ω₄"].explained < 0.05
    position, plan = check.sheets()
    assert measured.overlaps(position.svg) == measured.overlaps(plan.svg) == []
    assert any("S is the special point of link 4" in note for note in check.notes)
    assert ">S<" not in check.drawing(blank=True).svg
    assert ">S<" in position.svg


def of_pair(name: str, pair: str) -> tuple[Polygons, complex] | None:
    """Return the exact plans in which only one pair of legs may be taken, and its special point; None where it lies too far."""
    run = run_of(name)
    outline = read_outline(run.scene.mechanism)
    assert outline is not None
    taken: list[complex] = []

    def only(place: complex, ends: tuple[str, ...]) -> bool:
        taken.extend([place] if set(ends) == set(pair) else [])
        return set(ends) == set(pair)

    moving = kinematics_of(outline, run.scene.equations, run.exact, run.scene.exact_accelerations)
    variant = run.variant
    found = polygons(outline, moving, Driven(given_points(outline, variant), variant.known_rates), 3, only)
    return (found, taken[0]) if taken else None


def turned(name: str, quantity: str, value: complex | str | float) -> complex:
    """Return the direction in which a leg lets its point go, as a unit."""
    known = places(name, TIME)
    if value == "ω₄":
        return complex(np.exp(1j * float(known["ω₄"])))
    if isinstance(value, float):
        return complex(np.exp(1j * value))
    arm = complex(known[quantity]) - (complex(known[value]) if isinstance(value, str) else value)
    return 1j * arm / abs(arm)


@pytest.mark.parametrize(("name", "pair"), PAIRS)
def test_both_plans_close_on_the_lines_of_every_pair_of_legs(name: str, pair: str) -> None:
    made = of_pair(name, pair)
    assert made is not None
    found, at = made
    here = {(s.plan, s.kind, s.start, s.end): complex(s.vector[3]) for s in found.segments}
    known = places(name, TIME)
    v, a = ({key: derivative(name, key, TIME, order) for key in known} for order in (1, 2))
    omega, epsilon, x = v["ω₄"].real, a["ω₄"].real, complex(known["X"])
    v_s = v["X"] + 1j * omega * (at - x)
    a_s = a["X"] + (1j * epsilon - omega**2) * (at - x)
    largest = max(abs(vector) for key, vector in here.items() if key[0] == ACCELERATION)
    assert here[VELOCITY, "absolute", POLE, "S"] == pytest.approx(v_s, rel=1e-6)
    assert here[ACCELERATION, "absolute", POLE, "S"] == pytest.approx(a_s, abs=1e-6 * largest)
    (special,) = [one for one in found.found if one.rule == "special"]
    assert not any(one.rule == "solved" for one in found.found)
    for line in special.lines:
        point = line.at.rstrip("'")
        way = turned(name, point, ACROSS[name][point])
        start = POLE if (VELOCITY, "relative", line.base, "S") not in here else line.base
        begin = here.get((VELOCITY, "absolute", POLE, start), 0j)
        assert ((v_s - begin) * way.conjugate()).imag == pytest.approx(0, abs=1e-7 * abs(v_s)), "on the line of the leg"
        before = here.get((ACCELERATION, "normal", start, line.at), 0j) if line.kind == "bar" else 0j
        before += here.get((ACCELERATION, "coriolis", start, line.at), 0j)
        own, last = here[ACCELERATION, "normal", line.at, "S"], here[ACCELERATION, "tangential", start, "S"]
        begin = here.get((ACCELERATION, "absolute", POLE, start), 0j)
        assert begin + before + own + last == pytest.approx(a_s, abs=1e-6 * largest)
        assert (last * way.conjugate()).imag == pytest.approx(0, abs=1e-6 * largest), "the last part lies along the line"
        place = complex(known[point]) if point in known else 0.45 + 0.35j
        assert own == pytest.approx(-(omega**2) * (at - place), abs=1e-6 * largest)


def test_the_page_tells_both_constructions() -> None:
    lines = csv.DictReader(dict(run_tables(run_of("sleeve")))["polygons.csv"].splitlines())
    assert {line["kind"] for line in lines if line["to"] == "S"} >= {"absolute", "relative", "normal", "tangential"}
    made = of_pair("sleeve", "XN")
    assert made is not None
    from coursework.drawing.plans.plan_scale import scale_of
    from coursework.drawing.plans.steps import steps

    told = [str(step) for step in steps(made[0], ACCELERATION, 3, scale_of(made[0], ACCELERATION, 3))]
    (step,) = [one for one in told if "special point S of link 4" in one]
    assert re.search(
        r"from the pole first the Coriolis component of \d+\.\d mm that N′, the point of link 4 under N, has about N", step
    )
    assert re.search(r"then that of S about X, \d+\.\d mm in the direction from S to X, then at right angles to BX", step)


# ---- of three pairs, which


def leg(point: str, at: complex, along: complex) -> Leg:
    return Leg(point, Line("bar", "", ""), np.array([at]), np.array([along]))


def pairs(*legs: Leg) -> list[str]:
    return ["".join(leg.point for leg in found.legs) for found in special_points(legs, 0)]


def test_the_nearest_special_point_comes_first_and_parallel_legs_have_none() -> None:
    x, y, z = leg("X", 0j, 1 + 0j), leg("Y", 1 + 0j, 1 + 0j), leg("Z", 0.5 + 1j, 1j)
    assert pairs(x, y, z) == ["XZ", "YZ"], "the lines of X and Y, both upright, meet nowhere"
    assert pairs(x, y, leg("Z", 0.5 + 1j, 1 + 0j)) == [], "three parallel legs: computed as before"
    inclined = leg("Y", 1 + 0j, np.exp(0.3j))
    assert pairs(x, inclined, z)[-1] == "XY"


@pytest.mark.parametrize(("times", "there"), [(0.999, True), (1.001, False)])
def test_a_point_far_away_is_none(times: float, there: bool) -> None:
    """Legs at 0 and 1, a third at 2: the lines of the first two meet above 0, at `FAR` times 2 from the farthest, or beyond."""
    height = float(np.sqrt((times * FAR * 2) ** 2 - 4))
    x, y = leg("X", 0j, 1 + 0j), leg("Y", 1 + 0j, 1j * (1j * height - 1))
    assert ("XY" in pairs(x, y, leg("Z", 2 + 0j, np.exp(1j)))) == there


def test_a_point_on_the_lines_of_all_three_legs_is_none() -> None:
    legs = [leg(name, at, 1j * at) for name, at in (("X", 1 + 0j), ("Y", 1j), ("Z", -1 - 1j))]
    assert pairs(*legs) == []
    assert pairs(*legs[:2], leg("Z", -1 - 1j, 1j * (-1 - 1.001j))) != []


def test_a_special_point_is_called_like_no_other() -> None:
    assert special_name(["A", "B"]) == "S"
    assert special_name(["A", "s", "T", "U", "W"]) == "S1"


@pytest.mark.parametrize(("inside", "there"), [(0.2, True), (-0.2, False)])
def test_a_special_point_is_taken_where_its_cross_has_room_on_the_sheet(inside: float, there: bool) -> None:
    """It is moved up to where it just has room, and 0.2 mm to either side of that."""
    check = checked("bars")
    assert list(check.findings.specials) == ["S"]

    def on(x: float) -> Layout:
        return lay_out(check.sketch, replace(check.findings, specials={"S": Centre(complex(x, 0.0), ("Y", "Z"))}))

    near, far = 0.5, 50.0
    while far - near > 1e-6:
        middle = (near + far) / 2
        near, far = (middle, far) if on(middle).holds(Centre(complex(middle, 0.0), ("Y",))) else (near, middle)
    place = near - inside * on(near).scale / 1000
    sheet = on(place)
    at = sheet.put(complex(place, 0.0))
    assert sheet.holds(Centre(complex(place, 0.0), ("Y", "Z"))) == there
    assert (at.real + CROSS <= sheet.field[2]) == there


def nearly_parallel() -> str:
    """Return three legs within two degrees of each other: of their lines none meet on a sheet."""
    x, y, z = 0.05 + 0.5j, 0.3 + 0.5 * np.exp(1j * np.radians(92)), 0.6 + 0.5j
    first, second = y - x, z - x
    text = text_of("bars").replace('w1 = "6"', 'w1 = "0.05"').replace("0.2 s", "0.04 s")
    text = re.sub(r'(B|C) = "A[^"]*"', lambda found: f'{found[1]} = "A + {0.05 if found[1] == "B" else 0.3} @ phi1"', text)
    text = re.sub(r"([BCG] [+] )0[.][345]+( @ phi[235])", r"\g<1>0.5\g<2>", text).replace("(0.5, -0.2)", "(0.6, 0)")
    text = text.replace("0.25 @ (phi4 + 1)", f"{abs(first):.15g} @ (phi4 + {np.angle(first):.15g})")
    text = text.replace("0.3 @ phi4", f"{abs(second):.15g} @ phi4")
    for name, degrees in (("phi1", 0), ("phi2", 90), ("phi3", 92), ("phi4", 0), ("phi5", 90)):
        text = re.sub(rf'{name} = {{ start = "[^"]*"', f'{name} = {{ start = "{degrees} deg"', text)
    return text


def test_where_all_special_points_are_far_the_link_is_computed_with_the_reason() -> None:
    check = solve(parse_variant(nearly_parallel()), quantities=["graph_check"]).graph_check
    assert check is not None
    assert check.plan is not None
    assert len(check.plan.solved) == 1
    assert not check.plan.specials
    assert any("no two known lines meet" in note for note in check.notes)
    assert sum("all links together" in str(one.relation) for one in check.readings) == 1
