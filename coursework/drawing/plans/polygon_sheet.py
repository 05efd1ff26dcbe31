"""One plan of velocities or accelerations on paper, true to its scale, with the steps in which it is drawn.

Enters: `Polygons` and a row.  Leaves: `Drawing` with numbered steps.
Used by `plans.py` and `graph_check.py`.
"""

from __future__ import annotations

from collections.abc import Callable

from coursework.drawing.lettering.naming import PARTS, lies_on
from coursework.drawing.paper.board import COLUMN, EDGE, around
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import ITALIC, SMALL_LETTER, Sheet
from coursework.drawing.paper.sheet import width as width_of
from coursework.drawing.paper.symbols import decimal, image, name_word, short
from coursework.drawing.plans.foot import draw_foot, sheet_around
from coursework.drawing.plans.plan_scale import LONGEST, SEEN, SMALL, arrows_of, scale_of, short_ones
from coursework.drawing.plans.steps import steps
from coursework.drawing.plans.vectors import ACCELERATION, POLE, UNITS, VELOCITY, Polygons
from coursework.system.frozen import frozen
from coursework.words.sentences import say

INSET, HEAD = 44.0, 9.0  # mm: least width of the inset, and height of the room for its words
PENS = {
    "absolute": 'stroke="black" stroke-width="0.45"', "relative": 'stroke="black" stroke-width="0.3"',
    "normal": 'stroke="black" stroke-width="0.25" stroke-dasharray="1.6 0.9"', "tangential": 'stroke="black" stroke-width="0.25"',
    "coriolis": 'stroke="black" stroke-width="0.3" stroke-dasharray="2.4 1 0.4 1"',
    "sliding": 'stroke="black" stroke-width="0.3" stroke-dasharray="3 1"',
}  # fmt: skip
NAMES = {VELOCITY: "v", ACCELERATION: "a"}


def draw_plan(
    found: Polygons, plan: str, hinges: tuple[str, ...], row: int, written: Callable[[str], str], *,
    index: int | None = None, blank: bool = False,
) -> Drawing:  # fmt: skip
    """Return one plan of a row (from 1), found at `index` of the polygons (None: row - 1); `blank` draws only what is given."""
    index = row - 1 if index is None else index
    scale = scale_of(found, plan, index)
    unit = scale.unit
    arrows = arrows_of(found, plan, index)
    mm = [(kind, start, end, at / unit, vector / unit) for kind, start, end, at, vector in arrows]
    small = short_ones(mm)
    left, top, right, bottom = around([(0j, 9.0), *((complex(at + vector).conjugate(), 7.0) for *_, at, vector in mm)])
    inset = None
    if small and not blank:
        enlarged = say("plans.inset", times=scale.times, scale=decimal(unit / scale.times), unit=UNITS[plan])
        inset = _Inset.of(small, scale.times, written(enlarged))
    if inset is not None:
        is_beside = right + 3 + inset.width - left <= COLUMN - 2 * EDGE
        corner = complex(right + 3, top) if is_beside else complex(left, bottom + 3)
        right, bottom = max(right, corner.real + inset.width), max(bottom, corner.imag + inset.height)
    sheet, pole = sheet_around((left, top, right, bottom))
    images: dict[str, complex] = {}
    if blank:
        given = {one.point for one in found.found if one.rule in {"given", "turned"}}
        mm = [arrow for arrow in mm if arrow[0] == "absolute" and arrow[2] in given]
    for kind, start, end, at, vector in mm:
        tail, tip = pole + complex(at).conjugate(), pole + complex(at + vector).conjugate()
        if abs(vector) > 0.3:
            data = f' data-plan="{plan}" data-kind="{kind}" data-from="{short(start)}" data-to="{short(end)}"'
            sheet.arrow(tail, tip, PENS[kind], data, head=min(2.4, 0.6 * abs(vector)))
        if kind == "absolute":
            images[end] = tip
    sheet.circle(pole, 0.8, 'fill="white" stroke="black" stroke-width="0.35"')
    if inset is not None:
        inset.draw(sheet, pole + corner)
    at_pole = [name for name, tip in images.items() if abs(tip - pole) <= SEEN * LONGEST]
    still = [image(name) for name in dict.fromkeys((*hinges, *at_pole))]
    sheet.label(("p", NAMES[plan], "".join(f", {name}" for name in still)), [(pole, -1 + 1j, 1.2)], ITALIC)
    tips = [(tip, tip) for tip in (pole, *images.values())]
    for name, tip in images.items():
        if name not in at_pole:
            sheet.label(name_word(name.lower()), [(tip, tip - pole, 1.0)], ITALIC, owner=Owner([(tip, tip)], tips))
    for kind, start, end, at, vector in mm:
        if kind in {"normal", "coriolis"} and abs(vector) > SMALL:
            tail, tip = pole + complex(at).conjugate(), pole + complex(at + vector).conjugate()
            places = [(tail + part * (tip - tail), 1j * (tip - tail), 0.8) for part in PARTS]
            rivals = [line for line in sheet.segments if not lies_on(line, (tail, tip))]
            low = image(end) + ("" if start == POLE else image(start))
            sheet.label(("n" if kind == "normal" else "k", low, ""), places, ITALIC, owner=Owner([(tail, tip)], rivals))
    said = say("plans.scale", scale=decimal(unit), unit=UNITS[plan])
    time = float(found.t[index])
    draw_foot(sheet, [said], say("drawing.title", row=row, time=time), (unit, UNITS[plan]), written)
    caption = say(f"plans.{plan}.caption", row=row, time=time, scale=decimal(unit), unit=UNITS[plan])
    alt = say(f"plans.{plan}.alt", row=row)
    told = () if blank else steps(found, plan, index, scale)
    letters = _letters(found, hinges)
    return Drawing(f"{plan}-plan", sheet.svg(), sheet.width, sheet.height, caption, alt, exact=True, steps=told, letters=letters)


def _letters(found: Polygons, hinges: tuple[str, ...]) -> tuple[str, ...]:
    """Return the letters used in the steps: those of points and of their images."""
    points = {name.rstrip("'") for s in found.segments for name in (s.start, s.end) if name != POLE}
    points |= {*hinges, *(line.base for one in found.found for line in one.lines if line.base)}
    return tuple(sorted({name[0] for name in points} | {image(name)[0] for name in points}))


@frozen
class _Inset:
    """Short vectors drawn again, `times` as long, from a pole of their own at `origin` of a box (mm), below `lines` of words."""

    vectors: list[tuple[str, str, str, complex]]
    times: int
    lines: list[str]
    width: float
    height: float
    origin: complex

    @classmethod
    def of(cls, small: list[tuple[str, str, str, complex]], times: int, told: str) -> _Inset:
        left, top, right, bottom = around([(0j, 7.0), *(((times * vector).conjugate(), 7.0) for *_, vector in small)])
        lines = told.split("\n")
        width = max(INSET, right - left, *(SMALL_LETTER * width_of(line) + 3 for line in lines))
        return cls(small, times, lines, width, bottom - top + HEAD, complex((width - right - left) / 2, HEAD - top))

    def draw(self, sheet: Sheet, corner: complex) -> None:
        """Draw the box with its top left corner at a place of the sheet."""
        right, bottom = corner.real + self.width, corner.imag + self.height
        around_it = [corner, complex(right, corner.imag), complex(right, bottom), complex(corner.real, bottom)]
        sheet.path(around_it, 'fill="none" stroke="black" stroke-width="0.2"', closed=True)
        sheet.words.append((corner.real, corner.imag, right, corner.imag + HEAD))
        for k, line in enumerate(self.lines):
            sheet.text(corner + complex(1.5, 3.6 + 3.4 * k), (line, "", ""), size=SMALL_LETTER)
        pole = corner + self.origin
        sheet.circle(pole, 0.6, 'fill="white" stroke="black" stroke-width="0.3"')
        tips: list[tuple[complex, str]] = []
        for kind, start, end, vector in self.vectors:
            tip = pole + (vector * self.times).conjugate()
            if abs(tip - pole) > 0.4:
                data = f' data-inset="{self.times}" data-kind="{kind}" data-from="{short(start)}" data-to="{short(end)}"'
                sheet.arrow(pole, tip, PENS[kind], data, head=min(2.0, 0.6 * abs(tip - pole)))
                tips.append((tip, image(end) if kind == "absolute" else image(start) + image(end)))
        for tip, name in tips:
            sheet.label((name, "", ""), [(tip, tip - pole, 0.8)], ITALIC)
        sheet.words.append((corner.real, corner.imag, right, bottom))  # so that no word of the plan beside it crosses its border
