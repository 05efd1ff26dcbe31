"""Every word of a drawing stands nearer to what it names than to anything alike, or is led to it; none lies on a link."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from coursework import load, parse_variant, solve
from coursework.commands.new import _chain
from coursework.drawing.outline.lengths import lengths
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.symbols import angle_word, length_text, name_word
from coursework.mechanism.mechanism import build
from coursework.variant.catalogue import names
from tests.drawing import measured
from tests.drawing.check_sheet.checked import svg_of
from tests.drawing.lettering.test_angles import arc_of
from tests.drawing.outline.test_mechanism import drawing_of
from tests.sample import sampled

FARTHEST = 8.0  # mm from its line to a word that nothing leads to it
SENSE = 6.0  # mm before a word with the arrow of a rotation
# The crank of these three changes its length: no construction with rigid links.
CONSTRUCTED = [name for name in names() if not name.startswith("variable-crank")]


@pytest.mark.long
@pytest.mark.parametrize("name", sampled(names()))
def test_no_word_lies_on_a_link_or_an_arrow(name: str) -> None:
    assert measured.crossed(drawing_of(name).svg, "data-link", "data-driven") == []


@pytest.mark.long
@pytest.mark.parametrize("name", sampled(CONSTRUCTED))
def test_no_word_of_a_construction_lies_on_a_link_or_an_arrow(name: str) -> None:
    assert measured.crossed(svg_of(name), "data-link", "data-velocity") == []


@pytest.mark.parametrize("name", sampled(names()))
def test_a_length_stands_beside_the_part_that_has_it(name: str) -> None:
    svg = drawing_of(name).svg
    known = lengths(build(load(name)))
    parts = [line for line in measured.lines(svg, "data-link") if "data-from" in line.says]
    drawn = [*measured.lines(svg, "data-link"), *measured.lines(svg, "data-driven"), *measured.lines(svg, "data-dimension")]
    said: dict[str, list[measured.Line]] = {}
    for line in parts:
        length = known.get(frozenset((line.says["data-from"], line.says["data-to"])))
        if length is not None and length_text(length) and abs(line.b - line.a) > 2.5:
            said.setdefault(length_text(length), []).append(line)
    for text, own in said.items():
        written = [word for word in measured.words(svg) if word.text.replace("ℓ", "l") == text]
        assert len(written) >= len(own), text
        for line in own:
            # Of words alike the nearest is meant: the arms of a rhomb are all called l.
            word = min(written, key=lambda word: measured.beside(word, line))
            assert measured.astray(svg, word, own, drawn) == []
            assert measured.beside(word, line) < FARTHEST or measured.led(svg, word, own)


@pytest.mark.long
@pytest.mark.parametrize("kind", ["mechanism", "construction"])
@pytest.mark.parametrize("name", sampled(CONSTRUCTED))
def test_the_name_of_a_link_stands_beside_it(name: str, kind: str) -> None:
    svg = drawing_of(name).svg if kind == "mechanism" else svg_of(name)
    drawn = [*measured.lines(svg, "data-link"), *measured.lines(svg, "data-velocity")]
    wheels = measured.names(svg, "data-link") - {line.says["data-link"] for line in drawn if "data-link" in line.says}
    outline = read_outline(build(load(name)))
    assert outline is not None
    wheels |= {wheel.link for wheel in outline.wheels} | {bar.link for bar in outline.bars if len(bar.corners) == 1}
    for bar in outline.bars:
        own = [line for line in drawn if line.says.get("data-link") == bar.link]
        word = next((w for w in measured.words(svg) if w.text.partition(":")[0] == bar.link), None)
        if word is not None and own and bar.link not in wheels:
            left, *rest = word.box
            word = measured.Word(word.text, (left - (SENSE if ":" in word.text else 0.0), *rest))  # type: ignore[arg-type]
            others = [line for line in drawn if line not in own]
            assert measured.astray(svg, word, own, others) == []


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "texts"),
    [
        ("example-1", {"r₄"}), ("chebyshev", {"r₄", "2r₂"}), ("homework", {"r₄"}), ("example-3", {"r₄", "xF", "yF"}),
        ("example-4", {"r₃", "r₄"}), ("cardan", {"f", "R₀"}), ("example-6", {"h", "r₄"}), ("jansen", {"d", "i", "a"}),
        ("epicyclic", {"R₀"}), ("pantograph", {"L₁", "L₂"}), ("v104", {"xO", "yO"}), ("prp", {"xj", "yj"}),
    ],
)  # fmt: skip
def test_lengths_between_points_that_no_link_joins_have_dimension_lines(name: str, texts: set[str]) -> None:
    svg = drawing_of(name).svg
    dimensions: dict[str, list[measured.Line]] = {}
    for line in measured.lines(svg, "data-dimension"):
        dimensions.setdefault(line.says["data-dimension"], []).append(line)
    for text in texts - {"r₃"}:
        # A half to each end; the radius of a ring has one end, at its rim.
        assert len(dimensions[text]) == (1 if text == "R₀" else 2)
        words = [word for word in measured.words(svg) if word.text == text]
        others = [line for other, lines in dimensions.items() if other != text for line in lines]
        assert any(measured.astray(svg, word, dimensions[text], others) == [] for word in words)
    assert texts <= {word.text for word in measured.words(svg)}


@pytest.mark.parametrize("name", [*sampled(names()), "crank,RRR,RRR", "crank,RRR,RRR,RRP", "crank,RPR,RRP"])
def test_no_name_of_a_dimension_or_an_angle_is_taken_for_anothers(name: str) -> None:
    if "," in name:
        variant = parse_variant(_chain("own", name).decode()).with_data({"phi1": "36.27 deg"})
        svg = solve(variant, quantities=["table"]).mechanism().svg  # type: ignore[union-attr]
    else:
        svg = drawing_of(name).svg
    things: dict[str, list[measured.Line]] = {}
    for line in measured.lines(svg, "data-dimension"):
        things.setdefault(line.says["data-dimension"], []).append(line)
    for angle in measured.names(svg, "data-angle"):
        text = "".join(angle_word(angle))
        things[text] = [measured.Line(a, b, {"data-angle": text}) for a, b in pairwise(arc_of(svg, angle))]
    assert things
    # Two short dimensions near the edge, whose names have room only above their upper arrow, level with another's line.
    for crowded in {"engine-start": ["e"], "walschaerts": ["yD"]}.get(name, []):
        del things[crowded]
    written = [(word, word.text.partition("\u00a0")[0]) for word in measured.words(svg)]
    for text, own in things.items():
        named = [word for word, said in written if said == text]
        word = min(named, key=lambda word: min(measured.beside(word, line) for line in own))
        assert measured.astray(svg, word, own, [line for other, lines in things.items() if other != text for line in lines]) == []


def test_the_measure_sees_what_is_astray() -> None:
    def sheet(y: float, leader: str = "") -> str:
        own, other = (f'<line x1="0" y1="{at}" x2="40" y2="{at}" data-link="{link}"/>' for at, link in ((5, 1), (15, 2)))
        text = f'<text x="9" y="{y}" font-size="3.2">r</text>'
        return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20">{own}{other}{leader}{text}</svg>'

    def found(svg: str) -> list[str]:
        own, other = measured.lines(svg, "data-link")
        return measured.astray(svg, measured.words(svg)[0], [own], [other])

    _, up, down = measured.size("r", 3.2)
    between = 10 + (up - down) / 2
    assert found(sheet(between - 0.1)) == []
    assert len(found(sheet(between + 0.1))) == 1
    assert found(sheet(between + 0.1, '<line x1="10" y1="5" x2="10" y2="8.5" data-leader=""/>')) == []
    assert measured.crossed(sheet(15 - down + 0.1), "data-link") != []
    assert measured.crossed(sheet(15 - down - 0.1), "data-link") == []


def test_names_have_their_index_lowered() -> None:
    assert [name_word(name) for name in ("P1", "D5", "Ki", "xF", "A", "beta", "Pin", "b'", "b1''", "dx", "lAB", "AB")] == [
        ("P", "1", ""), ("D", "5", ""), ("K", "i", ""), ("x", "F", ""), ("A", "", ""), ("β", "", ""), ("Pin", "", ""),
        ("b′", "", ""), ("b", "1", "′′"), ("d", "x", ""), ("l", "AB", ""), ("AB", "", ""),
    ]  # fmt: skip
    assert '>P<tspan dy="0.8" font-size="2.3">1</tspan>' in drawing_of("jansen").svg
    assert "P₁" in {
        word.text.partition("\u00a0")[0][1:] for word in measured.words(svg_of("jansen")) if word.text.startswith("V")
    }


def test_the_point_from_which_a_guide_is_counted_is_drawn() -> None:
    assert "K" in {word.text for word in measured.words(drawing_of("v110").svg)}


def test_a_crank_without_length_is_drawn_all_the_same() -> None:
    variant = load("example-2")
    none = replace(variant, given=tuple(replace(datum, value=1e-30) if datum.name == "r1" else datum for datum in variant.given))
    drawing = solve(none, quantities=["table"]).mechanism()
    assert drawing is not None
    assert {"A", "B", "C"} <= {word.text for word in measured.words(drawing.svg)}


def test_a_ring_is_seen_whole_and_no_dimension_runs_through_the_ground_of_a_hinge() -> None:
    paths = [measured.points(path) for path in re.findall(r'd="(M[^"]*)"', drawing_of("epicyclic").svg)]
    rims = [[np.ptp(np.real(path)), np.ptp(np.imag(path))] for path in paths]
    assert max(rims) == pytest.approx([60.0, 60.0], rel=0.01)  # 240 mm at 1:4
    lines = {line.says["data-dimension"]: line for line in measured.lines(drawing_of("jansen").svg, "data-dimension")}
    links = measured.lines(drawing_of("jansen").svg, "data-link")
    assert lines["a"].a.imag < min(min(link.a.imag, link.b.imag) for link in links)


def test_many_links_are_drawn_larger_and_hardly_a_name_needs_a_line_to_what_it_names() -> None:
    svg = drawing_of("jansen").svg
    assert float(re.search(r'height="([\d.]+)mm"', svg)[1]) > 95  # type: ignore[index]
    assert len(measured.lines(svg, "data-leader")) <= 6  # of 33, and 12 at the usual size
