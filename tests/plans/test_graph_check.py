"""The graph-analytical check: numbers of the coursework, centres of the reference, rules one by one, the drawing itself."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from functools import cache
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest

from coursework import load, solve
from coursework.catalogue import names
from coursework.errors import InputError
from coursework.output.record import record
from coursework.plans.graph_check import GraphCheck, check_graph
from coursework.plans.instant_centres import Centre, Findings, construct
from coursework.plans.layout import LANDSCAPE, PAGE, SCALES, lay_out
from coursework.plans.pose import Body, Pose
from coursework.plans.sketch import Sketch, read_sketch
from coursework.run import Run
from coursework.variant.record import Link, Variant
from tests.drawing import measured

REFERENCE = Path(__file__).parents[1] / "reference" / "variants"
# Links that [links] and [frame] alone determine; V107 has a bar in a swivelling sleeve.
DRAWABLE = ("V101", "V102", "V104", "V105", "V108", "V110", "V112")
DIGITS_OF_THE_REFERENCE = 1e-9


@cache
def run_of(name: str) -> Run:
    return solve(name, quantities=["graph_check"])


@cache
def check_of(name: str, row: int | None = None) -> GraphCheck:
    """Return the check of a catalogue's variant, in its own row or another; the variant is solved once."""
    run = run_of(name)
    if row is None:
        assert run.graph is not None
        return run.graph
    equations = replace(run.scene.equations, variant=at_row(run.variant, row))
    check = check_graph(run.scene.mechanism, equations, run.motion, run.exact)
    assert check is not None
    return check


@cache
def svg_of(name: str) -> str:
    return check_of(name).drawing().svg


def at_row(variant: Variant, row: int | None) -> Variant:
    return replace(variant, time=replace(variant.time, check_row=row))


def sketch_of(name: str) -> Sketch:
    return check_of(name).sketch


# ---- the numbers of the coursework (mathematics.md, section 3)


def test_variant_31_at_the_start() -> None:
    check = check_of("31", 1)
    values = {row[0]: row[1] for row in check.rows}
    assert values["P3.x"] == pytest.approx(-1.0039877, abs=5e-8)
    assert values["P3.y"] == pytest.approx(1.0047422, abs=5e-8)
    assert values["P2.x"] == pytest.approx(0.0674619, abs=5e-8)
    assert values["P2.y"] == pytest.approx(-1.1381569, abs=5e-8)
    expected = {"ω₁": -1.57553728806, "ω₂": -0.717332163182, "ω₃": 5.5518389091, "ω₄": -16.6541505896}
    for name, value in expected.items():
        assert values[name] == pytest.approx(value, abs=1e-10)


def test_variant_31_in_the_row_of_the_coursework() -> None:
    check = check_of("31")
    assert (check.row, check.time, check.scale) == (4, 0.06, 10)
    assert [row[0] for row in check.rows] == [
        "ω₁", "ω₂", "ω₃", "ω₄", "V_A", "V_B", "V_C", "P3.x", "P3.y", "P2.x", "P2.y",
    ]  # fmt: skip
    values = {row[0]: row[1] for row in check.rows}
    expected = {"ω₁": 0.219835996720, "ω₂": 0.113615129728, "ω₃": 4.39156138925, "ω₄": -7.94100954258}
    for name, value in expected.items():
        assert values[name] == pytest.approx(value, abs=1e-11)
    for name, found, tabled, difference, _ in check.rows:
        assert difference == found - tabled, name
        assert abs(difference) < 1e-13, name
    run = run_of("31")
    for name, exact, error, unit in check.exact[:4]:
        column = name.replace("ω", "w").translate(str.maketrans("₁₂₃₄", "1234"))
        assert exact == pytest.approx(float(run.exact.column(column)[3]), abs=1e-12)
        assert error == pytest.approx(float(run.motion.column(column)[3] - run.exact.column(column)[3]), abs=1e-12)
        assert unit == "rad/s"
    assert check.notes == (
        "Link 1 turns about D.",
        "P₂ is where the perpendiculars to the velocities of A and B meet.",
        "P₃ is where the perpendiculars to the velocities of M and C meet.",
        "Link 4 rolls: its instantaneous centre is the contact P.",
        "The scheme has drifted, so this row does not close: P stands 7.05 mm beside its rail.",
    )


@pytest.mark.parametrize("name", DRAWABLE)
def test_centres_of_the_exact_row(name: str) -> None:
    reference = json.loads((REFERENCE / f"{name}.json").read_text())["icv_at_check_row_exact"]
    run = run_of(name.lower())
    sketch = read_sketch(run.scene.mechanism, run.scene.equations)(run.exact, run.variant.time.check_row - 1)
    findings = construct(sketch.pose)
    assert findings.missing == ()
    for link, expected in reference.items():
        centre = findings.centres[link.removeprefix("link")]
        assert centre.at is not None
        assert centre.at.real == pytest.approx(expected["x"], abs=DIGITS_OF_THE_REFERENCE)
        assert centre.at.imag == pytest.approx(expected["y"], abs=DIGITS_OF_THE_REFERENCE)
        assert findings.omegas[link.removeprefix("link")] == pytest.approx(expected["omega"], abs=DIGITS_OF_THE_REFERENCE)


@pytest.mark.parametrize("name", DRAWABLE)
def test_without_drift_drawing_and_table_agree(name: str) -> None:
    """The start row closes: whatever is measured there is what the velocity equations give."""
    check = check_of(name.lower(), 1)
    assert check.rows
    for quantity, _, _, difference, _ in check.rows:
        assert abs(difference) < 1e-9, quantity
    assert not any("drifted" in note for note in check.notes)


def test_a_bar_in_a_sleeve_is_constructed() -> None:
    """V107, row 7: reference numbers from the velocity equations at the table's row, to 1e-15."""
    check = check_of("v107")
    centre = check.findings.centres["3"]
    assert centre.lines == ("M", "O")
    assert centre.at == pytest.approx(0.70782 - 0.58848j, abs=5e-6)
    expected = {"3": -2.0497026, "2": -1.0073716, "1": -4.9137472, "4": -2.0497026}
    for link, omega in expected.items():
        assert check.findings.omegas[link] == pytest.approx(omega, abs=5e-8)
    motion = run_of("v107").motion
    for link, rate in {"1": "w1", "2": "w2", "3": "w3"}.items():
        assert check.findings.omegas[link] == pytest.approx(float(motion.column(rate)[6]), abs=1e-13)
    assert "P₃ is where the perpendicular to the velocity of M meets that to the bar in its sleeve at O." in check.notes
    svg = svg_of("v107")
    assert 'data-sleeve="4"' in svg
    assert "data-slot" in svg


def test_a_sleeve_on_a_moving_pivot_is_solved_by_the_plan() -> None:
    """A bar M–B slides through a sleeve whose pivot O moves: V_bar at O is V_O and a part along the bar, nothing else."""
    at = {"M": 0.5 + 0j, "B": 2 + 0j, "O": 1 + 0j, "K": 1 - 1j}
    bar, sleeve, arm = Body("1", ("M", "B"), "w1"), Body("2", ("O",)), Body("3", ("K", "O"), "w3")
    speeds = {"M": 0.3 + 1j}
    pose = Pose(at, (bar, sleeve, arm), frozenset({"K"}), {}, speeds, {"w3": -2.0}, {"1": ("O", 1 + 0j, "2")})
    found = construct(pose)
    # V_O = -2i * i = 2; across the bar O stands still, so 1 + ω (1 - 0.5) = 0.
    assert found.omegas["1"] == pytest.approx(-2.0, abs=1e-12)
    assert found.omegas["2"] == pytest.approx(-2.0, abs=1e-12)
    assert found.velocities["B"] == pytest.approx(0.3 - 2j, abs=1e-12)
    assert found.planned == ("1", "2")
    assert found.missing == ()


def test_what_the_geometry_leaves_open_stays_open() -> None:
    """A pin in no guide between two links with one known end each has a plan; a single link with one known end has none."""
    pose = Pose({"M": 0j, "B": 1 + 0j}, (Body("1", ("M", "B"), "w1"),), frozenset(), {}, {"M": 1 + 1j}, {})
    assert construct(pose).missing == ("1",)


@pytest.mark.parametrize(("far", "translates"), [(99.0, False), (101.0, True)])
def test_a_centre_beyond_a_hundred_mechanisms_is_a_translation(far: float, translates: bool) -> None:
    at = {"A": 0j, "B": 1 + 0j}
    along = 1j * (1 + 1j / far)  # the normals of A and B meet at (0, ...) far away
    pose = Pose(at, (Body("1", ("A", "B"), "w1"),), frozenset(), {"B": along / abs(along)}, {"A": 1 + 0j}, {})
    tilted = replace(pose, guided={"B": complex(1, -1 / far) / abs(complex(1, -1 / far))})
    centre = construct(tilted).centres["1"]
    assert (centre.at is None) == translates
    assert construct(tilted).omegas["1"] == pytest.approx(
        -1 / far if centre.at is not None else construct(tilted).omegas["1"], rel=0.1
    )


# ---- what is read off the drawing


def test_variant_31_is_read_as_the_guide_reads_it() -> None:
    """Page 1.5 of the specification, worked by hand: lengths to 0.5 mm at 1:10."""
    read = {one.name: one for one in check_of("31").readings}
    assert {name: one.read for name, one in read.items()} == {
        "ω₃": 93.5, "V_B": 5.0, "V_C": 41.5, "ω₂": 187.0, "V_A": 184.5, "ω₁": None, "ω₄": None,
    }  # fmt: skip
    speed = abs(4.5 * math.sin(13.08 * 0.06 + 4.35))
    omega = speed / 0.935
    expected = {
        "ω₃": omega, "V_C": omega * 0.415, "V_B": omega * 0.05, "ω₄": omega * 0.415 / 0.2285, "ω₂": omega * 0.05 / 1.87,
        "V_A": omega * 0.05 / 1.87 * 1.845, "ω₁": omega * 0.05 / 1.87 * 1.845 / 0.953,
    }  # fmt: skip
    for name, value in expected.items():
        assert read[name].found == pytest.approx(value, rel=1e-12), name
    assert {name: round(one.found, 4) for name, one in read.items()} == {
        "ω₃": 4.3898, "V_B": 0.2195, "V_C": 1.8218, "ω₂": 0.1174, "V_A": 0.2166, "ω₁": 0.2272, "ω₄": 7.9727,
    }  # fmt: skip
    assert read["ω₃"].table == pytest.approx(4.39156138925, abs=1e-11)
    assert read["ω₄"].table == pytest.approx(7.94100954258, abs=1e-11)
    assert read["V_B"].explained == pytest.approx(0.05)
    assert (str(read["ω₃"].relation), str(read["V_C"].relation), str(read["ω₄"].relation)) == ("V_M/P₃M", "ω₃·P₃C", "V_C/PC")


@pytest.mark.parametrize(
    "name", ["31", *(name.lower() for name in DRAWABLE), "v107", "homework", "jansen", "peaucellier", "example-1"]
)
def test_every_reading_is_as_near_as_its_lengths_allow(name: str) -> None:
    """Errors of a ruler add up along the working: no value may be off by more than the sum of what its lengths explain."""
    readings = check_of(name).readings
    assert readings
    blurred = any(one.read is not None and one.read < 2 for one in readings)
    total = sum(one.explained for one in readings)
    drift = 0.01 if name in {"v104", "v105", "v112"} else 0.0  # rows that do not close by this part of a link
    for one in readings:
        assert one.read is None or one.read % 0.5 == 0
        if not blurred and math.isfinite(one.table):
            assert abs(one.difference) <= total + drift, one.name


CHAINS = (
    "example-1",
    "example-2",
    "example-4",
    "example-5",
    "example-6",
    "prp",
    "oscillating-cylinder",
    "walschaerts",
    "whitworth",
)


@pytest.mark.parametrize("name", [*CHAINS, "cardan", "epicyclic"])
def test_links_that_follow_from_groups_or_points_are_constructed_too(name: str) -> None:
    """Five dyads and two carriers: the construction knows no velocity equation, yet agrees with the exact rates."""
    check = check_of(name)
    assert check.findings.missing == ()
    compared = 0
    for found in check.rows:
        if found[0].startswith("ω") and not math.isnan(found[2]):
            assert found[1] == pytest.approx(found[2], abs=1e-10)
            compared += 1
    assert compared or name in {"example-5", "prp"}  # there nothing turns but the crank
    assert measured.overlaps(svg_of(name)) == []


def test_without_a_check_row_it_is_row_4() -> None:
    variant = at_row(load("31"), None)
    run = solve(variant, quantities=["graph_check"])
    assert run.graph is not None
    assert (run.graph.row, run.graph.time) == (4, pytest.approx(0.06))


def test_the_record_of_a_run_has_what_was_read() -> None:
    found = record(run_of("31"))["graph_check"]
    assert (found["row"], found["time"], found["scale"]) == (4, pytest.approx(0.06), 10)
    assert set(found["rows"][0]) == {"name", "found", "read", "table", "unit"}
    assert found["centres"]["3"] == {
        "x": pytest.approx(check_of("31").findings.centres["3"].at.real),
        "y": pytest.approx(0.884, abs=1),
    }
    assert "graph_check" not in record(solve("31", quantities=["table"]))


def test_a_blank_sheet_leaves_the_construction_to_the_student() -> None:
    blank = check_of("31").drawing(blank=True)
    assert set(re.findall(r'data-velocity="(\w+)"', blank.svg)) == {"M"}
    assert "stroke-dasharray" not in blank.svg
    assert (blank.width, blank.height) == (check_of("31").drawing().width, check_of("31").drawing().height)
    said = {word.text for word in measured.words(blank.svg)}
    assert not any(text.startswith("P2") or text.startswith("P3") for text in said)
    assert {"A", "B", "C", "D", "M", "P"} <= said


@pytest.mark.parametrize(
    "name", ["31", *(name.lower() for name in DRAWABLE), "v107", "homework", "jansen", "peaucellier", "watt", "stephenson"]
)
def test_no_word_of_the_sheet_lies_on_another(name: str) -> None:
    assert measured.overlaps(svg_of(name)) == []
    assert measured.beyond(svg_of(name)) == []


@pytest.mark.parametrize("name", ["31", "v101", "v102", "v104", "v105", "v107", "v108", "v110", "v112"])
def test_a_velocity_is_named_beside_its_own_arrow(name: str) -> None:
    """A reader takes the nearest tip: in v102 the words of two arrows, one above the other, had changed places."""
    check, svg = check_of(name), svg_of(name)
    layout = lay_out(check.sketch, check.findings)
    shafts = {line.says["data-velocity"]: line for line in measured.lines(svg, "data-velocity")}
    tips = {point: line.a + layout.arrow(check.findings.velocities[point]) for point, line in shafts.items()}
    arrows = {point: measured.Line(line.a, tips[point], line.says) for point, line in shafts.items()}
    told = {match[1]: word for word in measured.words(svg) if (match := re.match(r"V(\w+)\s=", word.text))}
    for point in tips:
        apart = {other: measured.apart(told[point], tip) for other, tip in tips.items()}
        assert apart[point] <= min(apart.values()) + 1.0 or measured.led(svg, told[point], [arrows[point]]), point


def test_a_rack_hands_its_velocity_to_the_gear() -> None:
    check = check_of("v112")
    assert "Link 5 drives wheel 4 at Q: there both have one velocity." in check.notes
    assert check.sketch.racks == {"5": "Q"}
    assert "ω₅" not in [row[0] for row in check.rows]


def test_every_variant_that_asks_gets_its_drawing() -> None:
    for name in names():
        if "graph_check" in load(name).ask:
            check = check_of(name)
            assert check.rows, name
            ElementTree.fromstring(svg_of(name))


# ---- the rules, one by one


def scene(
    points: dict[str, complex], bodies: list[Body], *, fixed: str = "", guided: dict[str, complex] | None = None,
    velocities: dict[str, complex] | None = None, rates: dict[str, float] | None = None,
) -> Pose:  # fmt: skip
    return Pose(points, tuple(bodies), frozenset(fixed), guided or {}, velocities or {}, rates or {})


def test_translation_has_its_centre_at_infinity() -> None:
    points = {"A": 0j, "B": 2 + 1j, "C": 1 + 5j}
    found = construct(scene(points, [Body("1", ("A", "B", "C"))], guided={"B": 1 + 0j}, velocities={"A": 3 + 0j}))
    assert found.centres["1"] == Centre(None, ("A", "B"))
    assert found.omegas == {"1": 0.0}
    assert found.velocities == {"A": 3 + 0j, "B": 3 + 0j, "C": 3 + 0j}


def test_parallel_velocities_across_one_line_are_found_by_proportion() -> None:
    points = {"A": 0j, "B": 2 + 0j, "C": 5 + 0j}
    found = construct(scene(points, [Body("1", ("A", "B", "C"))], velocities={"A": 1j, "B": -3j}))
    assert found.centres["1"].at == pytest.approx(0.5)
    assert found.omegas["1"] == pytest.approx(-2.0)
    assert found.velocities["C"] == pytest.approx(-9j)


def test_a_driven_point_at_rest_stops_the_link() -> None:
    points = {"A": 0j, "B": 2 + 1j, "D": 3 + 0j}
    bodies = [Body("1", ("A", "B")), Body("2", ("B", "D"))]
    found = construct(scene(points, bodies, fixed="D", velocities={"A": 0j}))
    assert found.omegas == {"1": 0.0, "2": 0.0}
    assert found.velocities["B"] == 0


def test_a_driven_crank_and_the_wheel_it_carries() -> None:
    """A wheel of radius 1 rolls inside a ring of radius 3: it turns twice as fast as the arm, the other way."""
    points = {"O": 0j, "C": 2 + 0j, "P": 3 + 0j}
    bodies = [Body("1", ("O", "C"), "w1"), Body("2", ("C", "P"), "w2")]
    found = construct(scene(points, bodies, fixed="OP", rates={"w1": 5.0}))
    assert found.velocities["C"] == pytest.approx(10j)
    assert found.omegas["2"] == pytest.approx(-10.0)


def test_two_gears_share_the_velocity_of_their_contact() -> None:
    points = {"O": 0j, "P": 1 + 0j, "Q": 4 + 0j}
    bodies = [Body("1", ("O", "P"), "w1"), Body("2", ("Q", "P"), "w2")]
    assert construct(scene(points, bodies, fixed="OQ", rates={"w1": 6.0})).omegas["2"] == pytest.approx(-2.0)


def test_links_that_share_a_rate_turn_together() -> None:
    points = {"O": 0j, "A": 1 + 0j, "B": 2 + 2j}
    bodies = [Body("1", ("O", "A"), "w1"), Body("2", ("A", "B"), "w1")]
    found = construct(scene(points, bodies, fixed="O", velocities={"A": 2j}))
    assert found.omegas == {"1": 2.0, "2": 2.0}
    assert found.centres["2"].at == pytest.approx(0)
    assert found.velocities["B"] == pytest.approx(2j * (2 + 2j))


def test_a_dyad_between_two_moving_points_takes_a_velocity_plan() -> None:
    omega, points = (0.7, -1.3), {"A": 0j, "X": 1 + 2j, "B": 3 - 1j}
    v_x = 0.4 + 0.2j
    velocities = {"A": v_x - 1j * omega[0] * (points["X"] - points["A"]), "B": v_x - 1j * omega[1] * (points["X"] - points["B"])}
    found = construct(scene(points, [Body("1", ("A", "X")), Body("2", ("X", "B"))], velocities=velocities))
    assert found.velocities["X"] == pytest.approx(v_x)
    assert (found.omegas["1"], found.omegas["2"]) == pytest.approx(omega)
    assert found.plans == {"X": ("A", "B")}


def test_a_dead_point_is_left_open() -> None:
    """Crank and rod in one line, the driven slider moving along it: no crank velocity can be drawn."""
    points = {"O": 0j, "A": 1 + 0j, "B": 3 + 0j}
    bodies = [Body("1", ("O", "A")), Body("2", ("A", "B"))]
    assert construct(scene(points, bodies, fixed="O", velocities={"B": 1 + 0j})).missing == ("1", "2")


def test_a_rail_through_no_point_of_a_link_is_reported() -> None:
    variant = load("v102")
    rail = variant.frame.rails[0]
    loose = replace(variant, frame=replace(variant.frame, rails=((load("31").points[0][1], rail[1]),)))
    check = solve(loose, quantities=["graph_check"]).graph
    assert check is not None
    assert any(note.startswith("Rail 1 goes through no point of a link") for note in check.notes)
    assert "Link 3 is not determined by the drawing." in check.notes


# ---- what is asked for, and when it cannot be had


def test_not_asked_for_is_not_computed() -> None:
    run = solve("31", quantities=["table"])
    assert run.graph is None
    assert "graph_check" not in run.scene.ledger.calls


def test_what_is_missing_is_said() -> None:
    variant = load("31")
    bare = replace(at_row(variant, None), links=())
    with pytest.raises(InputError, match=r"needs \[links\]; this variant has none"):
        _ = solve(bare, quantities=["graph_check"]).graph
    with pytest.raises(InputError, match="links of constant length; AO changes"):
        _ = solve("variable-crank", quantities=["graph_check"]).graph
    assert solve(variant, end=0.04, quantities=["graph_check"]).graph is None  # the table ends before row 4
    with pytest.raises(InputError, match="ask for the whole table"):
        _ = solve(variant, quantities=["w3", "graph_check"]).graph


def test_a_motion_that_stops_before_the_row_has_no_check() -> None:
    variant = load("31")
    phase = replace(variant, given=tuple(replace(g, value=0.02) if g.name == "alpha" else g for g in variant.given))
    assert solve(at_row(phase, 7), quantities=["graph_check"]).graph is None  # the dead point is at 0.1169 s, row 6.8
    assert solve(at_row(phase, 4), quantities=["graph_check"]).graph is not None


# ---- the drawing

SVG = "{http://www.w3.org/2000/svg}"


def elements(svg: str, tag: str, key: str) -> list[ElementTree.Element]:
    return [item for item in ElementTree.fromstring(svg).iter(SVG + tag) if item.get(key) is not None]


def length(line: ElementTree.Element) -> float:
    return math.hypot(*(float(line.get(f"{axis}2", "")) - float(line.get(f"{axis}1", "")) for axis in "xy"))


def test_the_bar_measures_100_mm_and_the_sheet_is_in_mm() -> None:
    for name in ("31", "v101", "v102"):
        svg = svg_of(name)
        (bar,) = elements(svg, "line", "data-bar")
        assert length(bar) == 100
        root = ElementTree.fromstring(svg)
        width, height = (float(root.get(side, "").removesuffix("mm")) for side in ("width", "height"))
        assert root.get("viewBox") == f"0 0 {root.get('width', '')[:-2]} {root.get('height', '')[:-2]}"
        assert (width <= PAGE[0] and height <= PAGE[1]) or (width <= LANDSCAPE[0] and height <= LANDSCAPE[1])
        assert "must measure 100 mm; print at 100 %" in svg


def test_links_are_drawn_in_the_scale_of_the_coursework() -> None:
    svg = svg_of("31")
    drawn = {(line.get("data-from"), line.get("data-to")): length(line) for line in elements(svg, "line", "data-from")}
    expected = {("D", "A"): 95.3, ("A", "B"): 84.7, ("M", "B"): 91.4, ("B", "C"): 45.7}
    assert drawn == pytest.approx(expected, abs=2e-4)
    (wheel,) = elements(svg, "circle", "data-link")
    assert float(wheel.get("r", "")) == pytest.approx(22.85, abs=1e-4)
    assert "scale 1:10" in svg and "1 mm = 0.1 m/s" in svg


@pytest.mark.parametrize("name", ["31", *map(str.lower, DRAWABLE)])
def test_the_drawing_is_similar_to_the_mechanism(name: str) -> None:
    check = check_of(name)
    at = check.sketch.pose.positions
    for line in elements(svg_of(name), "line", "data-from"):
        metres = abs(at[line.get("data-from", "")] - at[line.get("data-to", "")])
        assert length(line) * check.scale / 1000 == pytest.approx(metres, abs=2e-7 * check.scale)
    layout = lay_out(check.sketch, check.findings)
    for arrow in elements(svg_of(name), "line", "data-velocity"):
        # The shaft ends where the head begins, 2.6 mm before the tip, earlier on short ones.
        whole = abs(check.findings.velocities[arrow.get("data-velocity", "")]) / layout.speed
        assert length(arrow) == pytest.approx(whole - min(2.6, 0.6 * whole), abs=2e-3)


def numbers(svg: str) -> list[tuple[float, float]]:
    root = ElementTree.fromstring(svg)
    found = [(float(i.get(f"x{k}", "")), float(i.get(f"y{k}", ""))) for i in root.iter(SVG + "line") for k in "12"]
    found += [(float(i.get("x", "")), float(i.get("y", ""))) for i in root.iter(SVG + "text")]
    for path in root.iter(SVG + "path"):
        found += [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", path.get("d", ""))]
    return found


@pytest.mark.parametrize("name", ["31", *map(str.lower, DRAWABLE)])
def test_nothing_leaves_the_sheet(name: str) -> None:
    check = check_of(name)
    layout = lay_out(check.sketch, check.findings)
    for x, y in numbers(svg_of(name)):
        assert -2 <= x <= layout.width + 2 and -2 <= y <= layout.height + 2


def test_a_wide_mechanism_lies_on_a_page_of_its_own_and_is_never_turned() -> None:
    layout = lay_out(check_of("31").sketch, check_of("31").findings)
    assert (layout.wide, layout.scale) == (True, 10)
    assert check_of("31").drawing().wide
    assert layout.width <= LANDSCAPE[0]
    assert layout.height <= LANDSCAPE[1]
    assert not check_of("v101").drawing().wide
    assert "rotate" not in svg_of("31")


def test_a_far_centre_is_told_at_the_border() -> None:
    text = unescape("".join(ElementTree.fromstring(svg_of("31")).itertext()))
    assert "P2\u00a0(0.003; −0.891) m" in text
    assert lay_out(check_of("31").sketch, check_of("31").findings).near == {"3"}


@pytest.mark.parametrize("name", ["31", "v107", "v112"])
def test_every_arrow_to_a_far_centre_bears_its_name(name: str) -> None:
    check = check_of(name)
    layout = lay_out(check.sketch, check.findings)
    words = [
        unescape("".join(text.itertext())) for text in ElementTree.fromstring(svg_of(name)).iter() if text.tag.endswith("text")
    ]
    far = {link: c for link, c in check.findings.centres.items() if c.at is not None and c.lines and link not in layout.near}
    assert far
    for link, centre in far.items():
        assert sum(word.startswith(f"P{link}") for word in words) == len(centre.lines)


def test_a_fixed_circle_stays_on_the_sheet_though_the_wheel_has_drifted() -> None:
    """In row 12 of v108 the contact stands 14 mm off a circle of 574 mm; its middle, hatch and name are there all the same."""
    svg, layout = svg_of("v108"), lay_out(check_of("v108").sketch, check_of("v108").findings)
    check = check_of("v108")
    middle = layout.put(check.sketch.pose.positions["O"])
    assert 0 < middle.real < layout.width and 0 < middle.imag < layout.height
    assert ">O</text>" in svg
    (arc,) = [path for path in re.findall(r'd="M([^"]*)"', svg) if path.count("L") > 20 and "M" not in path]
    places = [complex(*map(float, pair.split())) for pair in arc.split("L")]
    assert {round(abs(place - middle) * layout.scale) for place in places} == {574}


def test_scales_are_those_of_drawing_standards() -> None:
    assert {1.0, 2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 50.0, 100.0, 0.5, 0.2} <= set(SCALES)
    sketch, findings = sketch_of("31"), check_of("31").findings
    for factor, scale in ((0.001, 0.01), (0.1, 1.0), (10.0, 100.0), (1e5, 1e6)):
        larger = {name: at * factor for name, at in sketch.pose.positions.items()}
        assert lay_out(replace(sketch, pose=replace(sketch.pose, positions=larger)), findings).scale == scale


def test_the_drawing_is_the_same_every_time() -> None:
    run = run_of("31")
    fresh = check_graph(run.scene.mechanism, run.scene.equations, run.motion, run.exact)
    assert fresh is not None
    assert fresh.drawing().svg == svg_of("31")


def test_names_cannot_break_out_of_the_drawing() -> None:
    run, evil = run_of("31"), '"><script>alert(1)</script>&\x01\u202e' + 30 * "3"
    links = tuple(replace(link, name=evil) if link.name == "3" else link for link in run.variant.links)
    equations = replace(run.scene.equations, variant=replace(run.variant, links=links))
    check = check_graph(run.scene.mechanism, equations, run.motion, run.exact)
    assert check is not None
    svg = check.drawing().svg
    assert "&lt;script&gt;" in svg and "<script" not in svg
    assert not any(item.tag.endswith("script") for item in ElementTree.fromstring(svg).iter())
    assert "\x01" not in svg and "\u202e" not in svg


def test_a_file_may_call_its_points_like_centres() -> None:
    variant = load("31")
    sketch = sketch_of("31")
    taken = replace(sketch, pose=replace(sketch.pose, positions={**sketch.pose.positions, "P3": 0j}))
    from coursework.plans.graph_words import centre_letter, how_found

    assert (centre_letter(sketch), centre_letter(taken)) == ("P", "I")
    assert "I₃ is where the perpendiculars to the velocities of M and C meet." in how_found(taken, check_of("31").findings)
    assert variant.links[2] == Link("3", ("M", "B", "C"), "w3", None, None)


def test_a_mechanism_without_size_is_drawn_all_the_same() -> None:
    points = {"A": 0j, "B": 0j}
    still = scene(points, [Body("1", ("A", "B"))], fixed="A")
    full = check_of("31").sketch
    drawn = replace(full.outline, bars=(), wheels=(), rails=(), hinges=(), driven=()), full.poses, full.row
    sketch = Sketch(still, (), (), ("A",), (Link("1", ("A", "B"), None, None, None),), points, {}, {}, ("B",), (), *drawn)
    nothing = Findings({}, {}, {}, {}, ("1",))
    from coursework.plans.drawing import draw

    assert lay_out(sketch, nothing).scale == 1
    assert "velocities" not in draw(sketch, nothing, 1, 0.0).svg


def test_the_bar_measures_100_mm_in_the_pdf(tmp_path: Path) -> None:
    import pymupdf

    from coursework import write_report

    write_report(run_of("31"), tmp_path / "report.pdf")
    with pymupdf.open(tmp_path / "report.pdf") as document:
        bars = [
            drawn["rect"]
            for page in document
            for drawn in page.get_drawings()
            if drawn.get("color") and drawn["color"] == pytest.approx((1 / 255,) * 3, abs=1e-3)
        ]
    assert len(bars) == 1
    assert max(bars[0].width, bars[0].height) / 72 * 25.4 == pytest.approx(100, abs=0.05)


def test_the_blank_sheet_is_an_option(tmp_path: Path) -> None:
    from click.testing import CliRunner

    from coursework.cli import main

    asked = ["run", "31", "--blank", "--quantities", "graph_check", "--format", "html", "--out", str(tmp_path)]
    assert CliRunner().invoke(main, asked).exit_code == 0
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Construct the centres and velocities here." in page
    assert "V_M/P" not in page
    assert 'stroke-dasharray="2.4 1 0.4 1"' not in page
