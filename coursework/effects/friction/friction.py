"""Friction of pins, guides and wheels: a fixed point around the reactions of the ideal mechanism.

Enters: `Rows`, the reactions.  Leaves: `Action`s of friction.  Imported for a file with [friction] only.
Used by `kinetostatics.py`, `scheme.py`.

Pin: a couple coefficient * radius * |R| against the relative rotation.  Guide: a force coefficient * |N| against the sliding;
with a couple in it, max(|N|, 2 |K|/length) replaces |N|.  Wheel: a couple arm * |N| against its rotation.  A pair at rest (sign
0) has no friction in that row.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from coursework.effects.effects import Action
from coursework.effects.force_scheme import ForceScheme, Unknown
from coursework.effects.friction.held import STILL
from coursework.effects.rows import Rows
from coursework.mechanism.joints import FRAME
from coursework.system.arrays import Array, Flags
from coursework.variant.record.forces import Friction

# Convergence is tested every ROUNDS rounds: what shrinks goes on (slowly near locking), anything else has no solution.
ROUNDS, MOST_ROUNDS = 50, 2000
SETTLED, LEFT = 1e-13, 1e-9  # change in a round, relative to the largest reaction: converged; accepted if round-off stops it


def friction_of(rows: Rows, values: Array) -> tuple[Action, ...]:
    """Return the friction actions for unknown forces with the given `values` (n, unknowns)."""
    return tuple(action for rubs in rows.scheme.forces.friction for action in _at(rows, values, rubs))


def rubbing(unknowns: Sequence[Unknown], rubs: Friction) -> Iterator[tuple[int, str]]:
    """Yield, for an entry of [friction], the index of each unknown force that causes friction, and "pin", "wheel" or "guide"."""
    rolls, fixed = ({one.name[1:] for one in unknowns if one.name[0] == letter} for letter in "TK")
    for place, one in enumerate(unknowns):
        if one.is_drive or one.at is None or one.at.name != rubs.at:
            continue
        if one.direction.kind == "x" and one.name[1:-1] not in fixed and rubs.radius is not None and rubs.coefficient is not None:
            yield place, "pin"
        elif one.name[0] == "N" and one.name[1:] in rolls and rubs.arm is not None:
            yield place, "wheel"
        elif one.name[0] == "N" and one.name[1:] not in rolls and rubs.coefficient is not None:
            yield place, "guide"


def partner(scheme: ForceScheme, one: Unknown) -> str:
    """Return the partner of a body in a joint: for a pin of more than two links its first link, else the other body."""
    held = [other.on for other in scheme.unknowns if other.off == one.off and one.off in scheme.pins]
    return held[0] if held else one.off


def _at(rows: Rows, values: Array, rubs: Friction) -> Iterator[Action]:
    for place, kind in rubbing(rows.scheme.unknowns, rubs):
        one = rows.scheme.unknowns[place]
        if kind == "pin":
            size = np.hypot(values[:, place], values[:, place + 1])
            yield from _turning(rows, one, rows.scalar(rubs.coefficient) * rows.scalar(rubs.radius) * size)
        elif kind == "wheel":
            yield from _turning(rows, one, rows.scalar(rubs.arm) * np.abs(values[:, place]))
        else:
            yield from _sliding(rows, one, values, place, rubs)


def _turning(rows: Rows, one: Unknown, couple: Array) -> Iterator[Action]:
    """Yield a couple against the relative rotation of two bodies."""
    bodies = rows.scheme.by_name
    other = partner(rows.scheme, one)
    if one.on == other or one.on not in bodies:
        return
    below = rows.omega(bodies[other]) if other in bodies else np.zeros(rows.count)
    relative = rows.omega(bodies[one.on]) - below
    against = -couple * _sign(relative, float(np.abs(rows.omega(bodies[one.on])).max(initial=0.0)))
    yield Action("friction", one.on, couple=against)
    if other != FRAME:
        yield Action("friction", other, couple=-against)


def _sliding(rows: Rows, one: Unknown, values: Array, place: int, rubs: Friction) -> Iterator[Action]:
    """Yield a force against the sliding of a block along its guide."""
    assert one.at is not None
    bodies = rows.scheme.by_name
    at, along = rows.vector(one.at), rows.along(one) / 1j
    still = np.zeros(rows.count, dtype=complex)
    speeds = [still if name == FRAME else rows.velocity(bodies[name], at) for name in (one.on, one.off)]
    relative = (np.conj(along) * (speeds[0] - speeds[1])).real
    size = np.abs(values[:, place])
    following = rows.scheme.unknowns[place + 1] if place + 1 < len(rows.scheme.unknowns) else None
    if rubs.length is not None and following is not None and following.name == f"K{one.name[1:]}":
        size = np.maximum(size, 2 * np.abs(values[:, place + 1]) / rows.scalar(rubs.length))
    force = -rows.scalar(rubs.coefficient) * size * _sign(relative, float(np.abs(relative).max(initial=0.0))) * along
    yield Action("friction", one.on, np.asarray(force), at)
    if one.off != FRAME:
        yield Action("friction", one.off, np.asarray(-force), at)


def standing(found: Sequence[Action]) -> Flags:
    """Return in which rows (n,) a rubbing pair is at rest although it moves in others: its sign and friction are 0 there."""
    sizes = [np.abs(acting) for one in found for acting in (one.force, one.couple) if acting is not None]
    return np.asarray(np.any([(size == 0.0) & (size.max(initial=0.0) > 0.0) for size in sizes], axis=0))


def _sign(values: Array, largest: float) -> Array:
    return np.where(np.abs(values) > STILL * largest, np.sign(values), 0.0)
