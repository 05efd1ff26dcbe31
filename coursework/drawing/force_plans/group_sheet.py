"""One group on paper: the group to its scale with the forces on it, beside it the polygon of these forces to a scale of forces.

Enters: a `GroupPlan` and a row.  Leaves: `Drawing`.
Used by `force_plans.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import accumulate

from coursework.drawing.force_plans.vectors import DIRECTION, FOUND, KNOWN, ForceVector, GroupPlan
from coursework.drawing.paper.board import COLUMN, EDGE, around, largest_scale, vector_scale
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import ITALIC, Sheet
from coursework.drawing.paper.symbols import decimal, name_word, ratio
from coursework.drawing.plans.foot import draw_foot, sheet_over_foot
from coursework.drawing.plans.plan_scale import LONGEST
from coursework.system.frozen import frozen
from coursework.words.sentences import say

ARROW = 13.0  # mm of a force at the group: it shows only the direction; the polygon shows the size
HIGHEST, LEFT_PART = 70.0, 74.0  # mm: height and width of the group on the sheet
SHORT = 0.4  # mm: shorter lines are not drawn
GIVEN = 'stroke="black" stroke-width="0.45"'
PENS = {KNOWN: GIVEN, DIRECTION: 'stroke="black" stroke-width="0.3"', FOUND: 'stroke="black" stroke-width="0.3"'}
LINK = 'stroke="black" stroke-width="0.7" fill="none"'
CHORD = 'stroke="black" stroke-width="0.25" stroke-dasharray="2 1"'


@frozen
class Figure:
    """A group in a row (from 0): the points of each link by name (complex m)."""

    links: tuple[tuple[tuple[str, complex], ...], ...]
    row: int
    time: float


def scale_of(plan: GroupPlan, row: int) -> float:
    """Return N per mm, the smallest of 1, 2, 5 · 10^k at which neither a force nor the whole polygon is longer than 80 mm."""
    tips = accumulate((complex(vector.force[row]) for vector in plan.vectors), initial=0j)
    left, low, right, high = around((tip, 0.0) for tip in tips)
    longest = max([right - left, high - low, *(vector.size(row) for vector in plan.vectors)])
    return vector_scale(longest, LONGEST)


def draw_group(plan: GroupPlan, figure: Figure, number: int, written: Callable[[str], str]) -> Drawing:
    """Return `figure#forces-N`: the group with its forces, and beside it their polygon."""
    row, unit = figure.row, scale_of(plan, figure.row)
    shown = [vector for vector in plan.vectors if vector.size(row) > SHORT * unit]
    points = dict(point for link in figure.links for point in link)
    middle = sum(points.values()) / max(len(points), 1)

    def room(mm: float) -> Iterator[tuple[complex, float]]:
        yield from (((at - middle) * mm, 6.0) for at in points.values())
        for vector in shown:
            at = (complex(vector.at[row]) - middle) * mm
            yield at, 2.0
            yield at + ARROW * _way(vector, row), 5.0

    scale = largest_scale(room, LEFT_PART, HIGHEST)
    left, low, right, high = around(room(1000 / scale))
    tips = [*accumulate((complex(vector.force[row]) / unit for vector in shown), initial=0j)]
    begin, under, end, over = around((tip, 8.0) for tip in tips)
    width = max(COLUMN, right - left + end - begin + 3 * EDGE)
    top = max(high - low, over - under)
    sheet = sheet_over_foot(width, top + 2 * EDGE)
    corner = complex(EDGE - left, EDGE + (top + high + low) / 2)
    _draw_links(sheet, figure, shown, lambda z: corner + ((z - middle) * (1000 / scale)).conjugate())
    pole = complex(width - EDGE - end, EDGE + (top + over + under) / 2)
    _draw_polygon(sheet, plan, shown, [pole + tip.conjugate() for tip in tips])
    names = tuple(plan.bodies)
    lines = [say("drawing.scale", scale=ratio(scale)), say("plans.scale", scale=decimal(unit), unit="N")]
    draw_foot(sheet, lines, say("drawing.title", row=row + 1, time=figure.time), (unit, "N"), written)
    told = {"names": names, "row": row + 1, "scale": decimal(unit)}
    alone = len(plan.bodies) == 1
    several = "forces.plan.caption" if plan.inner is not None else "forces.plan.several"
    caption = say("forces.plan.single" if alone else several, **told)
    alt = say("forces.plan.alt_single" if alone else "forces.plan.alt", names=names, row=row + 1)
    return Drawing(f"forces-{number}", sheet.svg(), sheet.width, sheet.height, caption, alt, exact=True)


def _way(vector: ForceVector, row: int) -> complex:
    force = complex(vector.force[row])
    return force / abs(force)


def _draw_links(sheet: Sheet, figure: Figure, shown: Sequence[ForceVector], put: Callable[[complex], complex]) -> None:
    for link in figure.links:
        corners = [put(at) for _, at in link]
        for a, b in zip(corners, corners[1:] + corners[:1] if len(corners) > 2 else corners[1:], strict=False):
            if abs(b - a) > SHORT:
                sheet.line(a, b, LINK, heavy=True)
    points = dict(point for link in figure.links for point in link)
    for at in points.values():
        sheet.circle(put(at), 0.9, 'fill="white" stroke="black" stroke-width="0.35"')
    drawn: list[tuple[complex, complex]] = []
    for vector in shown:
        at, way = put(complex(vector.at[figure.row])), _way(vector, figure.row).conjugate()
        length = ARROW
        while any(abs(at + length * way - tip) < 3.0 for _, tip in drawn):
            length += 3.5
        drawn.append((at, at + length * way))
        sheet.arrow(at, at + length * way, PENS[vector.role], f' data-force="{vector.name}"', heavy=True)
    for name, place in points.items():
        sheet.label(name_word(name), [(put(place), -1 - 1j, 1.2)], ITALIC)
    for vector, (at, tip) in zip(shown, drawn, strict=True):
        sheet.label(vector.word, [(tip, tip - at, 0.8)], ITALIC, owner=Owner([(at, tip)]))


def _draw_polygon(sheet: Sheet, plan: GroupPlan, shown: Sequence[ForceVector], tips: Sequence[complex]) -> None:
    for vector, tail, tip in zip(shown, tips[:-1], tips[1:], strict=True):
        data = f' data-plan="force" data-name="{vector.name}"'
        sheet.arrow(tail, tip, PENS[vector.role], data, head=min(2.6, 0.6 * abs(tip - tail)), heavy=True)
    if plan.inner is not None and (chord := _chord(plan, shown, tips)):
        sheet.line(*chord, CHORD, ' data-chord=""')
        name = plan.inner[0]
        sheet.label((name[0], name[1:], ""), [((chord[0] + chord[1]) / 2, 1j * (chord[1] - chord[0]), 0.8)], ITALIC)
    sheet.circle(tips[0], 0.7, 'fill="white" stroke="black" stroke-width="0.3"')
    for vector, tail, tip in zip(shown, tips[:-1], tips[1:], strict=True):
        across = 1j * (tip - tail)
        places = [((tail + tip) / 2, across, 0.8), ((tail + tip) / 2, -across, 0.8)]
        sheet.label(vector.word, places, ITALIC, owner=Owner([(tail, tip)]))


def _chord(plan: GroupPlan, shown: Sequence[ForceVector], tips: Sequence[complex]) -> tuple[complex, complex] | None:
    """Return the line of the inner reaction in the polygon, which closes the forces on the first link; None if it has none."""
    first = [place for place, vector in enumerate(shown) if vector.body == plan.bodies[0]]
    last = next((place for place in first if place + 1 not in first), None)
    if last is None:
        return None
    closing = [place for place in first if place > last]
    begin = tips[closing[0]] if closing else tips[0]
    return (begin, tips[last + 1]) if abs(tips[last + 1] - begin) > SHORT else None
