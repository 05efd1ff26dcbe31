"""Nothing of a drawing lies beyond its edge, where no page and no file would show it."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree

import pytest
from fontTools.pens.boundsPen import ControlBoundsPen
from fontTools.svgLib.path import parse_path

from coursework.takeaway.figures.drawings import pictures_of
from tests.report.made import model_of
from tests.solved import solved

SVG = "{http://www.w3.org/2000/svg}"
PEN = 0.6  # mm: half of the thickest line


def places(root: ElementTree.Element) -> Iterator[tuple[float, float]]:
    """Give the ends of lines, the corners of paths, the centres of circles and where words begin; of what is not moved or cut."""
    aside = {
        id(node) for group in root.iter() if group.get("transform") or group.get("clip-path") or group.tag == f"{SVG}defs"
        for node in group.iter()
    }  # fmt: skip
    for node in root.iter():
        if node is root or id(node) in aside:
            continue
        named = [(x, y) for x, y in (("x1", "y1"), ("x2", "y2"), ("cx", "cy"), ("x", "y")) if node.get(x) is not None]
        yield from ((float(node.get(x, "")), float(node.get(y, ""))) for x, y in named)
        if node.tag == f"{SVG}path":
            parse_path(node.get("d", ""), pen := ControlBoundsPen(None))
            left, top, right, bottom = pen.bounds
            yield from ((left, top), (right, bottom))


@pytest.mark.parametrize("name", ["31", "v107", "31-forces", "example-1-forces", "variable-crank-table"])
def test_a_drawing_lies_on_its_sheet(name: str) -> None:
    for title, picture in pictures_of(model_of(solved(name))).items():
        found = [*places(ElementTree.fromstring(picture.svg))]
        beyond = [(x, y) for x, y in found if not (-PEN <= x <= picture.width + PEN and -PEN <= y <= picture.height + PEN)]
        assert found and not beyond, title
