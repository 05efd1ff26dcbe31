"""The figures of accuracy: places of values on their logarithmic axes, words that leave each other alone."""

import numpy as np
import pytest

import coursework
from coursework.report.graphs.accuracy_figures import STYLES, Chart, Method, _names, chart
from coursework.report.graphs.graph_paper import picture
from coursework.report.graphs.log_paper import MARKS, Scale, scale_for
from coursework.report.pages import build_model
from coursework.report.text.parts import Figure
from tests.drawing import measured

LABELS = {
    "evaluations": "evaluations of the velocities", "seconds": "running time, s", "own_legend": "this coursework",
    "floor_legend": "round-off",
}  # fmt: skip


def made_up(*, timed: bool) -> Chart:
    each = 1e-6 if timed else 1
    methods = tuple(
        Method(
            f"method {order}",
            tuple((24 * 4**k * each, 10.0**-order / 4.0 ** (order * k) * more) for k in range(6)),
            float(order),
        )
        for order, more in ((1, 1), (2, 1), (2, 3), (4, 1))
    )
    return Chart(methods, (24 * each, 0.1), 1e-14, "error, rad", LABELS, timed)


def check_words(svg: str) -> None:
    assert len(measured.words(svg)) > 4
    assert measured.overlaps(svg) == []
    assert measured.beyond(svg) == []


@pytest.mark.long
@pytest.mark.parametrize("language", ["en", "ru", "uk"])
def test_no_word_lies_over_a_word_or_beyond_the_sheet(language):
    sections = build_model(coursework.solve("31", quantities=["accuracy"]), language).sections
    (figure,) = (part for one in sections if one.name == "accuracy" for part in one.parts if isinstance(part, Figure))
    check_words(figure.svg)
    assert "paint-order" not in figure.svg  # no name has to stand on a line


@pytest.mark.parametrize("timed", [False, True])
def test_the_cost_is_time_where_it_was_measured_and_alike_methods_are_one_band(timed):
    svg, height = chart(made_up(timed=timed))
    assert f'height="{height:g}mm"' in svg
    check_words(svg)
    assert svg.count("running time, s") == timed
    assert svg.count("<circle") == 2  # the ring, and the one before its name
    assert svg.count('class="order"') == 2  # the band, and a piece of it for its name
    assert "method 2, method 2" in svg
    assert chart(made_up(timed=timed)) == (svg, height)


def test_every_method_has_a_pen_that_differs_without_colour():
    assert len({(dashes, mark) for _, dashes, mark in STYLES}) == len(STYLES)
    assert {mark for _, _, mark in STYLES} == set(MARKS)


def test_a_value_lies_where_its_logarithm_says():
    scale = Scale(10.0, 90.0, -2.0, 2.0)
    assert [scale.at(value) for value in (0.01, 0.1, 1, 100)] == pytest.approx([10, 30, 50, 90])
    assert scale.at(0.0) == scale.at(1e-9) == 10
    assert [text for _, text in scale.ticks()] == ["10⁻²", "10⁻¹", "10⁰", "10¹", "10²"]
    assert [text for _, text in Scale(0, 1, 1.2, 2.2).ticks()] == ["2·10¹", "5·10¹", "10²"]
    assert len(Scale(0, 1, -17, 3).ticks()) <= 8
    fitted = scale_for([1.0, 1000.0], 0, 100, (0.1, 0.2))
    assert (fitted.low, fitted.high) == pytest.approx((-0.3, 3.6))


def test_a_name_stands_at_the_end_of_its_line_or_behind_a_piece_of_it():
    piece, free, crossed = "<path/>", np.empty((0, 2)), np.array([(60.0, 30.0)])
    hidden = f'<g display="none">{piece}</g>'  # shown on a phone, which lists the names under the picture
    assert hidden in _names([("midpoint", (50.0, 30.0), piece)], free, [])
    behind = _names([("midpoint", (50.0, 30.0), piece)], crossed, [])
    assert piece in behind and hidden not in behind


def test_names_that_want_one_place_stand_apart():
    named = [(f"a name of many words, number {k}", (140.0, 30.0), "<path/>") for k in range(3)]
    svg = picture(170, 70, _names(named, np.empty((0, 2)), [(125.0, 28.0, 170.0, 32.0)]))
    assert measured.overlaps(svg) == []


def test_a_name_with_room_beside_the_axes_only_is_set_in_lines():
    everywhere = np.array([(float(x), float(y)) for x in range(14, 128) for y in range(70)])
    svg = picture(170, 70, _names([("a name of many words, number 0", (126.0, 30.0), "<path/>")], everywhere, []))
    assert svg.count("<text") == 2 and "paint-order" not in svg
