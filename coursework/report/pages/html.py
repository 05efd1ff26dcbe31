"""The report on a screen: one self-contained page, `reports/report.html.j2` filled with the model.

Enters: a `ReportModel`.  Leaves: HTML that fetches nothing and prints on A4.  Works without Typst (equations as text).
Used by `report/output/formats.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.report.formulas.latex import latex
from coursework.report.formulas.svg import Drawn, draw
from coursework.report.live.script import alone, hash_of, packed
from coursework.report.pages.model import ReportModel
from coursework.words.errors import OutputError
from coursework.words.templates import filled


def render_html(model: ReportModel, *, pack: bool = True) -> str:
    """Return the report as one HTML page; Typst draws the equations, which stand as plain text if it is missing.

    `pack`: compress the script of the live part, which then unpacks itself and takes half the bytes; else it stays readable.
    """
    page = model.plain()
    drawn = _drawn(page)
    scripts = {"latex": latex, **_scripts(model, pack)} if model.scripts else {}
    made = filled("report.html.j2", page=page, pictures=drawn.pictures, glyphs=drawn.glyphs, live=model.live, **scripts)
    if model.scripts:  # such a page may come to need any style rule
        return made
    from coursework.words.stylesheets import fitted

    return fitted(made)


def _scripts(model: ReportModel, pack: bool) -> dict[str, Any]:
    """Return the scripts of a page by purpose, and the hashes that admit them; a packed script needs two."""
    copying = alone("copying")
    if model.live is None:
        return {"copying": copying, "admitted": [hash_of(copying)]}
    moving = packed(model.live.script) if pack else model.live.script
    admitted = dict.fromkeys((hash_of(copying), hash_of(moving), model.live.hash))
    return {"copying": copying, "moving": moving, "admitted": [*admitted]}


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
