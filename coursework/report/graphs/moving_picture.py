"""The mechanism in motion as one animated picture: the exact motion solid, that of the table dashed, a graph beside them.

Enters: a `SceneRun` and its exact motion on finer rows.  Leaves: the bytes of a GIF, the same on every run.
Used by `commands/animate.py`.
"""

from __future__ import annotations

import io
import logging
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from coursework.drawing.outline.ground import hinge_ground, inward, racks, rail_side
from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import Poses, read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import SCHEMES, title_of
from coursework.report.graphs.graph_paper import SCHEME_INK
from coursework.report.live.spots import WIDTHS, scale_of, spots_of
from coursework.report.text.symbols import Symbol, symbol
from coursework.report.text.words import Words
from coursework.scene.scene_run import SceneRun
from coursework.words.data_folders import folder
from coursework.words.errors import InputError
from coursework.words.sentences import Phrases, say

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.lines import Line2D

SIZE, DPI = (7.2, 3.7), 100  # inches, and dots per inch
MOST_FRAMES, PER_SECOND = 100, 12
MOST_DOTS = 30
ORANGE = "#d55e00"  # stays apart from the blue of the table for colour-blind readers
SETTINGS: Any = {
    "font.family": ["DejaVu Sans", "Noto Sans CJK SC"], "font.size": 9, "text.usetex": False, "mathtext.fontset": "dejavusans",
    "axes.unicode_minus": True, "axes.titlesize": 9, "path.simplify": True, "axes.linewidth": 0.6, "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
}  # fmt: skip
_LOCK = threading.Lock()
Complex = NDArray[np.complexfloating[Any, Any]]
# Parts of the drawing's size: half of a block along its guide and across it, how far a guide extends beyond its travel, the depth
# of a hinge, the length of a stroke of hatching, and the distance between strokes.
BLOCK, ACROSS, BEYOND, PIVOT, STROKE, APART = 0.03, 0.018, 0.08, 0.035, 0.016, 0.022
ROUND = np.exp(1j * np.linspace(0, 2 * np.pi, 49))
GROUND: Any = {"color": "#777777", "zorder": 0}


def label_text(symbol: Symbol) -> str:
    """Return a symbol for a label: Unicode if there is no subscript or it is digits, else mathtext that this program makes."""
    if not symbol.subscript or symbol.subscript.isdigit():
        return symbol.text
    letter = symbol.letter if len(symbol.letter) == 1 else rf"\mathrm{{{symbol.letter}}}"
    head = rf"\dot{{{letter}}}" if symbol.dotted else letter
    low = symbol.subscript.replace("_", r"\_")
    return rf"${head}_{{\mathrm{{{low}}}}}$"


@cache
def _know_own_faces() -> None:
    from matplotlib.font_manager import fontManager

    logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)  # else it warns that our Chinese font has one weight
    for face in sorted((folder("reports") / "fonts").glob("*.otf")):
        fontManager.addfont(face)


@contextmanager
def _drawing() -> Iterator[None]:
    """Set matplotlib up for one picture at a time, without pyplot."""
    import matplotlib

    _know_own_faces()
    with _LOCK, matplotlib.rc_context(SETTINGS):
        yield


def moving_picture(run: SceneRun, exact: Motion, phrases: Phrases) -> bytes:
    """Return the GIF of a run beside its `exact` motion, whose rows are the frames (at most `MOST_FRAMES` of them).

    Raises `InputError` if the file places no points, or the table has fewer than two rows, with the stop that may have ended it.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from PIL import Image

    table = run.scene.scheme_rows or run.motion
    outline = read_outline(run.scene.mechanism)
    if outline is not None and len(table.t) < 2 and run.stop is not None:
        raise run.stop.refusal
    if outline is None or len(table.t) < 2:
        raise InputError(say("fault.C064", variant=run.variant.name))
    read = read_poses(outline, run.scene.equations)
    ghost = np.array([np.interp(exact.t, table.t, column) for column in table.coordinates.T]).T
    poses = read(exact.t, exact.coordinates), read(exact.t, ghost)
    mark = phrases.template("decimal")

    def told(key: str, **values: object) -> str:
        return phrases.template(f"live.{key}").format(**{name: str(value).replace(".", mark) for name, value in values.items()})

    with _drawing():
        figure: Any = Figure(figsize=SIZE, dpi=DPI)
        canvas: Any = FigureCanvasAgg(figure)
        field, graph = figure.add_axes((0.01, 0.02, 0.6, 0.9)), figure.add_axes((0.7, 0.2, 0.28, 0.57))
        size = _window(field, outline, poses)
        cursor = _graph(graph, run, table, exact, Words(phrases))
        draw_ground(field, outline, poses, size)
        shapes = [Shape(field, outline, each, size) for each in poses]
        joints = Joints(field, outline, poses[0])
        tableau = run.tableau or SCHEMES.get(table.scheme)
        scheme = phrases.written(title_of(tableau)) if tableau else table.scheme
        solid = figure.text(0.64, 0.93, told("truth"))
        dashes = figure.text(0.64, 0.88, told("ghost", scheme=scheme, h=f"{table.step:.4g}"), color=SCHEME_INK)
        begin = min(0.64, 0.985 - dashes.get_window_extent().width / (SIZE[0] * DPI))  # longer words begin farther left
        solid.set_x(begin)
        dashes.set_x(begin)
        figure.text(0.985, 0.03, told("mark_line"), color=ORANGE, ha="right")
        clock = figure.text(0.03, 0.93, "", weight="bold")
        stride = -(-len(exact.t) // MOST_FRAMES)
        frames: list[Image.Image] = []
        for frame in range(0, len(exact.t), stride):
            for shape, dashed in zip(shapes, (False, True), strict=True):
                shape.show(frame, dashed=dashed)
            joints.show(frame)
            t = float(exact.t[frame])
            cursor.set_xdata([t, t])
            clock.set_text(told("clock", row=round(t / table.step) + 1, t=f"{t:.3f}"))
            if not frames:  # what stands still is drawn once; the lines of the axes stand above the cursor
                lines = [line for shape in shapes[::-1] for line in shape.lines]
                moving = [*lines, joints.rings, *joints.words, cursor, *graph.spines.values(), clock]
                for artist in moving:
                    artist.set_animated(True)
                canvas.draw()
                still = canvas.copy_from_bbox(figure.bbox)
            canvas.restore_region(still)
            for artist in moving:
                figure.draw_artist(artist)
            frames.append(Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB"))
        gif = io.BytesIO()
        frames[0].save(gif, "gif", save_all=True, append_images=frames[1:], duration=1000 // PER_SECOND, loop=0)
        return gif.getvalue()


def _window(field: Axes, outline: Outline, poses: tuple[Poses, Poses]) -> float:
    """Set the window so that both motions fit, and return its size (m)."""
    shown = [places for each in poses for name, places in each.at.items() if not name.startswith("~")]
    for each in poses:
        for centre, rim in outline.circles:
            radius = np.abs(each.at[rim] - each.at[centre])
            shown += [each.at[centre] + radius * (1 + 1j), each.at[centre] - radius * (1 + 1j)]
        for slot in outline.slots:  # a lever reaches beyond the points of the file
            shown += each.slot_ends(slot)
    every = np.concatenate(shown)
    size = float(max(np.ptp(every.real), np.ptp(every.imag))) or 1.0
    field.set_xlim(every.real.min() - 0.12 * size, every.real.max() + 0.12 * size)
    field.set_ylim(every.imag.min() - 0.12 * size, every.imag.max() + 0.12 * size)
    field.set_aspect("equal")
    field.set_axis_off()
    return size


def _graph(axes: Axes, run: SceneRun, table: Motion, exact: Motion, words: Words) -> Line2D:
    """Draw the graph of the coordinate whose table is farthest from the exact motion, and return the line of its cursor."""
    inside = exact.t <= table.t[-1]  # after the last row nothing can be compared
    gaps = [
        np.max(np.abs(np.interp(exact.t, table.t, a) - b)[inside])
        for a, b in zip(table.coordinates.T, exact.coordinates.T, strict=True)
    ]
    name = table.coordinate_names[int(np.argmax(gaps))]
    axes.plot(exact.t, exact.column(name), color="black", linewidth=1.4)
    every = -(-len(table.t) // MOST_DOTS)  # more would merge into a thick line
    axes.plot(table.t, table.column(name), color=SCHEME_INK, marker="o", markersize=3, markevery=every, linewidth=0.8)
    behind, in_time = (words.behind(words.unit(run.variant.unit_of(column))) for column in (name, "t"))
    axes.set_title(label_text(symbol(name)) + behind, loc="left")
    axes.set_xlabel(f"t{in_time}")
    axes.spines[["top", "right"]].set_visible(False)
    return axes.axvline(0.0, color=ORANGE, linewidth=1.0)


def draw_ground(field: Axes, outline: Outline, motions: tuple[Poses, Poses], size: float) -> None:
    """Draw rails, fixed circles and hinges, hatched on the same side as in Figure 1; rails are long enough for both motions."""
    start = motions[0].pose(0)
    for rail in outline.rails:
        travels = [poses.travel(rail) for poses in motions]
        at, along = travels[0][:2]
        out = 1j * along * rail_side(outline, start, rail)
        at += out * size * (0.0 if rail.rolls or not rail.rider else ACROSS)
        low, high = min(travel[2] for travel in travels) - BEYOND * size, max(travel[3] for travel in travels) + BEYOND * size
        _plot(field, at + along * np.array([low, high]))
        _hatch(field, at + along * np.arange(low + APART * size / 2, high, APART * size), (out - 0.7 * along) * STROKE * size)
    for track in outline.tracks:
        middle, arm = start[track.centre], start[track.rim] - start[track.centre]
        _plot(field, middle + ROUND * arm)
        if solid := inward(outline, start, track):
            feet = arm * np.exp(2j * np.pi * np.linspace(0, 1, round(2 * np.pi * abs(arm) / (APART * size)), endpoint=False))
            _hatch(field, middle + feet, -solid * (1 + 0.7j) * feet / abs(arm) * STROKE * size)
    for name in outline.hinges:
        at, down = start[name], hinge_ground(outline, start, name) * PIVOT * size
        _plot(field, at + down * np.array([0, 1 + 0.6j, 1 - 0.6j, 0]))
        _plot(field, at + down * np.array([1 + 0.9j, 1 - 0.9j]))
        _hatch(field, at + down * (1 + 1j * np.linspace(-0.75, 0.9, 4)), down / abs(down) * (1 - 0.7j) * STROKE * size)


def _plot(field: Axes, points: Complex) -> None:
    field.plot(points.real, points.imag, linewidth=1.0, **GROUND)


def _hatch(field: Axes, feet: Complex, stroke: complex | Complex) -> None:
    ends = np.stack([feet, feet + stroke])
    field.plot(ends.real, ends.imag, linewidth=0.6, **GROUND)


class Shape:
    """The lines of one mechanism, moved from frame to frame."""

    def __init__(self, field: Axes, outline: Outline, poses: Poses, size: float) -> None:
        self.field, self.outline, self.poses, self.size = field, outline, poses, size
        self.racks = racks(outline, poses.pose(0))
        self.lines: list[Line2D] = []

    def show(self, frame: int, *, dashed: bool) -> None:
        """Show one frame."""
        style: dict[str, Any] = {"color": "black", "linewidth": 2.2, "zorder": 3}
        if dashed:
            style = {"color": SCHEME_INK, "linewidth": 1.3, "linestyle": (0, (4, 3)), "zorder": 2}
        for place, points in enumerate(self._lines(frame)):
            if place == len(self.lines):
                self.lines.append(self.field.plot([], [], **style)[0])
            self.lines[place].set_data(points.real, points.imag)

    def _lines(self, frame: int) -> Iterator[Complex]:
        poses, pose, size = self.poses, self.poses.pose(frame), self.size
        for bar in self.outline.bars:
            yield np.array([pose[name] for name in bar.corners])
        for slot in self.outline.slots:
            yield np.array([end[frame] for end in poses.slot_ends(slot)])
        for rack in self.racks:
            _, low, high = poses.line(rack.slot)
            ends, deep = np.array([min(low - BLOCK * size, 0.0), max(high + BLOCK * size, 0.0)]), 1j * rack.side * ACROSS * size
            along = poses.along(rack.rail.base, rack.rail.toward)[frame]
            yield pose[rack.rail.rider] + along * np.array([*ends, ends[1] + deep, ends[0] + deep, ends[0]])
        for block in self.outline.blocks:
            along = poses.along(block.base, block.toward)[frame] * size
            upper, lower = np.array([BLOCK, -BLOCK]) + 1j * ACROSS, np.array([-BLOCK, BLOCK]) - 1j * ACROSS
            yield pose[block.at] + along * np.array([*upper, np.nan, *lower] if block.open else [*upper, *lower, upper[0]])
        for wheel in self.outline.wheels:
            yield pose[wheel.centre] + ROUND * abs(pose[wheel.contact] - pose[wheel.centre])


class Joints:
    """The joints of the true mechanism and the names of its points, moved from frame to frame."""

    def __init__(self, field: Axes, outline: Outline, poses: Poses) -> None:
        from matplotlib.patheffects import withStroke

        self.names, self.poses = outline.shown, poses
        style: dict[str, Any] = {"color": "black", "markerfacecolor": "white", "markersize": 5, "linewidth": 0, "zorder": 4}
        self.rings = field.plot([], [], marker="o", **style)[0]
        # The spots of the live part on a narrow page, which is about as large: clear of the drawing in every position.
        width = WIDTHS[-1]
        spots = spots_of(outline, [poses], self.names)[-1][: len(self.names)]
        self.beside = np.array([complex(x, -y) for x, y in spots]) / scale_of(outline, [poses], width)
        halo = withStroke(linewidth=2.5, foreground="white")  # links sweep over the names
        middle: Any = {"style": "italic", "zorder": 5, "ha": "center", "va": "center", "path_effects": [halo]}
        self.words = [field.text(0, 0, label_text(symbol(name)), **middle) for name in self.names]

    def show(self, frame: int) -> None:
        """Show one frame."""
        pose = self.poses.pose(frame)
        places = np.array([pose[name] for name in self.names])
        self.rings.set_data(places.real, places.imag)
        for word, at in zip(self.words, places + self.beside, strict=True):
            word.set_position((at.real, at.imag))
