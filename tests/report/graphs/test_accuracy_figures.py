"""The figures of accuracy: places of values on their logarithmic axes, words that leave each other alone."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest

import coursework
from coursework.report.graphs.accuracy_figures import STYLES, Chart, Method, _names, chart
from coursework.report.graphs.graph_paper import picture
from coursework.report.graphs.log_paper import MARKS, Scale, across, scale_for, upward
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


def test_numbers_stand_at_the_lines_of_the_grid_that_they_name_and_a_label_in_the_middle_of_its_axis():
    x, y = Scale(20.0, 120.0, 0.0, 4.0), Scale(60.0, 10.0, -3.0, 1.0)
    svg = picture(170, 80, across(x, 60.0, 10.0, "below") + upward(y, 20.0, 120.0, "above"))
    said = {word.text: word.box for word in measured.words(svg)}
    grids = [
        measured.points(re.sub(r"V([\d.]+)", r"L0 \1", re.sub(r"H([\d.]+)", r"L\1 0", node.get("d"))))
        for node in ElementTree.fromstring(svg).iter(f"{measured.SVG}path")
        if node.get("stroke-width") == "0.1"
    ]
    upright, level = ({round(begin.real if k == 0 else begin.imag, 2) for begin in way[::2]} for k, way in enumerate(grids))
    assert (upright, level) == ({20.0, 45.0, 70.0, 95.0, 120.0}, {60.0, 47.5, 35.0, 22.5, 10.0})
    for power, sign in enumerate("⁰¹²³⁴"):
        left, top, right, _ = measured.words(svg)[power].box
        assert measured.words(svg)[power].text == f"10{sign}"
        assert (left + right) / 2 == pytest.approx(20.0 + 25.0 * power, abs=0.2) and 60.5 < top < 64.0
    for text, at in (("10⁻³", 60.0), ("10⁻²", 47.5), ("10⁻¹", 35.0)):
        _, top, right, bottom = said[text]
        assert abs((top + bottom) / 2 - at) < 0.5 and 16.0 < right < 19.5
    assert (said["below"][0] + said["below"][2]) / 2 == pytest.approx(70.0, abs=0.2) and 64.0 < said["below"][1] < 68.0
    assert said["above"][0] == pytest.approx(21.2, abs=0.2) and 7.0 < said["above"][3] < 10.0


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
