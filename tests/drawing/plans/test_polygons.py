"""Plans of velocities and accelerations: the closed forms of three chains, the wheel of variant 31, polygons that close."""

from __future__ import annotations

import csv
import json
import math
import re
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import pytest

from coursework import load, solve
from coursework.drawing.paper.record import Drawing
from coursework.report.output.tables import run_tables
from coursework.report.pages import build_model
from coursework.report.text.parts import Paragraph
from coursework.run import Run
from coursework.variant.catalogue import names
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.drawing import measured
from tests.sample import sampled
from tests.solved import solved

# Closed forms to 40 digits, velocities and accelerations confirmed by five-point differences; see the file's own `rule`.
REFERENCE = json.loads((Path(__file__).parents[2] / "reference" / "polygons.json").read_text(encoding="utf-8"))["plans"]
Key = tuple[str, str, str, str, str]


@cache
def run_of(name: str) -> Run:
    return solved(name, quantities=["plans"])


@cache
def vectors(name: str, row: int) -> dict[Key, complex]:
    """Return the vectors of a row of `polygons.csv`: motion, plan, kind, from, to."""
    text = dict(run_tables(run_of(name)))["polygons.csv"]
    lines = [line for line in csv.DictReader(text.splitlines()) if line["row"] == str(row)]
    assert {line["unit"] for line in lines if line["plan"] == "velocity"} == {"m/s"}
    assert {line["unit"] for line in lines if line["plan"] == "acceleration"} == {"m/s²"}
    return {
        (line["motion"], line["plan"], line["kind"], line["from"], line["to"]): complex(float(line["x"]), float(line["y"]))
        for line in lines
    }


def drawings_of(name: str) -> dict[str, Drawing]:
    ((*drawings,),) = run_of(name).figures().values()
    return {drawing.id: drawing for drawing in drawings}


@pytest.mark.parametrize("name", REFERENCE)
def test_the_file_holds_the_closed_forms(name: str) -> None:
    ((reference,),) = [REFERENCE[name]]
    found = vectors(name, reference["row"])
    for one in reference["segments"]:
        key = ("exact", one["plan"], one["kind"], one["from"], one["to"])
        assert found[key] == pytest.approx(complex(one["x"], one["y"]), abs=1e-9), key
    known = {(one["plan"], one["kind"], one["from"], one["to"]) for one in reference["segments"]}
    assert {key[1:] for key in found} - known == {("acceleration", "tangential", "pole", "B")}, (
        "a crank of constant speed has none"
    )
    assert found["exact", "acceleration", "tangential", "pole", "B"] == pytest.approx(0, abs=1e-12)


def test_the_head_of_the_file_and_its_rows() -> None:
    text = dict(run_tables(run_of("example-2")))["polygons.csv"].splitlines()
    assert text[0] == "row,t,motion,plan,kind,from,to,x,y,unit"
    rows = len(run_of("example-2").motion.t)
    assert {line.split(",")[0] for line in text[1:]} == {str(row) for row in range(1, rows + 1)}


def test_variant_31_in_the_row_of_the_coursework() -> None:
    """Numbers from 40-digit closed forms at the table's positions; P of the plan is the point of the wheel that touches."""
    found = vectors("31", 4)
    table = {(plan, end): z for (motion, plan, kind, _, end), z in found.items() if motion == "table" and kind == "absolute"}
    argument = 13.08 * 0.06 + 4.35
    assert table["velocity", "M"] == pytest.approx(4.5j * math.sin(argument), abs=1e-12)
    assert abs(table["velocity", "C"]) == pytest.approx(1.8145207, abs=5e-8)
    assert abs(table["velocity", "B"]) == pytest.approx(0.2126, abs=5e-5)
    assert abs(table["velocity", "A"]) == pytest.approx(0.2095, abs=5e-5)
    assert table["velocity", "P"] == pytest.approx(0, abs=1e-12)
    assert table["acceleration", "M"] == pytest.approx(4.5j * 13.08 * math.cos(argument), abs=1e-11)
    assert table["acceleration", "C"] == pytest.approx(-32.215422, abs=5e-6)
    assert table["acceleration", "A"] == pytest.approx(-17.760748 - 0.115112j, abs=5e-6)
    assert table["acceleration", "P"] == pytest.approx(14.409131j, abs=5e-6)


@pytest.mark.parametrize("name", sampled(names()))
def test_every_polygon_closes_and_its_parts_stand_as_they_must(name: str) -> None:
    run = run_of(name)
    plans = run.of(run_plans())
    points = solve(name, quantities=["table", "points"]).table
    row = plans.row
    for motion in ("table", "exact"):
        found = {key[1:]: z for key, z in vectors(name, row).items() if key[0] == motion}
        largest = {plan: max(abs(z) for key, z in found.items() if key[0] == plan) for plan in ("velocity", "acceleration")}
        for (plan, kind, start, end), z in found.items():
            slack = 1e-9 * largest[plan]
            begin = found.get((plan, "absolute", "pole", start), 0)
            if kind == "relative":
                assert begin + z == pytest.approx(found[plan, "absolute", "pole", end], abs=slack)
                if plan == "acceleration":
                    parts = found[plan, "normal", start, end] + found[plan, "tangential", start, end]
                    assert parts == pytest.approx(z, abs=slack)
            if kind == "coriolis":
                parts = begin + z + found[plan, "sliding", start, end]
                assert parts == pytest.approx(found.get((plan, "absolute", "pole", end), 0), abs=slack)
                assert (z.conjugate() * found["velocity", "sliding", start, end]).real == pytest.approx(
                    0, abs=slack * largest["velocity"]
                )
        if motion == "table":
            wheels = {wheel.contact for wheel in plans.outline.wheels}
            for (plan, kind, _, end), z in found.items():
                if plan == "velocity" and kind == "absolute" and f"{end}.vx" in points and end not in wheels:
                    assert z == pytest.approx(
                        complex(points[f"{end}.vx"].iloc[row - 1], points[f"{end}.vy"].iloc[row - 1]), abs=1e-9
                    )
    moving = {key[4] for key in vectors(name, row) if key[3] == "pole"}
    assert set(plans.outline.names) <= moving | set(plans.outline.hinges)


def run_plans() -> object:
    from coursework.scene.quantities import PLANS

    return PLANS


@pytest.mark.parametrize("name", sampled(names()))
def test_no_word_of_a_plan_lies_on_another(name: str) -> None:
    drawings = drawings_of(name)
    assert list(drawings) == ["velocity-plan", "acceleration-plan"]
    for drawing in drawings.values():
        assert measured.overlaps(drawing.svg) == []
        assert measured.beyond(drawing.svg) == []
        assert drawing.steps
        assert drawing.width < 170.5


Arrow = tuple[str, str, str]


def shafts(drawing: Drawing, inset: bool = False) -> dict[Arrow, tuple[complex, complex]]:
    """Return the arrows (mm, y up) by kind, from, to: where the shaft begins and the tip of the head."""
    tails: dict[Arrow, complex] = {}
    found: dict[Arrow, tuple[complex, complex]] = {}
    for node in ElementTree.fromstring(drawing.svg).iter():
        if "data-kind" in node.attrib and ("data-inset" in node.attrib) == inset:
            key = (node.attrib["data-kind"], node.attrib["data-from"], node.attrib["data-to"])
            if node.tag.endswith("line"):
                tails[key] = complex(float(node.attrib["x1"]), -float(node.attrib["y1"]))
            else:
                tip = re.match(r"M(-?[\d.]+) (-?[\d.]+)", node.attrib["d"])
                assert tip is not None
                found[key] = tails[key], complex(float(tip[1]), -float(tip[2]))
    return found


def arrows(drawing: Drawing, inset: bool = False) -> dict[Arrow, complex]:
    """Return the arrows (mm, y up) by kind, from, to, as vectors."""
    return {key: tip - tail for key, (tail, tip) in shafts(drawing, inset).items()}


@pytest.mark.parametrize("name", REFERENCE)
def test_vectors_are_drawn_to_the_scale_that_is_said(name: str) -> None:
    ((reference,),) = [REFERENCE[name]]
    for plan in ("velocity", "acceleration"):
        drawing = drawings_of(name)[f"{plan}-plan"]
        drawn = arrows(drawing)
        seen = 0
        for one in reference["segments"]:
            if one["plan"] == plan and one["mm"] > 0.3:
                expected = complex(one["x"], one["y"]) / one["scale"]
                assert drawn[one["kind"], one["from"], one["to"]] == pytest.approx(expected, abs=0.05)
                seen += 1
        assert seen > 1
        scale = {one["scale"] for one in reference["segments"] if one["plan"] == plan}.pop()
        assert f"1 mm = {scale:g} m/s" in drawing.caption
        (bar,) = measured.lines(drawing.svg, "data-bar")
        assert abs(bar.b - bar.a) == pytest.approx(100, abs=0.05)


@pytest.mark.parametrize("name", [*REFERENCE, "31", "v107"])
def test_an_acceleration_plan_has_every_vector_and_its_parts_follow_each_other(name: str) -> None:
    """Normal or Coriolis part from the image it is added to, then the part along the unknown line, which ends at the image."""
    row = run_of(name).of(run_plans()).row
    here = {key[2:]: z for key, z in vectors(name, row).items() if key[:2] == ("table", "acceleration")}
    drawn = shafts(drawings_of(name)["acceleration-plan"])
    unit = max(map(abs, here.values())) / max(abs(tip - tail) for tail, tip in drawn.values())
    assert set(drawn) == {key for key, vector in here.items() if abs(vector) / unit > 0.3}
    pole = drawn[next(key for key in drawn if key[1] == "pole" and key[0] in {"absolute", "normal"})][0]
    images = {end: pole + vector / unit for (kind, _, end), vector in here.items() if kind == "absolute"} | {"pole": pole}
    for (kind, start, end), (tail, tip) in drawn.items():
        assert tip - tail == pytest.approx(here[kind, start, end] / unit, abs=0.05)
        begins = images.get(start, pole)
        if kind in {"tangential", "sliding"}:
            first = next(here[other, start, end] for other in ("normal", "coriolis") if (other, start, end) in here)
            assert tail == pytest.approx(begins + first / unit, abs=0.05)
            if end in images:
                assert tip == pytest.approx(images[end], abs=0.05)
        else:
            assert tail == pytest.approx(begins, abs=0.05)


def test_what_is_too_short_is_drawn_again_enlarged() -> None:
    """Example 1, row 4: V_C = 0.00060151 m/s is 0.012 mm; a thousand times enlarged it is 12 mm."""
    drawing = drawings_of("example-1")["velocity-plan"]
    inset = arrows(drawing, inset=True)
    assert set(inset) == {("absolute", "pole", "C")}
    assert abs(inset["absolute", "pole", "C"]) == pytest.approx(12.030, abs=0.05)
    assert measured.names(drawing.svg, "data-inset") == {"1000"}
    assert any("1000" in word.text for word in measured.words(drawing.svg))
    # Variant 31: V_B = 2.126 mm and V_A = 2.095 mm, ten times.
    inset = arrows(drawings_of("31")["velocity-plan"], inset=True)
    assert abs(inset["absolute", "pole", "B"]) == pytest.approx(21.26, abs=0.05)
    assert abs(inset["absolute", "pole", "A"]) == pytest.approx(20.95, abs=0.05)


def test_the_steps_say_how_it_is_drawn() -> None:
    velocity, acceleration = (drawings_of("example-4")[f"{plan}-plan"].steps for plan in ("velocity", "acceleration"))
    assert len(velocity) == len(acceleration) == 3, "crank, lever under the block, end of the lever"
    assert "80.0 mm" in velocity[0]
    assert "57.5 mm" in velocity[1]  # 57.646, read to half a millimetre
    assert "slides at 2.775 m/s" in velocity[1]  # 55.5 mm at 0.05 m/s
    assert "55.5 mm" in velocity[1]
    assert "25.6 mm" in acceleration[1]
    assert "44.5 mm" in acceleration[1]
    crossed = drawings_of("v107")["velocity-plan"].steps[3]
    assert "from the pole at right angles to PA and from b at right angles to BA" in crossed
    assert all(math.isfinite(float(n)) for step in (*velocity, *acceleration) for n in re.findall(r"\d+\.\d+", step))


@pytest.mark.long
@pytest.mark.parametrize("name", ["31", "jansen"])
def test_letters_of_points_in_the_steps_are_set_as_in_a_formula(name: str) -> None:
    """In Jansen's leg the points are P1 to P4: the image of P1 is p with 1, not "p1"; units stay upright."""
    section = next(section for section in build_model(run_of(name)).sections if section.name == "plans")
    steps = [part.text for part in section.parts if isinstance(part, Paragraph)]
    upright = " ".join(run["t"] for step in steps for run in step if "t" in run)
    points = {point for point, _ in run_of(name).scene.mechanism.points}
    set_so = {run["v"] for step in steps for run in step if "v" in run}
    assert {point[0] for point in points} | {point[0].lower() for point in points} >= set_so - {"V", "a"} > {"p", "P"}
    assert " mm" in upright
    assert not re.search(r"\b[A-Z][A-Z]\b|\bp\d|\b[b-eg-z] lies", upright), upright


def test_the_point_under_one_with_an_index_has_its_prime_behind_the_index() -> None:
    text = (Path(__file__).parents[3] / "variants" / "oscillating-cylinder.toml").read_text(encoding="utf-8")
    run = solve(parse_variant(text.replace('"B"', '"B1"')), quantities=["plans"])
    ((*drawings,),) = run.figures().values()
    velocity = next(drawing for drawing in drawings if drawing.id == "velocity-plan")
    assert velocity.steps[1].startswith("b₁′ is the image of the point of the link under B₁")
    assert any(word.text == "b1′" for word in measured.words(velocity.svg))


def test_a_file_without_points_is_told_so() -> None:
    from dataclasses import replace

    bare = replace(load("31"), points=(), links=(), driven=None, holds=())
    with pytest.raises(InputError, match="points"):
        solve(bare, quantities=["plans"])


def test_vectors_are_as_long_on_paper_as_the_scale_says(tmp_path: Path) -> None:
    """Read back from the PDF: the bar, and the arrow of 80 mm of example 1 with its components."""
    import pymupdf

    from coursework import write_report

    write_report(run_of("example-1"), str(tmp_path / "report.pdf"))
    with pymupdf.open(tmp_path / "report.pdf") as sheets:
        lines = [
            (item[2] - item[1], path["color"])
            for sheet in sheets
            for path in sheet.get_drawings()
            for item in path["items"]
            if item[0] == "l" and path["color"] is not None
        ]
    mm = 25.4 / 72
    bars = [abs(way) * mm for way, color in lines if color == pytest.approx((1 / 255,) * 3, abs=1e-3)]
    assert [round(length, 2) for length in bars] == [100.0, 100.0]
    # V_B = 4 m/s at 0.05 m/s a mm: 80 mm, of which the head takes the last 2.4 mm of the shaft.
    reference = next(one for one in REFERENCE["example-1"][0]["segments"] if one["to"] == "B" and one["plan"] == "velocity")
    way = complex(reference["x"], -reference["y"]) / reference["scale"]
    shaft = way * (1 - 2.4 / abs(way))
    assert any(abs(complex(line.x, line.y) * mm - shaft) < 0.05 for line, _ in lines)
