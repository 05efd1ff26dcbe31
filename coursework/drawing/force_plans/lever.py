"""Zhukovsky's lever: the velocity plan turned by a right angle, with every force at the image of its point; read with a ruler.

Enters: a `ForceAnalysis`, the velocities for a unit of each drive, a row.  Leaves: `Lever`s, `Drawing`s.
Used by `force_plans.py`.

The plan is turned clockwise, so that the moment of a force about the pole is its power for a unit of the drive:
sum F h + sum M w = - F_d.  A driven point has two levers, one for each of its components.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.drawing.force_plans.vectors import word_of
from coursework.drawing.paper.board import around, vector_scale
from coursework.drawing.paper.placing import Owner
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import AXIS, ITALIC
from coursework.drawing.paper.symbols import decimal
from coursework.drawing.plans.foot import draw_foot, sheet_around
from coursework.drawing.plans.plan_scale import LONGEST, read_length
from coursework.effects.force_scheme import drives_of
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.kinetostatics.virtual_power import twists, unit_motions
from coursework.system.frozen import frozen
from coursework.words.sentences import say

ARROW = 14.0  # mm of a force: on a lever it shows direction and line of action, not size
ARM = 'stroke="black" stroke-width="0.25" stroke-dasharray="1.2 0.8"'
PEN = 'stroke="black" stroke-width="0.45"'


@frozen
class Arm:
    """A force (complex N) at the image of its point (mm from the pole); `h` (mm, + counter-clockwise) is its arm as read."""

    name: str
    word: tuple[str, str, str]
    force: complex
    image: complex
    h: float


@frozen
class Lever:
    """The lever of one drive in a row; 1 mm of it is a velocity of `unit` m (or m/rad) for a unit of the drive.

    `couples` is the sum of M w (N m or N); `read` is what the drive must supply by the arms as read, `computed` as calculated.
    """

    drive: str
    unit: float
    arms: tuple[Arm, ...]
    couples: float
    read: float
    computed: float


def levers_of(found: ForceAnalysis, row: int) -> tuple[Lever, ...]:
    """Return the lever of each drive in a row (from 0); none if the geometry does not determine the velocities."""
    rows, scheme = found.rows, found.rows.scheme
    velocities = unit_motions(rows, found.equations)
    if velocities is None or not np.isfinite(found.reactions.rows[row]).all():
        return ()
    moves = twists(rows, found.equations, velocities)[row]
    places = {body.name: place for place, body in enumerate(scheme.bodies)}
    if any(one.direction.kind == "couple" and one.off in places for one in drives_of(scheme)):
        return ()  # a motor between two moving links has no lever of its own
    levers = []
    for index, name in enumerate(found.drive_names):
        arms, couples = [], 0.0
        listed = []
        for action in found.actions:
            place = places[action.body]
            centre = scheme.bodies[place].centre
            turned = moves[place, 2, index]
            if action.couple is not None:
                couples += float(action.couple[row]) * turned
            elif action.force is not None and action.at is not None and abs(action.force[row]) > 0:
                arm = complex(action.at[row] - rows.vector(centre)[row])
                velocity = complex(moves[place, 0, index], moves[place, 1, index]) + 1j * turned * arm
                listed.append((word_of(action), complex(action.force[row]), -1j * velocity))
        longest = max((abs(image) for *_, image in listed), default=0.0)
        if not longest:
            continue
        unit = vector_scale(longest, LONGEST / 2)
        for word, force, image in listed:
            at = image / unit
            h = (np.conj(at) * force).imag / abs(force)
            arms.append(Arm("".join(word), word, force, at, float(np.sign(h) * read_length(abs(h)))))
        read = -sum(abs(one.force) * one.h * unit for one in arms) - couples
        levers.append(Lever(name, unit, tuple(arms), couples, float(read), float(found.column(name)[row])))
    return tuple(levers)


def draw_lever(lever: Lever, row: int, time: float, written: Callable[[str], str]) -> Drawing:
    """Return `figure#lever-DRIVE`: images of the points, forces, arms."""
    places = [(one.image.conjugate(), ARROW * (one.force / abs(one.force)).conjugate()) for one in lever.arms]
    circles = [(0j, 6.0), *((at, 5.0) for at, _ in places), *((at + way, 6.0) for at, way in places)]
    feet = [_foot(at, way) for at, way in places]
    sheet, pole = sheet_around(around([*circles, *((foot, 3.0) for foot in feet)]))
    for at, foot in zip((at for at, _ in places), feet, strict=True):
        if abs(at) > 0.3:
            sheet.line(pole, pole + at, 'stroke="black" stroke-width="0.3"')
        if abs(foot - at) > 0.3:
            sheet.line(pole + at, pole + foot, AXIS)
        if abs(foot) > 0.3:
            sheet.line(pole, pole + foot, ARM)
    for one, (at, way) in zip(lever.arms, places, strict=True):
        sheet.arrow(pole + at, pole + at + way, PEN, f' data-force="{one.name}"', heavy=True)
    sheet.circle(pole, 0.8, 'fill="white" stroke="black" stroke-width="0.35"')
    sheet.label(("p", "", ""), [(pole, -1 + 1j, 1.2)], ITALIC)
    for one, (at, way) in zip(lever.arms, places, strict=True):
        sheet.label(one.word, [(pole + at + way, way, 0.8)], ITALIC, owner=Owner([(pole + at, pole + at + way)]))
    said = say("forces.lever.scale", scale=decimal(lever.unit))
    draw_foot(sheet, [said], say("drawing.title", row=row + 1, time=time), (lever.unit, "m"), written)
    caption = say("forces.lever.caption", drive=lever.drive, row=row + 1)
    alt = say("forces.lever.alt", drive=lever.drive, row=row + 1)
    return Drawing(f"lever-{lever.drive}", sheet.svg(), sheet.width, sheet.height, caption, alt, exact=True)


def _foot(at: complex, way: complex) -> complex:
    """Return the foot of the perpendicular from the pole to the line of a force."""
    unit = way / abs(way)
    return at - (unit.conjugate() * at).real * unit
