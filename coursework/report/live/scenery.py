"""The lines and symbols that words in the live part must not cover, row by row, in units of the drawing with y down.

Enters: an `Outline`, its `Poses`, the rows considered, the units per metre.  Leaves: `Scenery`, arrays.
Used by `report/live/spots.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from coursework.drawing.outline.ground import hinge_ground, inward, racks, rail_side
from coursework.drawing.outline.outline import Outline, Slot
from coursework.drawing.outline.poses import Poses
from coursework.drawing.paper.cover import STILL
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import frozen

# As in drawing.js: how far a slot and a rail extend beyond the last place of a rider, how deep a rack and a hatching are, how far
# a rail is from the middle of its block.
SLOT_END, RAIL_END, RACK, HATCH, BESIDE = 10.0, 25.0, 7.0, 6.0, 7.0
RIM = np.exp(2j * np.pi * np.arange(13) / 12)  # a circle as chords


@frozen
class Scenery:
    """What is drawn in r rows: points `at` (name -> (r,)); s lines from `begin` by `step` (r, s, 2), of `length` (r, s).

    `symbols` (r, b, 4) are the boxes of b symbols.
    """

    at: dict[str, Complex]
    begin: Array
    step: Array
    length: Array
    symbols: Array

    def near(self, low: Array, high: Array) -> NDArray[np.intp]:
        """Return the indices of lines that come near any of the boxes with corners `low` and `high` (r, k, 2), in any row."""
        ends = self.begin, self.begin + self.step
        meet = (np.minimum(*ends) <= high.max(axis=1)[:, None]) & (np.maximum(*ends) >= low.min(axis=1)[:, None])
        return np.flatnonzero((meet[..., 0] & meet[..., 1]).any(axis=0))


def scenery_of(outline: Outline, poses: Poses, rows: NDArray[np.int64], scale: float) -> Scenery:
    """Return what is drawn in the rows `rows` of a motion; `scale` are the units per metre."""
    at: dict[str, Complex] = {name: np.asarray(scale * places[rows].conjugate()) for name, places in poses.at.items()}
    lines = [*_moving_lines(outline, poses, rows, scale, at)]
    lines += [(np.full(len(rows), begin), np.full(len(rows), end)) for begin, end in _fixed_lines(outline, poses, scale, at)]
    begin, end = pairs(np.array(lines).reshape(-1, 2, len(rows)).transpose(1, 2, 0))
    step = end - begin
    symbols = [
        np.concatenate([pairs(middle - half), pairs(middle + half)], axis=1)
        for middle, half in _symbols(outline, poses, rows, at)
    ]
    boxes = np.array(symbols).reshape(-1, len(rows), 4).transpose(1, 0, 2)
    return Scenery(at, begin, np.where(step == 0, STILL, step), np.hypot(step[..., 0], step[..., 1]), boxes)


def pairs(places: Complex) -> Array:
    """Return complex numbers as pairs (real, imaginary) along a new last axis."""
    return np.stack([places.real, places.imag], axis=-1)


def _moving_lines(
    outline: Outline, poses: Poses, rows: NDArray[np.int64], scale: float, at: dict[str, Complex]
) -> Iterator[tuple[Complex, Complex]]:
    def along(slot: Slot, deep: float) -> tuple[Complex, Complex]:
        beside, low, high = (scale * each for each in poses.line(slot))
        way = np.conj(poses.along(slot.base, slot.toward)[rows])
        foot = at[slot.at] - 1j * (deep or beside) * way
        return foot + way * (min(low, 0.0) - SLOT_END), foot + way * (max(high, 0.0) + SLOT_END)

    for bar in outline.bars:
        yield from ((at[a], at[b]) for a, b in itertools.pairwise(bar.corners))
    for slot in outline.slots:
        yield along(slot, 0.0)
        beside = scale * poses.line(slot)[0]
        yield at[slot.at], at[slot.at] - 1j * beside * np.conj(poses.along(slot.base, slot.toward)[rows])
    for wheel in outline.wheels:
        yield from itertools.pairwise(at[wheel.centre] + np.abs(at[wheel.contact] - at[wheel.centre]) * RIM[:, None])
        yield at[wheel.centre], at[wheel.contact]
    for rack in racks(outline, poses.pose(0)):
        slot = Slot(rack.link, rack.rail.rider, rack.rail.base, rack.rail.toward, (rack.contact,))
        yield from (along(slot, 0.0), along(slot, RACK * rack.side))


def _fixed_lines(outline: Outline, poses: Poses, scale: float, at: dict[str, Complex]) -> Iterator[tuple[complex, complex]]:
    """Yield fixed circles and rails, and the ends of their hatchings."""
    start = poses.pose(0)
    for track in outline.tracks:
        middle, solid = at[track.centre][0], inward(outline, start, track)
        for depth in (0.0, HATCH * solid) if solid else (0.0,):
            yield from itertools.pairwise((middle + (abs(at[track.rim][0] - middle) - depth) * RIM).tolist())
    for rail in outline.rails:
        _, along, low, high = poses.travel(rail)
        way = along.conjugate()
        foot = complex(at[rail.at][0])
        for off in (0.0, HATCH):
            out = -1j * way * rail_side(outline, start, rail) * (off + (0.0 if rail.rolls or not rail.rider else BESIDE))
            yield foot + out + way * (scale * low - RAIL_END), foot + out + way * (scale * high + RAIL_END)


def _symbols(
    outline: Outline, poses: Poses, rows: NDArray[np.int64], at: dict[str, Complex]
) -> Iterator[tuple[Complex, complex | Complex]]:
    """Yield the middle and the half size of each joint, pivot and block."""
    start = poses.pose(0)
    yield from ((at[name], 5 + 5j) for name in outline.shown)
    yield from ((at[name] + 11 * hinge_ground(outline, start, name).conjugate(), 12 + 12j) for name in outline.hinges)
    for block in outline.blocks:
        way = poses.along(block.base, block.toward)[rows]
        x, y = np.abs(way.real), np.abs(way.imag)
        yield at[block.at], 14 * x + 8 * y + 1j * (14 * y + 8 * x)
