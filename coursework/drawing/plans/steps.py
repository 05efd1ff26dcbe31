"""How a plan is drawn, step by step, as one writes it beside the drawing: lines, lengths in mm, values read off.

Enters: `Polygons`, a plan, a row and its scale.  Leaves: sentences.
Used by `polygon_sheet.py` and `graph_words.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.drawing.paper.symbols import image, lowered_name
from coursework.drawing.plans.plan_scale import PlanScale, read_length
from coursework.drawing.plans.vectors import ACCELERATION, POLE, VELOCITY, Found, Line, Polygons
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

READ_OFF = {"lines", "slide", "similar", "translates", "special"}  # rules after which a length is read off the plan


def steps(found: Polygons, plan: str, row: int, scale: PlanScale) -> tuple[Sentence, ...]:
    """Return the steps of one plan of a row (from 0) at a scale."""
    size = {(s.kind, s.start, s.end): abs(complex(s.vector[row])) for s in found.segments if s.plan == plan}
    told = _Told(plan, size, scale)
    return tuple(map(told.step, found.found))


def crossing(special: Found) -> Sentence:
    """Return a sentence that names the two lines of the mechanism in which a special point lies."""
    first, last = (
        say("plans.leg.bar", base=lowered_name(line.base), point=lowered_name(line.at))
        if line.kind == "bar"
        else say("plans.leg.guide", point=lowered_name(line.at.rstrip("'")))
        for line in special.lines
    )
    return say("plans.two", first=first, last=last)


@frozen
class _Told:
    """The words on one plan: `size` gives the amount of each vector (kind, start, end) of a row."""

    plan: str
    size: Mapping[tuple[str, str, str], float]
    scale: PlanScale

    def mm(self, *vector: str) -> float:
        """Return the length of a vector on paper (mm)."""
        kind, start, end = vector
        return self.size[kind, start, end] / self.scale.unit

    def step(self, one: Found) -> Sentence:
        """Return how one image is found."""
        point, amount = one.point, self.size["absolute", POLE, one.point]
        values: dict[str, object] = {"point": lowered_name(point), "image": image(point)}
        if one.rule in READ_OFF:
            values |= self.read(amount, "size", "mm")
        else:
            values |= {"size": amount, "mm": amount / self.scale.unit}
        if one.rule in {"given", "rolls", "meshes", "solved"}:
            centre = lowered_name(one.lines[0].base) if one.lines else ""
            return say(f"plans.{self.plan}.{one.rule}", centre=centre, **values)
        if one.rule == "special":
            values |= {"link": one.link, "legs": crossing(one)}
        under, rider = (point, one.rider) if one.rule == "slide" else (f"{point}'", point)
        if one.rule in {"slide", "stretches"}:
            sliding = self.size["sliding", under, rider]
            values |= {"rider": lowered_name(rider), "small": image(rider)}
            if one.rule == "slide":
                values |= self.read(sliding, "sliding", "sliding_mm")
            else:
                values |= {"sliding": sliding, "sliding_mm": sliding / self.scale.unit}
            if self.plan == ACCELERATION:
                coriolis = self.size["coriolis", under, rider]
                values |= {"coriolis": coriolis, "coriolis_mm": coriolis / self.scale.unit}
        drawn_to = under if one.rule == "stretches" else point
        parts = tuple(self.line(line, drawn_to) for line in one.lines)
        told = say("plans.two", first=parts[0], last=parts[1]) if len(parts) == 2 else parts
        return say(f"plans.{self.plan}.{one.rule}", lines=told, **values)

    def read(self, size: float, amount: str, length: str) -> dict[str, object]:
        """Return a vector as it is read: its length to half a millimetre, and the value of that length."""
        mm, unit = self.scale.length(size)
        key = "plans.long" if unit == self.scale.unit else "plans.long_inset"
        return {amount: read_length(mm) * unit, length: say(key, length=read_length(mm))}

    def line(self, line: Line, point: str) -> Sentence:
        """Return from where and in which direction a line is drawn, including a known part that is drawn first."""
        if line.at:
            return self.line_to_special(line, point)
        if line.kind == "rail":
            return say("plans.line.rail")
        if line.kind == "slot" and ("sliding", line.base, point) not in self.size:
            # The rider is known, the point under it is sought.
            return say("plans.line.slot", link=line.link, base=image(line.base))
        if line.kind == "slot":
            values = {"link": line.link, "base": image(line.base), "point": lowered_name(point)}
            if self.plan == VELOCITY:
                return say("plans.line.under", **values)
            return say("plans.line.coriolis", mm=self.mm("coriolis", line.base, point), **values)
        if line.kind == "wheel":
            return say("plans.line.wheel", contact=lowered_name(line.base), point=lowered_name(point))
        if line.kind == "driven":
            return self.driven_line(line, point)
        start = line.base if ("relative", line.base, point) in self.size else POLE
        known = {"start": _place(start), "base": lowered_name(line.base), "point": lowered_name(point)}
        if self.plan == ACCELERATION and ("normal", start, point) in self.size:
            return say("plans.line.normal", **known, mm=self.mm("normal", start, point))
        return say("plans.line.across", **known)

    def driven_line(self, line: Line, point: str) -> Sentence:
        """Return how the line to the rider of a driven length is drawn: first the known parts, then the line across it."""
        under = next(start for kind, start, end in self.size if kind == "sliding" and end == point)
        start = line.base if ("normal" if self.plan == ACCELERATION else "relative", line.base, under) in self.size else POLE
        values: dict[str, object] = {"base": lowered_name(line.base), "point": lowered_name(point), "link": line.link}
        values |= {"start": _place(start), "mm": self.mm("sliding", under, point)}
        if self.plan == ACCELERATION:
            values |= {"normal": self.mm("normal", start, under), "coriolis": self.mm("coriolis", under, point)}
        return say(f"plans.line.driven_{self.plan}", **values)

    def line_to_special(self, line: Line, special: str) -> Sentence:
        """Return how the line to the image of a special point is drawn, from what a leg gives for the point `line.at`."""
        start = POLE if line.kind == "rail" or ("relative", line.base, special) not in self.size else line.base
        values: dict[str, object] = {"special": lowered_name(special), "point": lowered_name(line.at), "link": line.link}
        values["start"] = _place(start)
        values["base"] = lowered_name(line.base) if line.kind in {"bar", "sleeve"} else image(line.base)
        if self.plan == VELOCITY:
            key = {"rail": "rail", "bar": "across", "slot": "under", "sleeve": "slot"}[line.kind]
            return say(f"plans.line.{key}", **(values | {"base": image(line.base)} if line.kind == "sleeve" else values))
        values["own"] = self.mm("normal", line.at, special)
        begun = {"bar": ("normal", start), "slot": ("coriolis", line.base), "sleeve": ("coriolis", start)}
        values["mm"] = self.mm(*begun[line.kind], line.at) if line.kind in begun else 0.0
        return say(f"plans.line.special.{line.kind}", **values)


def _place(start: str) -> Sentence | str:
    return say("plans.line.pole") if start == POLE else image(start)
