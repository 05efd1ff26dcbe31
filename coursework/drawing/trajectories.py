"""Twelve positions of a mechanism and the trajectories of its points; hodographs of their velocities.

Enters: a `Mechanism`, its velocity equations, its motion over one period and the rows of a table.  Leaves: `Drawing`s.
Used by `quantities.py`.
"""

from __future__ import annotations

import itertools
from functools import partial

import numpy as np

from coursework.drawing.figures import HIGHEST, VELOCITY, room
from coursework.drawing.lettering.naming import point_names
from coursework.drawing.outline.poses import read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.board import Board, fit, vector_scale
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import AXIS, ITALIC, number
from coursework.drawing.paper.symbols import decimal, short
from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.integration.motion import Motion
from coursework.results.kinematics.points import point_rows
from coursework.system.arrays import Array, Complex
from coursework.words.sentences import say

POSITIONS = 12
TRACE = 'fill="none" stroke="black" stroke-width="0.35" stroke-dasharray="1.6 0.9"'
CURVE = 'fill="none" stroke="black" stroke-width="0.3"'
LONGEST = 38.0  # mm: limit for the longest velocity of a hodograph
MOST_MARKED = 13  # rows numbered beside a hodograph; if there are more, every second, fifth, tenth … is numbered
AT_REST = 1e-9  # relative to the size of the mechanism, or to the largest velocity


def draw_positions(mechanism: Mechanism, equations: VelocityEquations, period: Motion) -> Drawing | None:
    """Return `figure#positions`: twelve positions at equal times, the first in full, and the trajectories of the points.

    None if the file places no points or the period has fewer than two rows.  `period` is the motion over a period at equal times;
    its last row repeats the first.
    """
    outline = read_outline(mechanism)
    if outline is None or not outline.names or len(period.t) < 2:
        return None
    poses = read_poses(outline, equations)(period.t, period.coordinates)
    rows = [round(k * (len(period.t) - 1) / POSITIONS) for k in range(POSITIONS)]
    board = fit(partial(room, outline, poses, rows, {}), HIGHEST)
    sheet = board.sheet()
    for row in rows[1:]:
        Painter(sheet, outline, poses, row, board.put, board.mm).thin()
    first = Painter(sheet, outline, poses, 0, board.put, board.mm)
    first.fixed()
    largest = max(abs(a - b) for a in first.place.values() for b in first.place.values())
    moving = [
        name for name in outline.names if float(np.ptp(poses.at[name].real) + np.ptp(poses.at[name].imag)) > AT_REST * largest
    ]
    contacts = {wheel.contact for wheel in outline.wheels}
    for name in moving:
        if name not in contacts:
            places = [board.put(complex(z)) for z in poses.at[name]]
            sheet.path(places, f'{TRACE} data-trajectory="{short(name)}"')
    first.moving()
    turned = [name for rate, _ in outline.cranks for bar in outline.bars if bar.rate == rate for name in bar.corners]
    numbered = next((name for name in (*outline.driven, *turned, *moving) if name in moving), "")
    point_names(first)
    if numbered:
        middle = board.put(complex(np.mean(poses.at[numbered])))
        for place, row in enumerate(rows[1:], start=2):
            at = board.put(complex(poses.at[numbered][row]))
            sheet.circle(at, 0.5, 'fill="black"')
            sheet.label((str(place), "", ""), [(at, at - middle, 0.8)])
    sheet.axes()
    last = float(period.t[-1])
    caption = say("drawing.positions.caption", scale=board.scale_text, step=last / POSITIONS, point=numbered or outline.names[0])
    return Drawing("positions", sheet.svg(), board.width, board.height, caption, say("drawing.positions.alt"))


def draw_hodographs(mechanism: Mechanism, equations: VelocityEquations, period: Motion, rows: Motion) -> tuple[Drawing, ...]:
    """Return `figure#hodograph-X` of every named point X of a link that moves: the tips of its velocity, drawn from one pole."""
    outline = read_outline(mechanism)
    if outline is None or len(period.t) < 2 or not len(rows.t):
        return ()
    smooth, marked = _velocities(equations, period), _velocities(equations, rows)
    contacts = {wheel.contact for wheel in outline.wheels}
    peaks = {name: float(np.max(np.abs(smooth[name]))) for name in outline.names if name in smooth}
    fastest = max(peaks.values(), default=0.0)
    shown = [name for name, peak in peaks.items() if name not in contacts and peak > AT_REST * fastest]
    return tuple(_hodograph(name, smooth[name], marked[name], rows.t) for name in shown)


def _velocities(equations: VelocityEquations, motion: Motion) -> dict[str, Complex]:
    names, values = point_rows(equations, motion)
    return {
        name.partition(".")[0]: np.asarray(values[:, k] + 1j * values[:, k + 1])
        for k, name in enumerate(names)
        if name.endswith(".vx")
    }


def _hodograph(name: str, curve: Complex, rows: Complex, t: Array) -> Drawing:
    both = np.concatenate([curve, rows])
    fastest = float(np.max(np.abs(both)))
    speed = vector_scale(fastest, LONGEST)
    tips = both / speed
    reach = [(complex(tip.conjugate()), 6.0) for tip in tips[np.isfinite(tips)]]
    board = fit(lambda mm: [(0j, 13.0), *reach], 2 * LONGEST + 20, narrowest=90.0)
    board = Board(1000.0 * speed, board.width, board.height, board.origin)
    sheet = board.sheet()
    pole = board.origin
    for way in (1.0 + 0j, 1j):
        ends = [pole + way * reach_to for reach_to in (-200.0, 200.0)]
        sheet.line(ends[0], ends[1], AXIS)
    sheet.path([pole + (z / speed).conjugate() for z in curve], f'{CURVE} data-hodograph="{short(name)}"')
    first = pole + complex(rows[0] / speed).conjugate()
    if abs(first - pole) > 0.5:
        sheet.arrow(pole, first, VELOCITY, f' data-velocity="{short(name)}" data-row="1"', head=min(2.6, 0.6 * abs(first - pole)))
    sheet.circle(pole, 0.8, 'fill="white" stroke="black" stroke-width="0.35"')
    sheet.label(("p", "v", ""), [(pole, -1 + 1j, 1.2)], ITALIC)
    pace = next(m * 10**k for k in itertools.count() for m in (1, 2, 5) if len(rows) / (m * 10**k) <= MOST_MARKED)
    tip_of = [pole + complex(z / speed).conjugate() for z in rows]
    for tip in tip_of:
        sheet.circle(tip, 0.55, f'fill="black" data-tip="{number(tip.real)} {number(tip.imag)}"')
    placed: list[complex] = []
    for row in range(0, len(rows), pace):
        if all(abs(tip_of[row] - other) > 2.0 for other in placed):  # the last row of a period repeats the first
            sheet.label((str(row + 1), "", ""), [(tip_of[row], tip_of[row] - pole, 0.9)])
            placed.append(tip_of[row])
    sheet.axes()
    top = int(np.argmax(np.abs(rows)))
    is_even = float(np.ptp(np.abs(rows))) <= AT_REST * fastest
    key = "drawing.hodograph.even" if is_even else "drawing.hodograph.caption"
    words = say(key, point=name, speed=decimal(speed), fastest=float(abs(rows[top])), row=top + 1, time=float(t[top]))
    return Drawing(f"hodograph-{name}", sheet.svg(), board.width, board.height, words, say("drawing.hodograph.alt", point=name))
