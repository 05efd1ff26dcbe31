"""The force polygon of every driven link and group: which forces act, in the order in which they are drawn tip to tail.

Enters: a `ForceAnalysis`.  Leaves: `GroupPlan`s, the last group first; numbers of all rows.
Used by `group_sheet.py`, `lever.py` and `force_plans.py`.

The order for a dyad with links i and j: the part of the outer reaction across link i, the known forces on i, those on j, the
part across j, then the two parts along the links, which close the polygon.  So the reaction between i and j is a chord.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from coursework.drawing.paper.symbols import name_word
from coursework.effects.effects import Action
from coursework.effects.force_scheme import Unknown
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import frozen

KNOWN, DIRECTION, FOUND = "known", "direction", "found"  # fully given; given in direction only; unknown
SUPERSCRIPT = {"t": "ᵗ", "n": "ⁿ"}
_LETTERS = {"inertia": ("F", "in"), "weight": ("G", ""), "friction": ("F", "fr")}


@frozen
class ForceVector:
    """A force (n,) complex N on a body of a group, at a place (n,) complex m; `name` and, as a drawing writes it, `word`."""

    name: str
    word: tuple[str, str, str]
    body: str
    force: Complex
    at: Complex
    role: str

    def size(self, row: int) -> float:
        """Return the size of the force (N) in a row (from 0)."""
        return float(abs(self.force[row]))


@frozen
class Moment:
    """The moments about a link's inner pin `point`: known ones `about` (n,) N m; force `across` (N) at an arm `length` (m)."""

    body: str
    point: str
    name: str
    about: Array
    length: Array
    across: Array


@frozen
class GroupPlan:
    """The forces on the `bodies` of one group in the order of the polygon; the `moments` give the parts across its links.

    `inner` is the name and the force (n,) of the joint between both links of a dyad, None for other groups.
    """

    bodies: tuple[str, ...]
    vectors: tuple[ForceVector, ...]
    moments: tuple[Moment, ...]
    inner: tuple[str, Complex] | None


ByBody = Mapping[str, list[ForceVector]]


def word_of(action: Action) -> tuple[str, str, str]:
    """Return how a drawing writes a known force: F with index in2, G with index 2, a load by its name."""
    if action.effect not in _LETTERS:
        return name_word(action.name)
    letter, low = _LETTERS[action.effect]
    return letter, f"{low}{action.body}", ""


def group_plans(found: ForceAnalysis) -> tuple[GroupPlan, ...]:
    """Return the plans of all groups, the last first; none if the order of the groups is unknown or a force is not finite."""
    scheme = found.rows.scheme
    if not scheme.groups or not np.isfinite(found.reactions.rows).all():
        return ()
    placed: list[set[str]] = [set(), *(set(group) for group in scheme.groups)]
    before = [set().union(*placed[: place + 1]) for place in range(len(placed))]
    plans = [_plan(found, group, before[place]) for place, group in enumerate(scheme.groups)]
    return tuple(reversed(plans))


def reactions_on(found: ForceAnalysis, body: str) -> Iterator[tuple[str, str, Complex, Complex, bool]]:
    """Yield the forces of joints and drives on a body: name, the other body, force (n,), place (n,), whether it is a drive."""
    rows, names = found.rows, found.reactions.names
    held: dict[str, tuple[Unknown, Complex]] = {}
    for name, unknown in zip(names, rows.scheme.unknowns, strict=True):
        if body not in {unknown.on, unknown.off} or unknown.direction.kind == "couple" or unknown.at is None:
            continue
        sign = 1.0 if unknown.on == body else -1.0
        both = name[:-1] if unknown.direction.kind in {"x", "y"} else name
        value = sign * found.column(name) * rows.along(unknown)
        held[both] = unknown, held[both][1] + value if both in held else np.asarray(value)
    for name, (unknown, force) in held.items():
        other = unknown.off if unknown.on == body else unknown.on
        called = name if unknown.on == body else _turned(name, unknown)
        assert unknown.at is not None
        yield called, other, force, rows.vector(unknown.at), bool(unknown.is_drive)


def _turned(name: str, unknown: Unknown) -> str:
    """Return the name of a reaction as it acts on the other link: R12 acts on link 2, R21 on link 1."""
    return f"{name[0]}{unknown.on}{unknown.off}" if len(unknown.on) == len(unknown.off) == 1 else name


def _plan(found: ForceAnalysis, group: Sequence[str], before: set[str]) -> GroupPlan:
    later = {body.name for body in found.rows.scheme.bodies} - before - set(group)
    known, outer, inner = (defaultdict[str, list[ForceVector]](list) for _ in range(3))
    for action in found.actions:
        if action.body in group and action.force is not None and action.at is not None and np.any(action.force):
            word = word_of(action)
            known[action.body].append(ForceVector("".join(word), word, action.body, action.force, action.at, KNOWN))
    for body in group:
        for name, other, force, at, is_drive in reactions_on(found, body):
            role = KNOWN if other in later else FOUND if name[0] in "RF" else DIRECTION
            vector = ForceVector(name, (name[0], name[1:], ""), body, force, at, role)
            listed = inner if other in group else known if other in later and not is_drive else outer
            listed[body].append(vector)
    if len(group) == 2 and inner[group[0]]:
        return _dyad(found, (group[0], group[1]), known, outer, inner)
    vectors = [vector for body in group for vector in (*outer[body][:1], *known[body])]
    vectors += [vector for body in group for vector in outer[body][1:]]
    return GroupPlan(tuple(group), tuple(vectors), (), None)


def _dyad(found: ForceAnalysis, group: tuple[str, str], known: ByBody, outer: ByBody, inner: ByBody) -> GroupPlan:
    first, second = group
    across, along = (defaultdict[str, list[ForceVector]](list) for _ in range(2))
    moments = []
    for body in group:
        pin = next((vector for vector in inner[body] if vector.name[0] == "R"), None)
        for vector in outer[body]:
            if vector.name[0] != "R" or pin is None or len(outer[body]) > 1 or np.any(pin.at == vector.at):
                along[body].append(vector)
                continue
            part_across, part_along, moment = _parted(found, vector, pin, known[body])
            across[body].append(part_across)
            along[body].append(part_along)
            moments.append(moment)
    vectors = (*across[first], *known[first], *known[second], *across[second], *along[second], *along[first])
    between = next((vector for vector in inner[second] if vector.name[0] in "RN"), None)
    return GroupPlan(group, vectors, tuple(moments), None if between is None else (between.name, between.force))


def _parted(
    found: ForceAnalysis, vector: ForceVector, pin: ForceVector, known: list[ForceVector]
) -> tuple[ForceVector, ForceVector, Moment]:
    """Return the parts of an outer reaction across and along its link, and the moment equation that gives the part across."""
    way = pin.at - vector.at
    length, unit = np.abs(way), way / np.abs(way)
    normal = (np.conj(1j * unit) * vector.force).real
    parts = []
    for key, force in (("t", normal * 1j * unit), ("n", (np.conj(unit) * vector.force).real * unit)):
        word = (vector.word[0], vector.word[1], SUPERSCRIPT[key])
        parts.append(ForceVector(f"{vector.name}{key}", word, vector.body, np.asarray(force), vector.at, DIRECTION))
    about = sum(((np.conj(one.at - pin.at) * one.force).imag for one in known), np.zeros(found.rows.count))
    place = next(k for k, body in enumerate(found.rows.scheme.bodies) if body.name == vector.body)
    couples = found.reactions.wrench[:, place, 2] - _moment_of_forces(found, place)
    moment = Moment(vector.body, _point_at(found, pin.at), parts[0].name, np.asarray(about + couples), length, normal)
    return parts[0], parts[1], moment


def _moment_of_forces(found: ForceAnalysis, place: int) -> Array:
    """Return the moment (n,) of the known forces on a body about its centre of mass, without couples."""
    body, rows = found.rows.scheme.bodies[place], found.rows
    total = np.zeros(rows.count)
    for action in found.actions:
        if action.body == body.name and action.force is not None and action.at is not None:
            total += (np.conj(action.at - rows.vector(body.centre)) * action.force).imag
    return total


def _point_at(found: ForceAnalysis, at: Complex) -> str:
    """Return the name of the joint at a place, "" if it has none."""
    joints = (one.at for one in found.rows.scheme.unknowns if one.at is not None and one.at.op == "name")
    return next((joint.name for joint in joints if np.array_equal(found.rows.vector(joint), at)), "")
