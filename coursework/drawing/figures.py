"""The mechanism as a figure of the page: the position in which it starts, and the one in which it stops.

Enters: a `Mechanism`, its velocity equations and a motion.  Leaves: `Drawing`, upright, as wide as a column.
Used by `scene_run.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.drawing.lettering.angles import angle_names, draw_angles, room_of_angles, segments_of
from coursework.drawing.lettering.dimensions import ORIGIN, SEVERAL, crowded_hinges, dimension_names, draw_dimensions
from coursework.drawing.lettering.naming import link_names, link_owner, part_lengths, point_names, rate_places
from coursework.drawing.lettering.turns import clockwise_rates
from coursework.drawing.outline.coinciding import clearest, coincides
from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import Poses, all_rows, read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.board import Board, fit
from coursework.drawing.paper.painter import DOT, Painter
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import AXIS, ITALIC, Sheet, inside
from coursework.drawing.paper.symbols import lowered_name, name_word, rate_word, short
from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.integration.motion import Motion, Stop
from coursework.system.angles import dot
from coursework.variant.formula.tree import Formula, terms
from coursework.variant.record.held import is_origin, velocities_of_points
from coursework.variant.record.variant import Variant
from coursework.words.errors import InputError
from coursework.words.sentences import joined, say, say_count

HIGHEST = 86.0  # mm: height limit, so that the drawing with its caption leaves room on the first page
TALL, MANY = 110.0, 7  # mm: height limit from so many links on: their names stand close, their data fill that page anyway
ARROW = 13.0  # mm, of a driven velocity: the arrow shows its direction, not its size
ARROWS = (ARROW, 10.5, 15.5, 8.5)  # mm: the next ones if the arrow would end in a joint or hinge
AT_HINGE = 7.0  # mm: the name of a driven rotation that is farther from its hinge gets a thin line that leads to it
VELOCITY = 'stroke="black" stroke-width="0.4"'


def draw_start(
    mechanism: Mechanism,
    equations: VelocityEquations,
    motion: Motion,
    start: list[float],
    clear: Callable[[], Motion] | None = None,
) -> Drawing | None:
    """Return `figure#mechanism`: the start position, None if the file places no points.

    `start` are all coordinates at t = 0 (rad, m); rails and slots are as long as the travel of their sliders in `motion`.
    If links lie on one line at the start, the drawing shows the row of the motion `clear()` in which they coincide least.
    """
    outline = read_outline(mechanism)
    if outline is None or not outline.names:
        return None
    read, row = read_poses(outline, equations), 0
    t, coordinates = np.zeros(1), np.array([start])
    if clear is not None and coincides(outline, read(t, coordinates)):
        with suppress(InputError, ArithmeticError):  # a mechanism without an exact motion is drawn in its start position
            shown = clear()
            if len(shown.t) and all_rows(equations, shown):
                row = clearest(outline, read(shown.t, shown.coordinates))
                t, coordinates = shown.t[row : row + 1], shown.coordinates[row : row + 1]
    names = [coordinate.name for coordinate in equations.variant.coordinates]
    values = dict(zip(names, coordinates[0].tolist(), strict=True))
    time = float(t[0])
    if all_rows(equations, motion):
        t, coordinates = np.append(t, motion.t), np.vstack([coordinates, motion.coordinates])
    board, svg = _mechanism(mechanism, outline, read(t, coordinates), values, dragged=not row)
    turned = "angles_against" if "&lt; 0" in svg else "angles"
    angles = say(f"drawing.mechanism.{turned}") if "data-angle" in svg else ""
    told = {"scale": board.scale_text, "driven": _driven_words(outline, equations.variant), "angles": angles}
    caption = say("drawing.mechanism.later", row=row + 1, time=time, **told) if row else say("drawing.mechanism.caption", **told)
    alt = say("drawing.mechanism.alt_later" if row else "drawing.mechanism.alt", row=row + 1, links=outline.links)
    return Drawing("mechanism", svg, board.width, board.height, caption, alt)


def draw_stop(mechanism: Mechanism, equations: VelocityEquations, motion: Motion, stop: Stop) -> Drawing | None:
    """Return `figure#dead-point`: the position in which the motion stops, None if that is not known."""
    outline = read_outline(mechanism)
    names = [coordinate.name for coordinate in equations.variant.coordinates]
    if outline is None or not outline.names or set(names) - set(stop.coordinates):
        return None
    t, coordinates = np.array([stop.time]), np.array([[stop.coordinates[name] for name in names]])
    if all_rows(equations, motion):
        t, coordinates = np.append(t, motion.t), np.vstack([coordinates, motion.coordinates])
    poses = read_poses(outline, equations)(t, coordinates)
    board, svg = _mechanism(mechanism, outline, poses)
    caption = say("drawing.stop.caption", time=stop.time, scale=board.scale_text)
    return Drawing("dead-point", svg, board.width, board.height, caption, say("drawing.stop.alt"))


def _mechanism(
    mechanism: Mechanism, outline: Outline, poses: Poses, values: Mapping[str, float] | None = None, *, dragged: bool = False
) -> tuple[Board, str]:
    """Return board and SVG of the first row with names, lengths and drives; with `values` of coordinates also their angles."""
    arrows = {name: way for name in outline.driven if (way := driven_way(poses, name))}
    true_size = _on_nothing(outline, poses, 0, 1000.0)
    around = [(true_size.place[name], SEVERAL) for name in crowded_hinges(true_size, mechanism)]
    if values is not None:
        around += room_of_angles(true_size, mechanism, values)

    def needed(mm: float) -> Iterator[tuple[complex, float]]:
        yield from room(outline, poses, [0], arrows, mm)
        yield from (((at * mm).conjugate(), wide) for at, wide in around)

    highest = TALL if len(outline.bars) >= MANY else HIGHEST
    board = fit(needed, highest)
    sheet = board.sheet()
    painter = Painter(sheet, outline, poses, 0, board.put, board.mm)
    painter.fixed()
    painter.moving(dragged=dragged)
    shafts = {
        name: (painter.at[name], painter.at[name] + _length(painter, name, way) * way.conjugate()) for name, way in arrows.items()
    }
    for name, (at, tip) in shafts.items():
        sheet.arrow(at, tip, VELOCITY, f' data-driven="{short(name)}"', heavy=True)
    marks = _marks(painter, sheet, mechanism)
    dimensions = draw_dimensions(painter, mechanism, marks)
    arcs = draw_angles(painter, mechanism, values)
    point_names(painter)
    for name, (at, tip) in shafts.items():
        sheet.label(("V", lowered_name(name), ""), [(tip, tip - at, 1.0)], ITALIC, owner=Owner([(at, tip)]))
    link_names(painter)
    measured, turned = [line for _, line in dimensions], segments_of(arcs)
    dimension_names(painter, dimensions, turned)
    part_lengths(painter, mechanism, [*measured, *turned])
    angle_names(painter, arcs, measured)
    clockwise = clockwise_rates(mechanism, painter.place)
    for bar in outline.bars:
        for rate, hinge in outline.cranks:
            if bar.rate == rate and hinge in bar.corners:
                law = poses.drive[rate]
                sense = (int(np.sign(law[np.argmax(np.abs(law) > 0)])) or 1) * (-1 if rate in clockwise else 1)
                owner = replace(link_owner(painter, bar), lost=AT_HINGE)
                sheet.label(rate_word(rate), rate_places(painter, bar, hinge), ITALIC, turn=sense, owner=owner)
    sheet.axes(highest=highest)
    return replace(board, height=sheet.height), sheet.svg()


def _length(painter: Painter, name: str, way: complex) -> float:
    """Return the length (mm) of the arrow of a driven velocity, chosen so that it ends in no hinge and on no joint."""
    at, along = painter.at[name], way.conjugate()
    free = (long for long in ARROWS if not painter.at_joint(at + long * along) and not painter.in_ground(at + long * along))
    return next(free, ARROW)


def room(
    outline: Outline, poses: Poses, rows: list[int], arrows: Mapping[str, complex], mm: float
) -> Iterator[tuple[complex, float]]:
    """Yield circles (middle and radius in mm) that must fit on the sheet at `mm` mm per metre, with the origin at 0."""
    for row in rows:
        painter = _on_nothing(outline, poses, row, mm)
        yield from painter.extent()
        for name, way in arrows.items():
            yield painter.at[name] + ARROW * way.conjugate(), 5.5


def _on_nothing(outline: Outline, poses: Poses, row: int, mm: float) -> Painter:
    """Return a painter of one row at `mm` mm per metre, with the origin at 0, only to ask how much room the row takes."""
    return Painter(Sheet(1.0, 1.0, (0.0, 0.0, 1.0, 1.0)), outline, poses, row, lambda z: (z * mm).conjugate(), mm)


def driven_way(poses: Poses, name: str) -> complex:
    """Return the unit vector of a point's driven velocity in the first row in which it moves, 0 if it never does."""
    return next((complex(v / abs(v)) for v in poses.velocity(name) if abs(v) > 0), 0j)


def _marks(painter: Painter, sheet: Sheet, mechanism: Mechanism) -> list[str]:
    """Draw the fixed points from which other points are measured, if nothing else shows them; return their names.

    They are the points from which guides of the frame are placed, and the origin if given positions of hinges refer to it.
    """
    points = dict(mechanism.points)
    riders = [through.name for through, _ in mechanism.variant.frame.rails if through.name in points]
    bases = [part.name for name in riders for part in terms(points[name]) if part.op == "name"]
    given = {datum.name for datum in mechanism.variant.given}
    if any(given.issuperset(points[name].names()) for name in painter.outline.hinges if name in points and points[name].names()):
        bases += [name for name, formula in points.items() if is_origin(formula)]
    drawn = []
    for name in dict.fromkeys((*riders, *bases)):
        at = painter.at.get(name)
        if at is None or name in painter.names or inside(at - 1, at + 1, sheet.field) != (at - 1, at + 1):
            continue
        sheet.circle(at, 0.7, DOT)
        sheet.label(name_word(name), [(at, painter.middle - at, 1.2)], ITALIC)
        for rail in painter.outline.rails:
            ends = painter.rail_line(rail)
            if rail.rider in riders and name in {part.name for part in terms(points[rail.rider])}:
                near = min(ends, key=lambda end: abs(end - at))
                along = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
                foot = at + along * dot(along, near - at)
                if not _between(ends, at):
                    sheet.line(at, foot, AXIS)
        drawn.append(name)
    placed = {*drawn, *painter.outline.hinges} & points.keys()
    if any(points[name].op == "pair" and given.issuperset(names) for name in placed if (names := points[name].names())):
        drawn += _origin(painter, sheet, points)
    return drawn


def _origin(painter: Painter, sheet: Sheet, points: Mapping[str, Formula]) -> list[str]:
    """Mark the origin if the file does not name it but measures from it; return its name in a list, [] if it is not marked."""
    at = painter.put(0j)
    if any(map(is_origin, points.values())) or inside(at - 1, at + 1, sheet.field) != (at - 1, at + 1):
        return []
    painter.at[ORIGIN] = at
    if all(abs(at - painter.at[name]) > 1 for name in painter.names):
        sheet.circle(at, 0.7, DOT)
    sheet.label((ORIGIN, "", ""), [(at, painter.middle - at, 1.2)], owner=Owner([(at, at)]))
    return [ORIGIN]


def _between(ends: tuple[complex, complex], at: complex) -> bool:
    way = ends[1] - ends[0]
    return 0 <= dot(way, at - ends[0]) <= dot(way, way)


def _driven_words(outline: Outline, variant: Variant) -> str:
    """Return a sentence on how arrows show the drives; drives without an arrow are named."""
    turned = tuple(rate for rate, _ in outline.cranks)
    arrows = {law for law, (point, _) in velocities_of_points(variant).items() if point in outline.driven}
    laws = tuple(law.name for law in variant.drive if law.name not in {*variant.rates, *arrows})
    others = (*(rate for rate in variant.given_rates if rate not in {*turned, *arrows}), *laws)
    told = [say("drawing.mechanism.driven", points=(point,)) for point in outline.driven]
    told += [say_count("drawing.mechanism.turned", len(turned), rates=turned)] if turned else []
    told += [say("drawing.mechanism.given", rates=others)] if others else []
    return joined(told) if told else say("drawing.mechanism.free")
