"""What is looked for is told with what it is, what drifts by the student's own letters, a limit by which side of it passes."""

from types import ModuleType

import pytest

import coursework
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import on_axes, spelled
from tests.mechanisms.library import mechanism
from tests.report.made import solved

CRANK = mechanism("crank")


def statement(real: ModuleType, variant: object) -> str:
    run = coursework.solve(variant, quantities=("table", "checks"))
    return str(real.text_of(real.parts(run, "statement"))).replace("\u00a0", " ").replace("\u202f", "")


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("oscillating-cylinder", "ω3 and u = ds/dt from"),
        ("v112", "ω4 and u = VCx from"),  # the rack runs on its rail
        ("v110", "uC = VCx and uA = VA from"),  # the guide of A is inclined
        ("cardan", "ω2 and u = VEx from"),  # no guide: the pin of the wheel runs on a diameter
        ("v101", "ω1, ω2, ω3 and ω4 from"),  # an angular velocity stands beside its link
    ],
)
def test_a_linear_velocity_is_told_with_what_moves_so(real: ModuleType, name: str, told: str) -> None:
    assert told in statement(real, name)


def test_of_two_points_with_one_velocity_that_of_the_file_is_told(real: ModuleType) -> None:
    """B and D of the lift rise alike; the file says of = "B"."""
    text = mechanism("scissor")
    assert "h = VBy and" in statement(real, coursework.parse_variant(text))
    assert "h = VDy and" in statement(real, coursework.parse_variant(text.replace('of = "B"', 'of = "D"')))


def test_a_drive_in_degrees_per_second_is_written_so(real: ModuleType) -> None:
    told = statement(real, coursework.parse_variant(mechanism("roberts")))
    assert "20°/s from t = 0 s; −40°/s from t = 0.4 s; 20°/s from" in told
    one = mechanism("roberts", w1="-20 deg/s")
    assert "ω₁ = −20°/s" in statement(real, coursework.parse_variant(one))


@pytest.mark.parametrize("name", ["v110", "v112"])
def test_the_velocity_of_a_point_has_it_as_its_index(real: ModuleType, name: str) -> None:
    """V_A: as one word it would be the segment VA."""
    run = coursework.solve(name, quantities=("table", "checks"))
    assert str({"v": "V", "s": {"v110": "A", "v112": "Cx"}[name]}) in str(real.parts(run, "statement"))


@pytest.mark.parametrize(("asked", "told"), [("u", "and u from"), ("table", "and u = VCy from")])
def test_what_is_not_asked_for_is_not_computed_to_tell_it(real: ModuleType, asked: str, told: str) -> None:
    run = coursework.solve("v102", quantities=(asked,))
    assert told in str(real.text_of(real.parts(run, "statement"))).replace("\u00a0", " ")
    assert "exact" not in run.scene.ledger.calls


def test_nothing_is_looked_for_where_the_drive_gives_all(real: ModuleType) -> None:
    told = statement(real, coursework.parse_variant(CRANK))
    assert "There is nothing to solve for: the drive gives every velocity, from t = 0 to 1 s" in told


def test_a_velocity_has_no_name_that_a_datum_has(real: ModuleType) -> None:
    text = coursework.load("v112").path.read_text(encoding="utf-8").replace("[given]\n", '[given]\nVCx = "1 m/s"\n')
    assert "ω4 and u = VC from" in statement(real, coursework.parse_variant(text))


@pytest.mark.parametrize(
    ("name", "rider", "point"),
    [("example-5", "D", "K"), ("v110", "A", "K"), ("prp", "C", ""), ("v110", "C", ""), ("engine-start", "C", "")],
)
def test_the_point_that_a_guide_leads_through_is_told(real: ModuleType, name: str, rider: str, point: str) -> None:
    """K is drawn and dimensioned; the guide of prp is moved aside, the others are given by their rider alone."""
    told = f"The guide of {rider} passes through"
    assert (f"{told} {point}." in statement(real, name)) if point else (told not in statement(real, name))


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("(E - A - r2 @ phi2).x", "E.x - A.x - r2*cos(phi2)"),
        ("(E - (a, b) - r2 @ phi2).y", "E.y - b - r2*sin(phi2)"),
        ("(R0 - R)*phi1 + R*psi2", "(R0 - R)*phi1 + R*psi2"),
        ("2*(C - 3*A).y", "2*(C.y - (3*A).y)"),
        ("-C.x*sin(b) + C.y*cos(b)", "-C.x*sin(b) + C.y*cos(b)"),
        ("C.y - (-A).x/2", "C.y - -A.x/2"),
    ],
)
def test_a_part_of_a_sum_is_a_sum_of_parts(written: str, told: str) -> None:
    assert spelled(on_axes(parse(written, vectors=True))) == told


def test_what_drifts_is_told_as_the_student_writes_it(real: ModuleType) -> None:
    run = solved("v112", quantities=("table", "checks"))
    finding = next(check for check in run.checks if check.code == "DRIFT")
    assert finding.sentence.startswith("E.y - A.y - r2*sin(phi2) is ")
    shown = real.text_of(real.parts(run, "checks"))
    assert "xE − xA − r2·cos\u202fφ2: largest" in shown
    assert "1 of [closure]" not in shown


@pytest.mark.parametrize(("name", "told"), [("example-5", True), ("example-4", False)])
def test_a_datum_called_as_the_step_is_told_apart_from_it(real: ModuleType, name: str, told: bool) -> None:
    assert ("h is a time, it is this step" in statement(real, coursework.load(name))) == told


@pytest.mark.parametrize(("end", "is_told"), [(0.06, True), (0.04, False)])
def test_a_row_beyond_the_last_is_not_said_to_be_checked(real: ModuleType, end: float, is_told: bool) -> None:
    run = solved("31", end=end, quantities=["table", "graph_check"])
    assert ("is checked by construction" in real.text_of(real.parts(run, "statement"))) is is_told


@pytest.mark.parametrize(("row", "drawn"), [("20", True), ("1", False)])
def test_a_row_of_which_there_is_no_drawing_is_not_said_to_be_checked_by_one(real: ModuleType, row: str, drawn: bool) -> None:
    """In row 1 the boom rests, so nothing can be read off a drawing; the section of the check says so."""
    text = mechanism("boom", ("check_row = 20", f"check_row = {row}"))
    run = coursework.solve(coursework.parse_variant(text), quantities=("table", "graph_check"))
    assert ("checked by construction" in real.text_of(real.parts(run, "statement"))) is drawn
    assert ("the row of the graph-analytical check" in real.text_of(real.parts(run, "results"))) is drawn
