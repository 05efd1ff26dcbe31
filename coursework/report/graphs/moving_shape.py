"""What moves in an animated picture, from frame to frame, and the ground on which it stands.

Enters: the axes of the picture, an `Outline`, its `Poses`, the size of all that is drawn (m).  Leaves: lines on the axes.
Used by `moving_picture.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from coursework.drawing.outline.ground import hinge_ground, inward, racks, rail_side
from coursework.drawing.outline.outline import Outline, Slot
from coursework.drawing.outline.poses import Poses
from coursework.report.graphs.graph_paper import SCHEME_INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.lines import Line2D

Complex = NDArray[np.complexfloating[Any, Any]]
# Parts of the drawing's size: half of a block along its guide and across, how far a guide goes on, the depth of a hinge, a stroke
# of hatching, and how far apart these are.
BLOCK, ACROSS, BEYOND, PIVOT, STROKE, APART = 0.03, 0.018, 0.08, 0.035, 0.016, 0.022
ROUND = np.exp(1j * np.linspace(0, 2 * np.pi, 49))
GROUND: Any = {"color": "#777777", "zorder": 0}


def draw_ground(field: Axes, outline: Outline, motions: tuple[Poses, Poses], size: float) -> None:
    """Draw rails, fixed circles and hinges, hatched on the side of the ground in Figure 1; rails for the way of both motions."""
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
            beside, low, high = poses.line(slot)
            along = poses.along(slot.base, slot.toward)[frame]
            yield pose[slot.at] + along * (1j * beside + np.array([min(low, 0.0), max(high, 0.0)]))
        for rack in self.racks:
            _, low, high = poses.line(Slot(rack.link, rack.rail.rider, rack.rail.base, rack.rail.toward, (rack.contact,)))
            ends, deep = np.array([min(low - BLOCK * size, 0.0), max(high + BLOCK * size, 0.0)]), 1j * rack.side * ACROSS * size
            along = poses.along(rack.rail.base, rack.rail.toward)[frame]
            yield pose[rack.rail.rider] + along * np.array([*ends, ends[1] + deep, ends[0] + deep, ends[0]])
        for block in self.outline.blocks:
            along = poses.along(block.base, block.toward)[frame] * size
            upper, lower = np.array([BLOCK, -BLOCK]) + 1j * ACROSS, np.array([-BLOCK, BLOCK]) - 1j * ACROSS
            yield pose[block.at] + along * np.array([*upper, np.nan, *lower] if block.open else [*upper, *lower, upper[0]])
        for wheel in self.outline.wheels:
            yield pose[wheel.centre] + ROUND * abs(pose[wheel.contact] - pose[wheel.centre])
