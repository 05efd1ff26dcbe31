"""Figures of the accuracy section: error against cost, and bars.

Enters: numbers and labels.  Leaves: SVG text, as in `figures.py`, whose drawing settings and lock are used.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from coursework.report.figures import GREY, MM, STYLES, WIDTH, drawing, label_text, svg_text
from coursework.report.numbers import superscript
from coursework.report.symbols import Symbol

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure as Drawing

PLOT_HEIGHT = 74.0  # mm of the axes with their labels
LEGEND_COLUMNS = 3
OTHER_ENTRIES = 3  # of the legend: the own step, the last row, round-off
LEGEND_LINE = 4.4  # mm of one line of the legend
BAR_HEIGHT = 4.2  # mm of paper for one bar
HATCHES = ("", "////", "....")
FILLS = ("#9ecae1", "#fdd0a2", "#d9d9d9")
NEAR = 3.0  # triangles closer than this factor of cost (its square in error) would overlap
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
        legend = LEGEND_LINE * -(-(len(page.methods) + OTHER_ENTRIES) // LEGEND_COLUMNS)
        height = PLOT_HEIGHT + legend
        figure = _sheet(height)
        below, tall = (legend + 11.0) / height, (PLOT_HEIGHT - 12.5) / height
        first = figure.add_axes((0.09, below, 0.43 if page.timed else 0.895, tall))
        first.set_ylabel(page.error_label, parse_math=False)
        _panel(first, page, timed=False)
        if page.timed:
            second = figure.add_axes((0.555, below, 0.43, tall), sharey=first)
            second.tick_params(labelleft=False)
            _panel(second, page, timed=True)
        handles, words = first.get_legend_handles_labels()
        figure.legend(
            handles, words, loc="lower left", bbox_to_anchor=(0.07, 0.0), ncols=LEGEND_COLUMNS, frameon=False, fontsize=8,
            handlelength=3.2, columnspacing=1.4, handletextpad=0.5, borderaxespad=0.2,
        )  # fmt: skip
        return svg_text(figure, WIDTH, height), height


def _panel(axes: Axes, page: Panels, *, timed: bool) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    _powers(axes.xaxis, axes.yaxis)
    _plain_axes(axes)
    triangles: list[tuple[float, float]] = []
    for index, method in enumerate(page.methods):
        _line(axes, method, index, triangles, timed=timed)
    if page.own is not None:
        evaluations, seconds, error = page.own
        cost = seconds if timed else evaluations
        if cost is not None:
            axes.plot(
                [cost], [_shown(error)], linestyle="none", marker="o", markersize=11, markerfacecolor="none",
                markeredgecolor="black", markeredgewidth=1.3, zorder=5, label=page.labels["own_legend"],
            )  # fmt: skip
    # One line of the legend stands for all broken thin lines.
    axes.plot([], [], color="#404040", linewidth=0.7, linestyle=(0, (4, 2)), label=page.labels["end_legend"])
    if page.floor > 0:
        low = min(axes.get_ylim()[0], page.floor / 10)
        axes.set_ylim(bottom=low)
        axes.axhspan(low, page.floor, color="#e6e6e6", linewidth=0, zorder=0, label=page.labels["floor_legend"])
    axes.set_xlabel(page.labels["seconds" if timed else "evaluations"], parse_math=False, labelpad=2)


def _shown(error: float) -> float:
    return max(abs(error), SMALLEST)


def _line(axes: Axes, method: Method, index: int, triangles: list[tuple[float, float]], *, timed: bool) -> None:
    colour, dashes, mark = STYLES[index % len(STYLES)]
    costs = method.seconds if timed else method.evaluations
    points = sorted(
        (float(cost), _shown(error), _shown(end))
        for cost, error, end in zip(costs, method.errors, method.end_errors, strict=True)
        if cost is not None and math.isfinite(error)
    )
    if not points:
        return
    x, y, end = zip(*points, strict=True)
    axes.plot(
        x, y, color=colour, linestyle=dashes, marker=mark, markersize=4, linewidth=1.2, markerfacecolor="white",
        label=method.name.replace("$", r"\$"), zorder=3,
    )  # fmt: skip
    if any(math.isfinite(value) for value in end):
        axes.plot(x, end, color=colour, linewidth=0.7, linestyle=(0, (4, 2)), zorder=2)
    if method.order is not None and not timed:
        _slope(axes, x, y, method, colour, triangles)


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
