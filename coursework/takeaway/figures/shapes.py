"""Reads a drawing of this tool back as shapes of a drawing office: segments, chains, circles, arrows, hatching, words.

Enters: SVG made by `drawing/paper`.  Leaves: shapes in mm of the sheet, y up.  Used by `dxf.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from xml.etree import ElementTree  # only for our own SVG, which is escaped and has no declarations

from coursework.system.frozen import frozen

_SVG = "{http://www.w3.org/2000/svg}"
_STEP = re.compile(r"([MmlZ])([^MmlZ]*)")  # the path data that `ways.py` writes
_NUMBER = re.compile(r"-?[\d.]+(?:e-?\d+)?")
SAME = 0.02  # mm: two places this near are the same
HEAD_CORNERS = 3


@frozen
class Pen:
    """How a line is drawn: width (mm), dashes (mm), and the data attributes that say what it is."""

    width: float
    dashes: tuple[float, ...]
    data: Mapping[str, str]


@frozen
class Chain:
    """A polyline; `fill` is "", "white", "black" or "grey"."""

    points: tuple[complex, ...]
    closed: bool
    fill: str
    pen: Pen


@frozen
class Circle:
    """A circle."""

    middle: complex
    radius: float
    fill: str
    pen: Pen


@frozen
class Arrow:
    """A polyline with a head; the tip is the first of the points."""

    points: tuple[complex, ...]
    head: float
    pen: Pen


@frozen
class Hatching:
    """Parallel strokes side by side: where each begins, and the vector `lean` of all of them."""

    begins: tuple[complex, ...]
    lean: complex
    pen: Pen


@frozen
class Words:
    """Words that begin `at` a place of their base line: pieces (text, letter height in mm, how far below the base line)."""

    at: complex
    pieces: tuple[tuple[str, float, float], ...]
    size: float
    italic: bool
    bold: bool
    pen: Pen


Shape = Chain | Circle | Arrow | Hatching | Words


def shapes_of(svg: str, height: float) -> Iterator[Shape]:
    """Yield the shapes from the background to the foreground, without those that only a screen shows."""
    line: Chain | None = None  # an open chain, to which the next shape may be the head
    for shape in _read(ElementTree.fromstring(svg), height):
        if isinstance(shape, Chain) and _is_head(shape):
            shape, line = _headed(line, shape)
        if line is not None:
            yield line
        line = shape if isinstance(shape, Chain) and not shape.closed else None
        if line is None:
            yield shape
    if line is not None:
        yield line


def _is_head(shape: Chain) -> bool:
    return shape.closed and shape.fill == "black" and len(shape.points) == HEAD_CORNERS


def _headed(line: Chain | None, head: Chain) -> tuple[Arrow, Chain | None]:
    """Return a head joined with the line that leads to it, and None; if no line does, the head alone and the line as it was."""
    tip, *sides = head.points
    neck = sum(sides) / 2
    size = abs(tip - neck)
    if line is not None and abs(line.points[-1] - neck) < SAME:
        return Arrow((tip, *reversed(line.points[:-1])), size, line.pen), None
    return Arrow((tip, neck), size, head.pen), line


def _read(element: ElementTree.Element, height: float) -> Iterator[Shape]:
    for one in element:
        if element.get("class") == "paper":
            one.set("data-bar", "")  # the bar for checking a print, with its ticks
        kind = one.tag.removeprefix(_SVG)
        if kind == "g" and one.get("display") != "none":
            yield from _read(one, height)
        elif kind == "line":
            ends = (complex(float(one.get(f"x{k}", 0)), height - float(one.get(f"y{k}", 0))) for k in (1, 2))
            yield Chain(tuple(ends), False, "", _pen(one))
        elif kind == "circle":
            middle = complex(float(one.get("cx", 0)), height - float(one.get("cy", 0)))
            yield Circle(middle, float(one.get("r", 0)), _fill(one), _pen(one))
        elif kind == "path":
            yield from _paths(one, height)
        elif kind == "text":
            yield _words(one, height)


def _pen(element: ElementTree.Element) -> Pen:
    has_line = element.get("stroke", "none") not in ("none", "white")
    dashes = tuple(map(float, _NUMBER.findall(element.get("stroke-dasharray", ""))))
    data = {name.removeprefix("data-"): value for name, value in element.attrib.items() if name.startswith("data-")}
    return Pen(float(element.get("stroke-width", 0)) if has_line else 0.0, dashes, data)


def _fill(element: ElementTree.Element) -> str:
    colour = element.get("fill", "black")
    if colour == "none":
        return "white" if element.get("stroke") == "white" else ""
    return colour if colour in ("white", "black") else "grey"


def _paths(element: ElementTree.Element, height: float) -> Iterator[Shape]:
    pieces = list(_pieces(element.get("d", ""), height))
    pen, fill = _pen(element), _fill(element)
    leans = {complex(round((points[1] - points[0]).real, 3), round((points[1] - points[0]).imag, 3)) for points, _ in pieces
             if len(points) == 2}  # fmt: skip
    if element.get("d", "").startswith("m") and len(leans) == 1 and all(len(points) == 2 for points, _ in pieces):
        yield Hatching(tuple(points[0] for points, _ in pieces), leans.pop(), pen)
        return
    band = float(element.get("stroke-width", 0)) if element.get("stroke") == "white" else 0.0
    for points, closed in pieces:
        yield Chain(_beside(*points, band), True, fill, pen) if band and len(points) == 2 else Chain(points, closed, fill, pen)


def _beside(a: complex, b: complex, width: float) -> tuple[complex, ...]:
    """Return the corners of the area that a white line covers, as a masking area has no line width."""
    aside = 0.5j * width * (b - a) / abs(b - a)
    return a - aside, b - aside, b + aside, a + aside


def _pieces(way: str, height: float) -> Iterator[tuple[tuple[complex, ...], bool]]:
    """Yield the pieces of a path: points, and whether the piece is closed."""
    points: list[complex] = []
    for letter, rest in _STEP.findall(way):
        numbers = list(map(float, _NUMBER.findall(rest)))
        places = [complex(x, -y) for x, y in zip(numbers[::2], numbers[1::2], strict=True)]
        at = points[-1] if points else 1j * height
        if letter == "Z":
            yield tuple(points), True
            points = points[:1]
            continue
        if letter in "Mm" and points:
            if len(points) > 1:
                yield tuple(points), False
            points = []
        if letter == "M":
            points = [1j * height + place for place in places]
        else:  # relative steps; those of m begin a new piece at the end of the last one
            for step in places:
                at += step
                points.append(at)
    if len(points) > 1:
        yield tuple(points), False


def _words(element: ElementTree.Element, height: float) -> Words:
    size = float(element.get("font-size", 3.2))
    low, pieces = 0.0, [(element.text or "", size, 0.0)]
    for span in element:
        low += float(span.get("dy", 0))
        pieces.append((span.text or "", float(span.get("font-size", size)), low))
    at = complex(float(element.get("x", 0)), height - float(element.get("y", 0)))
    italic, bold = element.get("font-style") == "italic", element.get("font-weight") == "bold"
    return Words(at, tuple(piece for piece in pieces if piece[0]), size, italic, bold, _pen(element))
