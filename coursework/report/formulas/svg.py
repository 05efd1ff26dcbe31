"""Displayed equations as SVG for the HTML page: set by Typst like those on paper, each once per process.

Enters: Typst math sources.  Leaves: SVG with glyphs by reference, and the glyphs, once for all.
Used by `assigning/sheet.py` and `html.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from coursework.report.formulas.line_breaks import pieces
from coursework.report.formulas.typesetting import refusal, typeset
from coursework.system.frozen import frozen
from coursework.words.data_folders import folder

_SYMBOL = re.compile(r'<symbol id="([^"]+)"[^>]*>\s*<path d="([^"]+)"\s*/>\s*</symbol>')
_RUN = re.compile(r'<g transform="matrix\(1 0 0 -1 (\S+) (\S+)\)"\s*>((?:\s*<use [^>]*/>)*)\s*</g>')
_COPY = re.compile(r'href="#([^"]+)" x="([^"]+)" y="([^"]+)"')
_NOTHING = re.compile(r"<g [^>]*/>|</svg>")
_SHIFTED = re.compile(r'transform="translate\((\S+) (\S+)\)" d="M 0 0([^"A-Z]*)"')
_DEFINITIONS = re.compile(r"<defs[^>]*>.*?</defs>", re.DOTALL)
_OPENING = re.compile(r'<svg[^>]*?viewBox="([^"]+)"[^>]*?width="([\d.]+)pt"[^>]*?height="([\d.]+)pt"[^>]*>')
NARROW = 200  # pt: what the screen of the smallest phone, 320 px, shows without being moved
MOST_CACHED = 2000  # equations kept; a batch over many variants starts anew beyond


@frozen
class Picture:
    """A formula as SVG, in `pieces` that may stand one below the other, and the width of the widest in pt."""

    svg: str
    width: float
    pieces: int = 1

    @property
    def is_wide(self) -> bool:
        """Return whether it may have to be moved sideways, so that the keyboard must reach it."""
        return self.width > NARROW


@frozen
class Drawn:
    """Pictures by source, and the glyphs they refer to (to stand once in the page)."""

    pictures: dict[str, Picture]
    glyphs: str


_cache: dict[tuple[Path, str], tuple[Picture, dict[str, str]]] = {}


def draw(sources: Iterable[str], *, breaks: bool = False) -> Drawn:
    """Return every equation as SVG; `breaks`: a long one in pieces.  Raises `OutputError` where Typst is not installed."""
    parted = {source: pieces(source) if breaks else [source] for source in sources}
    wanted = list(dict.fromkeys(piece for parts in parted.values() for piece in parts))
    if len(_cache) > MOST_CACHED:
        _cache.clear()
    looks = folder("reports")  # own pieces may draw them in another way
    if missing := [piece for piece in wanted if (looks, piece) not in _cache]:
        try:
            pages = typeset("equation.typ", missing, "svg")
        except RuntimeError as error:  # typst.TypstError
            raise refusal(error) from error
        pages = pages if isinstance(pages, list) else [pages]
        for piece, page in zip(missing, pages, strict=True):
            _cache[looks, piece] = _taken_apart(page.decode("utf-8"))
    glyphs: dict[str, str] = {}
    for piece in wanted:
        glyphs |= _cache[looks, piece][1]
    pictures = {source: _joined([_cache[looks, piece][0] for piece in parts]) for source, parts in parted.items()}
    return Drawn(pictures, "".join(glyphs[key] for key in sorted(glyphs)))


def _joined(parts: list[Picture]) -> Picture:
    if len(parts) == 1:
        return parts[0]
    return Picture("".join(part.svg for part in parts), max(part.width for part in parts), len(parts))


def _taken_apart(svg: str) -> tuple[Picture, dict[str, str]]:
    """Return the picture without its glyphs, and the glyphs by id.  Raises `ValueError` where Typst writes another SVG."""
    glyphs = {found[1]: _marker(found[1], found[2]) for found in _SYMBOL.finditer(svg)}
    opening = _OPENING.search(svg)
    if not opening:
        raise ValueError("Typst's SVG has another shape than this version of it wrote")
    box, width, height = opening[1], float(opening[2]), float(opening[3])
    body = _DEFINITIONS.sub("", svg[opening.end() :])
    places: dict[str, list[str]] = {}
    for run in _RUN.finditer(body):
        for copy in _COPY.finditer(run[3]):
            # A run of letters counts its heights upwards.
            x, y = float(run[1]) + float(copy[2]), float(run[2]) - float(copy[3])
            places.setdefault(copy[1], []).append(f"{_short(x)} {_short(y)}")
    bars = _NOTHING.sub("", _RUN.sub("", body)).replace('stroke="#000000"', 'stroke="currentColor"')  # on a dark screen too
    bars = _SHIFTED.sub(lambda bar: f'd="M{_short(float(bar[1]))} {_short(float(bar[2]))}{bar[3]}"', bars)
    if "<use" in bars or not places.keys() <= glyphs.keys():
        raise ValueError("Typst's SVG has another shape than this version of it wrote")
    size = f'width="{width:.2f}pt" height="{height:.2f}pt" style="--wide:{width:.2f}pt"'
    head = f'<svg class="math" viewBox="{box}" {size} aria-hidden="true">'
    letters = "".join(_set(glyph, where) for glyph, where in places.items())
    bars = re.sub(r">\s+<", "><", bars).strip()
    return Picture(f'{head}<g fill="none">{letters}</g>{bars}</svg>', width), glyphs


def _marker(glyph: str, outline: str) -> str:
    """Return a glyph as a marker: the places of all its copies in a formula are numbers of one element.

    An element with a shift of its own for each copy, a thousand a page, is what a browser goes through whenever it paints.
    """
    drawn = f'<path transform="scale(1 -1)" d="{outline}"/>'
    return f'<marker id="{glyph}" markerUnits="userSpaceOnUse" overflow="visible">{drawn}</marker>'


def _set(glyph: str, places: list[str]) -> str:
    """Return a line that nobody sees with the glyph at each of its corners; its ends bear none."""
    return f'<polyline points="0 0 {" ".join(places)} 0 0" marker-mid="url(#{glyph})"/>'


def _short(value: float) -> str:
    """Return pt to a hundredth, which no eye can tell."""
    return f"{value:.2f}".rstrip("0").rstrip(".")
