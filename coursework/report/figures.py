"""How matplotlib draws for a page, without pyplot: settings, colours, SVG in mm; and drawings that print to scale.

Enters: a drawing.  Leaves: SVG text that is the same bytes in every process, with text kept as text.
Used by `accuracy_figures.py` and the sections that show a drawing.  One figure at a time (a lock).
"""

from __future__ import annotations

import io
import re
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING, Any

from coursework.data import folder
from coursework.drawing import record
from coursework.report.page_context import PageContext
from coursework.report.parts import Figure, Paragraph, Part
from coursework.report.symbols import Symbol

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawing

WIDTH = 170.0  # mm; the text width of A4 with margins of 20 mm
MM = 1 / 25.4  # inches
GREY = "#8c8c8c"
# Colours that stay apart for colour-blind readers (Okabe and Ito); dashes and marks keep them apart in print.
STYLES = (
    ("#0072b2", "-", "o"), ("#d55e00", "--", "s"), ("#009e73", "-.", "^"), ("#000000", ":", "D"),
    ("#cc79a7", (0, (5, 1, 1, 1, 1, 1)), "v"), ("#e69f00", (0, (8, 2)), "P"), ("#56b4e9", (0, (3, 1)), "X"),
    ("#7b3294", "-", "*"), ("#8c510a", "--", "<"), ("#000000", "-.", ">"),
)  # fmt: skip
SETTINGS: dict[str, Any] = {
    "svg.fonttype": "none", "font.family": ["DejaVu Sans", "Noto Sans CJK SC"], "font.size": 8.5, "text.usetex": False,
    "mathtext.fontset": "dejavusans", "axes.unicode_minus": True, "path.simplify": True, "axes.linewidth": 0.6,
    "xtick.major.width": 0.6, "ytick.major.width": 0.6, "svg.image_inline": True,
}  # fmt: skip
_FALLBACKS = "'DejaVu Sans', Verdana, 'Segoe UI', sans-serif"
_LOCK = threading.Lock()


def label_text(symbol: Symbol) -> str:
    """Return a symbol for a label: Unicode where that suffices, mathtext of our own making for other subscripts."""
    if not symbol.subscript or symbol.subscript.isdigit():
        return symbol.text
    letter = symbol.letter if len(symbol.letter) == 1 else rf"\mathrm{{{symbol.letter}}}"
    head = rf"\dot{{{letter}}}" if symbol.dotted else letter
    low = symbol.subscript.replace("_", r"\_")
    return rf"${head}_{{\mathrm{{{low}}}}}$"


@cache
def _know_own_faces() -> None:
    from matplotlib.font_manager import fontManager

    for face in sorted((folder("reports") / "fonts").glob("*.otf")):
        fontManager.addfont(face)


@contextmanager
def drawing(name: str) -> Iterator[None]:
    """Set matplotlib up for one figure, alone; `name` salts its ids, so that figures can share a page."""
    import matplotlib

    _know_own_faces()
    settings: Any = {**SETTINGS, "svg.hashsalt": name}
    with _LOCK, matplotlib.rc_context(settings):
        yield


def svg_text(figure: Drawing, width: float, height: float) -> str:
    """Return a drawing as SVG to stand in a page: no prolog, no metadata, no ids but those it refers to."""
    target = io.StringIO()
    figure.savefig(target, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    text = target.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>\s*", "", text, flags=re.DOTALL)
    text = re.sub(r"<!--.*?-->\s*", "", text, flags=re.DOTALL)
    text = re.sub(r'<g id="[^"]*"', "<g", text)
    text = re.sub(r' width="[^"]*pt"', f' width="{width:g}mm"', text, count=1)
    text = re.sub(r' height="[^"]*pt"', f' height="{height:g}mm"', text, count=1)
    return text.replace("'DejaVu Sans', 'Noto Sans CJK SC'", _FALLBACKS).strip()


def drawn(context: PageContext, drawing: record.Drawing) -> Figure:
    """Return a drawing as a figure of the page, its words in the page's language."""
    caption, alt = context.rich(drawing.caption), context.told(drawing.alt)
    return Figure(drawing.svg, drawing.width, drawing.height, alt, caption, drawing.exact, id=drawing.id)


def drawn_parts(context: PageContext, drawing: record.Drawing) -> list[Part]:
    """Return a drawing with the steps in which it was made."""
    figure = drawn(context, drawing)
    numbered = [context.rich(f"{number}. {context.told(step)}") for number, step in enumerate(drawing.steps, start=1)]
    return [figure, *(Paragraph(step, "note") for step in numbered)]
