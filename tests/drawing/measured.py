"""What a drawing says, measured without the code that drew it: the boxes of its words by the font's own metrics, its lines.

Enters: SVG text.  Leaves: boxes and lines in mm.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass
from functools import cache
from xml.etree import ElementTree

import numpy as np
from matplotlib import font_manager
from matplotlib.ft2font import FT2Font

SVG = "{http://www.w3.org/2000/svg}"
UNITS = 64 * 10  # of the font engine a pixel, at the size it is asked at


@dataclass(frozen=True)
class Word:
    """A text with its box (left, top, right, bottom) in mm."""

    text: str
    box: tuple[float, float, float, float]

    def meets(self, other: Word) -> bool:
        a, b = self.box, other.box
        return min(a[2], b[2]) > max(a[0], b[0]) and min(a[3], b[3]) > max(a[1], b[1])


@dataclass(frozen=True)
class Line:
    """A line from `a` to `b` (mm) with what the drawing says of it."""

    a: complex
    b: complex
    says: dict[str, str]


@cache
def _font(bold: bool) -> FT2Font:
    found = FT2Font(font_manager.findfont(font_manager.FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal")))
    found.set_size(640, 72)
    return found


def size(text: str, height: float, bold: bool = False) -> tuple[float, float, float]:
    """Return advance, ascent and descent (mm) of a text in a font `height` mm high."""
    font = _font(bold)
    font.set_text(text, 0.0)
    wide, high, below = (side / UNITS * height / 64 for side in (*font.get_width_height(), font.get_descent()))
    return wide, high - below, -below


def words(svg: str) -> list[Word]:
    """Return the words of a drawing that is not turned."""
    found = []
    root = ElementTree.fromstring(svg)
    for hidden in root.findall(f".//{SVG}g[@display='none']"):  # what a screen has instead
        hidden.clear()
    moved = {
        node: [float(part) for part in group.get("transform", "")[len("translate(") : -1].split()]
        for group in root.iter(f"{SVG}g")
        if group.get("transform", "").startswith("translate(")
        for node in group.iter(f"{SVG}text")
    }
    for node in root.iter(f"{SVG}text"):
        right, down = moved.get(node, (0.0, 0.0))
        usual = float(node.get("font-size", root.get("font-size", "3")))
        pieces = [(node.text or "", usual, 0.0)]
        for piece in node:
            pieces.append((piece.text or "", float(piece.get("font-size", usual)), float(piece.get("dy", "0"))))
            pieces.append((piece.tail or "", usual, 0.0))
        x = left = float(node.get("x", "0")) + right
        base = float(node.get("y", "0")) + down
        top, bottom = base, base
        for text, height, shift in pieces:
            base += shift
            if text:
                wide, up, low = size(text, height, node.get("font-weight") == "bold")
                x, top, bottom = x + wide, min(top, base - up), max(bottom, base - low)
        back = (x - left) * {"middle": 0.5, "end": 1.0}.get(node.get("text-anchor", "start"), 0.0)
        found.append(Word("".join(node.itertext()), (left - back, top, x - back, bottom)))
    return found


def points(way: str) -> list[complex]:
    """Return the corners of a path of places and steps (M, L, m, l, Z) in mm, y down."""
    found: list[complex] = []
    for kind, told in re.findall(r"([MLml])([^A-Za-z]*)", way):
        numbers = [float(number) for number in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", told)]
        for x, y in zip(numbers[::2], numbers[1::2], strict=True):
            found.append(complex(x, y) + (found[-1] if kind.islower() and found else 0))
    return found


def overlaps(svg: str) -> list[tuple[str, str]]:
    """Return the pairs of words that cover each other."""
    return [(a.text, b.text) for a, b in itertools.combinations(words(svg), 2) if a.meets(b)]


def beyond(svg: str) -> list[str]:
    """Return the words that leave the sheet."""
    _, _, width, height = map(float, ElementTree.fromstring(svg).get("viewBox", "").split())
    return [w.text for w in words(svg) if w.box[0] < 0 or w.box[1] < 0 or w.box[2] > width or w.box[3] > height]


def apart(word: Word, point: complex) -> float:
    """Return how far a word is from a point (mm), 0 for a point within its box."""
    left, top, right, bottom = word.box
    across, down = max(left - point.real, point.real - right, 0.0), max(top - point.imag, point.imag - bottom, 0.0)
    return abs(complex(across, down))


def lines(svg: str, key: str) -> list[Line]:
    """Return the lines that carry an attribute."""
    found = []
    for node in ElementTree.fromstring(svg).iter(f"{SVG}line"):
        if key in node.attrib:
            a, b = (complex(float(node.get(f"x{k}", "0")), float(node.get(f"y{k}", "0"))) for k in "12")
            found.append(Line(a, b, dict(node.attrib)))
    return found


def names(svg: str, key: str) -> set[str]:
    """Return the values of an attribute."""
    return {node.attrib[key] for node in ElementTree.fromstring(svg).iter() if key in node.attrib}


def along(line: Line, count: int = 240) -> np.ndarray:
    """Return places on a line, so near each other that no word passes between them."""
    return line.a + (line.b - line.a) * np.arange(count + 1) / count


def beside(word: Word, line: Line) -> float:
    """Return how far a word is from a line (mm)."""
    (left, top, right, bottom), places = word.box, along(line)
    across = np.maximum(np.maximum(left - places.real, places.real - right), 0.0)
    down = np.maximum(np.maximum(top - places.imag, places.imag - bottom), 0.0)
    return float(np.hypot(across, down).min())


def led(svg: str, word: Word, own: list[Line]) -> bool:
    """Return whether a thin line leads from a word to one of its own lines."""
    near = [line for line in lines(svg, "data-leader") if min(apart(word, line.a), apart(word, line.b)) < 3.0]
    return any(abs(place - foot) < 1.5 for line in near for mine in own for place in along(mine) for foot in (line.a, line.b))


def crossed(svg: str, *keys: str) -> list[tuple[str, str]]:
    """Return the words through which a line goes that carries one of the attributes."""
    drawn = [line for key in keys for line in lines(svg, key)]
    return [(word.text, str(line.says)) for word in words(svg) for line in drawn if beside(word, line) == 0.0]


def covers(line: Line, other: Line) -> bool:
    """Return whether two lines lie on one another: what stands beside one stands beside both."""
    return int((np.abs(along(line, 20)[:, None] - along(other)).min(axis=1) < 0.5).sum()) > 1


def astray(svg: str, word: Word, own: list[Line], others: list[Line]) -> list[str]:
    """Return the other lines to which a word stands nearer than to its own, where no thin line leads it back."""
    mine = min(beside(word, line) for line in own)
    nearer = [line for line in others if beside(word, line) <= mine and not any(covers(line, one) for one in own)]
    return [] if led(svg, word, own) else [f"{word.text} at {line.says}" for line in nearer]
