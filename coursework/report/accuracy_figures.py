"""Figures of the accuracy section: error against cost, and bars.

Enters: numbers and labels.  Leaves: SVG text, as in `figures.py`, whose drawing settings and lock are used.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from coursework.report.figures import GREY, MM, STYLES, WIDTH, drawing, label_text, svg_text
from coursework.report.numbers import superscript
from coursework.report.symbols import Symbol

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure as Drawing

Pen = dict[str, Any]  # what matplotlib is told of a line or, without a style of line, of a patch
Sample = tuple[str, Pen]  # one entry of the legend
OTHERS = ("own_legend", "end_legend", "floor_legend")  # below the methods

PLOT_HEIGHT = 68.0  # mm of the axes with their labels
LEGEND_COLUMNS = (3, 2, 1)  # as many as have room for their words
LEGEND_LINE = 4.4  # mm of one line of the legend
LEGEND_LEFT, LEGEND_PEN, LEGEND_GAP = 12.0, 9.0, 1.8  # mm: where it begins, of a sample, between it and its words
LETTER, SIGN = 1.66, 2.9  # mm at 8 points: of a letter, a little more than the mean, and of a Chinese sign
BAR_HEIGHT = 4.2  # mm of paper for one bar
HATCHES = ("", "////", "....")
FILLS = ("#9ecae1", "#fdd0a2", "#d9d9d9")
NEAR = 3.0  # triangles closer than this factor of cost (its square in error) would overlap
OWN: Pen = {
    "linestyle": "none", "marker": "o", "markersize": 11, "markerfacecolor": "none", "markeredgecolor": "black",
    "markeredgewidth": 1.3,
}  # fmt: skip
LAST_ROW: Pen = {"linewidth": 0.7, "linestyle": (0, (4, 2))}
ROUND_OFF: Pen = {"color": "#e6e6e6", "linewidth": 0}
SMALLEST = 1e-17  # an error of exactly 0 has no place on a logarithmic axis; it is drawn here


@dataclass(frozen=True, slots=True)
class Method:
    """One line: evaluations, seconds (None = not shown), largest and last-row error at each setting, its order."""

    name: str
    evaluations: tuple[int, ...]
    seconds: tuple[float | None, ...]
    errors: tuple[float, ...]
    end_errors: tuple[float, ...]
    order: float | None
    order_text: str


@dataclass(frozen=True, slots=True)
class Panels:
    """The whole figure; `own` = (evaluations, seconds, error) of the coursework, `labels` by key of the words file."""

    methods: tuple[Method, ...]
    own: tuple[int, float | None, float] | None
    floor: float
    error_label: str
    labels: dict[str, str]

    @property
    def timed(self) -> bool:
        """Return whether there are running times for a second panel."""
        return any(seconds is not None for method in self.methods for seconds in method.seconds)


@dataclass(frozen=True, slots=True)
class Bar:
    """One kind of bar: its word, a value for each label."""

    label: str
    values: tuple[float, ...]


def _sheet(height: float) -> Drawing:
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure as Drawing

    figure = Drawing(figsize=(WIDTH * MM, height * MM))
    FigureCanvasSVG(figure)
    return figure


def _plain_axes(axes: Axes) -> None:
    axes.grid(visible=True, linewidth=0.3, color="#d0d0d0")
    axes.set_axisbelow(True)
    axes.tick_params(which="both", length=2.5, labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _powers(*each: Axis) -> None:
    """Label the decades of a logarithmic axis "10⁻³": as text, because matplotlib's own mathematics takes 7 ms a label."""
    from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator

    for axis in each:
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"10{superscript(str(round(math.log10(value))))}"))
        axis.set_minor_formatter(NullFormatter())
        axis.set_minor_locator(NullLocator())  # fifteen decades would have a hundred marks that nobody reads


def panels(name: str, page: Panels) -> tuple[str, float]:
    """Return error against evaluations and, where times are shown, against seconds, sharing the error axis; and mm high."""
    with drawing(name):
        columns = _columns([*(method.name for method in page.methods), *(page.labels[key] for key in OTHERS)])
        legend = LEGEND_LINE * max(map(len, columns))
        height = PLOT_HEIGHT + legend
        figure = _sheet(height)
        below, tall = (legend + 11.0) / height, (PLOT_HEIGHT - 12.5) / height
        first = figure.add_axes((0.09, below, 0.43 if page.timed else 0.895, tall))
        first.set_ylabel(page.error_label, parse_math=False)
        samples = _panel(first, page, timed=False)
        if page.timed:
            second = figure.add_axes((0.555, below, 0.43, tall), sharey=first)
            second.tick_params(labelleft=False)
            _panel(second, page, timed=True)
        _legend(figure, dict(samples), columns, height)
        return svg_text(figure, WIDTH, height), height


def _columns(words: list[str]) -> list[list[str]]:
    """Return the words of a legend in columns that fit side by side."""
    found = [words]
    for count in LEGEND_COLUMNS:
        rows = -(-len(words) // count)
        found = [words[first : first + rows] for first in range(0, len(words), rows)]
        if LEGEND_LEFT + sum(map(_wide, found)) <= WIDTH:
            break
    return found


def _wide(column: list[str]) -> float:
    """Return mm of a column of the legend, with room behind it."""
    longest = max(sum(SIGN if sign >= "\u2e80" else LETTER for sign in words) for words in column)
    return LEGEND_PEN + 2 * LEGEND_GAP + longest


def _legend(figure: Drawing, pens: dict[str, Pen], columns: list[list[str]], height: float) -> None:
    """Write the legend below the axes; matplotlib's own lays every word out eight times."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Rectangle

    rows, begin = max(map(len, columns)), LEGEND_LEFT
    for column in columns:
        left, middle, right = (at / WIDTH for at in (begin, begin + LEGEND_PEN / 2, begin + LEGEND_PEN))
        begin += _wide(column)
        for row, words in enumerate(column):
            pen = pens.get(words)
            if pen is None:  # nothing of it is drawn
                continue
            y, thick = LEGEND_LINE * (rows - row - 0.5) / height, 2.4 / height
            if "linestyle" in pen:
                x = [middle] if pen["linestyle"] == "none" else [left, middle, right]
                figure.add_artist(Line2D(x, [y] * len(x), markevery=[len(x) // 2], **pen))
            else:
                figure.add_artist(Rectangle((left, y - thick / 2), right - left, thick, **pen))
            figure.text(right + LEGEND_GAP / WIDTH, y, words, fontsize=8, va="center_baseline", parse_math=False)


def _panel(axes: Axes, page: Panels, *, timed: bool) -> list[Sample]:
    """Draw the lines of one panel and return what its legend says."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    _powers(axes.xaxis, axes.yaxis)
    _plain_axes(axes)
    triangles: list[tuple[float, float]] = []
    samples: list[Sample] = []
    for index, method in enumerate(page.methods):
        if (pen := _line(axes, method, index, triangles, timed=timed)) is not None:
            samples.append((method.name, pen))
    if page.own is not None:
        evaluations, seconds, error = page.own
        cost = seconds if timed else evaluations
        if cost is not None:
            axes.plot([cost], [_shown(error)], zorder=5, **OWN)
            samples.append((page.labels["own_legend"], OWN))
    # One line of the legend stands for all broken thin lines.
    samples.append((page.labels["end_legend"], {"color": "#404040", **LAST_ROW}))
    if page.floor > 0:
        low = min(axes.get_ylim()[0], page.floor / 10)
        axes.set_ylim(bottom=low)
        axes.axhspan(low, page.floor, zorder=0, **ROUND_OFF)
        samples.append((page.labels["floor_legend"], ROUND_OFF))
    axes.set_xlabel(page.labels["seconds" if timed else "evaluations"], parse_math=False, labelpad=2)
    return samples


def _shown(error: float) -> float:
    return max(abs(error), SMALLEST)


def _line(axes: Axes, method: Method, index: int, triangles: list[tuple[float, float]], *, timed: bool) -> Pen | None:
    """Draw one method and return its pen, None where it has nothing to show."""
    colour, dashes, mark = STYLES[index % len(STYLES)]
    costs = method.seconds if timed else method.evaluations
    points = sorted(
        (float(cost), _shown(error), _shown(end))
        for cost, error, end in zip(costs, method.errors, method.end_errors, strict=True)
        if cost is not None and math.isfinite(error)
    )
    if not points:
        return None
    x, y, end = zip(*points, strict=True)
    pen: Pen = {
        "color": colour, "linestyle": dashes, "marker": mark, "markersize": 4, "linewidth": 1.2, "markerfacecolor": "white",
    }  # fmt: skip
    axes.plot(x, y, zorder=3, **pen)
    if any(math.isfinite(value) for value in end):
        axes.plot(x, end, color=colour, zorder=2, **LAST_ROW)
    if method.order is not None and not timed:
        _slope(axes, x, y, method, colour, triangles)
    return pen


def _slope(
    axes: Axes, x: tuple[float, ...], y: tuple[float, ...], method: Method, colour: str, triangles: list[tuple[float, float]]
) -> None:
    """Draw a triangle with the measured slope above a line, towards its cheap-to-dear end where lines are apart."""
    if method.order is None or len(x) < 3:
        return
    start = max(1, (2 * len(x)) // 3) - 1
    left, right = x[start], x[start] * min(x[start + 1] / x[start], 4.0)
    top = y[start] * 3
    bottom = top * (right / left) ** -method.order
    if any(max(right / x0, x0 / right) < NEAR and max(top / y0, y0 / top) < NEAR**2 for x0, y0 in triangles):
        return  # two labels would lie on each other; the note of the table has every order
    triangles.append((right, top))
    axes.fill([left, right, right], [top, top, bottom], facecolor="none", edgecolor=colour, linewidth=0.8, zorder=4)
    axes.annotate(
        method.order_text, (right, math.sqrt(top * bottom)), xytext=(2.5, 0), textcoords="offset points", ha="left",
        va="center", fontsize=8, color="black", parse_math=False,
    )  # fmt: skip


def bars(
    name: str,
    labels: Sequence[Symbol | str],
    groups: Sequence[Bar],
    x_label: str,
    *,
    texts: Sequence[str] = (),
    logarithmic: bool = False,
) -> tuple[str, float]:
    """Return horizontal bars and the height of the drawing in mm; `texts` stand at the ends of a single group."""
    height = 15.0 + BAR_HEIGHT * len(labels) * (len(groups) + 0.6) + (5.0 if len(groups) > 1 else 0.0)
    with drawing(name):
        figure = _sheet(height)
        below, above = 10.0 / height, (7.0 if len(groups) > 1 else 2.0) / height
        left = 0.09 if len(groups) > 1 else 0.3
        axes = figure.add_axes((left, below, 0.97 - left, 1 - below - above))
        _plain_axes(axes)
        axes.grid(visible=False, axis="y")
        thick = 1 / (len(groups) + 0.6)
        for index, group in enumerate(groups):
            places = [row + (index - (len(groups) - 1) / 2) * thick for row in range(len(labels))]
            axes.barh(
                places, group.values, height=thick * 0.86, color=FILLS[index % 3], edgecolor="black", linewidth=0.6,
                hatch=HATCHES[index % 3], label=group.label,
            )  # fmt: skip
        _bar_axes(axes, labels, x_label, logarithmic=logarithmic)
        for row, text in enumerate(texts):
            axes.annotate(
                text, (groups[0].values[row], row), xytext=(3, 0), textcoords="offset points", va="center", fontsize=8,
                parse_math=False,
            )  # fmt: skip
        if len(groups) > 1:
            axes.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncols=len(groups), frameon=False, borderaxespad=0.2)
        return svg_text(figure, WIDTH, height), height


def _bar_axes(axes: Axes, labels: Sequence[Symbol | str], x_label: str, *, logarithmic: bool) -> None:
    words = [label.replace("$", r"\$") if isinstance(label, str) else label_text(label) for label in labels]
    axes.set_yticks(range(len(words)), words)
    axes.set_ylim(len(words) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0, labelsize=8.5)
    axes.set_xlabel(x_label, parse_math=False, labelpad=2)
    if logarithmic:
        axes.set_xscale("log")
        _powers(axes.xaxis)
        low, high = axes.get_xlim()
        axes.set_xlim(low / 2, high * 6)
    else:
        axes.axvline(0, color=GREY, linewidth=0.8)
        axes.margins(x=0.08)
