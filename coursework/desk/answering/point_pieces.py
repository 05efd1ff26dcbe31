"""Pieces that are no groups: a driven point, a rod with a slider in a straight guide, a wheel that rolls beneath a slider.

Enters: a text's variant, the point a piece hangs on with its path.  Leaves: what the text gets.  Used by `pieces.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence

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
ASKS = {POINT: "", GUIDE: "desk.piece.hangs", WHEEL: "desk.piece.centre"}  # what each asks for: a point of the text
# Length of a rod and radius of a wheel, in parts of how far their point goes from its middle, or of a quarter of the mechanism.
REACH, ROUND = 2.5, 0.25
Said = Callable[[str], str]


def led(name: str, said: Said, asked: Sequence[str]) -> str:
    """Return a whole text whose point M a drive moves; two links hold it."""
    text = filled(
        "new-point.toml.j2", name=name, asked=asked, schemes=SCHEME_NAMES, say=lambda key, **values: said(say(key, **values))
    )
    return commented(text)


def size_about(end: End, ends: Collection[End]) -> float:
    """Return what sizes of pieces on a point are parts of (m)."""
    every = np.concatenate([one.path for one in ends])
    return max(end.amplitude, float(np.ptp(every.real)) / 4, float(np.ptp(every.imag)) / 4)


def with_guide(end: End, ends: Collection[End], number: int, letter: str) -> Additions:
    """Return a rod on a point, and a slider on a level guide through the other end of the rod, as high as the point's middle.

    It goes to the side on which fewer of the other points are.
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
    """How a point slides: the `angle` of its guide, its `rate` along that where a chain has a name for it.

    `rail` is the place of the guide among those of the frame, where it stands there for this point.
    """

    angle: Formula
    rate: str = ""
    rail: int | None = None


def slider_of(variant: Variant, point: str) -> Slider | None:
    """Return how a point slides in a guide of the frame, None where it does not."""
    return next(iter([*_in_rails(variant, point), *_in_chain(variant, point)]), None)


def _in_rails(variant: Variant, point: str) -> Iterator[Slider]:
    rails = enumerate(variant.frame.rails)
    return (Slider(angle, rail=k) for k, (through, angle) in rails if through.name == point and not variant.groups)


def _in_chain(variant: Variant, point: str) -> Iterator[Slider]:
    """Yield how the end of a group slides whose last coordinate is its way along a guide of the frame."""
    moving = {name for one in variant.coordinates for name in (one.name, one.rate)}
    rates = {one.name: one.rate for one in variant.coordinates if one.unit == "m"}
    for group in variant.groups:
        if group.meets == point and len(group.guides) == 1 and group.coordinates[-1] in rates:
            [guide] = group.guides
            if not moving & {*guide.angle.names()}:
                yield Slider(guide.angle, rates[group.coordinates[-1]])


def with_wheel(end: End, slider: Slider, size: float, number: int, letter: str, said: Said) -> Additions:
    """Return a wheel about a point that slides, and the line on which it rolls, in the place of the point's guide.

    A chain, whose group keeps its guide, says in an equation that it rolls.
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
