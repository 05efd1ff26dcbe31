"""Whether each link turns at its stated rate: its points, its rolling contact and the bar it slides on must agree with it.

Enters: velocity equations and their closure, or rows of a motion.  Leaves: what [points] say otherwise than written equations and
drives.  Raises `InputError` naming each link whose `rate` is another's.  Used by `unseen_signs.py`, `equations.py`.
A rate named for the wrong link or a wheel that would slip, if no position equation uses it, changes no column of the table, but
it changes the velocity plan and the forces.

An angle may be counted clockwise; its whole link then turns at minus the rate.  Where a rate meets other links or forces, it
counts as vectors do: counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.equations.reduction.bound import Speed, Turn, rate_of, speed_of
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.closure import Closure
from coursework.motion.geometry.drives.drive import drive_values
from coursework.motion.geometry.judging.agreement import given_by_geometry, gives
from coursework.motion.geometry.judging.compared import looked_at
from coursework.motion.geometry.judging.misfits import row_of
from coursework.motion.geometry.judging.open_loops import where_judged
from coursework.system.arrays import Array
from coursework.variant.record.held import largest_length, velocities_of_points
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_TOLERANCE = 1e-6  # share of the largest rate: far above round-off, far below the difference from another link's rate
# Without position equations the start may be rounded: share of a velocity that tells apart, and of its largest value that moves.
_APART, _MOVING = 0.05, 0.05


def require_turning(equations: VelocityEquations, closure: Closure, rigid: bool) -> None:
    """Raise `InputError` naming each link that does not turn at its rate; with other data it may not.

    Where links are `rigid`, an arm that grows does so lengthwise, and turns at the rate of its link.
    """
    if faults := _faults(equations, closure, rigid):
        # An open start changes how links turn: a fault counts only if it remains once the start closes.
        near = where_judged(closure)
        if near is not None and _faults(equations, near, rigid):
            raise InputError(faults)


def _faults(equations: VelocityEquations, closure: Closure, rigid: bool) -> list[Fault]:
    turns = equations.geometry.turns()
    if not turns:
        return []
    times, positions = looked_at(equations, closure)
    derived = given_by_geometry(equations)
    rows = [row_of(speed) for turn in turns for speed in (turn.found, turn.named, turn.grows)]
    matrix, right, _ = compile_system(equations, [*derived, *rows]).matrices(times, positions)
    known, asked, freely = matrix[:, : len(derived)], matrix[:, len(derived) :], right[:, len(derived) :]
    apart = np.isfinite(np.concatenate([asked, freely[:, :, None]], axis=2)).all(axis=(0, 2)).reshape(-1, 3).all(axis=1)
    turns = tuple(turns[place] for place in np.flatnonzero(apart))  # points in one place do not tell how their link turns
    asked, freely = asked[:, np.repeat(apart, 3)], freely[:, np.repeat(apart, 3)]
    velocities = np.linalg.pinv(known) @ right[:, : len(derived), None]
    # What the geometry leaves open is not judged; nor is what changes its shape because the start is not closed.
    told = np.array([gives(known, asked[:, place]) for place in range(asked.shape[1])], dtype=bool).reshape(-1, 3)
    found, named, grows = np.moveaxis(((asked @ velocities)[:, :, 0] - freely).reshape(len(times), -1, 3), 2, 0)
    # The terms of a rate, not the rate: a link that rests has round-off alone.
    terms = ((np.abs(asked) @ np.abs(velocities))[:, :, 0] + np.abs(freely)).reshape(len(times), -1, 3)
    largest = np.max(terms[:, :, :2], initial=0.0)
    judged = told.all(axis=1) & (rigid | (np.max(np.abs(grows), axis=0) <= _TOLERANCE * largest * closure.scale**2))
    faults = []
    for link in dict.fromkeys(turn.link for turn in turns):
        mine = [place for place, turn in enumerate(turns) if turn.link == link and judged[place]]
        others = [(turn.rate, named[:, place]) for place, turn in enumerate(turns) if turn.link != link and told[place].all()]
        if mine and (fault := _of_link(turns[mine[0]], closure, times, found[:, mine], named[:, mine], largest, others)):
            faults.append(fault)
    return faults


def said_otherwise(equations: VelocityEquations, times: Array, positions: Array) -> list[Sentence]:
    """Return which links turn, or else which driven points move, by [points] otherwise than the file says, in rows (n, m).

    For files without position equations: the velocities are those of the written equations.  Links are judged whose points
    keep their distance wherever the coordinates are.
    """
    variant, turns, pairs = equations.variant, equations.geometry.turns(), _pairs(equations)
    driven = velocities_of_points(variant)
    if not pairs:
        return []
    every = [*given_by_geometry(equations), *equations.equations]
    rows = [row_of(speed) for speed in (*(turn.grows for turn in turns), *(speed for pair in pairs for speed in pair))]
    matrix, right, _ = compile_system(equations, [*every, *rows]).matrices(times, positions)
    velocities = np.linalg.pinv(matrix[:, : len(every)]) @ right[:, : len(every), None]
    grows = np.max(np.abs(np.concatenate([matrix, right[:, :, None]], axis=2)), axis=(0, 2), initial=0.0)[len(every) :]
    first = len(every) + len(turns)
    both = (matrix[:, first:] @ velocities)[:, :, 0] - right[:, first:]
    terms = np.max((np.abs(matrix[:, first:]) @ np.abs(velocities))[:, :, 0] + np.abs(right[:, first:]), initial=0.0)
    links, points, laws = [], [], [law.name for law in variant.drive]
    driven_rates = np.abs(np.nan_to_num(drive_values(equations, laws, times)))
    share = driven_rates / np.maximum(np.sum(driven_rates, axis=1, keepdims=True), 1e-300)
    led = np.argmax(share, axis=0).tolist()  # for each drive the row in which it moves most beside the others
    rolls = {link.name for link in variant.links if link.contact}
    for place, (one, other) in enumerate(both.T.reshape(-1, 2, len(times))):
        size = np.maximum(np.abs(one), np.abs(other))
        first_row = int(np.argmax(size > _MOVING * np.max(size)))  # the first in which it moves: later ones drift
        senses = (-1, 1) if place < len(turns) and not _counted_as_vectors(turns[place].link, equations) else (1,)
        # A contact does not drift: there a wheel keeps to one sense, also where another drive leads.
        moved = [first_row, *(led if place < len(turns) and turns[place].link in rolls else ())]
        least = np.maximum(_APART * size[moved], _TOLERANCE * terms)
        off = [np.abs(one[moved] - sense * other[moved]) > least for sense in senses]
        apart, row = all(each.any() for each in off), max(moved[int(np.argmax(each))] for each in off)
        if not apart or (place < len(turns) and grows[place] > _TOLERANCE * largest_length(variant) ** 2):
            continue
        known = {"found": float(one[row]), "named": float(other[row]), "time": float(times[row])}
        if place < len(turns):
            links.append(say("check.AGREEMENT.turns", link=turns[place].link, rate=turns[place].rate, **known))
        else:
            law, (point, axis) = [*driven.items()][place - len(turns)]
            points.append(say("check.AGREEMENT.moves", point=point, axis=axis, rate=law, **known))
    return links or points


def _pairs(equations: VelocityEquations) -> list[tuple[Speed, Speed]]:
    """Return the speed that [points] give, and the one that the file names, of each link, then of each driven point."""
    variant, vectors = equations.variant, equations.symbols.vectors
    links = [(turn.found, turn.named) for turn in equations.geometry.turns()]
    return links + [
        (rate_of(vectors[point]["xy".index(axis)], variant, equations.symbols), speed_of(law, variant.sought))
        for law, (point, axis) in velocities_of_points(variant).items()
    ]


def _of_link(
    turn: Turn, closure: Closure, times: Array, found: Array, named: Array, largest: float,
    others: Sequence[tuple[str, Array]],
) -> Fault | None:  # fmt: skip
    """Return the fault in the rate of one link, None if its rate is right; `found` and `named` (c, k) are compared.

    `others` are the names and rates (c,) of other links, one of which may be meant.
    """
    off, opposite = np.abs(found - named), np.all(np.abs(found + named) <= _TOLERANCE * largest, axis=0)
    if np.all(off <= _TOLERANCE * largest) or (opposite.all() and not _counted_as_vectors(turn.link, closure.equations)):
        return None
    run = off[: len(closure.configurations[0])]  # what follows is at no time of the run: told only if nothing differs before
    shown_off = run if np.any(run > _TOLERANCE * largest) else off
    row, place = (int(at[0]) for at in np.nonzero(off == np.max(shown_off)))
    shown = [0.0 if abs(value) <= _TOLERANCE * largest else float(value) for value in (found[row, place], named[row, place])]
    meant = (rate for rate, of in others if np.all(np.abs(found - of[:, None]) <= _TOLERANCE * largest))
    known = {"link": turn.link, "rate": turn.rate, "found": shown[0], "named": shown[1], "time": float(times[row])}
    variant = closure.equations.variant
    is_wheel = any(link.name == turn.link and link.contact for link in variant.links)
    hint = say("fault.turning.opposite", rate=turn.rate) if opposite[place] else say("fault.turning.wheel") if is_wheel else ""
    own = next(meant, "")
    told = say("fault.V309.as", own=own, **known) if own else say("fault.V309.alone", hint=hint, **known)
    return Fault(told, variant.file, variant.nearest_line("links", turn.link))


def _counted_as_vectors(link: str, equations: VelocityEquations) -> bool:
    """Return whether the file contains something for which the sense of rotation of a link's rate matters."""
    variant = equations.variant
    return variant.forces is not None or any(link in {one.link, one.relative} for one in variant.bindings)
