"""Plots by matplotlib, for a user's own text.

Enters: a `Run` or a study.  Leaves: matplotlib Axes with labels, units and a legend.  Raises `InputError`.
Used by `run.py` and `study.py`; nothing else imports it, so no page waits for matplotlib.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from coursework.motion.integration.motion import Motion
from coursework.report.text.symbols import symbol
from coursework.results.accuracy.record import AccuracyStudy
from coursework.scene.scene_run import SceneRun
from coursework.system.grouped import grouped
from coursework.variant.record.variant import no_column
from coursework.words.sentences import say

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Lines that can be told apart in black and white: the rows are dots, the exact motion is a line.
ROWS: dict[str, Any] = {"linestyle": "--", "marker": "o", "markersize": 3.5}
MOTION: dict[str, Any] = {"linestyle": "-", "linewidth": 1.2}
BETWEEN = 8  # points of the exact line per row


def plot_run(run: SceneRun, names: Sequence[str], exact: bool, ax: Axes | None) -> Any:
    """Return the Axes that `Run.plot` describes."""
    listed = names or run.motion.velocity_names
    for name in listed:
        # For "B.vx", `unit_of` tells later whether there is such a point.
        if name not in run.motion.names and not _is_acceleration(run.motion, name) and "." not in str(name):
            raise no_column(name, run.motion.names)
    by_unit = grouped((run.variant.unit_of(name), name) for name in listed)
    if len(by_unit) == 1 or ax is not None:
        drawn = _axes(ax)
        _columns(drawn, run, listed, ", ".join(by_unit), exact)
        return drawn
    import matplotlib.pyplot as plt

    _, several = plt.subplots(len(by_unit), 1, sharex=True, layout="constrained")
    for one, (unit, group) in zip(several, by_unit.items(), strict=True):
        _columns(one, run, group, unit, exact)
    return several


def _columns(ax: Axes, run: SceneRun, names: Sequence[str], unit: str, exact: bool) -> None:
    motion = run.motion
    alone, labels = len(names) == 1, [_label(motion, name) for name in names]
    scheme = str(run.scheme_title)
    for name, shown in zip(names, labels, strict=True):
        label = scheme if alone else f"{shown}, {scheme}" if exact else shown
        (line,) = ax.plot(motion.t, _column(run, motion, name), label=label, **ROWS)
        if exact:
            t, values = _between(run, name)
            told = str(say("exact.title"))
            ax.plot(t, values, label=told if alone else f"{shown}, {told}", color=line.get_color(), **MOTION)
    ax.set_xlabel("t, s")
    ax.set_ylabel(", ".join((*labels, unit) if unit else labels))
    ax.grid(visible=True, linewidth=0.4)
    ax.legend()


def _between(run: SceneRun, name: str) -> tuple[Any, Any]:
    """Return times and values of the exact motion, with further points between the rows."""
    import numpy as np

    t = run.scene.exact.t
    found: Motion = run.scene.exact
    if len(t) > 1:
        finer = np.linspace(0.0, float(t[-1]), BETWEEN * (len(t) - 1) + 1)
        found = run.scene.exact_at(finer)
    return found.t, _column(run, found, name)


def _is_acceleration(motion: Motion, name: str) -> bool:
    return name not in motion.names and str(name)[:1] == "d" and name[1:] in motion.velocity_names


def _label(motion: Motion, name: str) -> str:
    if _is_acceleration(motion, name):
        return f"d{symbol(name[1:]).text}/dt"
    return name if "." in name else symbol(name).text


def _column(run: SceneRun, motion: Motion, name: str) -> Any:
    if name in motion.names:
        return motion.column(name)
    results = run.scene.over(motion)
    if "." in name:
        names, rows = results.point_accelerations
        return rows[:, names.index(name)]
    return results.accelerations[:, motion.velocity_names.index(name[1:])]


def plot_study(study: AccuracyStudy, ax: Axes | None) -> Axes:
    """Return the Axes that `Study.plot` describes."""
    drawn = _axes(ax)
    marks = "os^Dv*Ph<>"
    methods = dict.fromkeys(row.method for row in study.rows if not row.failed)
    for place, method in enumerate(methods):
        rows = [row for row in study.rows if row.method == method and not row.failed and math.isfinite(row.max_error)]
        points = sorted((row.evaluations, row.max_error) for row in rows)
        drawn.plot(*zip(*points, strict=True), label=str(method), marker=marks[place % len(marks)], markersize=4, linewidth=1)
    unit = study.rows[0].unit if study.rows else ""
    drawn.set(xscale="log", yscale="log", xlabel="evaluations", ylabel=f"largest error, {unit}")
    drawn.grid(visible=True, linewidth=0.4)
    drawn.legend(fontsize="small")
    return drawn


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    _, drawn = plt.subplots(layout="constrained")
    return drawn
