"""What each shape of a sheet becomes in DXF: entity, layer, weight, dashes, in numbers of the sheet."""

import math

import pytest

from coursework.takeaway.figures.drafting import Draft
from coursework.takeaway.figures.shapes import Arrow, Chain, Circle, Hatching, Pen, Words

BODY = (0j, 10 + 0j, 10 + 5j, 5j)


def drawn(shape):
    draft = Draft(210.0, 297.0)
    draft.draw(shape)
    return list(draft.space), draft


def pen(width=0.35, dashes=(), **data):
    return Pen(width, tuple(dashes), data)


def chain(width=0.35, points=2, closed=False, fill="", dashes=()):
    return Chain(BODY[:points], closed, fill, pen(width, dashes))


@pytest.mark.parametrize(("shape", "layer"), [
    (chain(0.19), "dimensions"), (chain(0.2), "links"), (chain(0.21), "ground"), (chain(0.49), "ground"), (chain(0.5), "joints"),
    (chain(0.59), "joints"), (chain(0.6), "links"), (chain(0.9, dashes=(2.0, 1.0)), "construction"),
    (chain(0.35, 4, True, "grey"), "links"), (chain(0.35, 3, True, "black"), "ground"), (chain(0.35, 4, True, "black"), "joints"),
    (Circle(0j, 1.2, "", pen()), "joints"), (Circle(0j, 1.21, "", pen()), "links"),
    (Circle(0j, 9.0, "", pen(0.35, (1.0, 1.0))), "construction"),
    (Arrow((0j, 9j), 2.0, pen(0.2)), "dimensions"), (Arrow((0j, 9j), 2.0, pen(0.21)), "velocities"),
    (Hatching((0j,), 1 + 1j, pen()), "ground"),
    (Words(0j, (("a", 3.0, 0.0),), 3.0, False, False, pen()), "text"),
])  # fmt: skip
def test_a_shape_is_on_the_layer_of_its_pen_and_kind(shape, layer):
    assert {entity.dxf.layer for entity in drawn(shape)[0]} == {layer}


@pytest.mark.parametrize(("shape", "kinds"), [
    (chain(), ["LINE"]), (chain(points=3), ["LWPOLYLINE"]), (chain(0.0), []),
    (chain(0.35, 4, True, "black"), ["HATCH", "LWPOLYLINE"]),
    (chain(0.0, 4, True, "grey"), ["HATCH"]), (chain(0.35, 4, True, "white"), ["WIPEOUT", "LWPOLYLINE"]),
    (chain(0.35, 4, False, "black"), ["LWPOLYLINE"]),
    (Circle(0j, 1.0, "", pen()), ["CIRCLE"]), (Circle(0j, 1.0, "black", pen()), ["HATCH", "CIRCLE"]),
    (Circle(0j, 1.0, "white", pen()), ["WIPEOUT", "CIRCLE"]), (Arrow((0j, 9j), 2.0, pen()), ["LEADER"]),
    (Hatching((0j, 1 + 0j), 1j, pen()), ["HATCH"]),
])  # fmt: skip
def test_a_shape_is_drawn_with_what_fills_or_covers_it(shape, kinds):
    assert [entity.dxftype() for entity in drawn(shape)[0]] == kinds


def test_what_a_drawing_says_that_a_line_is_comes_before_how_it_looks():
    for name, layer in (
        ("slot", "links"),
        ("sleeve", "joints"),
        ("rail", "ground"),
        ("plan", "velocities"),
        ("bar", "dimensions"),
    ):
        assert drawn(Chain(BODY[:2], False, "", pen(0.1, (1.0, 1.0), **{name: ""})))[0][0].dxf.layer == layer


def test_lines_have_places_weight_and_dashes():
    (line,), draft = drawn(chain(0.42, dashes=(2.4, 1.2, 0.5, 1.2)))
    assert (tuple(line.dxf.start), tuple(line.dxf.end), line.dxf.lineweight) == ((0, 0, 0), (10, 0, 0), 40)
    assert line.dxf.linetype == "DASH_24_12_05_12"
    lengths = [tag.value for tag in draft.document.linetypes.get("DASH_24_12_05_12").pattern_tags.tags if tag.code == 49]
    assert lengths == [2.4, -1.2, 0.5, -1.2]
    assert [drawn(chain(width))[0][0].dxf.lineweight for width in (0.01, 0.024, 0.03, 0.56, 0.57, 3.0)] == [0, 0, 5, 53, 60, 100]
    (closed,), _ = drawn(chain(0.35, 4, True))
    (open_,), _ = drawn(chain(0.35, 4))
    assert (closed.closed, open_.closed) == (True, False)
    assert [tuple(point[:2]) for point in closed.get_points()] == [(0, 0), (10, 0), (10, 5), (0, 5)]


def test_a_disc_covers_a_circle_and_a_hatch_of_a_colour_fills_it():
    (cover, circle), _ = drawn(Circle(3 + 4j, 2.0, "white", pen()))
    assert (tuple(circle.dxf.center), circle.dxf.radius) == ((3, 4, 0), 2.0)
    corners = [complex(corner.x, corner.y) for corner in cover.boundary_path_wcs()]
    assert len(corners) >= 24 and max(abs(abs(corner - (3 + 4j)) - 2.0) for corner in corners) < 1e-6
    colours = [drawn(chain(0.0, 4, True, fill))[0][0].dxf.color for fill in ("black", "grey")]
    assert colours == [7, 9]


@pytest.mark.parametrize(("begins", "step"), [((0j, 2 + 0j, 4 + 0j), 2 + 0j), ((0j,), -1 + 1j)])
def test_hatching_begins_where_its_strokes_do_and_leans_as_they_do(begins, step):
    lean = 1 + 1j
    (hatch,), _ = drawn(Hatching(begins, lean, pen()))
    (line,) = hatch.pattern.lines
    assert (line.angle, complex(line.base_point.x, line.base_point.y), complex(line.offset.x, line.offset.y)) == (
        45.0,
        begins[0],
        pytest.approx(step),
    )
    border = [complex(corner[0], corner[1]) for corner in hatch.paths.paths[0].vertices]
    first, last = begins[0] - step / 2, begins[-1] + step / 2
    assert border == pytest.approx([first, last, last + lean, first + lean])


def test_words_stand_on_their_base_line_in_their_face_and_indices_are_lower():
    (text,), _ = drawn(Words(5 + 6j, (("v", 4.0, 0.0), ("A", 3.0, 1.0)), 4.0, True, False, pen()))
    assert text.dxf.char_height == pytest.approx(4 * 0.729)
    assert tuple(text.dxf.insert) == pytest.approx((5, 6 + 4 * 0.729, 0))
    assert text.text.startswith("\\fArial|b0|i1;v") and "A" in text.text
    (plain,), _ = drawn(Words(0j, (("a{b", 4.0, 0.0), ("c", 4.0, 1.0), ("d", 3.0, 0.0)), 4.0, False, False, pen()))
    assert plain.text == "a\\{bcd"
    (bold,), _ = drawn(Words(0j, (("a", 4.0, 0.0),), 4.0, False, True, pen()))
    assert bold.text == "\\fArial|b1|i0;a"


def test_an_arrow_is_a_leader_from_its_tip_with_a_head_of_its_size():
    (leader,), _ = drawn(Arrow((0j, 9j, 9 + 9j), 2.5, pen(0.5)))
    assert [tuple(point)[:2] for point in leader.vertices] == [(0, 0), (0, 9), (9, 9)]
    assert leader.dxf.lineweight == 50


def test_a_sheet_has_its_size_in_millimetres_and_no_other_shape():
    draft = Draft(210.0, 297.0)
    assert tuple(draft.document.header["$LIMMAX"]) == (210.0, 297.0) and draft.document.units == 4
    assert tuple(draft.document.header["$EXTMIN"]) == (0, 0, 0) and tuple(draft.document.header["$EXTMAX"]) == (210.0, 297.0, 0)
    with pytest.raises(TypeError):
        draft.draw("circle")
    assert math.isclose(drawn(chain(points=2))[0][0].dxf.end[0], 10.0)
