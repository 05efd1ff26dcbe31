"""Draws shapes into a DXF document, each on the layer of its kind.

Enters: shapes of a sheet (mm, y up).  Leaves: a document of ezdxf.  Used by `dxf.py`.
"""

from __future__ import annotations

import cmath
import math
import re
from functools import singledispatchmethod
from typing import Any

from coursework.takeaway.figures.shapes import Arrow, Chain, Circle, Hatching, Pen, Shape, Words

# Colours by number, as is usual in drawing offices: thin lines have other colours than thick ones.
LAYERS = {
    "links": 7, "joints": 7, "ground": 8, "velocities": 1, "dimensions": 3, "construction": 8, "text": 7,
}  # fmt: skip
_BY_DATA = {
    "link": "links", "slot": "links", "sleeve": "joints", "joint": "joints", "rail": "ground", "velocity": "velocities",
    "driven": "velocities", "plan": "velocities", "force": "velocities", "dimension": "dimensions", "angle": "dimensions",
    "bar": "dimensions", "leader": "text", "chord": "construction",
}  # fmt: skip
CAPITAL = 0.729  # height of a capital of the sheet's face, relative to the font size
WIDTHS = (0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100)  # line widths of DXF, hundredths of a mm
FACE, STYLE = "arial.ttf", "SHEET"  # with Greek and Cyrillic; every drawing program has or replaces it
JOINT = 1.2  # mm: largest radius of a joint
THIN, SLEEVE, HEAVY = 0.2, 0.5, 0.6  # mm: dimension lines are below THIN, sleeves and links from SLEEVE and HEAVY on
GREY = 9  # colour number
DISC = 24  # corners of the area that covers the lines below a joint
TYPED = str.maketrans({"\\": "\\\\", "{": "\\{", "}": "\\}", "^": "^ ", "%": "{%}", "\u00a0": " ", "\u2009": " "})
LOWERED = re.compile("[₀-₉]+")
DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
LOW = 0.72  # height of a subscript, relative to the letter


class Draft:
    """A document being drawn."""

    def __init__(self, width: float, height: float) -> None:
        from ezdxf import units
        from ezdxf.filemanagement import new

        self.document: Any = new("R2010")
        self.document.units = units.MM
        self.document.header["$LIMMAX"] = (width, height)
        self.document.header["$EXTMIN"], self.document.header["$EXTMAX"] = (0, 0, 0), (width, height, 0)
        self.document.styles.add(STYLE, font=FACE)
        for name, colour in LAYERS.items():
            self.document.layers.add(name, color=colour)
        self.space: Any = self.document.modelspace()

    @singledispatchmethod
    def draw(self, shape: Shape) -> None:
        """Draw a shape."""
        raise TypeError(type(shape).__name__)

    @draw.register
    def _(self, chain: Chain) -> None:
        layer, points = self._layer(chain.pen, chain), [_xy(p) for p in chain.points]
        if chain.fill == "white":
            self._cover(points, layer)
        elif chain.fill and chain.closed:
            hatch = self.space.add_hatch(color=7 if chain.fill == "black" else GREY, dxfattribs={"layer": layer})
            hatch.paths.add_polyline_path(points, is_closed=True)
        if not chain.pen.width:
            return
        if len(points) == 2:
            self.space.add_line(*points, dxfattribs=self._look(chain.pen, layer))
        else:
            self.space.add_lwpolyline(points, close=chain.closed, dxfattribs=self._look(chain.pen, layer))

    @draw.register
    def _(self, circle: Circle) -> None:
        layer = self._layer(circle.pen, circle)
        if circle.fill == "white":
            turn = [circle.middle + cmath.rect(circle.radius, math.tau * k / DISC) for k in range(DISC)]
            self._cover([_xy(p) for p in turn], layer)
        elif circle.fill:
            hatch = self.space.add_hatch(color=7, dxfattribs={"layer": layer})
            hatch.paths.add_edge_path().add_arc(_xy(circle.middle), circle.radius, 0, 360)
        self.space.add_circle(_xy(circle.middle), circle.radius, dxfattribs=self._look(circle.pen, layer))

    @draw.register
    def _(self, arrow: Arrow) -> None:
        layer = self._layer(arrow.pen, arrow)
        override = {"dimasz": arrow.head, "dimscale": 1.0, "dimldrblk": "", "dimclrd": 256, "dimlwd": self._weight(arrow.pen)}
        points = [(*_xy(p), 0) for p in arrow.points]
        self.space.add_leader(points, override=override, dxfattribs=self._look(arrow.pen, layer))

    @draw.register
    def _(self, hatching: Hatching) -> None:
        first, last = hatching.begins[0], hatching.begins[-1]
        step = (last - first) / (len(hatching.begins) - 1) if len(hatching.begins) > 1 else hatching.lean * 1j
        ends = first - step / 2, last + step / 2
        border = [ends[0], ends[1], ends[1] + hatching.lean, ends[0] + hatching.lean]
        angle = math.degrees(cmath.phase(hatching.lean))
        hatch = self.space.add_hatch(color=256, dxfattribs=self._look(hatching.pen, "ground"))
        hatch.set_pattern_fill("GROUND", definition=[[angle, _xy(first), _xy(step), []]])
        hatch.paths.add_polyline_path([_xy(p) for p in border], is_closed=True)

    @draw.register
    def _(self, words: Words) -> None:
        text, size = "", words.size * CAPITAL
        for piece, height, low in words.pieces:
            said = _typed(piece)
            text += _lowered(said) if low > 0 and height < words.size else said
        face = f"\\fArial|b{int(words.bold)}|i{int(words.italic)};" if words.italic or words.bold else ""
        made = self.space.add_mtext(
            f"{face}{text}", dxfattribs={"layer": "text", "style": STYLE, "char_height": size, "width": 0, "attachment_point": 1}
        )
        made.set_location((words.at.real, words.at.imag + size, 0))

    def _cover(self, points: list[tuple[float, float]], layer: str) -> None:
        """Cover what lies below, as the symbol of a joint hides the ends of its links."""
        self.space.add_wipeout(points).dxf.layer = layer

    def _layer(self, pen: Pen, shape: Shape) -> str:
        for name, layer in _BY_DATA.items():
            if name in pen.data:
                return layer
        if pen.dashes:
            return "construction"
        if isinstance(shape, Circle):
            return "joints" if shape.radius <= JOINT else "links"
        if isinstance(shape, Arrow):
            return "velocities" if pen.width > THIN else "dimensions"
        if isinstance(shape, Chain) and shape.closed:
            return "links" if shape.fill == "grey" else "ground" if len(shape.points) == 3 else "joints"
        if pen.width < THIN:
            return "dimensions"
        return "links" if pen.width >= HEAVY or pen.width == THIN else "joints" if pen.width >= SLEEVE else "ground"

    def _look(self, pen: Pen, layer: str) -> dict[str, Any]:
        return {"layer": layer, "lineweight": self._weight(pen), **({"linetype": self._dashed(pen)} if pen.dashes else {})}

    def _weight(self, pen: Pen) -> int:
        return min(WIDTHS, key=lambda one: abs(one - 100 * pen.width))

    def _dashed(self, pen: Pen) -> str:
        """Return the name of the line type with these dashes, which is added when first used."""
        name = "DASH_" + "_".join(f"{part:g}".replace(".", "") for part in pen.dashes)
        if name not in self.document.linetypes:
            pattern = [part if place % 2 == 0 else -part for place, part in enumerate(pen.dashes)]
            self.document.linetypes.add(name, [sum(pen.dashes), *pattern])
        return name


def _xy(point: complex) -> tuple[float, float]:
    return (round(point.real, 6) + 0.0, round(point.imag, 6) + 0.0)


def _lowered(text: str) -> str:
    return f"{{\\H{LOW}x;\\S^ {text};}}"


def _typed(text: str) -> str:
    """Return text without what MTEXT would take for a command or cannot print; subscript digits become MTEXT subscripts."""
    kept = "".join(letter for letter in text.translate(TYPED) if letter.isprintable())
    return LOWERED.sub(lambda found: _lowered(found[0].translate(DIGITS)), kept)
