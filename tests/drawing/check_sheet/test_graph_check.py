"""The graph-analytical check: numbers of the coursework, centres of the reference, what is asked for."""

from __future__ import annotations

import cmath
import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

from coursework import load, parse_variant, solve
from coursework.drawing.check_sheet.instant_centres import construct
from coursework.drawing.check_sheet.sketch import Body, Pose, Slide, read_sketch
from coursework.drawing.outline.tracing import read_outline
from coursework.report.output.record import record
from coursework.words.errors import InputError
from tests.drawing import measured
from tests.drawing.check_sheet.checked import DRAWABLE, at_row, check_of, run_of, svg_of
from tests.mechanisms.library import mechanism

REFERENCE = Path(__file__).parents[2] / "reference" / "variants"
DIGITS_OF_THE_REFERENCE = 1e-9


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
    assert [row[0] for row in check.exact] == [row[0] for row in check.rows]
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
        "The scheme has drifted, so this row does not close: P stands 7.05 mm off its guide.",
    )


@pytest.mark.parametrize("name", DRAWABLE)
def test_centres_of_the_exact_row(name: str) -> None:
    reference = json.loads((REFERENCE / f"{name}.json").read_text())["icv_at_check_row_exact"]
    run = run_of(name.lower())
    sketch = read_sketch(run.scene.mechanism, read_outline(run.scene.mechanism), run.scene.equations, {})(
        run.exact, run.variant.time.check_row - 1
    )
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
    pose = Pose(at, (bar, sleeve, arm), frozenset({"K"}), {}, speeds, {"w3": -2.0}, (Slide("O", "1", 1 + 0j, "2"),))
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
    """Page 1.5 of the specification, worked by hand: lengths to 0.5 mm at 1:10; P₂ lies below the sheet and is computed."""
    read = {one.name: one for one in check_of("31").readings}
    assert {name: one.read for name, one in read.items()} == {
        "ω₃": 93.5, "V_B": 5.0, "V_C": 41.5, "ω₂": None, "V_A": None, "ω₁": None, "ω₄": None,
    }  # fmt: skip
    speed = abs(4.5 * math.sin(13.08 * 0.06 + 4.35))
    omega = speed / 0.935
    assert {name: one.computed for name, one in read.items() if one.computed} == {"ω₂": 187.0, "V_A": 184.5}
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
    # What is computed from a reading holds its tolerance: P₃M to 0.25 mm in 93.5, P₃B to 0.25 in 5, and so on.
    v_b, v_c = 0.25 / 93.5 + 0.25 / 5, 0.25 / 93.5 + 0.25 / 41.5
    worst = {"ω₃": 0.25 / 93.5, "V_B": v_b, "V_C": v_c, "ω₂": v_b + 0.25 / 187, "ω₄": v_c}
    worst["V_A"] = worst["ω₁"] = worst["ω₂"] + 0.25 / 184.5
    assert {name: one.explained for name, one in read.items()} == pytest.approx(worst)
    assert all(one.rests for one in read.values())
    assert (str(read["ω₃"].relation), str(read["V_C"].relation), str(read["ω₄"].relation)) == ("V_M/P₃M", "ω₃·P₃C", "V_C/PC")
    # The speed of a crank's pin is the product of two data: no reading, and nothing that a drawing checks.
    assert [one.rests for one in check_of("example-2").readings] == [False, True, True]


@pytest.mark.parametrize(
    "name",
    ["31", *(name.lower() for name in DRAWABLE), "v107", "homework", "jansen", "peaucellier", "example-1", "prp", "walschaerts"],
)
def test_every_reading_is_as_near_as_its_lengths_allow(name: str) -> None:
    """Errors of a ruler add up along the working: no value may be off by more than its tolerance, which adds them up."""
    readings = check_of(name).readings
    assert readings
    blurred = any(one.read is not None and one.read < 2 for one in readings)
    drift = 0.01 if name in {"v104", "v105", "v112"} else 0.0  # rows that do not close by this part of a link
    for one in readings:
        assert one.read is None or one.read % 0.5 == 0
        if not blurred and math.isfinite(one.table):
            assert abs(one.difference) <= one.explained * (1 + one.explained) + drift + 1e-12, one.name


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


@pytest.mark.long
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
    assert run.graph_check is not None
    assert (run.graph_check.row, run.graph_check.time) == (4, pytest.approx(0.06))


def test_the_record_of_a_run_has_what_was_read() -> None:
    found = record(run_of("31"))["graph_check"]
    assert (found["row"], found["time"], found["scale"]) == (4, pytest.approx(0.06), 10)
    assert set(found["rows"][0]) == {"name", "found", "read", "table", "unit"}
    assert found["centres"]["3"] == {
        "x": pytest.approx(check_of("31").findings.centres["3"].at.real),
        "y": pytest.approx(0.884, abs=1),
    }
    assert "graph_check" not in record(solve("31", quantities=["table"]))


def test_not_asked_for_is_not_computed() -> None:
    run = solve("31", quantities=["table"])
    assert run.graph_check is None
    assert "graph_check" not in run.scene.ledger.calls


def test_what_is_missing_is_said() -> None:
    variant = load("31")
    bare = replace(at_row(variant, None), links=())
    with pytest.raises(InputError, match=r"needs \[links\]; this variant has none"):
        _ = solve(bare, quantities=["graph_check"]).graph_check
    with pytest.raises(InputError, match="links of constant length; AO changes"):
        _ = solve("variable-crank", quantities=["graph_check"]).graph_check
    with pytest.raises(InputError, match=r"variable-crank.toml:57  .*links of constant length"):  # the line that asks for it
        _ = solve(replace(load("variable-crank"), ask=("graph_check",))).graph_check
    assert solve(variant, end=0.04, quantities=["graph_check"]).graph_check is None  # the table ends before row 4
    with pytest.raises(InputError, match="ask for the whole table"):
        _ = solve(variant, quantities=["w3", "graph_check"]).graph_check


def test_a_motion_that_stops_before_the_row_has_no_check() -> None:
    variant = load("31")
    phase = replace(variant, given=tuple(replace(g, value=0.02) if g.name == "alpha" else g for g in variant.given))
    assert solve(at_row(phase, 7), quantities=["graph_check"]).graph_check is None  # the dead point is at 0.1169 s, row 6.8
    last = solve(at_row(phase, 6), quantities=["graph_check"]).graph_check
    assert last is not None and [row[0] for row in last.exact] == [row[0] for row in last.rows]  # the motion itself is there, too


def test_a_velocity_is_read_from_the_pole_and_a_relative_one_between_two_images() -> None:
    read = {one.name: one.length for name in ("v107", "example-4", "prp") for one in check_of(name).readings if one.images}
    pole = "p_v\u00a0"
    wanted = {"V_A": f"{pole}a", "V_AB": "ba", "V_B": f"{pole}b", "V_O′": f"{pole}o′", "V_O′M": "mo′", "V_E": f"{pole}e"}
    wanted |= {"V_BB′": "b′b", "V_CC′": "c′c"}
    assert {name: read[name] for name in wanted} == wanted


def test_a_crank_whose_angle_counts_clockwise_is_constructed_as_it_turns() -> None:
    """By hand: the pin goes round clockwise at 40 pi/60 rad/s; rates are told as the file counts them."""
    text = mechanism("clockwise-four-bar", ('["table"]', '["table", "graph_check"]'))
    run = solve(parse_variant(text.replace("[[constraint]]", "check_row = 3\n[[constraint]]", 1)), "exact")
    check = run.graph_check
    turned = math.radians(30) + math.tau / 3 * 0.1
    assert check.findings.velocities["B"] == pytest.approx(-1j * 0.1 * math.tau / 3 * cmath.exp(-1j * turned), abs=1e-9)
    assert check.findings.omegas["1"] == pytest.approx(-math.tau / 3)
    assert {name for name, *_ in check.rows} >= {"ω₂", "ω₃", "V_C"}
    for name, drawn, tabled, off, _ in check.rows:
        assert off == pytest.approx(0.0, abs=1e-6), (name, drawn, tabled)
