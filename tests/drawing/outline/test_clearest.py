"""Figure 1 shows links apart: in the start position, or in the row in which least coincides; guides pass joints by."""

from __future__ import annotations

import cmath
import itertools
import math
import re
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from coursework import load, parse_variant, solve
from coursework.drawing.figures import draw_start
from coursework.drawing.outline.coinciding import _close, _Part, clearest, coincides
from coursework.drawing.outline.outline import Bar, Rail, Slot
from coursework.drawing.outline.poses import Poses
from coursework.run import Run
from tests.drawing import measured
from tests.drawing.outline.test_mechanism import drawing_of
from tests.mechanisms.library import mechanism

# The shaper of a task sheet: at 90 degrees crank and lever lie on one line, and the end of the lever beside the guide of the ram.
SHAPER = mechanism("shaper", ('"0 deg"', '"90 deg"'), step="0.02 s", end="0.5 s", rails=None, quantities=None)


def solved(text: str) -> Run:
    return solve(parse_variant(text), quantities=["table"])


def caption_of(text: str) -> str:
    drawing = solved(text).mechanism()
    assert drawing is not None
    return drawing.caption


@pytest.mark.parametrize(("degrees", "starts"), [("22.4", False), ("22.6", True)])
def test_the_start_is_shown_where_its_links_are_seen_apart(degrees: str, starts: bool) -> None:
    """The other arm stands at 20 degrees; stretched by less than 2.5 degrees, two links are one line."""
    caption = caption_of(mechanism("two-arms", ('"80 deg"', f'"{degrees} deg"')))
    assert ("in row 1, t = 0," in caption) == starts
    assert ("in row 1 links lie almost on one line" in caption) != starts


@pytest.mark.parametrize(("angle", "are_one"), [
    (2.4, True), (2.6, False), (-2.4, True), (-2.6, False), (187.3, True), (187.6, False), (172.7, True), (172.4, False),
    (90, False),
])  # fmt: skip
def test_two_arms_are_one_line_stretched_by_2_5_degrees_or_folded_by_7_5(angle: float, are_one: bool) -> None:
    places = {"A": (20 + 20j,), "B": (45 + 20j,), "C": (45 + 20j + 22 * cmath.exp(1j * math.radians(angle)),)}
    for turn in (1, cmath.exp(1j)):
        turned = {name: (at * turn,) for name, (at,) in places.items()}
        assert coincides(outline_of({"1": "AB", "2": "BC"}), poses_of(**turned)) is are_one


def test_a_rod_on_its_guide_is_seen_where_the_crank_stands_across_it() -> None:
    """Only links hide one another: the rod is drawn over the guide, as wide as the slide."""
    changes = (('A = "(0, 0)"', 'A = "(0, 0)"\nD = "(0, r1)"'), ('through = "A"', 'through = "D"'), ('"0 deg"', '"90 deg"'))
    assert "in row 1, t = 0," in caption_of(mechanism("example-2", *changes))


def test_a_shaper_is_shown_where_crank_and_lever_are_apart() -> None:
    run = solved(SHAPER)
    drawing = run.mechanism()
    assert drawing is not None
    row = int(re.search(r"row (\d+), t = ([\d.]+) s", drawing.caption)[1])  # type: ignore[index]
    assert f"t = {(row - 1) * 0.02:.6g} s" in drawing.caption
    assert drawing.alt == f"The mechanism in row {row}. Links: 1 AB, 2 B, 3 DE, 4 EF and 5 F."
    between = (run.exact.column("phi1") - run.exact.column("phi3"))[row - 1] % math.pi
    assert math.radians(60) < between < math.radians(120)
    sides = {line.says["data-link"]: line for line in measured.lines(drawing.svg, "data-link") if "data-from" in line.says}
    drawn = cmath.phase((sides["1"].b - sides["1"].a) / (sides["3"].b - sides["3"].a)) % math.pi
    assert drawn == pytest.approx(-between % math.pi, abs=1e-3)
    assert measured.overlaps(drawing.svg) == []


def test_rows_that_coincide_less_are_not_looked_for_where_the_start_is_fine() -> None:
    assert "in row 1, t = 0," in drawing_of("31").caption and "bent arrow" not in drawing_of("31").caption
    assert "The bent arrow is the given" in drawing_of("example-2").caption  # a crank; in 31 a point is driven
    assert "row 1, t = 0" not in drawing_of("example-2").caption  # crank and rod along the guide


def joints_of(svg: str) -> dict[tuple[float, float], float]:
    rings = [node for node in ElementTree.fromstring(svg).iter() if node.get("r") in {"1.25", "1"}]
    return {(float(ring.get("cx", "")), float(ring.get("cy", ""))): float(ring.get("r", "")) for ring in rings}


@pytest.mark.long
@pytest.mark.parametrize("degrees", [*range(0, 360, 30), 83, 97])
def test_no_guide_runs_through_a_joint_that_does_not_slide_on_it(degrees: int) -> None:
    run = solved(SHAPER.replace("90 deg", f"{degrees} deg"))
    drawing = draw_start(run.scene.mechanism, run.scene.equations, run.motion, run.scene.start)
    assert drawing is not None
    rails = measured.lines(drawing.svg, "data-rail")
    assert rails
    blocks = [
        complex(*at) for at in joints_of(drawing.svg) if any(abs(min_gap(complex(*at), rail) - 2.4) < 1e-3 for rail in rails)
    ]
    assert len(blocks) >= 1
    for at, rail in itertools.product(joints_of(drawing.svg), rails):
        assert min_gap(complex(*at), rail) > 2.4 - 1e-3


def min_gap(at: complex, line: measured.Line) -> float:
    way = line.b - line.a
    along = min(1.0, max(0.0, ((at - line.a) * way.conjugate()).real / abs(way) ** 2))
    return abs(at - line.a - along * way)


@pytest.mark.long
def test_a_driven_arrow_ends_beside_joints_and_hinges() -> None:
    """Where an arrow of 13 mm would end on A it has another length."""
    text = load("robot-arm").path.read_text(encoding="utf-8").replace("0.2 rad", "3.14 rad")  # type: ignore[union-attr]
    lengths = set()
    for reach in range(60, 200, 5):
        run = solved(text.replace('r2 = "0.4 m"', f'r2 = "{reach} mm"'))
        drawing = draw_start(run.scene.mechanism, run.scene.equations, run.motion, run.scene.start)
        assert drawing is not None
        [shaft] = measured.lines(drawing.svg, "data-driven")
        tip = shaft.b + 2.6 * (shaft.b - shaft.a) / abs(shaft.b - shaft.a)
        lengths.add(round(abs(tip - shaft.a), 1))
        assert all(abs(tip - complex(*at)) > 1.74 for at in joints_of(drawing.svg))
    assert 13.0 in lengths and len(lengths) > 1


@pytest.mark.parametrize(("asked", "is_exact"), [("plots", True), ("table", False)])
def test_the_row_is_of_the_motion_itself_where_that_is_asked_for(asked: str, is_exact: bool) -> None:
    """The table of a driven point drifts; what is drawn closes beside graphs of the exact motion, else it is the table's row."""
    run = solve("v102", quantities=(asked,))
    drawing = run.mechanism()
    assert drawing is not None
    row = int(re.search(r"row (\d+)", drawing.caption)[1])  # type: ignore[index]
    assert row > 1
    assert ("exact" in run.scene.ledger.calls) is is_exact
    motion = run.exact if is_exact else run.motion
    [crank] = [line for line in measured.lines(drawing.svg, "data-link") if line.says.get("data-from") == "D"]
    way = (crank.b - crank.a).conjugate()
    assert cmath.phase(way) == pytest.approx(math.remainder(float(motion.column("phi1")[row - 1]), math.tau), abs=1e-3)


def test_a_place_is_as_near_to_a_part_as_its_nearest_end() -> None:
    """Beside the middle, and as far beyond each end on the line: 0.5 m off at a scale of 10 mm/m, of which 8 mm are far."""
    part = _Part("1", np.array([0j]), np.array([2 + 0j]), frozenset())
    near = _close(part, np.array([[1 + 0j, 1 + 0.5j, 2.5 + 0j, -0.5 + 0j, 4 + 0j]]), np.array([10.0]), 8.0)
    assert near[0].tolist() == pytest.approx([1.0, 0.375, 0.375, 0.375, 0.0])


def outline_of(bars: dict[str, str], **more: tuple[Any, ...]) -> Any:
    """Bars through joints of one letter each; P and Q stand 100 mm apart, so that a metre is a millimetre on paper."""
    shown = ("P", "Q", *dict.fromkeys("".join(bars.values())))
    parts = {"slots": (), "rails": (), "hinges": (), **more}
    return SimpleNamespace(shown=shown, bars=tuple(Bar(link, tuple(ends)) for link, ends in bars.items()), **parts)


def poses_of(**places: tuple[complex, ...]) -> Poses:
    """Places of points in every row; one that is given for one row stays there."""
    count = max(map(len, places.values()))
    kept = {"P": (0j,), "Q": (60 + 80j,), **places}
    at = {name: np.array(found * (count // len(found)), complex) for name, found in kept.items()}
    return Poses(np.arange(count) * 0.1, at, {})


# Two links side by side, 9 mm long, in row 1 at a distance, in row 2 far apart.
BESIDE = {"1": "AB", "2": "CD"}


def beside(gap: float) -> dict[str, tuple[complex, ...]]:
    return {"A": (20 + 20j,), "B": (29 + 20j,), "C": (20 + 20j + gap * 1j, 20 + 60j), "D": (29 + 20j + gap * 1j, 29 + 60j)}


@pytest.mark.parametrize(("gap", "row"), [(5.3, 1), (5.5, 0)])
@pytest.mark.parametrize("hidden", ["guide", "hinge"])
def test_a_link_on_a_guide_or_on_a_hinge_weighs_two_fifths_of_a_link_on_a_link(hidden: str, gap: float, row: int) -> None:
    """Links 5.4 mm apart, of 9, hide two fifths of each other: nearer, the row with a link on a guide or a hinge is clearer."""
    if hidden == "hinge":
        places = beside(gap) | {"H": (1 + 1j, 24 + 60j)}
        assert clearest(outline_of(BESIDE, hinges=("H",)), poses_of(**places)) == row
    else:
        places = beside(gap) | {"E": (20 + 60j,), "F": (29 + 60j,), "K": (20 + 60j, 29 + 60j)}
        assert clearest(outline_of(BESIDE, rails=(Rail("E", "E", "F", "K"),)), poses_of(**places)) == row
        assert (
            clearest(outline_of(BESIDE, rails=(Rail("E", "E", "F"), Rail("E", "E", "F", "K", rolls=True))), poses_of(**places))
            == 1
        )


@pytest.mark.parametrize(("gap", "row"), [(8.9, 1), (9.1, 0), (-8.9, 1), (-9.1, 0)])
def test_links_9_mm_apart_are_seen_apart_in_a_row_that_is_sought(gap: float, row: int) -> None:
    assert clearest(outline_of(BESIDE), poses_of(**beside(gap))) == row


@pytest.mark.parametrize(("gap", "are_one"), [(1.45, True), (1.55, False), (-1.45, True), (-1.55, False)])
def test_links_in_row_1_lie_on_one_line_up_to_one_and_a_half_millimetres_apart(gap: float, are_one: bool) -> None:
    assert coincides(outline_of(BESIDE), poses_of(**beside(gap))) is are_one
    assert not coincides(outline_of({"1": "AB", "2": "CD"}), poses_of(**{name: at[::-1] for name, at in beside(gap).items()}))
    assert not coincides(outline_of({"1": "ABCD"}), poses_of(**beside(gap)))  # parts of one link are no two links


@pytest.mark.parametrize(("degrees", "row"), [(59, 1), (61, 0), (119, 0), (121, 1)])
def test_links_at_a_joint_become_clearer_up_to_sixty_degrees(degrees: float, row: int) -> None:
    """Against a row with two links 8.99 mm apart, which hide next to nothing."""
    arm = 30 + 40j + 20 * cmath.exp(1j * math.radians(degrees))
    places = {"A": (50 + 40j,), "B": (30 + 40j,), "C": (arm, 30 + 60j), "D": (1 + 70j,), "E": (21 + 70j,)}
    gap = {"F": (1 + 1j, 1 + 78.99j), "G": (21 + 1j, 21 + 78.99j)}
    assert clearest(outline_of({"1": "AB", "2": "BC", "3": "DE", "4": "FG"}), poses_of(**places, **gap)) == row


def test_a_block_in_a_slot_beside_its_point_is_a_part_of_the_link() -> None:
    """The slot runs 10 mm above A; another link lies in it in row 1, beside it in row 2."""
    slot = Slot("1", "A", "A", "B", ("R",))
    places = {"A": (20 + 20j,), "B": (40 + 20j,), "R": (30 + 30j,), "C": (20 + 30j, 20 + 60j), "D": (30 + 30j, 30 + 60j)}
    assert clearest(outline_of({"2": "CD"}, slots=(slot,)), poses_of(**places)) == 1
    assert clearest(outline_of({"1": "CD"}, slots=(slot,)), poses_of(**places)) == 0


@pytest.mark.parametrize(("count", "row"), [(180, 7), (181, 8), (360, 8), (361, 9)])
def test_of_more_than_180_rows_every_second_third_is_compared(count: int, row: int) -> None:
    """Each row is as clear as the next but for those before the eighth: from 0, of every second 8, of every third 9."""
    far = tuple(20 + 20j + (0 if k < 7 else 40j) for k in range(count))
    places = {"A": (20 + 20j,) * count, "B": (29 + 20j,), "C": far, "D": tuple(place + 9 for place in far)}
    assert clearest(outline_of(BESIDE), poses_of(**places)) == row
