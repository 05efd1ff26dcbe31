"""Curves over time as SVG, by matplotlib without pyplot, on one sheet that is used again and again.

Enters: arrays and symbols.  Leaves: SVG text that is the same bytes in every process, in mm, with text kept as text.
Loads matplotlib when the first figure is drawn.  One drawing at a time (a lock): the sheet is shared.
"""

from __future__ import annotations

import io
import re
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.drawing import record
from coursework.integration.motion import Array
from coursework.report.page_context import PageContext
from coursework.report.parts import Figure, Runs
from coursework.report.symbols import Symbol

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Drawing
    from matplotlib.lines import Line2D

WIDTH, HEIGHT = 170.0, 82.0  # mm; the text width of A4 with margins of 20 mm
MM = 1 / 25.4  # inches
GREY = "#8c8c8c"
# Colours that stay apart for colour-blind readers (Okabe and Ito); dashes and marks keep them apart in print.
STYLES = (
    ("#0072b2", "-", "o"), ("#d55e00", "--", "s"), ("#009e73", "-.", "^"), ("#000000", ":", "D"),
    ("#cc79a7", (0, (5, 1, 1, 1, 1, 1)), "v"), ("#e69f00", (0, (8, 2)), "P"), ("#56b4e9", (0, (3, 1)), "X"),
    ("#7b3294", "-", "*"), ("#8c510a", "--", "<"), ("#000000", "-.", ">"),
)  # fmt: skip
MOST_MARKS = 30  # marks on one curve; more would merge into a band
MOST_POINTS = 2000  # points of one curve; finer than any printer at this width
SETTINGS: dict[str, Any] = {
    "svg.fonttype": "none", "font.family": ["DejaVu Sans"], "font.size": 8.5, "text.usetex": False,
    "mathtext.fontset": "dejavusans", "axes.unicode_minus": True, "path.simplify": True, "axes.linewidth": 0.6,
    "xtick.major.width": 0.6, "ytick.major.width": 0.6, "svg.image_inline": True,
}  # fmt: skip
_FALLBACKS = "'DejaVu Sans', Verdana, 'Segoe UI', sans-serif"
_LOCK = threading.Lock()


@dataclass(frozen=True, slots=True)
class Curve:
    """One marked line and, where there is one, the thin line behind it (t in s, values in one unit)."""

    symbol: Symbol
    t: Array
    values: Array
    thin_t: Array = field(default_factory=lambda: np.zeros(0))
    thin: Array = field(default_factory=lambda: np.zeros(0))


def label_text(symbol: Symbol) -> str:
    """Return a symbol for a label: Unicode where that suffices, mathtext of our own making for other subscripts."""
    if not symbol.subscript or symbol.subscript.isdigit():
        return symbol.text
    letter = symbol.letter if len(symbol.letter) == 1 else rf"\mathrm{{{symbol.letter}}}"
    head = rf"\dot{{{letter}}}" if symbol.dotted else letter
    low = symbol.subscript.replace("_", r"\_")
    return rf"${head}_{{\mathrm{{{low}}}}}$"


@contextmanager
def drawing(name: str) -> Iterator[None]:
    """Set matplotlib up for one figure, alone; `name` salts its ids, so that figures can share a page."""
    import matplotlib

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
    return text.replace("'DejaVu Sans'", _FALLBACKS).strip()


def sparse(values: Array, most: int) -> Array:
    """Return at most about `most` of the values, the last one included."""
    pace = max(1, -(-len(values) // most))
    kept = np.arange(0, len(values), pace)
    return values[np.union1d(kept, [len(values) - 1])] if len(values) else values


class _Sheet:
    """Axes with a fixed place; lines are taken from a stock and given new data, which is what makes it fast."""

    def __init__(self) -> None:
        from matplotlib.backends.backend_svg import FigureCanvasSVG
        from matplotlib.figure import Figure as Drawing

        self.figure = Drawing(figsize=(WIDTH * MM, HEIGHT * MM))
        FigureCanvasSVG(self.figure)
        self.axes: Axes = self.figure.add_axes((0.095, 0.13, 0.89, 0.76))
        self.axes.grid(visible=True, linewidth=0.3, color="#c8c8c8")
        self.axes.set_axisbelow(True)
        self.axes.tick_params(length=2.5)
        self.axes.yaxis.set_label_coords(0.008, 0.51, transform=self.figure.transFigure)
        for side in ("top", "right"):
            self.axes.spines[side].set_visible(False)
        self.stop_line = self.axes.axvline(0, color="black", linewidth=0.9, linestyle=(0, (6, 3)), zorder=1.5)
        self.thin: list[Line2D] = []
        self.marked: list[Line2D] = []

    def lines(self, stock: list[Line2D], count: int) -> list[Line2D]:
        while len(stock) < count:
            stock += self.axes.plot([], [])
        for index, line in enumerate(stock):
            line.set_visible(index < count)
            if index >= count:
                line.set_data([], [])
        return stock[:count]

    def draw(self, curves: Sequence[Curve], x_label: str, y_label: str, thin_label: str, stop: tuple[float, str] | None) -> str:
        thin = self.lines(self.thin, sum(1 for curve in curves if curve.thin.size))
        for line, curve in zip(thin, (curve for curve in curves if curve.thin.size), strict=True):
            line.set(color=GREY, linewidth=0.8, linestyle="-", zorder=2)
            line.set_data(sparse(curve.thin_t, MOST_POINTS), sparse(curve.thin, MOST_POINTS))
        marked = self.lines(self.marked, len(curves))
        for index, (line, curve) in enumerate(zip(marked, curves, strict=True)):
            colour, dashes, mark = STYLES[index % len(STYLES)]
            line.set(color=colour, linestyle=dashes, marker=mark, linewidth=1.2, markersize=3.4, zorder=3)
            line.set(markerfacecolor="white", markeredgewidth=0.9)
            t = sparse(curve.t, MOST_POINTS)
            line.set_data(t, sparse(curve.values, MOST_POINTS))
            line.set_markevery(max(1, len(t) // MOST_MARKS))
        self.stop_line.set_visible(stop is not None)
        self.stop_line.set_xdata([stop[0] if stop else 0.0] * 2)
        self.axes.set_xlabel(x_label, parse_math=False, labelpad=2)
        self.axes.set_ylabel(y_label, parse_math=False, verticalalignment="top")
        self._limits(curves, stop[0] if stop else None)
        handles, labels = list(marked), [label_text(curve.symbol) for curve in curves]
        if thin:
            handles, labels = [*handles, thin[0]], [*labels, thin_label]
        if stop:
            handles, labels = [*handles, self.stop_line], [*labels, stop[1].replace("$", r"\$")]
        self.axes.legend(
            handles, labels, loc="lower left", bbox_to_anchor=(0.05, 1.0), ncols=min(len(labels), 8), frameon=False,
            borderaxespad=0.2, handlelength=3.2, columnspacing=1.6, handletextpad=0.5, fontsize=8.5,
        )  # fmt: skip
        return svg_text(self.figure, WIDTH, HEIGHT)

    def _limits(self, curves: Sequence[Curve], stop: float | None) -> None:
        times = np.concatenate([np.concatenate([curve.t, curve.thin_t]) for curve in curves])
        values = np.concatenate([np.concatenate([curve.values, curve.thin]) for curve in curves])
        last = max(float(times.max()), stop or 0.0)
        first = float(times.min())
        low, high = float(values.min()), float(values.max())
        room = 0.06 * (high - low) or 0.5 * abs(high) or 1.0
        self.axes.set_xlim(first - 0.01 * (last - first or 1.0), last + 0.015 * (last - first or 1.0))
        self.axes.set_ylim(low - room, high + room)


@lru_cache(maxsize=1)
def _sheet() -> _Sheet:
    return _Sheet()


def time_plot(
    name: str, curves: Sequence[Curve], *, x_label: str, y_label: str, thin_label: str, stop: float | None = None,
    stop_label: str = "",
) -> str:  # fmt: skip
    """Return curves over time as SVG, `WIDTH` by `HEIGHT` mm.

    Parameters: `name` of the figure (salts its ids); labels as they stand; `stop` time of a dead point (s) and
    `stop_label` its kind.
    """
    with drawing(name):
        return _sheet().draw(curves, x_label, y_label, thin_label, None if stop is None else (stop, stop_label))


def drawn(context: PageContext, drawing: record.Drawing) -> Figure:
    """Return a drawing as a figure of the page, its words in the page's language."""
    caption, alt = context.rich(drawing.caption), context.told(drawing.alt)
    return Figure(drawing.svg, drawing.width, drawing.height, alt, caption, drawing.exact, id=drawing.id)


_SIZE = re.compile(r'<svg\b[^>]*?\swidth="([\d.]+)mm"[^>]*?\sheight="([\d.]+)mm"')


def true_to_scale(svg: str, alt: str, caption: Runs) -> Figure:
    """Return a drawing that prints at exactly the size it names.  Raises `ValueError` where it names none in mm."""
    size = _SIZE.search(svg)
    if not size:
        raise ValueError("a drawing to scale gives its width and height in mm")
    return Figure(svg[svg.index("<svg") :], float(size[1]), float(size[2]), alt, caption, exact=True)
