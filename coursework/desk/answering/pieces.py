"""Pieces to build from, groups, driven points, guides and wheels: a picture of each, and its lines, attached to points of a text.

Enters: a `Desk`, a kind, the points to which the piece is attached.  Leaves: the text with it.  Used by `bench.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Iterator, Sequence
from typing import Any

import numpy as np

from coursework.api import make_run, variant_in
from coursework.desk.answering.derived import lacking_lines
from coursework.desk.answering.edits import Additions, changed, with_additions
from coursework.desk.answering.pictures import picture
from coursework.desk.answering.typed import Desk
from coursework.desk.job import OK, Answer, plain
from coursework.drawing.outline.poses import read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.mechanism.drafts.candidates import ROWS, End
from coursework.mechanism.drafts.chain import DoesNotClose, draft_of, draft_on, letters
from coursework.mechanism.drafts.text import additions, commented, text_of
from coursework.scene.quantities import ACCELERATIONS, CHECKS, GRAPH_CHECK, PLOTS, POINTS, TABLE
from coursework.scene.scene import Scene
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, constant, spelled
from coursework.variant.record.roles import role, title
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import GROUP_KINDS, GROUP_SHAPES, SCHEME_NAMES
from coursework.variant.toml.positions import KeyPath
from coursework.words.errors import CourseworkError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say
from coursework.words.templates import filled

ASKED = (TABLE, PLOTS, CHECKS, GRAPH_CHECK, ACCELERATIONS, POINTS)
STILL = 1e-9  # m: a point that moves less stands still
DRIVEN = next(kind for kind, shape in GROUP_SHAPES.items() if shape.driven)
# The group of a rod and a slider in a guide of the frame.
ROD = next(kind for kind, shape in GROUP_SHAPES.items() if (shape.points, shape.lengths, shape.guides) == (1, (1,), 1))


def pieces(desk: Desk) -> Answer:
    """Return each kind with its title, its picture, and what it asks for: the point to which it is attached."""
    return plain(OK, [*(_group(kind, desk) for kind in GROUP_KINDS), *_by_points(desk)])


def _group(kind: str, desk: Desk) -> dict[str, Any]:
    shape = GROUP_SHAPES[kind]
    letters = shape.named()
    means = role(shape, "from", letters, 1) if shape.points else say("desk.rides_on")
    return _shown(kind, title(shape, letters), _alone(kind, desk), [] if shape.driven else [means], desk)


def _by_points(desk: Desk) -> Iterator[dict[str, Any]]:
    """Yield the pieces that are not groups, each drawn attached to the one before it."""
    text, on = "", ""
    for kind, on in zip(ASKS, ("", "A", "B"), strict=True):
        text = piece(Desk({"kind": kind, "on": [on] if on else [], "text": text}, desk.language, desk.setup))["text"]
        yield _shown(kind, say(f"desk.piece.{kind}"), text, [say(ASKS[kind])] if on else [], desk)


def _shown(kind: str, title: Sentence | str, text: str, asks: Sequence[Sentence | str], desk: Desk) -> dict[str, Any]:
    written = desk.words.written
    svg = picture(make_run(variant_in(text, kind, {})).scene)
    return {"kind": kind, "title": written(title), "svg": svg, "asks": [{"key": "from", "means": written(one)} for one in asks]}


def _alone(kind: str, desk: Desk) -> str:
    """Return a whole text that begins with a piece: one group of a kind and the crank that moves it, or a driven point."""
    if kind in ASKS:
        return led(desk.name, desk.words.written, [one.name for one in ASKED])
    draft = draft_of([DRIVEN] if kind == DRIVEN else [DRIVEN, kind])
    # The first line, on how to run the file in a terminal and on its chain, is dropped: the desk does not need it.
    return text_of(draft, desk.name, desk.words.written, [one.name for one in ASKED]).partition("\n")[2]


def piece(desk: Desk) -> dict[str, Any]:
    """Return `text` and `ranges` with one more piece, or a `sentence` if it cannot be attached there."""
    kind, hung = str(desk.body["kind"]), [str(name) for name in desk.body["on"]]
    if kind not in GROUP_KINDS and kind not in ASKS:
        return desk.unchanged(say("desk.no_file", name=kind[:40]))
    if not desk.text.strip() and kind not in (GUIDE, WHEEL):
        return changed("", [(0, 0, _alone(kind, desk))])
    if kind == POINT or not desk.text.strip():
        return desk.unchanged(say("desk.piece.first" if kind == POINT else "desk.piece.later"))
    if kind in GROUP_KINDS and not desk.variant.groups:
        return desk.unchanged(say("desk.piece.no_chain", kind=kind))
    scene = make_run(desk.variant).scene
    known, taken = _ends(scene), {*desk.variant.names, *(name for name, _ in scene.mechanism.points)}
    if not hung and kind != DRIVEN:
        return desk.unchanged(say("desk.piece_does_not_close", kind=kind))
    if scene.stop is not None and not known and kind != DRIVEN:
        return desk.unchanged(scene.stop.sentence)
    if missing := [name for name in hung if name not in known]:
        return desk.unchanged(say("desk.no_joint", joint=missing[0][:40]))
    if kind != DRIVEN and all(known[name].amplitude < STILL for name in hung):
        return desk.unchanged(say("desk.piece_on_still", point=hung[0]))
    digits = [int(found) for name in desk.variant.names for found in re.findall(r"\d{1,3}", name)]
    number = max((*digits, *(int(link.name) for link in desk.variant.links if link.name.isdecimal())), default=0) + 1
    if kind in ASKS and not (kind == GUIDE and desk.variant.groups):
        return _put_to(kind, hung[0], known, number, taken, desk)
    beside = [*known.values()][-1:] if kind == DRIVEN else []  # so that it stands clear of the others
    return _hang(ROD if kind == GUIDE else kind, [known[name] for name in hung] or beside, number, taken, desk)


def _put_to(kind: str, on: str, known: dict[str, End], number: int, taken: set[str], desk: Desk) -> dict[str, Any]:
    """Return the text with a piece that is not a group, and with equations for it if the text has written equations."""
    letter = next(letter for letter in letters() if letter not in taken)
    slider = slider_of(desk.variant, on)
    if kind == GUIDE:
        more = with_guide(known[on], known.values(), number, letter)
    elif slider is None:
        return desk.unchanged(say("desk.piece.not_straight", point=on))
    elif not desk.variant.links:
        return desk.unchanged(say("desk.piece.no_links"))
    else:
        more = with_wheel(known[on], slider, size_about(known[on], known.values()), number, letter, desk.words.written)
    if desk.variant.constraints and not desk.variant.groups and desk.setup.policy.equations:
        text = with_additions(desk.text, more)["text"]
        more.sections["constraint"] = lacking_lines(Desk({**desk.body, "text": text}, desk.language, desk.setup))
    return with_additions(desk.text, more)


def _hang(kind: str, ends: list[End], number: int, taken: set[str], desk: Desk) -> dict[str, Any]:
    """Return the text with one more group on `ends`, or a sentence if the group does not close."""
    try:
        draft = draft_on(kind, ends, taken, number)
    except (DoesNotClose, CourseworkError, ArithmeticError):
        return desk.unchanged(say("desk.piece_does_not_close", kind=kind))
    lines = additions(draft, len(desk.variant.groups) + 1, desk.words.written)
    rails = [f'{{ through = "{guide.through}", angle = "{guide.angle}" }}' for guide in draft.rails]
    entries: dict[KeyPath, list[str]] = {("frame", "hinges"): [f'"{name}"' for name in draft.hinges], ("frame", "rails"): rails}
    return with_additions(desk.text, Additions(lines, entries))


def _ends(scene: Scene) -> dict[str, End]:
    """Return the points to which a piece may be attached, with their paths; empty if they or the motion are not known."""
    outline, motion = read_outline(scene.mechanism), scene.exact
    if outline is None or not len(motion.t):
        return {}
    poses = read_poses(outline, scene.equations)(motion.t, motion.coordinates)
    at = np.linspace(0, len(motion.t) - 1, ROWS)
    rows = np.arange(len(motion.t))
    turning = {group.meets: group.coordinates[: GROUP_KINDS[group.kind]][-1:] for group in scene.variant.groups if group.meets}
    found = {}
    for name, path in poses.at.items():
        turns = next(iter(turning.get(name, ())), "")
        angle = motion.coordinates[:, motion.coordinate_names.index(turns)] if turns else np.zeros(len(rows))
        places = np.interp(at, rows, path.real) + 1j * np.interp(at, rows, path.imag)
        found[name] = End(name, places, turns, np.interp(at, rows, angle))
    return found


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
