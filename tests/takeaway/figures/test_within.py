"""Nothing of a drawing lies beyond its edge, where no page and no file would show it; and its caption names what is drawn."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree import ElementTree

import pytest
from fontTools.pens.boundsPen import ControlBoundsPen
from fontTools.svgLib.path import parse_path

from coursework.report.text.parts import Figure
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


@pytest.mark.long
@pytest.mark.parametrize("name", ["31", "v107", "31-forces", "example-1-forces", "variable-crank-table"])
def test_a_drawing_lies_on_its_sheet(name: str) -> None:
    for title, picture in pictures_of(model_of(solved(name))).items():
        found = [*places(ElementTree.fromstring(picture.svg))]
        beyond = [(x, y) for x, y in found if not (-PEN <= x <= picture.width + PEN and -PEN <= y <= picture.height + PEN)]
        assert found and not beyond, title


@pytest.mark.parametrize("name", ["31", "31-forces", "example-1-forces"])
def test_a_caption_names_the_row_that_is_drawn(name: str) -> None:
    """That of the file's check where forces or centres are drawn; with a time, the one that the row has."""
    run = solved(name)
    found = [part for section in model_of(run).sections for part in section.parts if isinstance(part, Figure) and part.id]
    for figure in found:
        caption = "".join(piece.get("t", piece.get("v", "")) for piece in figure.caption)
        rows, others = (set(re.findall(r"[Rr]ow (\d+)", text)) for text in (caption, figure.alt))
        assert rows == others or not others, figure.id
        assert figure.id in {"mechanism", "tangent"} or rows <= {str(run.variant.time.row_of_check)}, figure.id
        times = {float(time) for time in re.findall(r"t = (\d+(?:\.\d+)?)", caption)}
        assert times <= {float(f"{run.motion.t[int(row) - 1]:.6g}") for row in rows}, figure.id
    assert len(found) >= 3
