"""How a plan is drawn, step by step, as one writes it beside the drawing: lines, lengths in mm, what is read.

Enters: `Polygons`, a plan, a row and its scale.  Leaves: sentences.
Used by `polygon_sheet.py`.
"""

from __future__ import annotations

from coursework.drawing.paper.symbols import lowered_name
from coursework.drawing.plans.polygons import ACCELERATION, POLE, Found, Line, Polygons
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def image(name: str) -> str:
    """Return the letter of an image: that of the point, small, its digits lowered."""
    return lowered_name(name).lower()


def steps(found: Polygons, plan: str, row: int, unit: float) -> tuple[Sentence, ...]:
    """Return the steps of one plan of a row (from 0); `unit` m/s or m/s² a mm."""
    size = {(s.kind, s.start, s.end): abs(complex(s.vector[row])) for s in found.segments if s.plan == plan}
    return tuple(_step(one, plan, size, unit) for one in found.found)


def _step(one: Found, plan: str, size: dict[tuple[str, str, str], float], unit: float) -> Sentence:
    point, amount = one.point, size[("absolute", POLE, one.point)]
    values = {"point": lowered_name(point), "image": image(point), "size": amount, "mm": amount / unit}
    if one.rule in {"given", "rolls", "solved"}:
        return say(f"plans.{plan}.{one.rule}", **values)
    under = f"{point}'" if one.rule == "stretches" else point
    if one.rule in {"slide", "stretches"}:
        rider = under.rstrip("'")
        sliding = size[("sliding", under, rider)]
        values |= {"rider": lowered_name(rider), "small": image(rider), "sliding": sliding, "sliding_mm": sliding / unit}
        if plan == ACCELERATION:
            coriolis = size[("coriolis", under, rider)]
            values |= {"coriolis": coriolis, "coriolis_mm": coriolis / unit}
    parts = tuple(_line(line, under, plan, size, unit) for line in one.lines)
    return say(
        f"plans.{plan}.{one.rule}", lines=say("plans.two", first=parts[0], last=parts[1]) if len(parts) == 2 else parts, **values
    )


def _line(line: Line, point: str, plan: str, size: dict[tuple[str, str, str], float], unit: float) -> Sentence:
    """Return from where and in which direction a line is drawn, with the normal part where one comes first."""
    if line.kind == "rail":
        return say("plans.line.rail")
    if line.kind == "slot":
        return say("plans.line.slot", link=line.link, base=image(f"{line.base}'" if line.base == point else line.base))
    if line.kind == "wheel":
        return say("plans.line.wheel", contact=lowered_name(line.base), point=lowered_name(point))
    start = line.base if ("relative", line.base, point) in size else POLE
    normal = size.get(("normal", start, point))
    where = say("plans.line.pole") if start == POLE else image(line.base)
    if plan == ACCELERATION and normal is not None:
        return say("plans.line.normal", start=where, base=lowered_name(line.base), point=lowered_name(point), mm=normal / unit)
    return say("plans.line.across", start=where, base=lowered_name(line.base), point=lowered_name(point))
