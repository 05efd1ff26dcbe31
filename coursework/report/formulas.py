"""Displayed equations as SVG for the HTML page: set by Typst like those on paper, each once per process.

Enters: Typst math sources.  Leaves: SVG with glyphs by reference, and the glyphs, once for all.
Used by `assigning/sheet.py` and `html.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from coursework.report.typesetting import typeset

_SYMBOL = re.compile(r'<symbol id="([^"]+)".*?</symbol>', re.DOTALL)
_DEFINITIONS = re.compile(r"<defs[^>]*>.*?</defs>", re.DOTALL)
_OPENING = re.compile(r'<svg[^>]*?viewBox="([^"]+)"[^>]*?width="([\d.]+)pt"[^>]*?height="([\d.]+)pt"[^>]*>')
NARROW = 260  # pt: what the screen of a phone shows without being moved
MOST_CACHED = 2000  # equations kept; a batch over many variants starts anew beyond


@dataclass(frozen=True, slots=True)
class Picture:
    """A formula as SVG and its width in pt."""

    svg: str
    width: float

    @property
    def is_wide(self) -> bool:
        """Return whether it may have to be moved sideways, so that the keyboard must reach it."""
        return self.width > NARROW


@dataclass(frozen=True, slots=True)
class Drawn:
    """Pictures by source, and the glyphs they refer to (to stand once in the page)."""

    pictures: dict[str, Picture]
    glyphs: str


_cache: dict[str, tuple[Picture, dict[str, str]]] = {}


def draw(sources: Iterable[str]) -> Drawn:
    """Return every equation as SVG.  Raises `OutputError` where Typst is not installed."""
    wanted = list(dict.fromkeys(sources))
    if len(_cache) > MOST_CACHED:
        _cache.clear()
    if missing := [source for source in wanted if source not in _cache]:
        pages = typeset("equation.typ", missing, "svg")
        pages = pages if isinstance(pages, list) else [pages]
        for source, page in zip(missing, pages, strict=True):
            _cache[source] = _taken_apart(page.decode("utf-8"))
    glyphs: dict[str, str] = {}
    for source in wanted:
        glyphs |= _cache[source][1]
    return Drawn({source: _cache[source][0] for source in wanted}, "".join(glyphs[key] for key in sorted(glyphs)))


def _taken_apart(svg: str) -> tuple[Picture, dict[str, str]]:
    """Return the picture without its glyphs, and the glyphs by id."""
    glyphs = {match[1]: match[0] for match in _SYMBOL.finditer(svg)}
    opening = _OPENING.search(svg)
    if not opening:
        raise ValueError("Typst's SVG has another shape than this version of it wrote")
    box, width, height = opening[1], float(opening[2]), float(opening[3])
    body = _DEFINITIONS.sub("", svg[opening.end() :])
    size = f'width="{width:.2f}pt" height="{height:.2f}pt" style="--wide:{width:.2f}pt"'
    head = f'<svg class="math" viewBox="{box}" {size} aria-hidden="true">'
    body = body.replace(' fill="#000000" fill-rule="nonzero"', "").replace("xlink:href", "href")
    return Picture(head + re.sub(r">\s+<", "><", body).strip(), width), glyphs
