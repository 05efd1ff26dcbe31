"""What the graph-analytical check says in words: names, how each centre was found, by how much the row violates its lengths.

Enters: a `Sketch` and the `Findings`.  Leaves: sentences.  Used by `graph_check.py`.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterable, Mapping, Set
from typing import TYPE_CHECKING

from coursework.drawing.check_sheet.instant_centres import Centre, Findings
from coursework.drawing.check_sheet.sketch import Body, Sketch
from coursework.drawing.paper.symbols import LOWERED, lowered_name
from coursework.words.sentences import joined, say

if TYPE_CHECKING:
    from coursework.drawing.check_sheet.check_plan import CheckPlan

# Relative to the mechanism: a smaller change of a link's length since the start is round-off, not drift.
RIGID = 1e-9


def centre_letter(sketch: Sketch) -> str:
    """Return the letter of instantaneous centres: P, or I if a point of the file is called P or has the name of a centre."""
    contacts = {contact for _, contact in sketch.wheels.values()}
    return letter_of_centres(sketch.pose.positions, contacts, [body.name for body in sketch.pose.bodies])


def letter_of_centres(points: Collection[str], contacts: Collection[str], links: Iterable[str]) -> str:
    """Return the letter of centres, given the points, those among them at which wheels roll, and the links."""
    taken = ("P" in points and "P" not in contacts) or any(f"P{link}" in points for link in links)
    return "I" if taken else "P"


def _centre(body: Body, letter: str) -> str:
    """Return the name of a link's centre in a sentence: P₃."""
    if body.name.isascii() and body.name.isdecimal():
        return letter + lowered(body.name)
    return say("drawing.centre", letter=letter, link=body.name)


def lowered(digits: str) -> str:
    """Return text with its digits as subscripts; other characters stay as they are."""
    return digits.translate(LOWERED)


def omega_name(body: Body) -> str:
    """Return the name of a link's angular velocity: ω₃ for the rate w3, else the name of its rate or link."""
    short = re.fullmatch(r"(?:w|omega)_?(\d+)", body.rate or "")
    if short or (body.rate is None and not body.has_namesake and body.name.isdecimal() and body.name.isascii()):
        digits = short[1] if short else body.name
        return "ω" + lowered(digits)
    return body.rate or say("drawing.omega", link=body.name)


def how_found(sketch: Sketch, findings: Findings, plan: CheckPlan | None) -> list[str]:
    """Return sentences on how the velocity of each link was found, in the order of the file."""
    sentences: list[str] = []
    sleeves = {(slide.link, slide.rider) for slide in sketch.pose.slides}
    solved = plan.solved if plan is not None else set(sketch.pose.positions)
    bodies = [body for body in sketch.pose.bodies if not body.guide]
    links = [body.name for body in bodies if body.name in findings.planned and not solved & {*body.points}]
    bars = {slide.link for slide in sketch.pose.slides}
    if asked := [body.name for body in bodies if body.name in links and (len(body.points) > 1 or body.name in bars)]:
        sentences.append(say("drawing.by_lines", links=tuple(asked)))
    for one in plan.polygons.found if plan is not None else ():
        if one.rule == "special":
            from coursework.drawing.plans.steps import crossing

            sentences.append(say("drawing.special", special=lowered_name(one.point), link=one.link, legs=crossing(one)))
    if plan is not None and findings.beyond:
        sentences.append(say("drawing.beyond", links=findings.beyond))
    for body in bodies:
        centre = findings.centres.get(body.name)
        if body.name in links:
            continue
        if body.name in findings.planned:
            sentences.append(say("drawing.by_plan", link=body.name))
        elif body.name in findings.missing:
            sentences.append(say("drawing.missing", link=body.name))
        elif centre is not None:
            sentences.append(_story(body, centre, sketch.wheels, centre_letter(sketch), sleeves))
    return sentences


def why_unread(sketch: Sketch, findings: Findings, plan: CheckPlan | None) -> str:
    """Return a sentence on why nothing can be read off a drawing."""
    pose = sketch.pose
    if not (pose.velocities or pose.rates or pose.driven_lengths):
        return say("graph.unread_free")
    if not any(findings.velocities.values()):
        # The known rates include those of driven lengths, and no velocity of a point follows from such a rate alone.
        return say("graph.unread_lengths" if any(pose.rates.values()) else "graph.unread_still")
    if findings.missing:
        return say("graph.unread_left")
    together = (findings.planned or findings.beyond) and (plan is None or plan.solved)
    return say("graph.unread_together" if together else "graph.unread_given")


def _story(body: Body, centre: Centre, wheels: Mapping[str, tuple[str, str]], letter: str, sleeves: Set[tuple[str, str]]) -> str:
    pivot = next((name for name in centre.lines if (body.name, name) in sleeves), "")
    if pivot and centre.at is not None:
        other = next(name for name in centre.lines if name != pivot)
        return say("drawing.sleeve", centre=_centre(body, letter), point=other, pivot=pivot)
    if centre.lines and centre.at is None:
        return say("drawing.translates", link=body.name, points=tuple(centre.lines))
    if len(centre.lines) == 1:
        return say("drawing.follows", centre=_centre(body, letter), link=body.name, point=centre.lines[0])
    if centre.lines:
        return say("drawing.meet", centre=_centre(body, letter), points=tuple(centre.lines))
    if body.name in wheels and centre.point == wheels[body.name][1]:
        return say("drawing.rolls", link=body.name, point=centre.point)
    return say("drawing.turns", link=body.name, point=centre.point)


def drift(sketch: Sketch) -> list[str]:
    """Return a sentence, in a list, on links and rails that the row violates, so that drawing and table differ; [] if none."""
    now, start = sketch.pose.positions, sketch.start
    allowed = RIGID * sketch.pose.size
    found = []
    for body in sketch.pose.bodies:
        centre, contact = sketch.wheels.get(body.name, ("", sketch.racks.get(body.name, "")))
        for a, b in itertools.combinations(body.points, 2):
            if contact in {a, b} and centre not in {a, b}:
                continue
            length, first = abs(now[a] - now[b]), abs(start[a] - start[b])
            if abs(length - first) > allowed:
                key = "drawing.long" if length > first else "drawing.short"
                found.append(say(key, side=f"{a}{b}", link=body.name, off=1e3 * float(abs(length - first))))
    for key, left in (("drawing.beside", sketch.off_rails), ("drawing.off", sketch.off_tracks)):
        found += [say(key, point=point, off=1e3 * abs(off)) for point, off in left if abs(off) > allowed]
    return [say("drawing.drifted", found=joined(found, "join.semicolon"))] if found else []
