"""The rules of the construction, one by one, on scenes of a few points."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest

from coursework import load, parse_variant, solve
from coursework.drawing.check_sheet.drawing import place
from coursework.drawing.check_sheet.instant_centres import Centre, construct
from coursework.drawing.check_sheet.sketch import Body
from coursework.drawing.paper.symbols import powers
from coursework.words.sentences import load_phrases
from tests.drawing.check_sheet.checked import scene
from tests.report.own import BOOM


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


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("sine", "across"), [(0.98e-9, True), (1.02e-9, False)])
def test_velocities_across_the_line_of_their_points_have_no_centre_by_them(size: float, sine: float, across: bool) -> None:
    """The directions are parallel, and across AB but for a sine: beyond a billionth, the centre is infinitely far away."""
    points = {"A": 0j, "B": size * complex(sine, 1)}
    found = construct(scene(points, [Body("1", ("A", "B"))], guided={"A": 1 + 0j, "B": 1 + 0j}))
    assert found.centres.get("1") == (None if across else Centre(None, ("A", "B")))


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
    assert found.planned == ("1", "2")


def test_a_dead_point_is_left_open() -> None:
    """Crank and rod in one line, the driven slider moving along it: no crank velocity can be drawn."""
    points = {"O": 0j, "A": 1 + 0j, "B": 3 + 0j}
    bodies = [Body("1", ("O", "A")), Body("2", ("A", "B"))]
    assert construct(scene(points, bodies, fixed="O", velocities={"B": 1 + 0j})).missing == ("1", "2")


def test_a_rail_through_no_point_of_a_link_is_reported() -> None:
    variant = load("v102")
    rail = variant.frame.rails[0]
    loose = replace(variant, frame=replace(variant.frame, rails=((load("31").points[0][1], rail[1]),)))
    check = solve(loose, quantities=["graph_check"]).graph_check
    assert check is not None
    assert any(note.startswith("Rail 1 goes through no point of a link") for note in check.notes)
    assert "Link 3 is not determined by the drawing." in check.notes


def test_what_is_at_rest_is_written_down_in_one_order_in_every_process() -> None:
    """The order of a set of names changes from process to process, and with it the last digit of what is solved."""
    names = "QAZMBKE"
    pose = scene({name: complex(k, k * k) for k, name in enumerate(names)}, [Body("1", tuple(names))], fixed=names)
    assert list(construct(pose).velocities) == sorted(names)


def test_a_driven_length_is_constructed() -> None:
    """The boom on a cylinder moves in row 20, and stands in row 1, where its speed begins as a sine."""
    run = solve(parse_variant(BOOM), quantities=("table", "graph_check"))
    check = run.graph_check
    assert check is not None and not check.unread and check.plan is not None
    assert any("as its length is driven" in step for step in check.sheets()[1].steps)
    values = {given.name: given.value for given in run.variant.given}
    boom = cmath.rect(values["c"], run.motion.column("phi")[19])
    along = boom - complex(values["xB"], values["yB"])
    push = values["v1"] * math.sin(values["p"] * run.motion.t[19])
    omega = push * abs(along) / (along.conjugate() * 1j * boom).real
    turning = (along.conjugate() * 1j * omega * boom).imag / abs(along) ** 2
    read = {one.name: one for one in check.readings}
    for name, expected in (("ω₁", omega), ("ω₂", turning), ("V_C", omega * abs(boom))):
        assert read[name].found == pytest.approx(abs(expected), rel=read[name].explained)
    still = solve(parse_variant(BOOM.replace("check_row = 20", "check_row = 1")), quantities=("table", "graph_check"))
    assert still.graph_check is not None and "nothing moves in that row" in still.graph_check.unread


def test_a_slider_that_no_pair_ties_to_the_drive_is_left_open() -> None:
    """K runs on its rail and hangs on nothing that the file shows: no plan is drawn with a K at rest."""
    bodies = [Body("1", ("O", "A")), Body("2", ("K",), guide=1 + 0j)]
    pose = scene({"O": 0j, "A": 1 + 1j, "K": 2 + 0j}, bodies, fixed="O", guided={"K": 1 + 0j}, velocities={"A": 1j - 1})
    assert construct(pose).missing == ("2",)


@pytest.mark.parametrize("size", [0.02, 250.0])
@pytest.mark.parametrize(("times", "is_told"), [(99.0, True), (-99.0, True), (101.0, False), (-101.0, False)])
def test_a_centre_farther_away_than_a_hundred_times_the_mechanism_is_at_infinity(
    size: float, times: float, is_told: bool
) -> None:
    body = Body("1", ("A", "B"))
    found = construct(scene({"A": 0j, "B": size + 0j}, [body], velocities={"A": 3j, "B": 3j * (1 - 1 / times)}))
    assert found.centres["1"].at == (pytest.approx(times * size) if is_told else None)
    assert found.omegas["1"] == pytest.approx(-3 / times / size)


def test_a_place_in_micrometres_is_written_with_a_power_of_ten() -> None:
    """Variant 31 a million times smaller: nobody counts the zeros of -0.000000891 m."""
    at = 3.14e-9 - 8.912e-7j
    assert powers(load_phrases("ru").written(place(at, 9))) == " (3·10⁻⁹; -8,91·10⁻⁷) м"
    assert str(place(1e6 * at, 3)) == " (0.003; -0.891) m" and str(place(at, 6)) == " (0; -0.000001) m"
