"""The drawings of a page, each under a speaking name.

Enters: a `ReportModel`.  Leaves: `Picture`s.  Used by `pictures.py` and `dxf.py`.
"""

from __future__ import annotations

import re
import struct
import zlib
from collections.abc import Iterator, Sequence
from typing import Any

from coursework.drawing.paper.sheet import HALO
from coursework.report.formulas.typesetting import typeset
from coursework.report.graphs.graph_paper import LETTERS
from coursework.report.pages.model import ReportModel
from coursework.report.pages.pdf import pdf_of
from coursework.report.text.parts import Figure, Panels
from coursework.system.frozen import frozen

DOTS_PER_INCH = 300
MM_PER_INCH = 25.4
_END_OF_HEAD = 33  # bytes of a PNG: its signature and the chunk IHDR
_HALOED = re.compile(r'<text class="halo" ([^\n]*</text>)')
_BORDER = 'fill="#fff" stroke="#fff" stroke-width=".9" stroke-linejoin="round" aria-hidden="true"'
# The end of a group of words that end where they stand: one of them slanted first, upright behind.
_ENDED = re.compile(r'<text x="([\d.]+)" (y="[\d.]+")>(<tspan font-style="italic">[^<]*</tspan>)([^<]+)</text></g>')
_NARROW, _WIDE = 0.36, 0.54  # of the height of letters: a comma or a space, and what a unit is written with
_UNSAFE = re.compile(r"[^\w.-]+")


@frozen
class Picture:
    """One drawing: its file's name without an ending, SVG, size in mm, words for who cannot see it."""

    name: str
    svg: str
    width: float
    height: float
    alt: str

    @property
    def file(self) -> str:
        """Return the SVG for any program, such as draws no white border of words, or ends each part of a word in one place."""
        svg = _ENDED.sub(_parted, self.svg)
        return _HALOED.sub(rf"<text {_BORDER} \1<text \1", svg.replace(HALO, "")) if HALO in svg else svg


def _parted(found: re.Match[str]) -> str:
    """Return a word whose parts end each where it should."""
    x, y, head, tail = found.groups()
    left = float(x) - LETTERS * sum(_NARROW if letter in ", " else _WIDE for letter in tail)
    return f'<text x="{x}" {y}>{tail}</text><text x="{left:.2f}" {y}>{head}</text></g>'


def pictures_of(model: ReportModel) -> dict[str, Picture]:
    """Return every drawing of the page in its order, by its name: that of its place on the page, or of what it shows."""
    found: dict[str, Picture] = {}
    for section in model.sections:
        for part in section.parts:
            if isinstance(part, Figure):
                _add(found, part.id or section.name, part.svg, part.width, part.height, part.alt)
            elif isinstance(part, Panels):
                for item in part.items:
                    _add(found, f"graph-{item.name}", item.svg, part.width, part.height, item.alt)
    return found


def _add(found: dict[str, Picture], name: str, svg: str, width: float, height: float, alt: str) -> None:
    stem = _UNSAFE.sub("-", name).strip("-.") or "drawing"
    free, number = stem, 2
    while free.casefold() in {one.casefold() for one in found}:
        free, number = f"{stem}-{number}", number + 1
    found[free] = Picture(free, svg, width, height, alt)


def as_pdf(picture: Picture, language: str) -> bytes:
    """Return a drawing as a PDF of one page of its size.  Raises `OutputError` where Typst is missing."""
    return pdf_of("drawing.typ", _asked([picture], language)).content


def as_png(pictures: Sequence[Picture], language: str) -> Iterator[bytes]:
    """Yield drawings as PNG of 300 dots an inch, which their files say, so that they have their size in a text."""
    if pictures:
        made = typeset("drawing.typ", _asked(pictures, language), "png", ppi=DOTS_PER_INCH)
        yield from map(_with_density, [made] if isinstance(made, bytes) else made)


def _asked(pictures: Sequence[Picture], language: str) -> dict[str, Any]:
    return {
        "title": pictures[0].name, "language": language,
        "drawings": [{"svg": one.svg, "width": one.width, "height": one.height, "alt": one.alt} for one in pictures],
    }  # fmt: skip


def _with_density(content: bytes) -> bytes:
    """Return a PNG whose file says how many dots a metre has."""
    density = round(DOTS_PER_INCH / MM_PER_INCH * 1000)
    said = b"pHYs" + struct.pack(">IIB", density, density, 1)
    chunk = struct.pack(">I", len(said) - 4) + said + struct.pack(">I", zlib.crc32(said))
    return content[:_END_OF_HEAD] + chunk + content[_END_OF_HEAD:]
