"""Groups as pieces to build from: a picture of each, and its lines put into a text, on points that the text has.

Enters: a `Desk`, a kind, the points it hangs on.  Leaves: the text with it.  Used by `bench.py`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from coursework.api import make_run, variant_in
from coursework.desk.answering.edits import Piece, changed
from coursework.desk.answering.pictures import picture
from coursework.desk.answering.typed import Desk
from coursework.desk.job import OK, Answer, plain
from coursework.drawing.outline.poses import all_rows, read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.mechanism.drafts.candidates import ROWS, End
from coursework.mechanism.drafts.chain import DoesNotClose, Draft, draft_of, draft_on
from coursework.mechanism.drafts.text import additions, text_of
from coursework.scene.quantities import ACCELERATIONS, CHECKS, GRAPH_CHECK, PLOTS, POINTS, TABLE
from coursework.scene.scene import Scene
from coursework.variant.record.roles import role, title
from coursework.variant.record.vocabulary import GROUP_KINDS, GROUP_SHAPES
from coursework.variant.toml.positions import locate
from coursework.words.errors import CourseworkError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

ASKED = (TABLE, PLOTS, CHECKS, GRAPH_CHECK, ACCELERATIONS, POINTS)
STILL = 1e-9  # m: a point that goes less far stands
DRIVEN = next(kind for kind, shape in GROUP_SHAPES.items() if shape.driven)


def pieces(desk: Desk) -> Answer:
    """Return each kind with its title, its picture, and what it asks: the point it hangs on."""
    return plain(OK, [_piece(kind, desk) for kind in GROUP_KINDS])


def _piece(kind: str, desk: Desk) -> dict[str, Any]:
    shape, written = GROUP_SHAPES[kind], desk.words.written
    letters = shape.named()
    means = role(shape, "from", letters, 1) if shape.points else say("desk.rides_on")
    asks = [] if shape.driven else [{"key": "from", "means": written(means)}]
    scene = make_run(variant_in(_alone(kind, desk), kind, {})).scene
    return {"kind": kind, "title": written(title(shape, letters)), "svg": picture(scene), "asks": asks}


def _alone(kind: str, desk: Desk) -> str:
    """Return a whole text with one group of a kind, and the crank that moves it."""
    draft = draft_of([DRIVEN] if kind == DRIVEN else [DRIVEN, kind])
    return text_of(draft, desk.name, desk.words.written, [one.name for one in ASKED])


def piece(desk: Desk) -> dict[str, Any]:
    """Return `text` and `ranges` with one more group, and a `sentence` where it cannot be had there."""
    kind, hung = str(desk.body["kind"]), [str(name) for name in desk.body["on"]]
    if kind not in GROUP_KINDS:
        return _without(desk, say("desk.no_file", name=kind[:40]))
    if not desk.text.strip():
        return changed("", [(0, 0, _alone(kind, desk))])
    scene = make_run(desk.variant).scene
    known = _ends(scene)
    if not hung and kind != DRIVEN:
        return _without(desk, say("desk.piece_does_not_close", kind=kind))
    if missing := [name for name in hung if name not in known]:
        return _without(desk, say("desk.no_joint", joint=missing[0][:40]))
    if kind != DRIVEN and all(known[name].amplitude < STILL for name in hung):
        return _without(desk, say("desk.piece_on_still", point=hung[0]))
    beside = [*known.values()][-1:] if kind == DRIVEN else []  # so that it does not stand on another
    digits = [int(found) for name in desk.variant.names for found in re.findall(r"\d{1,3}", name)]
    try:
        taken = [name for name, _ in scene.mechanism.points]
        draft = draft_on(kind, [known[name] for name in hung] or beside, taken, max(digits, default=0) + 1)
    except (DoesNotClose, CourseworkError, ArithmeticError):
        return _without(desk, say("desk.piece_does_not_close", kind=kind))
    return changed(desk.text, _put_in(desk.text, additions(draft, len(desk.variant.groups) + 1, desk.words.written), draft))


def _without(desk: Desk, why: Sentence) -> dict[str, Any]:
    return {"text": desk.text, "ranges": [], "sentence": desk.words.written(why)}


def _ends(scene: Scene) -> dict[str, End]:
    """Return the points that something may hang on, along the motion."""
    outline, motion = read_outline(scene.mechanism), scene.exact
    if outline is None or not len(motion.t) or not all_rows(scene.equations, motion):
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


def _put_in(text: str, lines: Mapping[str, Sequence[str]], draft: Draft) -> list[Piece]:
    """Return the pieces of text that a draft adds, each at the end of its section; one that is missing comes last."""
    found = locate(text)
    last = {str(path[0]): 0 for path in found.keys}
    for path, (line, _) in (*found.keys.items(), *found.values.items()):
        last[str(path[0])] = max(last[str(path[0])], line)
    for path, (_, end) in found.spans.items():
        last[str(path[0])] = max(last[str(path[0])], text.count("\n", 0, end) + 1)
    ends = [*(len(line) for line in text.split("\n"))]
    made = []
    for section, added in lines.items():
        if added:
            at = sum(ends[: last[section]]) + last[section] - 1 if section in last else len(text.rstrip("\n"))
            head = [] if section in last or section == "group" else ["", f"[{section}]"]
            made.append((at, at, "".join(f"\n{line}" for line in (*head, *added))))
    span = found.spans.get(("frame", "hinges"))
    if draft.hinges and span is not None:
        inside = text[span[0] + 1 : span[1] - 1].strip()
        names = ", ".join(f'"{name}"' for name in draft.hinges)
        made.append((span[1] - 1, span[1] - 1, f", {names}" if inside else names))
    return made
