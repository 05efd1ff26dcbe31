"""A sheet of paper in millimetres: lines, circles, arrows, and labels that do not cover each other.

Enters: points in mm as complex numbers, x to the right and y **down**.  Leaves: SVG, one user unit = 1 mm.
Used by `painter.py`, `board.py`, `drawing/figures.py` and `drawing/check_sheet/drawing.py`; knows nothing of mechanisms.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterable, Sequence

import numpy as np

from coursework.drawing.paper.cover import Rectangle, Segment
from coursework.drawing.paper.placing import BEYOND, MARGIN, Owner, Place, Taken
from coursework.drawing.paper.ways import numbers_of, way
from coursework.words.html_table import escaped

AXIS = 'stroke="black" stroke-width="0.15" stroke-dasharray="2.4 1 0.4 1"'  # the pen of axes and construction lines
FONT = "'DejaVu Sans', Verdana, 'Segoe UI', sans-serif"
LETTER = 3.2  # mm, 9 pt
SMALL_LETTER = 3.0  # mm, 8.5 pt, and 11 px on a screen at full size: the smallest size of a word
SIZES = (LETTER, 2.3, SMALL_LETTER)  # mm: of the text, of its subscript, of what follows
DECIMALS = 3  # decimals of a mm: 1 µm is finer than paper or screen can show
BROAD = frozenset("MWmwωΩΨΦφψЖШЩЮФМжшщюфмы%@…—=+−<>")
NARROW = frozenset(" \u00a0.,:;/|!'()[]ijl")
HEAVIER = 1.1  # a bold word is this many times as wide
AXES = 7.0  # mm, length of the arrows x and y
LONGEST = 60  # letters of a text; a longer one would run over the drawing
PITCH = 1.6  # mm between the strokes of a hatch
CROWDED = 8.0  # mm of covered lines: axes that cover more are not seen among them
BOLD, ITALIC = 'font-weight="bold"', 'font-style="italic"'
OFF_POINT = 1.6  # mm: the symbol of a joint reaches this far around a point
BAND = 'stroke="white" stroke-width="1.8" stroke-linecap="butt"'
HIDDEN, ALONG = 12.0, 0.95  # mm, and cosine of the angle: a shorter arrow nearer to a link's direction is not seen on it
HEADLESS = 2.1  # mm, 8 px: a shorter vector has no head, as it would be nothing else
HALO = "<style>.halo{stroke:#fff;stroke-width:.9;stroke-linejoin:round;paint-order:stroke}</style>"  # around words on lines
LEAD = 'stroke="#555" stroke-width="0.15"'
Word = tuple[str, str, str]  # text, its subscript, what follows


def plain(text: str) -> str:
    """Return text fit for SVG: printable letters only, escaped, at most `LONGEST` letters."""
    kept = "".join(letter for letter in text if letter.isprintable())
    return escaped(kept if len(kept) <= LONGEST else kept[: LONGEST - 1] + "…")


def width(text: str) -> float:
    """Return an upper estimate of a text's width, in heights of its letters; a Chinese letter is a square."""
    return sum(map(_wide, text))


def _wide(letter: str) -> float:
    if ord(letter) > 0x2E80:
        return 1.02
    return 0.9 if letter in BROAD else 0.42 if letter in NARROW else 0.71 if letter.isupper() else 0.64


def number(value: float, decimals: int = DECIMALS) -> str:
    """Return a coordinate as text, without a minus before zero."""
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def inside(a: complex, b: complex, box: Rectangle) -> tuple[complex, complex] | None:
    """Return the part of a segment within a rectangle (left, top, right, bottom), None if there is none."""
    low, high = 0.0, 1.0
    step = b - a
    for at, rate, least, most in ((a.real, step.real, box[0], box[2]), (a.imag, step.imag, box[1], box[3])):
        if rate == 0:
            if not least <= at <= most:
                return None
            continue
        first, second = sorted(((least - at) / rate, (most - at) / rate))
        low, high = max(low, first), min(high, second)
    return (a + low * step, a + high * step) if low < high else None


class Sheet:
    """What is drawn so far, and the room that it takes."""

    def __init__(self, width: float, height: float, field: Rectangle) -> None:
        self.width, self.height, self.field = width, height, field
        self.items: list[str] = []
        self.segments: list[Segment] = []
        self.heavy: list[Segment] = []  # links and arrows, on which no word may stand
        self.boxes: list[Rectangle] = []  # symbols that words are not to cover
        self.words: list[Rectangle] = []  # boxes of the words so far
        self.taken = Taken(self.segments, self.heavy, self.boxes, self.words)

    def line(self, a: complex, b: complex, pen: str, data: str = "", *, heavy: bool = False) -> None:
        """Draw a segment, clipped to the drawing field."""
        if part := inside(a, b, self.field):
            a, b = part
            ends = f'x1="{number(a.real)}" y1="{number(a.imag)}" x2="{number(b.real)}" y2="{number(b.imag)}"'
            self.items.append(f"<line {ends} {pen}{data}/>")
            (self.heavy if heavy else self.segments).append((a, b))

    def path(self, points: Sequence[complex], look: str, *, closed: bool = False, blocks: bool = True) -> None:
        """Draw a line through points; `look` gives stroke and fill, and if it `blocks`, words avoid it."""
        self.items.append(f'<path d="{_way(points)}{"Z" if closed else ""}" {look}/>')
        if blocks:
            self.segments += itertools.pairwise(points)

    def circle(self, at: complex, radius: float, look: str, data: str = "", *, rim: bool = False, blocks: bool = True) -> None:
        """Draw a circle; words keep off its disc, with `rim` only off its line, unless it does not block."""
        self.items.append(f'<circle cx="{number(at.real)}" cy="{number(at.imag)}" r="{number(radius)}" {look}{data}/>')
        if not blocks:
            return
        if rim:
            turn = [at + cmath.rect(radius, math.tau * k / 32) for k in range(33)]
            self.segments += itertools.pairwise(turn)
        else:
            self.boxes.append((at.real - radius, at.imag - radius, at.real + radius, at.imag + radius))

    def arrow(self, a: complex, b: complex, pen: str, data: str = "", head: float = 2.6, *, heavy: bool = False) -> None:
        """Draw an arrow from a to b with a filled head."""
        along = (b - a) / abs(b - a)
        neck = b - along * min(head, abs(b - a))
        self.line(a, neck, pen, data, heavy=heavy)
        side = 0.32 * head * 1j * along
        self.path([b, neck + side, neck - side], f'fill="black"{data}', closed=True)

    def vector(self, a: complex, b: complex, pen: str, data: str) -> None:
        """Draw the arrow of a vector; a short one along a heavy line gets a white band, as it would not be seen otherwise."""
        along = (b - a) / abs(b - a)
        if OFF_POINT < abs(b - a) < HIDDEN and any(self._hides(a, along, line) for line in self.heavy):
            self.items.append(f'<path d="{_way((a + OFF_POINT * along, b))}" fill="none" {BAND}/>')
        if abs(b - a) < HEADLESS:
            self.line(a, b, pen, data, heavy=True)
        else:
            self.arrow(a, b, pen, data, head=min(2.6, 0.6 * abs(b - a)), heavy=True)

    def _hides(self, at: complex, along: complex, line: Segment) -> bool:
        ways = [end - at for end in line if abs(end - at) > OFF_POINT]
        return len(ways) == 1 and (along.conjugate() * ways[0]).real > ALONG * abs(ways[0])

    def axes(self, highest: float = 0.0) -> None:
        """Draw the directions of x and y in the corner where they cover least; below, if that is much and `highest` allows."""
        left, top, right, bottom = self.field
        wide = high = AXES + 3.5
        corners = [complex(x, y) for y in (bottom - high, top) for x in (left, right - wide)]
        middles = np.array([(corner.real + wide / 2, corner.imag + high / 2) for corner in corners])
        costs = self.taken.covered(middles, wide, high, self.field)
        corner = corners[int(np.argmin(costs))]
        if costs.min() > CROWDED + 2 * BEYOND * MARGIN and self.height + high <= highest:
            self.height, self.field = self.height + high, (left, top, right, bottom + high)
            corner = complex(left, bottom)
        at = corner + complex(1, high - 1.5)
        pen = 'stroke="black" stroke-width="0.2"'
        for toward, name, shift in ((complex(AXES), "x", 0.5 + 0.9j), (-AXES * 1j, "y", 1.0 + 1.2j)):
            self.arrow(at, at + toward, pen, head=1.6)
            self.text(at + toward + shift, (name, "", ""), ITALIC)
        self.words.append((corner.real, corner.imag, corner.real + wide, corner.imag + high))

    def hatch(self, a: complex, b: complex, away: complex) -> None:
        """Hatch one side of a segment: short strokes that lean towards `away` (a direction)."""
        if a == b or not away:
            return  # at this scale the segment is too small to have sides
        count = max(1, round(abs(b - a) / PITCH))
        along = (b - a) / count
        lean = (away / abs(away) - along / abs(along)) * 1.3
        strokes = [(a + (k + 0.5) * along, a + (k + 0.5) * along + lean) for k in range(count)]
        self.strokes([(p, q) for p, q in strokes if inside(p, q, self.field)], 'stroke="black" stroke-width="0.15"')

    def strokes(self, lines: Sequence[Segment], pen: str) -> None:
        """Draw segments as one path, in which each after the first is written from the end of the one before."""
        part, at, text = 10**DECIMALS, (0, 0), ""
        for a, b in lines:
            begin, step = ((round(part * one.real), round(part * one.imag)) for one in (a, b - a))
            text += f"m{numbers_of((begin[0] - at[0], begin[1] - at[1], *step), DECIMALS)}"
            at = begin[0] + step[0], begin[1] + step[1]
        self.items.append(f'<path d="{text}" fill="none" {pen}/>')
        self.segments += lines

    def label(self, word: Word, places: Iterable[Place], look: str = "", *, turn: int = 0, owner: Owner | None = None) -> Place:
        """Write a word beside one of its places, the best ones first, where it covers least; return that place.

        `turn` +1 or -1 puts an arc with an arrow before the word: counter-clockwise or clockwise.  Without an `owner` a word
        belongs to the points of its places.
        """
        listed = list(places)
        lead = 6.6 if turn else 0.0
        wide = sum(size * width(part[:LONGEST]) for part, size in zip(word, SIZES, strict=True))
        wide = lead + wide * (HEAVIER if look == BOLD else 1.0)
        height = 5.8 if turn else LETTER * 0.95 + (0.6 if word[1] else 0)
        owner = owner or Owner([(at, at) for at, _, _ in listed])
        stand = self.taken.stand(wide, height, listed, owner, self.field)
        middle = stand.middle
        left, top = middle.real - wide / 2, middle.imag - height / 2
        if stand.leader is not None:
            self.leader(stand.leader, (left, top, left + wide, top + height))
        self.words.append((left, top, left + wide, top + height))
        if turn:
            self.sense(complex(left + 3, middle.imag), turn)
        base = middle.imag + LETTER * 0.37 - (0.3 if word[1] else 0)
        self.text(complex(left + lead, base), word, look)
        return stand.place

    def leader(self, foot: complex, box: Rectangle) -> None:
        """Draw the thin line from the thing that a word names to the word."""
        edge = inside(foot, complex(box[0] + box[2], box[1] + box[3]) / 2, box)
        if edge is not None and abs(edge[0] - foot) > MARGIN:
            self.line(foot, edge[0], LEAD, ' data-leader=""')

    def text(self, at: complex, word: Word, look: str = "", size: float = LETTER) -> None:
        """Write a word on a white halo, with its base line beginning at a point."""
        head, low, tail = (plain(part) for part in word)
        upright = ""
        if tail.startswith(" "):  # a value, not part of the name
            tail = "\u00a0" + tail[1:]  # a renderer may drop a space at the beginning of a tspan
            upright = ' font-style="normal"' if look == ITALIC else ""
        below = f'<tspan dy="0.8" font-size="{SIZES[1]}">{low}</tspan>' if low else ""
        raised = ' dy="-0.8"' if low else ""
        if low and tail and not tail[0].isspace():
            raised += ' dx="0.5"'  # else the halo of what follows covers the subscript
        beside = f'<tspan{raised} font-size="{SIZES[2]}"{upright}>{tail}</tspan>' if tail else ""
        high = "" if size == LETTER else f' font-size="{size}"'
        place = f'x="{number(at.real)}" y="{number(at.imag)}"{high}'
        self.items.append(f'<text class="halo" {place}{" " if look else ""}{look}>{head}{below}{beside}</text>')

    def sense(self, at: complex, turn: int) -> None:
        """Draw the sense of a rotation: an arc of 250 degrees with an arrowhead, +1 counter-clockwise as seen."""
        angles = [math.radians(90 + turn * (-125 + 250 * k / 20)) for k in range(21)]
        arc = [at + 2.3 * cmath.exp(1j * angle).conjugate() for angle in angles]
        self.path(arc, 'fill="none" stroke="black" stroke-width="0.3"', blocks=False)
        along = (arc[-1] - arc[-2]) / abs(arc[-1] - arc[-2])
        tip = arc[-1] + 1.7 * along
        self.path([tip, arc[-1] + 0.9j * along, arc[-1] - 0.9j * along], 'fill="black"', closed=True, blocks=False)

    def svg(self) -> str:
        """Return the drawing as SVG text."""
        width, height = number(self.width, 4), number(self.height, 4)  # the next item on the page begins where this ends
        return "\n".join((
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}" '
            f'font-size="{LETTER}">',
            f'{HALO}<g font-family="{FONT}" fill="black" stroke-linecap="round">',
            *self.items,
            "</g>",
            "</svg>",
        ))  # fmt: skip


def _way(points: Sequence[complex]) -> str:
    return way([np.real(points), np.imag(points)], decimals=DECIMALS) if points else "M"
