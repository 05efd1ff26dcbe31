"""A dyad of two links with its forces, read back from the sheet: true lengths, directions, tip to tail, the inner reaction."""

import numpy as np
import pytest

from coursework.drawing.force_plans.group_sheet import ARROW, Figure, draw_group, scale_of
from coursework.drawing.force_plans.vectors import FOUND, KNOWN, ForceVector, GroupPlan
from coursework.takeaway.figures.shapes import Arrow, Chain, Circle, shapes_of
from coursework.words.sentences import load_phrases
from tests.drawing import measured

# Row 1 (from 0) is drawn.  Link 2 from A to B, link 3 from B to C; forces in newtons, their sum is zero.
FIGURE = Figure(((("A", 0j), ("B", 0.3 + 0.4j)), (("B", 0.3 + 0.4j), ("C", 0.9 + 0.4j))), 1, 0.05)
FORCES = {
    "R12t": (-30 + 40j, "2", 0j),
    "F2": (60 - 10j, "2", 0.15 + 0.2j),
    "F3": (0 - 50j, "3", 0.6 + 0.4j),
    "R03": (-30 + 20j, "3", 0.9 + 0.4j),
}


def plan(forces=FORCES, inner=("R23", None)):
    vectors = tuple(
        ForceVector(
            name, (name[0], name[1:], ""), body, np.array([99j, force]), np.array([7j, at]), KNOWN if name[0] == "F" else FOUND
        )
        for name, (force, body, at) in forces.items()
    )
    return GroupPlan(("2", "3"), vectors, (), inner)


def read(given, figure=FIGURE):
    """Return the arrows beside the group and of the polygon by name, and the other shapes, in mm, y up."""
    drawing = draw_group(given, figure, 4, load_phrases("en").written)
    shapes = list(shapes_of(drawing.svg, drawing.height))
    arrows = [one for one in shapes if isinstance(one, Arrow)]
    beside = {one.pen.data["force"]: one for one in arrows if "force" in one.pen.data}
    polygon = {one.pen.data["name"]: one for one in arrows if "plan" in one.pen.data}
    return drawing, beside, polygon, [one for one in shapes if not isinstance(one, Arrow)]


def way(arrow):
    return arrow.points[0] - arrow.points[-1]


def test_forces_are_true_to_scale_one_behind_the_other_in_the_order_of_the_plan():
    """60.8 N within 80 mm: 1 N a mm."""
    assert scale_of(plan(), 1) == 1.0 and scale_of(plan({"F2": (81.0 + 0j, "2", 0j)}), 1) == 2.0 and scale_of(plan(), 0) == 5.0
    drawing, _, polygon, _ = read(plan())
    assert list(polygon) == list(FORCES)
    for name, (force, _, _) in FORCES.items():
        assert way(polygon[name]) == pytest.approx(force, abs=0.03)
        assert polygon[name].head == pytest.approx(min(2.6, 0.6 * abs(force)), abs=0.02)
    tips = [one.points[0] for one in polygon.values()]
    tails = [one.points[-1] for one in polygon.values()]
    assert tails == pytest.approx([tips[-1], *tips[:-1]], abs=0.03)  # the last tip is the first tail: the sum is zero
    assert all(0 <= tip.real <= drawing.width and 0 <= tip.imag <= drawing.height for tip in (*tips, *tails))
    assert (drawing.id, drawing.exact) == ("forces-4", True)
    assert "row 2, t = 0.05 s" in {word.text.replace("\u00a0", " ") for word in measured.words(drawing.svg)}
    assert "row 2" in drawing.caption and "row 2" in drawing.alt


def test_beside_the_group_each_force_has_its_direction_at_its_place():
    _, beside, _, others = read(plan())
    pins = [one.middle for one in others if isinstance(one, Circle) and one.radius == pytest.approx(0.9)]
    links = [one.points for one in others if isinstance(one, Chain) and one.pen.width == pytest.approx(0.7)]
    assert len(pins) == 3 and len(links) == 2
    a, b, c = pins
    scale = abs(b - a) / 0.5
    assert (c - b, b - a) == (pytest.approx(0.6 * scale, abs=0.03), pytest.approx((0.3 + 0.4j) * scale, abs=0.03))
    assert [abs(last - first) for first, last in links] == pytest.approx([0.5 * scale, 0.6 * scale], abs=0.03)
    for name, (force, _, at) in FORCES.items():
        assert way(beside[name]) == pytest.approx(ARROW * force / abs(force), abs=0.03)
        assert beside[name].points[-1] == pytest.approx(a + at * scale, abs=0.05)


def test_arrows_that_would_end_in_one_place_are_of_two_lengths_and_what_is_too_short_is_left_out():
    forces = FORCES | {"G2": (90 - 15j, "2", 0.15 + 0.2j), "tiny": (0.39 + 0j, "3", 0j), "seen": (0.81 + 0j, "3", 0j)}
    _, beside, polygon, _ = read(plan(forces))  # 91 N: 2 N a mm
    assert abs(way(beside["G2"])) == pytest.approx(ARROW + 3.5, abs=0.03) and abs(way(beside["F2"])) == pytest.approx(
        ARROW, abs=0.03
    )
    assert "tiny" not in polygon and "tiny" not in beside and "seen" in polygon


@pytest.mark.parametrize(("order", "chord"), [
    (("R12t", "F2", "F3", "R03"), ("R12t", "F2")), (("F2", "F3", "R03", "R12t"), ("R12t", "F2")),
    (("F3", "R03", "R12t", "F2"), None), (("F3", "R03"), None),
])  # fmt: skip
def test_the_inner_reaction_lies_across_what_acts_on_the_first_link(order, chord):
    """From where the forces on link 2 begin to where they end."""
    _, _, polygon, others = read(plan({name: FORCES[name] for name in order}))
    chords = [one.points for one in others if isinstance(one, Chain) and "chord" in one.pen.data]
    wanted = (
        [(polygon[chord[0]].points[-1], polygon[chord[1]].points[0])] if chord else []
    )  # those behind all others end where all begin
    assert chords == [pytest.approx(ends, abs=0.03) for ends in wanted]
    assert not any("chord" in one.pen.data for one in read(plan(inner=None))[3])


def test_a_link_of_three_points_is_a_triangle():
    triangle = Figure(((("A", 0j), ("B", 0.3 + 0j), ("C", 0.3j)),), 1, 0.0)
    _, _, _, others = read(plan({"F2": FORCES["F2"]}, None), triangle)
    lines = [one for one in others if isinstance(one, Chain) and one.pen.width == pytest.approx(0.7)]
    assert len(lines) == 3


@pytest.mark.parametrize("factor", [1.0, 0.2])
def test_group_and_polygon_stand_in_the_middle_of_a_sheet_with_room_for_words(factor):
    """8 mm around the polygon, 6 mm around the joints of the group, 5 mm around the tips of forces; edges: 2, foot: 17."""
    drawing, beside, polygon, others = read(plan(FORCES | {"R12t": (factor * (-30 + 40j), "2", 0j)}))
    ends = [end for one in polygon.values() for end in one.points]
    sheet = drawing.height - 17.0
    spans = []
    for circles in (
        [(end, 8.0) for end in ends],
        [(one.middle, 6.0) for one in others if isinstance(one, Circle) and one.radius == pytest.approx(0.9)]
        + [(one.points[0], 5.0) for one in beside.values()],
    ):
        low, high = (min(at.imag - room for at, room in circles), max(at.imag + room for at, room in circles))
        assert low + high == pytest.approx(2 * 17.0 + sheet, abs=0.05)
        spans.append(high - low)
    assert max(spans) == pytest.approx(sheet - 4.0, abs=0.05)
    assert max(end.real for end in ends) + 8.0 == pytest.approx(drawing.width - 2.0, abs=0.03)
    assert min(one.middle.real for one in others if isinstance(one, Circle)) > 2.0 + 6.0 - 0.03
