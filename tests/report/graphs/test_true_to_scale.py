"""Links, vectors and the bar read back from the PDF as vectors: every length the task sheet gives, at the scale printed."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import pymupdf
import pytest

from coursework.report.graphs.figures import scale_on_paper
from coursework.report.text.words import load_words
from tests.report.made import model_of, paper_of, solved

MM = 72 / 25.4
NEAR = 0.05  # mm
LINK, ARROW = 0.8, 0.4  # mm, the pens of a link and of a velocity


@dataclass(frozen=True)
class Printed:
    """What a page of a PDF shows, in mm: lines by their pen, filled triangles, circles (their widths), its text."""

    lines: dict[float, list[tuple[complex, complex]]]
    triangles: list[list[complex]]
    circles: list[float]
    bars: list[float]
    text: str


def _place(point: pymupdf.Point) -> complex:
    return complex(point.x, point.y) / MM


def _printed(sheet: pymupdf.Page) -> Printed:
    lines: dict[float, list[tuple[complex, complex]]] = {}
    triangles, circles, bars = [], [], []
    for path in sheet.get_drawings():
        pieces = [(_place(item[1]), _place(item[2])) for item in path["items"] if item[0] == "l"]
        if path["type"] == "f" and len(path["items"]) in {2, 3} and pieces:
            triangles.append([end for piece in pieces for end in piece])
        elif path["color"] is not None:
            pen = round(path["width"] / MM, 2)
            lines.setdefault(pen, []).extend(pieces)
            if sum(item[0] == "c" for item in path["items"]) == 4 and abs(path["rect"].width - path["rect"].height) < 0.01:
                circles.append(path["rect"].width / MM)
            if all(abs(part - 1 / 255) < 1e-3 for part in path["color"]):
                bars += [abs(a - b) for a, b in pieces]
    return Printed(lines, triangles, circles, bars, sheet.get_text())


@cache
def pages(name: str) -> tuple[Printed, ...]:
    made = paper_of(model_of(solved(name, quantities=["graph_check"])))
    with pymupdf.open(stream=made, filetype="pdf") as document:
        return tuple(_printed(sheet) for sheet in document)


def construction(name: str) -> tuple[Printed, float, float]:
    """Return the page of the construction, mm of paper a metre, and m/s a mm of paper, as it says."""
    # A wide sheet stands behind the plan, which has a bar of its own but no scale of lengths.
    page = next(one for one in pages(name) if one.bars and "scale" in one.text)
    scale = re.search(r"scale (\d+(?:\.\d+)?):(\d+(?:\.\d+)?)", page.text)
    speed = re.search(r"1 mm = (\S+) m/s", page.text)
    assert scale and speed
    return page, 1000 * float(scale[1]) / float(scale[2]), float(speed[1])


def has(lengths: Iterable[float], wanted: float) -> bool:
    return any(abs(length - wanted) < NEAR for length in lengths)


# From the task sheets: lengths of links in m, radii of wheels in m.
LINKS = {
    "31": (0.953, 0.847, 0.457, 2 * 0.457),
    "v107": (0.38, 0.862),
    "jansen": (0.015, 0.05, 0.0415, 0.0558, 0.0619, 0.0393, 0.0394, 0.0367, 0.0657),
}
WHEELS = {"31": (0.457 / 2,), "v107": (0.341,), "jansen": ()}


@pytest.mark.long
@pytest.mark.parametrize("name", LINKS)
def test_links_and_wheels_have_their_lengths_in_both_drawings(name: str) -> None:
    first = next(one for one in pages(name) if "Figure 1" in one.text)
    scale = re.search(r"scale 1:(\d+(?:\.\d+)?)", first.text)
    assert scale
    sheet, mm, _ = construction(name)
    for page, size in ((first, 1000 / float(scale[1])), (sheet, mm)):
        lengths = [abs(a - b) for a, b in page.lines[LINK]]
        for wanted in LINKS[name]:
            assert has(lengths, wanted * size), (wanted, sorted(lengths))
        for radius in WHEELS[name]:
            assert has(page.circles, 2 * radius * size), (radius, page.circles)


@pytest.mark.long
@pytest.mark.parametrize(("name", "sheets"), [("31", 1), ("v107", 2), ("jansen", 2)])
def test_the_bar_is_100_mm_on_each_sheet(name: str, sheets: int) -> None:
    """Where no centre can be drawn, or it lies off the sheet, there is a plan of velocities beside the position."""
    bars = [length for page in pages(name) for length in page.bars]
    assert len(bars) == sheets
    assert all(abs(bar - 100) < NEAR for bar in bars)


def arrows(page: Printed) -> list[float]:
    """Return the lengths of the velocities: from the beginning of a line to the tip of the head at its end."""
    found = []
    for begin, end in page.lines[ARROW]:
        heads = [corners for corners in page.triangles if min(abs(sum(corners) / len(corners) - end), 9) < 3]
        if heads:
            head = min(heads, key=lambda corners: abs(sum(corners) / len(corners) - end))
            found.append(max(abs(corner - begin) for corner in head))
    return found


def test_velocities_are_as_long_as_the_scale_says() -> None:
    phi, r3 = 2.87, 0.457
    for row in range(4):  # three steps of Euler by hand, equation (11) alone; row 4 is drawn
        driven = 4.5 * math.sin(13.08 * 0.02 * row + 4.35)
        omega = driven / (r3 * (2 * math.cos(phi) + math.sin(phi)))
        centre = omega * r3 * (math.cos(phi) - 2 * math.sin(phi))
        phi += 0.02 * omega
    speeds = {"M": abs(driven), "C": abs(centre)}
    page, _, speed = construction("31")
    found = arrows(page)
    for point in ("M", "C"):
        assert has(found, speeds[point] / speed), (point, found)
    page, _, speed = construction("v107")
    turned = 11.64 * 0.135 + 0.16
    assert has(arrows(page), math.hypot(2.6 * math.sin(turned), 2.0 * math.cos(turned)) / speed)
    page, _, speed = construction("jansen")
    assert has(arrows(page), 10 * 0.015 / speed)


@pytest.mark.parametrize(("language", "scale"), [
    ("en", ", 1 mm = 0.05 m/s²"), ("en", ", scale 1:2.5"), ("en", ", 1 mm = 2·10⁻⁸ m/s"), ("ru", ", μ = 0,05 (м/с²)/мм"),
    ("uk", ", 1 мм = 20 Н"), ("zh", "，μ = 0.5 (m/s)/mm"),
])  # fmt: skip
def test_a_scale_is_said_on_paper_only(language: str, scale: str) -> None:
    """On a screen a millimetre has no fixed size; there the bar below the drawing says it."""
    said = scale_on_paper(load_words(language), f"Row 4{scale}. The rest", lambda text: [{"t": text}])
    assert said == [{"t": "Row 4"}, {"o": scale}, {"t": ". The rest"}]
