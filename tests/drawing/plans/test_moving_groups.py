"""RPR, RPP, PRP and RRP between links that move: read off a plan, drawn with Coriolis's part, beside closed forms."""

from __future__ import annotations

import csv
import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest

from coursework import load, solve
from coursework.drawing.check_sheet.graph_check import GraphCheck
from coursework.drawing.check_sheet.layout import CROSS, lay_out
from coursework.drawing.check_sheet.readings import read_off
from coursework.report.output.record import record
from coursework.report.output.tables import run_tables
from coursework.report.pages import build_model
from coursework.report.text.parts import Figure, Paragraph
from coursework.variant.reading.reader import parse_variant
from tests.drawing import measured
from tests.drawing.check_sheet.checked import check_of
from tests.drawing.plans.moving_groups import CLOSED, HEAD, acceleration, crank, run_of, velocity
from tests.mechanisms.library import mechanism

GIVEN = {"shaper": {"V_B"}, "six-bar": {"V_B"}, "pin": {"V_K", "V_N"}, "block": {"V_K", "V_N"}, "pushed": set()}
# The rows of each, V_XY that of X about Y; of the others only what the closed form has besides.
ROWS = {
    "shaper": "V_B V_B′ V_BB′ ω₃ V_E V_F V_FE ω₄",
    "six-bar": "V_B V_C V_CB ω₂ ω₃ V_Q ω₅ V_E V_G′",
    "pin": "V_K V_N V_C V_CC′ V_CC′′",
    "block": "V_K V_N V_K′ V_KK′ V_F",
    "pushed": "V_C V_CB ω₂ ω₃",
}


def checked(name: str) -> GraphCheck:
    found = run_of(name).graph_check
    assert found is not None
    return found


def reference(name: str, row: str, t: float) -> float:
    """Return what a row of the check must say, from closed forms."""
    known = CLOSED[name](t)
    if row in known:
        return abs(velocity(name, row, t))
    point = row.removeprefix("V_")
    if point in known:
        return abs(velocity(name, point, t))
    return abs(velocity(name, point[0], t) - velocity(name, point[1], t))


@pytest.mark.parametrize("name", ROWS)
def test_every_row_is_read_and_is_as_near_as_its_readings_allow(name: str) -> None:
    check = checked(name)
    assert [one.name for one in check.readings] == ROWS[name].split()
    for one in check.readings:
        exact = reference(name, one.name, check.time)
        assert one.table == pytest.approx(exact, rel=1e-9), one.name
        assert one.read is None or one.read % 0.5 == 0
        assert one.rests == (one.name not in GIVEN[name]), one.name
        assert one.computed is None, "a centre off the sheet is replaced by the plan"
        assert abs(one.found - exact) <= exact * one.explained * (1 + one.explained) + 1e-12, one.name
        assert (0 < one.explained < 0.1) == one.rests


@pytest.mark.parametrize("name", ROWS)
def test_a_vector_is_as_long_on_the_plan_as_it_is_read(name: str) -> None:
    check = checked(name)
    _, plan = check.sheets()
    assert plan.id == "check-plan"
    assert measured.overlaps(plan.svg) == []
    unit = float(re.search(r"1 mm = ([\d.]+) m/s", str(plan.caption))[1])  # type: ignore[index]
    vectors = [one for one in check.readings if one.images]
    assert vectors
    for one in vectors:
        scale = float(re.search(r"·([\d.]+) ", str(one.relation))[1])  # type: ignore[index]
        assert math.log10(unit / scale) == pytest.approx(round(math.log10(unit / scale)), abs=1e-9), "as it is, or in the inset"
        assert one.read is not None
        assert one.read == pytest.approx(reference(name, one.name, check.time) / scale, abs=0.25 + 1e-9), one.name
        assert one.found == pytest.approx(one.read * scale)
    assert not any("No two known lines" in str(step) for step in plan.steps)


@pytest.mark.parametrize("name", ROWS)
def test_the_plan_of_accelerations_has_coriolis_and_closes(name: str) -> None:
    check = checked(name)
    lines = csv.DictReader(dict(run_tables(run_of(name)))["polygons.csv"].splitlines())
    here = {
        (line["plan"], line["kind"], line["from"], line["to"]): complex(float(line["x"]), float(line["y"]))
        for line in lines
        if line["row"] == str(check.row) and line["motion"] == "exact"
    }
    largest = max(abs(vector) for key, vector in here.items() if key[0] == "acceleration")
    points = {point for point in CLOSED[name](check.time) if len(point) == 1 and point.isupper()}
    for point in points:
        key = ("acceleration", "absolute", "pole", point)
        assert here[key] == pytest.approx(acceleration(name, point, check.time), abs=1e-7 * largest), point
    for (plan, kind, start, end), vector in here.items():
        begin = here.get((plan, "absolute", "pole", start), 0)
        tip = here.get((plan, "absolute", "pole", end), 0)
        if kind == "relative":
            assert begin + vector == pytest.approx(tip, abs=1e-9 * largest)
        if kind == "coriolis":
            sliding = here["velocity", "sliding", start, end]
            turning = {"B'": "ω₃", "G'": "ω₅"}.get(start)
            omega = velocity(name, turning, check.time).real if turning else {"C'": 8.0, "C''": -4.0}.get(start, -4.0)
            assert vector == pytest.approx(2j * omega * sliding, abs=1e-7 * largest)
            assert begin + vector + here[plan, "sliding", start, end] == pytest.approx(tip, abs=1e-9 * largest)
    slides = sum(key[1] == "coriolis" for key in here)
    assert slides == {"shaper": 1, "six-bar": 1, "pin": 2, "block": 2, "pushed": 0}[name]


FIVE_BAR = mechanism(
    "crank-and-driven-point", ('"60 deg"', '"80 deg"'), ('"0.9 rad"', '"20 deg"'), ('"-0.9 rad"', '"-50 deg"'), r1="0.2 m",
    r2="0.4 m", r3="0.45 m", V=None, p=None, n="5 rad/s", VMx="0.5*cos(5*t)", VMy="0.15*sin(5*t)", end="0.2 s",
)  # fmt: skip


def test_a_dyad_between_a_crank_and_a_driven_point_is_read_off_the_plan() -> None:
    run = solve(parse_variant(FIVE_BAR), quantities=["graph_check"])
    check = run.graph_check
    assert check is not None
    phi = [float(run.motion.column(f"phi{k}")[3]) for k in (1, 2, 3)]
    arms = [length * np.exp(1j * angle) for length, angle in zip((0.2, 0.4, 0.45), phi, strict=True)]
    v_b, v_m = 5j * arms[0], complex(0.5 * math.cos(0.3), 0.15 * math.sin(0.3))
    matrix = np.array([[(1j * arm).real for arm in arms[1:]], [(1j * arm).imag for arm in arms[1:]]])
    w2, w3 = np.linalg.solve(matrix, [(v_m - v_b).real, (v_m - v_b).imag])
    v_c = v_b + 1j * w2 * arms[1]
    wanted = {"V_C": abs(v_c), "V_CB": abs(v_c - v_b), "ω₂": abs(w2), "V_CM": abs(v_c - v_m), "ω₃": abs(w3)}
    read = {one.name: one for one in check.readings if one.name != "V_B"}
    assert list(read) == list(wanted)
    for name, value in wanted.items():
        assert abs(read[name].found - value) <= value * read[name].explained * 1.01, name
        assert 0 < read[name].explained < 0.02


# ---- the edge of the sheet, and sheets without anything to read


@pytest.mark.parametrize(("inside", "near"), [(0.2, True), (-0.2, False)])
def test_a_centre_off_the_sheet_is_computed_and_never_read(inside: float, near: bool) -> None:
    """P₂ of variant 31 is moved up to where its cross just has room on the lying sheet, and 0.2 mm to either side of that."""
    check = check_of("31")
    centre = check.findings.centres["2"]
    assert centre.at is not None

    def at(y: float) -> GraphCheck:
        moved = replace(centre, at=complex(check.sketch.pose.positions["A"].real, y))
        return replace(check, findings=replace(check.findings, centres={**check.findings.centres, "2": moved}))

    low, high = -3.0, 0.0
    while high - low > 1e-6:
        middle = (low + high) / 2
        seen = "2" in lay_out(at(middle).sketch, at(middle).findings).near
        low, high = (low, middle) if seen else (middle, high)
    moved = at(high + inside / 100)
    layout = lay_out(moved.sketch, moved.findings)
    assert ("2" in layout.near) == near
    place = moved.findings.centres["2"].at
    assert place is not None
    left, _, right, bottom = layout.field
    there = layout.put(place)
    assert (left <= there.real - CROSS and there.real + CROSS <= right and there.imag + CROSS <= bottom) == near
    (row,) = [one for one in read_off(moved.sketch, moved.findings, layout, {}, None) if one.name == "ω₂"]
    assert (row.read is not None, row.computed is None) == (near, near)


def test_variant_31_tells_what_is_computed() -> None:
    rows = {row["name"]: row for row in record(solve("31", quantities=["graph_check"]))["graph_check"]["rows"]}
    assert {name for name, row in rows.items() if row["read"] is not None} == {"ω₃", "V_B", "V_C"}
    assert set(rows["ω₂"]) == {"name", "found", "read", "table", "unit"}


LONE = HEAD.format(
    name="a crank alone", drive='w1 = "{rate}"', step="0.01 s", end="0.1 s", hinges='["A"]', rails="",
    coordinates='phi1 = {{ start = "20 deg", rate = "w1" }}', points='A = "(0, 0)"', groups=crank("A", "B", "0.1", "phi1"),
)  # fmt: skip


@pytest.mark.parametrize(
    ("rate", "why"),
    [("10", "all velocities follow from what is given"), ("10*cos(pi*t/0.06)", "nothing moves in that row")],
)
def test_a_sheet_on_which_nothing_can_be_read_is_left_out_with_the_reason(rate: str, why: str) -> None:
    run = solve(parse_variant(LONE.replace("{rate}", rate).replace("{{", "{").replace("}}", "}")), quantities=["graph_check"])
    section = next(section for section in build_model(run).sections if section.name == "graph_check")
    (part,) = section.parts
    assert isinstance(part, Paragraph)
    assert why in json.dumps(part.text)
    assert record(run)["graph_check"]["rows"][0]["read"] is None


LADDER = """
format = 1
title = "a ladder"
[given]
L = "2.5 m"
v = "0.3 m/s"
[coordinates]
x = { start = "0 m", rate = "u" }
phi = { start = "2.2 rad", rate = "w" }
[time]
step = "0.1 s"
end = "1 s"
[[constraint]]
name = "1"
equation = "u = v"
[[constraint]]
name = "2"
equation = "u - L*w*sin(phi) = 0"
[points]
F = "(x, 0)"
T = "F + L @ phi"
[links]
1 = { points = ["F", "T"], rate = "w" }
[frame]
rails = [ { through = "T", angle = "90 deg" }, { through = "F", angle = "0" } ]
"""


def test_what_moves_undriven_is_not_said_to_rest() -> None:
    """Of the ladder an equation says how fast its foot runs, by where it is: no law of time drives it."""
    check = solve(parse_variant(LADDER.replace('"u = v"', '"u = v*(1 + x/L)"')), quantities=["graph_check"]).graph_check
    assert check is not None and "nothing is driven" in check.unread


def test_a_foot_that_an_equation_drives_evenly_begins_the_construction() -> None:
    run = solve(parse_variant(LADDER), quantities=["graph_check"])
    assert run.graph_check is not None and not run.graph_check.unread
    phi = float(run.motion.column("phi")[run.graph_check.row - 1])
    found = {name: value for name, value, *_ in run.graph_check.rows}
    assert (found["w"], found["V_T"]) == pytest.approx((0.3 / 2.5 / math.sin(phi), 0.3 / abs(math.tan(phi))), rel=1e-9)


def test_a_rate_that_forces_give_is_what_a_construction_begins_with() -> None:
    """Row 12 of the slider-crank that a motor runs up, beside the closed form; in row 1 it is at rest."""
    run_up = load("example-2-motor")
    run = solve(run_up.with_data(check_row=12), quantities=["graph_check"])
    check, length = run.graph_check, run.variant.values
    assert check is not None and not check.unread
    turned, tilted, omega = (float(run.motion.column(name)[11]) for name in ("theta1", "theta2", "w1"))
    rod = -length["r1"] * omega * math.cos(turned) / (length["r2"] * math.cos(tilted))
    slider = length["r1"] * omega * math.sin(turned) + length["r2"] * rod * math.sin(tilted)
    found = {name: value for name, value, *_ in check.rows}
    assert (found["ω₂"], found["V_C"]) == pytest.approx((rod, abs(slider)), rel=1e-9)
    still = solve(run_up.with_data(check_row=1), quantities=["graph_check"]).graph_check
    assert still is not None and "nothing moves in that row" in still.unread


def test_the_page_has_both_sheets_and_a_blank_one_leaves_the_plan_to_the_student() -> None:
    figures = [part for section in build_model(run_of("shaper")).sections for part in section.parts if isinstance(part, Figure)]
    assert [one.id for one in figures if one.id in {"graph-check", "check-plan"}] == ["graph-check", "check-plan"]
    position, plan = checked("shaper").sheets(blank=True)
    assert "Complete the plan" in str(plan.caption)
    assert plan.steps == ()
    assert set(re.findall(r'data-kind="(\w+)" data-from="\w+" data-to="(\w+)"', plan.svg)) == {("absolute", "B")}
    assert set(re.findall(r'data-velocity="(\w+)"', position.svg)) <= {"B"}
    full = checked("shaper").sheets()[1]
    assert (plan.width, plan.height) == (full.width, full.height)
