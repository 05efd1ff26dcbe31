"""The sheet of the check: to scale, in its borders, every word beside its own, and blank when asked."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from html import unescape
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest

from coursework import load
from coursework.drawing.check_sheet.drawing import _seen
from coursework.drawing.check_sheet.graph_check import check_graph
from coursework.drawing.check_sheet.instant_centres import Findings
from coursework.drawing.check_sheet.layout import LANDSCAPE, PAGE, SCALES, lay_out
from coursework.drawing.check_sheet.sketch import Body, Sketch
from coursework.drawing.paper.sheet import HEADLESS
from coursework.variant.catalogue import names
from coursework.variant.record.variant import Link
from coursework.words.sentences import Sentence, say
from tests.drawing import measured
from tests.drawing.check_sheet.checked import DRAWABLE, check_of, run_of, scene, sketch_of, svg_of


def test_a_blank_sheet_leaves_the_construction_to_the_student() -> None:
    blank = check_of("31").drawing(blank=True)
    assert set(re.findall(r'data-velocity="(\w+)"', blank.svg)) == {"M"}
    assert "stroke-dasharray" not in blank.svg
    assert (blank.width, blank.height) == (check_of("31").drawing().width, check_of("31").drawing().height)
    said = {word.text for word in measured.words(blank.svg)}
    assert not any(text.startswith("P2") or text.startswith("P3") for text in said)
    assert {"A", "B", "C", "D", "M", "P"} <= said


@pytest.mark.long
@pytest.mark.parametrize(
    "name", ["31", *(name.lower() for name in DRAWABLE), "v107", "homework", "jansen", "peaucellier", "watt", "stephenson"]
)
def test_no_word_of_the_sheet_lies_on_another(name: str) -> None:
    assert measured.overlaps(svg_of(name)) == []
    assert measured.beyond(svg_of(name)) == []


@pytest.mark.long
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
    assert drawn == pytest.approx(expected, abs=2e-3)
    (wheel,) = elements(svg, "circle", "data-link")
    assert float(wheel.get("r", "")) == pytest.approx(22.85, abs=1e-4)
    assert "scale 1:10" in svg and "1 mm = 0.1 m/s" in svg


@pytest.mark.parametrize("name", ["31", *map(str.lower, DRAWABLE)])
def test_the_drawing_is_similar_to_the_mechanism(name: str) -> None:
    check = check_of(name)
    at = check.sketch.pose.positions
    for line in elements(svg_of(name), "line", "data-from"):
        metres = abs(at[line.get("data-from", "")] - at[line.get("data-to", "")])
        assert length(line) * check.scale / 1000 == pytest.approx(metres, abs=2e-6 * check.scale)
    layout = lay_out(check.sketch, check.findings)
    for arrow in elements(svg_of(name), "line", "data-velocity"):
        # The shaft ends where the head begins, 2.6 mm before the tip, earlier on short ones; the shortest have none.
        whole = abs(check.findings.velocities[arrow.get("data-velocity", "")]) / layout.speed
        head = min(2.6, 0.6 * whole) if whole >= HEADLESS else 0.0
        assert length(arrow) == pytest.approx(whole - head, abs=2e-3)


def numbers(svg: str) -> list[tuple[float, float]]:
    root = ElementTree.fromstring(svg)
    found = [(float(i.get(f"x{k}", "")), float(i.get(f"y{k}", ""))) for i in root.iter(SVG + "line") for k in "12"]
    found += [(float(i.get("x", "")), float(i.get("y", ""))) for i in root.iter(SVG + "text")]
    for path in root.iter(SVG + "path"):
        found += [(place.real, place.imag) for place in measured.points(path.get("d", ""))]
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
    assert check_of("31").drawing().width > 170.5
    assert layout.width <= LANDSCAPE[0]
    assert layout.height <= LANDSCAPE[1]
    assert check_of("v101").drawing().width < 170.5
    assert "rotate" not in svg_of("31")


def test_a_low_drawing_stands_upright_a_little_smaller_than_half_a_lying_page() -> None:
    check = check_of("engine-start")
    layout = lay_out(check.sketch, check.findings)
    assert (layout.wide, layout.scale) == (False, 2)


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
    (places,) = [way for way in map(measured.points, re.findall(r'd="(M[^"]*)"', svg)) if len(way) > 21]
    assert {round(abs(place - middle) * layout.scale) for place in places} == {574}


def test_scales_are_those_of_drawing_standards() -> None:
    assert {1.0, 2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 50.0, 100.0, 0.5, 0.2, 2e-5} <= set(SCALES)
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
    mechanism = replace(run.scene.mechanism, variant=replace(run.variant, links=links))
    check = check_graph(mechanism, run.scene.equations, run.motion, run.exact)
    assert check is not None
    svg = check.drawing().svg
    assert "&lt;script&gt;" in svg and "<script" not in svg
    assert not any(item.tag.endswith("script") for item in ElementTree.fromstring(svg).iter())
    assert "\x01" not in svg and "\u202e" not in svg


def test_a_file_may_call_its_points_like_centres() -> None:
    variant = load("31")
    sketch = sketch_of("31")
    taken = replace(sketch, pose=replace(sketch.pose, positions={**sketch.pose.positions, "P3": 0j}))
    from coursework.drawing.check_sheet.graph_words import centre_letter, how_found

    assert (centre_letter(sketch), centre_letter(taken)) == ("P", "I")
    assert "I₃ is where the perpendiculars to the velocities of M and C meet." in how_found(taken, check_of("31").findings, None)
    assert variant.links[2] == Link("3", ("M", "B", "C"), "w3", None, None)


def test_a_mechanism_without_size_is_drawn_all_the_same() -> None:
    points = {"A": 0j, "B": 0j}
    still = scene(points, [Body("1", ("A", "B"))], fixed="A")
    full = check_of("31").sketch
    drawn = replace(full.outline, bars=(), wheels=(), rails=(), hinges=(), driven=()), full.poses, full.row
    sketch = Sketch(still, (), (), ("A",), points, {}, {}, ("B",), (), *drawn)
    nothing = Findings({}, {}, {}, ("1",))
    from coursework.drawing.check_sheet.drawing import draw

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

    from coursework.commands.cli import main

    asked = ["run", "31", "--blank", "--quantities", "graph_check", "--format", "html", "--out", str(tmp_path)]
    assert CliRunner().invoke(main, asked).exit_code == 0
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Construct the centres and velocities here." in page
    assert "V_M/P" not in page
    assert 'stroke-dasharray="2.4 1 0.4 1"' not in page


def test_links_without_a_centre_are_told_where_there_is_something_to_ask_of_them():
    """A link of two points, or the bar in a sleeve; a point alone has no centre of its own."""
    from coursework.drawing.check_sheet.graph_words import how_found

    bodies = [SimpleNamespace(name=name, points=points, guide=False) for name, points in (("2", "B"), ("3", "CD"), ("4", "E"))]
    pose = SimpleNamespace(bodies=bodies, slides=[SimpleNamespace(link="2", rider="B")], positions={})
    findings = SimpleNamespace(planned={"2", "3", "4"}, beyond=(), centres={})
    assert how_found(SimpleNamespace(pose=pose), findings, None) == [say("drawing.by_lines", links=("2", "3"))]


def test_what_to_look_at_is_a_point_near_its_centre_or_the_fastest_point() -> None:
    body = SimpleNamespace(name="2", points=("A", "B"))
    pose = SimpleNamespace(size=10.0, positions={"A": 0j, "B": 5 + 0j}, bodies=[body])
    sketch = SimpleNamespace(pose=pose, moving={"A", "B"})

    def seen(at: complex | None, **velocities: complex) -> Sentence | str:
        findings = SimpleNamespace(drawn={"2": SimpleNamespace(at=at, lines=[1])}, velocities=velocities)
        return _seen(sketch, findings)  # type: ignore[arg-type]

    assert seen(9j, A=3 + 4j, B=-2j, C=99j) == say("graph.fastest", point="A", speed=5.0)
    assert seen(None, A=1j, B=-2j) == say("graph.fastest", point="B", speed=2.0)
    assert seen(9j) == "" and seen(5 + 0j, A=1j, B=0j) == say("graph.close", link="2", point="B")


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "near"), [(0.049, True), (0.051, False)])
def test_a_centre_is_near_a_point_within_a_twentieth_of_the_size(size: float, part: float, near: bool) -> None:
    pose = SimpleNamespace(size=size, positions={"A": 1j * size}, bodies=[SimpleNamespace(name="2", points=("A",))])
    findings = SimpleNamespace(drawn={"2": SimpleNamespace(at=1j * size + part * size, lines=[1])}, velocities={})
    told = _seen(SimpleNamespace(pose=pose, moving={"A"}), findings)  # type: ignore[arg-type]
    assert told == (say("graph.close", link="2", point="A") if near else "")
