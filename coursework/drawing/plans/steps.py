"""How a plan is drawn, step by step, as one writes it beside the drawing: lines, lengths in mm, values read off.

Enters: `Polygons`, a plan, a row and its scale.  Leaves: sentences.
Used by `polygon_sheet.py` and `graph_words.py`.
"""

from __future__ import annotations

from coursework.drawing.paper.symbols import image, lowered_name
from coursework.drawing.plans.plan_scale import PlanScale, read_length
from coursework.drawing.plans.vectors import ACCELERATION, POLE, VELOCITY, Found, Line, Polygons
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

READ_OFF = {"lines", "slide", "similar", "translates", "special"}  # rules after which a length is read off the plan


def steps(found: Polygons, plan: str, row: int, scale: PlanScale) -> tuple[Sentence, ...]:
    """Return the steps of one plan of a row (from 0) at a scale."""
    size = {(s.kind, s.start, s.end): abs(complex(s.vector[row])) for s in found.segments if s.plan == plan}
    return tuple(_step(one, plan, size, scale) for one in found.found)


def _step(one: Found, plan: str, size: dict[tuple[str, str, str], float], scale: PlanScale) -> Sentence:
    point, amount = one.point, size[("absolute", POLE, one.point)]
    values: dict[str, object] = {"point": lowered_name(point), "image": image(point)}
    if one.rule in READ_OFF:
        values |= _read(amount, scale, "size", "mm")
    else:
        values |= {"size": amount, "mm": amount / scale.unit}
    if one.rule in {"given", "rolls", "meshes", "solved"}:
        centre = lowered_name(one.lines[0].base) if one.lines else ""
        return say(f"plans.{plan}.{one.rule}", centre=centre, **values)
    if one.rule == "special":
        values |= {"link": one.link, "legs": crossing(one)}
    under, rider = (point, one.rider) if one.rule == "slide" else (f"{point}'", point)
    if one.rule in {"slide", "stretches"}:
        sliding = size[("sliding", under, rider)]
        values |= {"rider": lowered_name(rider), "small": image(rider)}
        if one.rule == "slide":
            values |= _read(sliding, scale, "sliding", "sliding_mm")
        else:
            values |= {"sliding": sliding, "sliding_mm": sliding / scale.unit}
        if plan == ACCELERATION:
            coriolis = size[("coriolis", under, rider)]
            values |= {"coriolis": coriolis, "coriolis_mm": coriolis / scale.unit}
    drawn_to = under if one.rule == "stretches" else point
    parts = tuple(_line(line, drawn_to, plan, size, scale.unit) for line in one.lines)
    told = say("plans.two", first=parts[0], last=parts[1]) if len(parts) == 2 else parts
    return say(f"plans.{plan}.{one.rule}", lines=told, **values)


def crossing(special: Found) -> Sentence:
    """Return a sentence that names the two lines of the mechanism in which a special point lies."""
    first, last = (
        say("plans.leg.bar", base=lowered_name(line.base), point=lowered_name(line.at))
        if line.kind == "bar"
        else say("plans.leg.guide", point=lowered_name(line.at.rstrip("'")))
        for line in special.lines
    )
    return say("plans.two", first=first, last=last)


def _read(size: float, scale: PlanScale, amount: str, length: str) -> dict[str, object]:
    """Return a vector as it is read: its length to half a millimetre, and the value of that length."""
    mm, unit = scale.length(size)
    key = "plans.long" if unit == scale.unit else "plans.long_inset"
    return {amount: read_length(mm) * unit, length: say(key, length=read_length(mm))}


def _line(line: Line, point: str, plan: str, size: dict[tuple[str, str, str], float], unit: float) -> Sentence:
    """Return from where and in which direction a line is drawn, including a known part that is drawn first."""
    if line.at:
        return _line_to_special(line, point, plan, size, unit)
    if line.kind == "rail":
        return say("plans.line.rail")
    if line.kind == "slot" and ("sliding", line.base, point) not in size:  # the rider is known, the point under it is sought
        return say("plans.line.slot", link=line.link, base=image(line.base))
    if line.kind == "slot":
        values = {"link": line.link, "base": image(line.base), "point": lowered_name(point)}
        if plan == VELOCITY:
            return say("plans.line.under", **values)
        return say("plans.line.coriolis", mm=size["coriolis", line.base, point] / unit, **values)
    if line.kind == "wheel":
        return say("plans.line.wheel", contact=lowered_name(line.base), point=lowered_name(point))
    if line.kind == "driven":
        return _driven_line(line, point, plan, size, unit)
    start = line.base if ("relative", line.base, point) in size else POLE
    normal = size.get(("normal", start, point))
    where = say("plans.line.pole") if start == POLE else image(line.base)
    if plan == ACCELERATION and normal is not None:
        return say("plans.line.normal", start=where, base=lowered_name(line.base), point=lowered_name(point), mm=normal / unit)
    return say("plans.line.across", start=where, base=lowered_name(line.base), point=lowered_name(point))


def _driven_line(line: Line, point: str, plan: str, size: dict[tuple[str, str, str], float], unit: float) -> Sentence:
    """Return how the line to the rider of a driven length is drawn: first the known parts, then the line across it."""
    under = next(start for kind, start, end in size if kind == "sliding" and end == point)
    start = line.base if ("normal" if plan == ACCELERATION else "relative", line.base, under) in size else POLE
    values: dict[str, object] = {"base": lowered_name(line.base), "point": lowered_name(point), "link": line.link}
    values["start"] = say("plans.line.pole") if start == POLE else image(line.base)
    values["mm"] = size["sliding", under, point] / unit
    if plan == ACCELERATION:
        values |= {"normal": size["normal", start, under] / unit, "coriolis": size["coriolis", under, point] / unit}
    return say(f"plans.line.driven_{plan}", **values)


def _line_to_special(line: Line, special: str, plan: str, size: dict[tuple[str, str, str], float], unit: float) -> Sentence:
    """Return how the line to the image of a special point is drawn, from what a leg gives for the point `line.at`."""
    start = POLE if line.kind == "rail" or ("relative", line.base, special) not in size else line.base
    values: dict[str, object] = {"special": lowered_name(special), "point": lowered_name(line.at), "link": line.link}
    values["start"] = say("plans.line.pole") if start == POLE else image(line.base)
    values["base"] = lowered_name(line.base) if line.kind in {"bar", "sleeve"} else image(line.base)
    if plan == VELOCITY:
        key = {"rail": "rail", "bar": "across", "slot": "under", "sleeve": "slot"}[line.kind]
        return say(f"plans.line.{key}", **(values | {"base": image(line.base)} if line.kind == "sleeve" else values))
    values["own"] = size["normal", line.at, special] / unit
    before = {"bar": ("normal", start, line.at), "slot": ("coriolis", line.base, line.at), "sleeve": ("coriolis", start, line.at)}
    values["mm"] = size[before[line.kind]] / unit if line.kind in before else 0.0
    return say(f"plans.line.special.{line.kind}", **values)
