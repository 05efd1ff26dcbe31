"""What the strokes of a drawing are to a drawing office; a sheet 100 mm high, whose y goes up."""

import pytest

from coursework.takeaway.figures.shapes import Arrow, Chain, Circle, Hatching, Words, shapes_of

NS = 'xmlns="http://www.w3.org/2000/svg"'


def shapes(inside):
    return list(shapes_of(f"<svg {NS}>{inside}</svg>", 100.0))


@pytest.mark.parametrize(("way", "chains"), [
    ("M1 2l3 4", [((1 + 98j, 4 + 94j), False)]), ("M1 2l3 4 -1 -1", [((1 + 98j, 4 + 94j, 3 + 95j), False)]),
    ("M1 2 5 2Z", [((1 + 98j, 5 + 98j), True)]), ("M1 2 5 2Zl1 1", [((1 + 98j, 5 + 98j), True), ((1 + 98j, 2 + 97j), False)]),
    ("M1 2l1 0M5 6l0 1e-1", [((1 + 98j, 2 + 98j), False), ((5 + 94j, 5 + 93.9j), False)]),
    ("M1 2l1 0m5 6l1 1", [((1 + 98j, 2 + 98j), False), ((7 + 92j, 8 + 91j), False)]), ("M1 2", []),
    ("m1 2l1 0", [((1 + 98j, 2 + 98j), False)]),
])  # fmt: skip
def test_a_path_is_chains_of_points(way, chains):
    found = shapes(f'<path d="{way}" fill="none"/>')
    if way.startswith("m"):
        assert found == [Hatching((1 + 98j,), 1 + 0j, found[0].pen)]
    else:
        assert [(one.points, one.closed) for one in found] == [(pytest.approx(points), closed) for points, closed in chains]


@pytest.mark.parametrize(("given", "width", "dashes", "data"), [
    ('stroke="black" stroke-width="0.5" stroke-dasharray="2.4 1.2"', 0.5, (2.4, 1.2), {}), ('stroke-width="0.5"', 0.0, (), {}),
    ('stroke="white" stroke-width="0.5"', 0.0, (), {}), ('stroke="none" stroke-width="0.5"', 0.0, (), {}),
    ('stroke="black"', 0.0, (), {}),
    ('data-link="3" class="x" data-bar="100"', 0.0, (), {"link": "3", "bar": "100"}),
])  # fmt: skip
def test_a_pen_has_the_width_of_what_is_seen_and_says_what_it_draws(given, width, dashes, data):
    (found,) = shapes(f'<line x1="1" y1="2" x2="3" {given}/>')
    assert (found.points, found.closed, found.fill) == ((1 + 98j, 3 + 100j), False, "")
    assert (found.pen.width, found.pen.dashes, found.pen.data) == (width, dashes, data)


@pytest.mark.parametrize(("given", "fill"), [
    ("", "black"), ('fill="none"', ""), ('fill="none" stroke="white"', "white"), ('fill="white"', "white"),
    ('fill="#888"', "grey"),
])  # fmt: skip
def test_a_fill_is_white_black_or_grey(given, fill):
    (found,) = shapes(f'<circle cx="1" cy="2" r="3" {given}/>')
    assert found == Circle(1 + 98j, 3.0, fill, found.pen)


def test_a_white_band_covers_its_own_width_whichever_way_it_runs():
    for far, corners in (("4 0", (1 + 97j, 5 + 97j, 5 + 99j, 1 + 99j)), ("0 -4", (2 + 98j, 2 + 102j, 102j, 98j))):
        (found,) = shapes(f'<path d="M1 2l{far}" fill="none" stroke="white" stroke-width="2"/>')
        assert (found.points, found.closed, found.fill, found.pen.width) == (pytest.approx(corners), True, "white", 0.0)


HEAD = '<path d="M20 10 17 9 17 11Z" fill="black"/>'


@pytest.mark.parametrize(("line", "kinds"), [
    ('<line x1="1" y1="10" x2="17" y2="10"/>', [Arrow]), ('<line x1="1" y1="10" x2="17.019" y2="10"/>', [Arrow]),
    ('<line x1="1" y1="10" x2="17.021" y2="10"/>', [Chain, Arrow]), ("", [Arrow]), ('<circle r="1"/>', [Circle, Arrow]),
    ('<line x1="17" y1="10" x2="17" y2="10"/><circle r="1"/>', [Chain, Circle, Arrow]),
    ('<line x1="1" y1="1" x2="2" y2="1"/><path d="M1 10 9 12 17 10" fill="none"/>', [Chain, Arrow]),
])  # fmt: skip
def test_a_head_and_the_line_that_leads_to_its_neck_are_one_arrow(line, kinds):
    found = shapes(line + HEAD)
    assert [type(one) for one in found] == kinds
    assert found[-1].head == pytest.approx(3.0) and found[-1].points[0] == 20 + 90j
    begins = {1: 17 + 90j if not line else 1 + 90j}.get(len(found), 1 + 90j if "path" in line else 17 + 90j)
    assert found[-1].points[-1] == pytest.approx(begins)


@pytest.mark.parametrize("other", ["M20 10 17 9 17 11Z M1 1l1 1", "M20 10 17 9 17 11 18 10Z"])
def test_what_is_no_black_triangle_is_no_head(other):
    assert Arrow not in {type(one) for one in shapes(f'<path d="{other}" fill="white"/>')}
    assert [type(one) for one in shapes('<path d="M20 10 17 9 17 11 18 10Z" fill="black"/>')] == [Chain]


def test_strokes_of_one_direction_are_hatching_and_of_two_are_none():
    (found,) = shapes('<path d="m1 2l1 1m2 0l1 1m2 0l1 1" fill="none"/>')
    assert (found.begins, found.lean) == (pytest.approx((1 + 98j, 4 + 97j, 7 + 96j)), pytest.approx(1 - 1j))
    assert [type(one) for one in shapes('<path d="m1 2l1 1m2 0l1 2" fill="none"/>')] == [Chain, Chain]
    assert [type(one) for one in shapes('<path d="m1 2l1 1m2 0l1 1 1 1" fill="none"/>')] == [Chain, Chain]


def test_words_have_pieces_that_stand_lower_one_by_one():
    spans = 'v<tspan dy="1" font-size="3">A</tspan><tspan dy="-1">x</tspan>'
    (found,) = shapes(f'<text x="5" y="10" font-size="4" font-style="italic">{spans}</text>')
    assert found == Words(5 + 90j, (("v", 4.0, 0.0), ("A", 3.0, 1.0), ("x", 4.0, 0.0)), 4.0, True, False, found.pen)
    (found,) = shapes('<text font-weight="bold"><tspan dy="2">a</tspan></text>')
    assert (found.at, found.pieces, found.bold, found.italic) == (100j, (("a", 3.2, 2.0),), True, False)


def test_what_a_screen_alone_shows_is_left_out_and_the_bar_of_the_paper_is_known():
    found = shapes('<g display="none"><circle r="1"/></g><g class="paper"><line x2="1"/></g><g><g><line x2="2"/></g></g>')
    assert [(one.points[1], "bar" in one.pen.data) for one in found] == [(1 + 100j, True), (2 + 100j, False)]
