"""The report on a screen: one self-contained page, `reports/report.html.j2` filled with the model.

Enters: a `ReportModel`.  Leaves: HTML that fetches nothing and prints on A4.  Works without Typst (equations as text).
Used by `report/output/formats.py`.
"""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path
from typing import Any

from coursework.report.formulas.svg import Drawn, draw
from coursework.report.pages.model import ReportModel
from coursework.words.data_folders import folder
from coursework.words.errors import OutputError
from coursework.words.templates import filled

_BARE = re.compile(r"""("[^"]*")|/\*.*?\*/|\s*([{};,])\s*|(?<=:)\s+""", re.DOTALL)


def _stylesheet(name: str) -> str:
    return _text(folder("reports") / f"{name}.css")


@lru_cache
def _text(path: Path) -> str:
    """Return a stylesheet without its remarks and margins, which only its reader needs."""
    return _BARE.sub(lambda found: found[1] or found[2] or "", path.read_text(encoding="utf-8"))


def render_html(model: ReportModel) -> str:
    """Return the report as one HTML page; equations are drawn by Typst, or stand as text where it is missing."""
    page = model.plain()
    drawn = _drawn(page)
    style = _stylesheet("report") + (_stylesheet("live") if model.live else "")
    return filled("report.html.j2", page=page, style=style, pictures=drawn.pictures, glyphs=drawn.glyphs, live=model.live)


def _drawn(page: dict[str, Any]) -> Drawn:
    sources = [
        item["math"]
        for section in page["sections"]
        for part in section["parts"]
        if part["kind"] == "equations"
        for item in part["items"]
    ]
    try:
        return draw(sources, breaks=True)
    except OutputError:
        return Drawn({}, "")
