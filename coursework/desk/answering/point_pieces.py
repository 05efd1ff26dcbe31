"""Pieces that are not groups: a driven point, a rod with a slider in a straight guide, a wheel that rolls beneath a slider.

Enters: a text's variant, the point to which a piece is attached, with its path.  Leaves: additions.  Used by `pieces.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence

import numpy as np

from coursework.desk.answering.edits import Additions
from coursework.mechanism.drafts.candidates import End
from coursework.mechanism.drafts.text import commented
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, constant, spelled
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import SCHEME_NAMES
from coursework.words.sentences import say
from coursework.words.templates import filled

POINT, GUIDE, WHEEL = "point", "guide", "wheel"
ASKS = {POINT: "", GUIDE: "desk.piece.hangs", WHEEL: "desk.piece.centre"}  # keys of the words that ask for a point of the text
# Length of a rod and radius of a wheel, in parts of `size_about`.
REACH, ROUND = 2.5, 0.25
Said = Callable[[str], str]


def led(name: str, said: Said, asked: Sequence[str]) -> str:
    """Return a whole text with a point M that a drive moves and two links hold."""
    text = filled(
        "new-point.toml.j2", name=name, asked=asked, schemes=SCHEME_NAMES, say=lambda key, **values: said(say(key, **values))
    )
    return commented(text)


def size_about(end: End, ends: Collection[End]) -> float:
    """Return the size (m) to which pieces on a point are scaled: its amplitude, or a quarter of the mechanism if larger."""
    every = np.concatenate([one.path for one in ends])
    return max(end.amplitude, float(np.ptp(every.real)) / 4, float(np.ptp(every.imag)) / 4)


def with_guide(end: End, ends: Collection[End], number: int, letter: str) -> Additions:
    """Return a rod on a point, with a slider at its other end on a horizontal guide as high as the middle of the point's path.

    The rod points to the side on which there are fewer other points.
    """
    others = [one.middle.real for one in ends if one is not end]
    length = float(f"{REACH * size_about(end, ends):.2g}")
    angle = round(math.degrees(math.asin((end.middle.imag - end.path[0].imag) / length)))
    if sum(others) > len(others) * end.middle.real:
        angle = 180 - angle
    sections = {
        "given": [_line(f'r{number} = "{length:g} m"', f"{end.name}{letter}")],
        "coordinates": [f'phi{number} = {{ start = "{angle} deg", rate = "w{number}" }}'],
        "points": [f'{letter} = "{end.name} + r{number} @ phi{number}"'],
        "links": [f'{number} = {{ points = ["{end.name}", "{letter}"], rate = "w{number}" }}'],
    }
    rail = f'{{ through = "{letter}", angle = "0" }}'
    return Additions(sections, {("frame", "rails"): [rail], ("closure", "holds"): [f'"{letter}.y"']})


@frozen
class Slider:
    """A point that slides: the `angle` of its guide, and its `rate` along the guide, "" if there is no name for it.

    `rail` is the index of the guide among the frame's rails, None if it is the guide of a group.
    """

    angle: Formula
    rate: str = ""
    rail: int | None = None


def slider_of(variant: Variant, point: str) -> Slider | None:
    """Return the slider of a point in a guide of the frame, None if it does not slide in one.

    In a chain the point ends a group whose last coordinate is a length along the guide.
    """
    for rail, (through, angle) in enumerate(variant.frame.rails if not variant.groups else ()):
        if through.name == point:
            return Slider(angle, rail=rail)
    moving = {name for one in variant.coordinates for name in (one.name, one.rate)}
    rates = {one.name: one.rate for one in variant.coordinates if one.unit == "m"}
    for group in variant.groups:
        if group.meets == point and len(group.guides) == 1 and group.coordinates[-1] in rates:
            [guide] = group.guides
            if not moving & {*guide.angle.names()}:
                return Slider(guide.angle, rates[group.coordinates[-1]])
    return None


def with_wheel(end: End, slider: Slider, size: float, number: int, letter: str, said: Said) -> Additions:
    """Return a wheel on a point that slides, and the rail on which it rolls, which replaces the point's own rail.

    In a chain the group keeps its guide, so an equation says that the wheel rolls.
    """
    radius, angle = float(f"{ROUND * size:.1g}"), "0" if constant(slider.angle) == 0 else spelled(slider.angle)
    beneath = f"(0, R{number})" if angle == "0" else f"R{number} @ ({angle} + pi/2)"
    sections = {
        "given": [_line(f'R{number} = "{radius:g} m"', f"{end.name}{letter}, {said(say('desk.piece.radius'))}")],
        "unknowns": [f'w{number} = "1/s"'],
        "points": [f'{letter} = "{end.name} - {beneath}"'],
        "links": [f'{number} = {{ wheel = "{end.name}", contact = "{letter}", rate = "w{number}" }}'],
    }
    if slider.rate:
        because = said(say("desk.piece.rolls", point=letter))
        equation = f'equation = "{slider.rate} + R{number}*w{number} = 0"'
        sections["constraint"] = ["", "[[constraint]]", f'name     = "{number}"', f'because  = "{because}"', equation]
    if slider.rail is not None:
        return Additions(sections, values={("frame", "rails", slider.rail, "through"): letter})
    return Additions(sections, {("frame", "rails"): [f'{{ through = "{letter}", angle = "{angle}" }}']})


def _line(code: str, comment: str) -> str:
    return commented(f"{code}\t{comment}").rstrip("\n")
