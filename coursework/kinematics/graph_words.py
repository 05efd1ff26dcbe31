"""What the graph-analytical check says in words: names, how each centre was found, how far the row does not close.

Enters: a `Sketch` and the `Findings`.  Leaves: sentences.  Used by `graph_check.py`.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping

from coursework.errors import listing
from coursework.kinematics.instant_centres import Body, Centre, Findings
from coursework.kinematics.scene import Sketch

# A link longer or shorter than at the start by less than this share of the mechanism is round-off, not drift.
RIGID = 1e-9


def centre_letter(sketch: Sketch) -> str:
    """Return the letters of instantaneous centres: P, or IC where a point of the file is called like one."""
    return "IC" if any(f"P{body.name}" in sketch.scene.positions for body in sketch.scene.bodies) else "P"


def _centre(body: Body, letter: str) -> str:
    """Return how the centre of a link is called in a sentence: P₃."""
    return letter + (_lowered(body.name) if body.name.isascii() and body.name.isdecimal() else f" of link {body.name}")


def _lowered(digits: str) -> str:
    return digits.translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉"))


def omega_name(body: Body) -> str:
    """Return how the angular velocity of a link is called: ω₃ for the rate w3, else the name of its rate or link."""
    short = re.fullmatch(r"(?:w|omega)_?(\d+)", body.rate or "")
    if short or (body.rate is None and body.name.isdecimal() and body.name.isascii()):
        digits = short[1] if short else body.name
        return "ω" + _lowered(digits)
    return body.rate or f"ω of link {body.name}"


def how_found(sketch: Sketch, findings: Findings) -> list[str]:
    """Return how each link was dealt with, in the order of the file."""
    sentences = [
        f"V_{point} by a velocity plan: V_{a} + V_{point}{a} = V_{b} + V_{point}{b}, each difference at right angles to its link."
        for point, (a, b) in findings.plans.items()
    ]
    for body in sketch.scene.bodies:
        centre = findings.centres.get(body.name)
        if body.name in findings.missing:
            sentences.append(f"Link {body.name} is not determined by the drawing.")
        elif centre is not None and not body.guide:
            sentences.append(_story(body, centre, sketch.wheels, centre_letter(sketch)))
    return sentences


def _story(body: Body, centre: Centre, wheels: Mapping[str, tuple[str, str]], letter: str) -> str:
    if centre.lines and centre.at is None:
        return f"Link {body.name} translates: the velocities of {listing(centre.lines)} are parallel."
    if len(centre.lines) == 1:
        return f"{_centre(body, letter)} follows from the known rate of link {body.name} and the velocity of {centre.lines[0]}."
    if centre.lines:
        return f"{_centre(body, letter)} is where the perpendiculars to the velocities of {listing(centre.lines)} meet."
    if body.name in wheels and centre.point == wheels[body.name][1]:
        return f"Link {body.name} rolls: its instantaneous centre is the contact {centre.point}."
    return f"Link {body.name} turns about {centre.point}."


def drift(sketch: Sketch) -> list[str]:
    """Return which links and rails the row does not keep: there the drawing and the table differ by as much."""
    now, start = sketch.scene.positions, sketch.start
    allowed = RIGID * sketch.scene.size
    found = []
    for link in sketch.links:
        joints = dict.fromkeys(name for name in (*link.points, link.wheel, link.contact) if name)
        for a, b in itertools.combinations(joints, 2):
            if link.contact in {a, b} and link.wheel not in {a, b}:
                continue
            length, first = abs(now[a] - now[b]), abs(start[a] - start[b])
            if abs(length - first) > allowed:
                found.append(f"{a}{b} of link {link.name} is {1e3 * abs(length - first):.3g} mm too {_than(length, first)}")
    found += [
        f"{rail.point} stands {1e3 * abs(rail.off):.3g} mm beside its rail" for rail in sketch.rails if abs(rail.off) > allowed
    ]
    found += [f"{t.point} stands {1e3 * abs(t.off):.3g} mm off its circle" for t in sketch.tracks if abs(t.off) > allowed]
    return [f"The scheme has drifted, so this row does not close: {'; '.join(found)}."] if found else []


def _than(length: float, first: float) -> str:
    return "long" if length > first else "short"
