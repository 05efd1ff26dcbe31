"""The drawings of a page, each with a telling name; `--format figures`: a folder with every one as SVG, PDF and PNG.

Enters: a `ReportModel`, or `Results`.  Leaves: `Picture`s, or the bytes of files.  Used by `dxf.py`, `note/` and by the list of
formats, by name.
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
from coursework.report.output.results import Results
from coursework.report.pages.model import ReportModel
from coursework.report.pages.pdf import pdf_of
from coursework.report.text.parts import Figure, Panels
from coursework.system.files.whole_files import free_name
from coursework.system.frozen import frozen
from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say

DOTS_PER_INCH = 300
MM_PER_INCH = 25.4
_END_OF_HEAD = 33  # bytes of a PNG before the first free place: signature and chunk IHDR
_HALOED = re.compile(r'<text class="halo" ([^\n]*</text>)')
_BORDER = 'fill="#fff" stroke="#fff" stroke-width=".9" stroke-linejoin="round" aria-hidden="true"'
# The last text in a group with text-anchor "end": an italic part first, then an upright one.
_ENDED = re.compile(r'<text x="([\d.]+)" (y="[\d.]+")>(<tspan font-style="italic">[^<]*</tspan>)([^<]+)</text></g>')
_NARROW, _WIDE = 0.36, 0.54  # widths relative to the letter height: of a comma or a space, of the letters of a unit
_UNSAFE = re.compile(r"[^\w.-]+")


@frozen
class Picture:
    """One drawing: name of its file without ending, SVG, size in mm, text for those who cannot see it."""

    name: str
    svg: str
    width: float
    height: float
    alt: str

    @property
    def file(self) -> str:
        """Return SVG that any program draws well, even without paint-order or with every part of a text anchored by itself."""
        svg = _ENDED.sub(_parted, self.svg)
        return _HALOED.sub(rf"<text {_BORDER} \1<text \1", svg.replace(HALO, "")) if HALO in svg else svg


def _parted(found: re.Match[str]) -> str:
    """Return both parts of such a text as texts of their own, each with its proper end."""
    x, y, head, tail = found.groups()
    left = float(x) - LETTERS * sum(_NARROW if letter in ", " else _WIDE for letter in tail)
    return f'<text x="{x}" {y}>{tail}</text><text x="{left:.2f}" {y}>{head}</text></g>'


def pictures_of(model: ReportModel) -> dict[str, Picture]:
    """Return every drawing of the page in order, by name: its own id or that of its section; graphs by what they show."""
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
    free = free_name(_UNSAFE.sub("-", name).strip("-.") or "drawing", {one.casefold() for one in found})
    found[free] = Picture(free, svg, width, height, alt)


def as_pdf(picture: Picture, language: str) -> bytes:
    """Return a drawing as a PDF of one page of its size.  Raises `OutputError` if Typst is missing."""
    return pdf_of("drawing.typ", _asked([picture], language)).content


def as_png(pictures: Sequence[Picture], language: str) -> Iterator[bytes]:
    """Yield drawings as PNG with 300 dots per inch; the files say so, so that they have their true size in a text."""
    if pictures:
        made = typeset("drawing.typ", _asked(pictures, language), "png", ppi=DOTS_PER_INCH)
        yield from map(_with_density, [made] if isinstance(made, bytes) else made)


def _asked(pictures: Sequence[Picture], language: str) -> dict[str, Any]:
    return {
        "title": pictures[0].name, "language": language,
        "drawings": [{"svg": one.svg, "width": one.width, "height": one.height, "alt": one.alt} for one in pictures],
    }  # fmt: skip


def _with_density(content: bytes) -> bytes:
    """Return a PNG with a chunk that tells how many dots there are per metre."""
    density = round(DOTS_PER_INCH / MM_PER_INCH * 1000)
    said = b"pHYs" + struct.pack(">IIB", density, density, 1)
    chunk = struct.pack(">I", len(said) - 4) + said + struct.pack(">I", zlib.crc32(said))
    return content[:_END_OF_HEAD] + chunk + content[_END_OF_HEAD:]


FOLDER = "figures"


def write(results: Results) -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of each file.  Raises `NotToBeHad` if the page has no drawing."""
    pictures = list(pictures_of(results.model).values())
    if not pictures:
        raise NotToBeHad(say("fault.W041"))
    for one, png in zip(pictures, as_png(pictures, results.language), strict=True):
        stem = f"{FOLDER}/{one.name}"
        yield f"{stem}.svg", one.file.encode("utf-8")
        yield f"{stem}.pdf", as_pdf(one, results.language)
        yield f"{stem}.png", png
