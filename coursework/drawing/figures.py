"""The mechanism as a figure of the page: where it starts, where it stops, twelve positions, hodographs.

Enters: a `Mechanism`, its velocity equations and a motion.  Leaves: `Drawing`, upright, as wide as a column.
Used by `run.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from coursework.drawing.board import Board, fit
from coursework.drawing.lengths import lengths
from coursework.drawing.outline import Outline
from coursework.drawing.painter import DOT, Painter
from coursework.drawing.poses import Poses, all_rows, read_poses
from coursework.drawing.record import Drawing
from coursework.drawing.sheet import ITALIC, Sheet, inside
from coursework.drawing.symbols import length_text, rate_word, short
from coursework.drawing.tracing import read_outline
from coursework.integration.motion import Motion, Stop
from coursework.mechanism import Mechanism
from coursework.reduction.equations import VelocityEquations
from coursework.sentences import Sentence, say

HIGHEST = 86.0  # mm: with its caption the drawing leaves room on the first page
ARROW = 13.0  # mm, of a driven velocity: its direction counts, not its size
PARTS = (0.1, 0.3, 0.5, 0.7, 0.9)  # of a link: where it may be taken for what a word names
MISTAKEN = 4.0  # mm of way that the name of a length rather takes than standing nearer to another link
VELOCITY = 'stroke="black" stroke-width="0.4"'


def draw_start(mechanism: Mechanism, equations: VelocityEquations, motion: Motion, start: list[float]) -> Drawing | None:
    """Return `figure#mechanism`: the start position, None where the file places no points.

    `start` are all coordinates at t = 0 (rad, m); rails and slots are as long as the travel of their sliders in `motion`.
    """
    outline = read_outline(mechanism)
    if outline is None or not outline.names:
        return None
    t, coordinates = np.zeros(1), np.array([start])
    if all_rows(equations, motion):
        t, coordinates = np.append(t, motion.t), np.vstack([coordinates, motion.coordinates])
    poses = read_poses(outline, equations)(t, coordinates)
    board, svg = _mechanism(mechanism, outline, poses, 0)
    caption = say("drawing.mechanism.caption", scale=board.scale_text, driven=_driven_words(outline))
    return Drawing("mechanism", svg, board.width, board.height, caption, say("drawing.mechanism.alt"))


def draw_stop(mechanism: Mechanism, equations: VelocityEquations, motion: Motion, stop: Stop) -> Drawing | None:
    """Return `figure#dead-point`: the position in which the motion stops, None where that is not known."""
    outline = read_outline(mechanism)
    names = [coordinate.name for coordinate in equations.variant.coordinates]
    if outline is None or not outline.names or set(names) - set(stop.coordinates):
        return None
    t, coordinates = np.array([stop.time]), np.array([[stop.coordinates[name] for name in names]])
    if all_rows(equations, motion):
        t, coordinates = np.append(t, motion.t), np.vstack([coordinates, motion.coordinates])
    poses = read_poses(outline, equations)(t, coordinates)
    board, svg = _mechanism(mechanism, outline, poses, 0)
    caption = say("drawing.stop.caption", time=stop.time, scale=board.scale_text)
    return Drawing("dead-point", svg, board.width, board.height, caption, say("drawing.stop.alt"))


def _mechanism(mechanism: Mechanism, outline: Outline, poses: Poses, row: int) -> tuple[Board, str]:
    """Return one row with names, lengths and what drives it."""
    arrows = {name: way for name in outline.driven if (way := driven_way(poses, name, row))}
    board = fit(partial(room, outline, poses, [row], arrows), HIGHEST)
    sheet = board.sheet()
    painter = Painter(sheet, outline, poses, row, board.put, board.mm)
    painter.fixed()
    painter.moving()
    for name, way in arrows.items():
        tip = painter.at[name] + ARROW * way.conjugate()
        sheet.arrow(painter.at[name], tip, VELOCITY, f' data-driven="{short(name)}"')
    turns = {rate: painter.at[hinge] for rate, hinge in outline.cranks}
    _marks(painter, sheet, mechanism)
    painter.point_names()
    for name, way in arrows.items():
        sheet.label(("V", short(name), ""), [(painter.at[name] + ARROW * way.conjugate(), way.conjugate(), 1.0)], ITALIC)
    painter.link_names()
    _lengths(painter, sheet, mechanism)
    for rate, at in turns.items():
        sense = float(np.sign(poses.drive[rate][np.argmax(np.abs(poses.drive[rate]) > 0)]))
        sheet.label(rate_word(rate), [(at, at - painter.middle, 2.5)], ITALIC, turn=int(sense) or 1)
    sheet.axes(highest=HIGHEST)
    return replace(board, height=sheet.height), sheet.svg()


def room(
    outline: Outline, poses: Poses, rows: list[int], arrows: Mapping[str, complex], mm: float
) -> Iterator[tuple[complex, float]]:
    """Yield what takes room at so many mm a metre, with the origin at 0."""
    empty = Sheet(1.0, 1.0, (0.0, 0.0, 1.0, 1.0))
    for row in rows:
        painter = Painter(empty, outline, poses, row, lambda z: (z * mm).conjugate(), mm)
        yield from painter.extent()
        for name, way in arrows.items():
            yield painter.at[name] + ARROW * way.conjugate(), 5.5


def driven_way(poses: Poses, name: str, row: int) -> complex:
    """Return the direction in which a drive moves a point in a row, or in the next row in which it does."""
    velocity = poses.velocity(name)
    later = [*range(row, len(velocity)), *range(row)]
    return next((complex(velocity[k] / abs(velocity[k])) for k in later if abs(velocity[k]) > 0), 0j)


def _marks(painter: Painter, sheet: Sheet, mechanism: Mechanism) -> None:
    """Draw the points that the guides of the frame lead through where nothing else does: lengths are counted from them."""
    throughs = [through.name for through, _ in mechanism.variant.frame.rails if through.op == "name"]
    for name in dict.fromkeys(throughs):
        at = painter.at.get(name)
        if at is None or name in painter.names or inside(at - 1, at + 1, sheet.field) != (at - 1, at + 1):
            continue
        sheet.circle(at, 0.7, DOT)
        sheet.label((short(name), "", ""), [(at, painter.middle - at, 1.2)], ITALIC)


def _lengths(painter: Painter, sheet: Sheet, mechanism: Mechanism) -> None:
    """Write the lengths that the file gives beside the parts of the links that have them."""
    known = lengths(mechanism)
    drawn = [(bar.corners[k], bar.corners[k + 1]) for bar in painter.outline.bars for k in range(len(bar.corners) - 1)]
    drawn += [(wheel.centre, wheel.contact) for wheel in painter.outline.wheels]
    named = [(known.get(frozenset(ends)), painter.at[ends[0]], painter.at[ends[1]]) for ends in dict.fromkeys(drawn)]
    for track, (_, radius) in zip(painter.outline.tracks, mechanism.variant.frame.circles, strict=True):
        wheel = painter.wheel_on(track)
        # Along a link between the two centres it would read as a length of that link.
        if wheel and not any({track.centre, wheel.centre} <= {*bar.corners} for bar in painter.outline.bars):
            named.append((radius, painter.at[track.centre], painter.at[wheel.contact]))
    along = [[begin + part * (end - begin) for part in PARTS] for _, begin, end in named]
    for place, (length, *ends) in enumerate(named):
        text = length_text(length) if length is not None else ""
        if text and abs(ends[1] - ends[0]) > 4:
            side = 1j * (ends[1] - ends[0])
            middle = sum(ends) / 2
            towards = -side if _dot(side, middle - painter.middle) > 0 else side
            others = list(itertools.chain(*along[:place], *along[place + 1 :]))
            sheet.label((text, "", ""), [(middle, towards, 1.0)], ITALIC, others=others, mistaken=MISTAKEN)


def _driven_words(outline: Outline) -> Sentence:
    if outline.driven:
        return say("drawing.mechanism.driven", points=outline.driven)
    if outline.cranks:
        return say("drawing.mechanism.turned", rates=tuple(rate for rate, _ in outline.cranks))
    return say("drawing.mechanism.free")


def _dot(a: complex, b: complex) -> float:
    return (a.conjugate() * b).real
