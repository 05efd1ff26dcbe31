"""The effects, one record each: only what a file names is computed and imported.

Enters: `Rows`.  Leaves: `Action`s, the forces and couples that are known as soon as the motion is.
Used by `kinetostatics.py`, `energy.py`, `checks.py` and `told.py`.  To add one: write its function and a record in `EFFECTS`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from coursework.effects.force_scheme import Body, torques_beside_drives
from coursework.effects.rows import SECOND, Rows
from coursework.mechanism.joints import FRAME
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import named
from coursework.variant.record.forces import Forces


@frozen
class Action:
    """A `force` (n,) complex N at a place (n,) complex m, or a `couple` (n,) N m, on a body, due to an `effect`.

    `name` is its name in the file, "" if it has none of its own.
    """

    effect: str
    body: str
    force: Complex | None = None
    at: Complex | None = None
    couple: Array | None = None
    name: str = ""


@frozen
class Effect:
    """One effect: `named` tells whether a file names it, `acts` yields its actions, `section` is the section that names it."""

    name: str
    section: str
    named: Callable[[Forces], bool]
    acts: Callable[[Rows], Iterator[Action]]


def _weighed(rows: Rows) -> Iterator[tuple[Body, Array, Complex]]:
    for body in rows.scheme.bodies:
        if body.mass is not None:
            yield body, rows.mass(body), rows.vector(body.centre)


def _inertia(rows: Rows) -> Iterator[Action]:
    for body, mass, centre in _weighed(rows):
        yield Action("inertia", body.name, np.asarray(-mass * rows.vector(body.centre, SECOND)), centre)
    for body in rows.scheme.bodies:
        if np.any(inertia := rows.inertia(body)):
            yield Action("inertia", body.name, couple=-inertia * rows.epsilon(body))


def _weight(rows: Rows) -> Iterator[Action]:
    x, y = (rows.scalar(part) for part in rows.scheme.forces.gravity or (None, None))
    for body, mass, centre in _weighed(rows):
        yield Action("weight", body.name, np.asarray(mass * (x + 1j * y)), centre)


def _loads(rows: Rows) -> Iterator[Action]:
    for load in rows.scheme.forces.loads:
        body = rows.scheme.body_named(load.on)
        if load.torque is not None:
            yield Action("loads", body, couple=rows.scalar(load.torque), name=load.name)
        elif load.force is not None and load.at is not None:
            yield Action("loads", body, rows.vector(load.force), rows.vector(load.at), name=load.name)


def _springs(rows: Rows) -> Iterator[Action]:
    for spring in rows.scheme.forces.springs:
        way, rate = rows.stretch(spring)
        length = np.abs(way)
        unit, pull = way / length, rows.scalar(spring.damping) * rate
        if spring.stiffness is not None:
            pull = pull + rows.scalar(spring.stiffness) * (length - rows.scalar(spring.free))
        for end, force in zip(spring.ends, (pull * unit, -pull * unit), strict=True):
            if (body := rows.scheme.holder(end)) != FRAME:
                yield Action("springs", body, force, rows.vector(named(end)), name=spring.name)


def _motor(rows: Rows) -> Iterator[Action]:
    for body, below, load in torques_beside_drives(rows.scheme):
        yield Action("motor", body, couple=rows.scalar(load.torque), name=load.name)
        if below != FRAME:
            yield Action("motor", below, couple=-rows.scalar(load.torque), name=load.name)


INERTIA = Effect("inertia", "masses", lambda forces: bool(forces.masses), _inertia)
WEIGHT = Effect("weight", "forces", lambda forces: bool(forces.masses) and forces.gravity is not None, _weight)
LOADS = Effect("loads", "forces", lambda forces: bool(forces.loads), _loads)
SPRINGS = Effect("springs", "forces", lambda forces: bool(forces.springs), _springs)

# Friction depends on the reactions, so it is computed together with them (`friction.py`).  A motor moves the mechanism
# (`dynamics.py`): on a free link the rows give what drives it, elsewhere it is a couple.
FRICTION = Effect("friction", "friction", lambda forces: bool(forces.friction), lambda rows: iter(()))
MOTOR = Effect("motor", "motor", lambda forces: forces.motor is not None, _motor)

EFFECTS: tuple[Effect, ...] = (INERTIA, WEIGHT, LOADS, SPRINGS, FRICTION, MOTOR)


def actions_of(rows: Rows) -> tuple[Action, ...]:
    """Return the actions of all effects that the file names."""
    return tuple(action for effect in EFFECTS if effect.named(rows.scheme.forces) for action in effect.acts(rows))


def wrenches(rows: Rows, actions: tuple[Action, ...]) -> Array:
    """Return the sums (n, bodies, 3): force along x and y (N), moment about the centre of mass (N m)."""
    places = {body.name: place for place, body in enumerate(rows.scheme.bodies)}
    total = np.zeros((rows.count, len(places), 3))
    for action in actions:
        place = places[action.body]
        add_wrench(total[:, place], action, rows.vector(rows.scheme.bodies[place].centre))
    return total


def add_wrench(total: Array, action: Action, about: Complex | float) -> None:
    """Add an action to the sums (n, 3) of forces along x and y and of moments about the place `about`."""
    if action.couple is not None:
        total[:, 2] += action.couple
    if action.force is not None and action.at is not None:
        total[:, 0] += action.force.real
        total[:, 1] += action.force.imag
        total[:, 2] += (np.conj(action.at - about) * action.force).imag
