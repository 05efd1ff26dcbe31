"""A mechanism for Newton's laws: bodies with their masses, and every unknown force or couple between them.

Enters: nothing.  Leaves: the records `ForceScheme`, `Body`, `Unknown`, `Direction`, still in formulas.
Used by `scheme.py`, which reads them, `rows.py`, `kinetostatics.py` and all that follows.

R<i><j> is the force of link i on link j, 0 the frame.  For a pin that joins more than two links, R<P><j> is the force of the pin
on link j, since pair forces are not unique there.  N acts across a guide, K is the couple of a body that cannot turn in its
guide, T acts along a rolling contact.  Of a second slide or contact of the same two links the names end in _2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from coursework.mechanism.joints import FRAME
from coursework.mechanism.structure import in_order
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.forces import DISC, ROD, Forces, Load


@frozen
class Body:
    """A moving link: its `name`, the `rate` it turns with ("" if it has none), its `centre` of mass, its `mass` (None for none).

    `span` are two of its points, from which the angular velocity follows if there is no named rate; for the inertia of a rod they
    are its ends, for that of a disc its centre and contact.  `turns`: whether it needs a moment of inertia.
    """

    name: str
    rate: str
    centre: Formula
    mass: Formula | None
    inertia: Formula | str | None
    span: tuple[Formula, Formula] | None = None
    turns: bool = False


@frozen
class Direction:
    """The direction of an unknown: +x or +y ("x", "y"), along a line or to its left ("along", "across"), or a "couple".

    The line has an `angle`, or leads `through` two points; "tangent" is to the right of it, where it leads to a wheel's centre.
    "slope" drives a `coordinate` that no link has: a couple on an arm, as a force at its end, or a force along a length.
    """

    kind: str
    angle: Formula | None = None
    through: tuple[Formula, Formula] | None = None
    coordinate: str = ""


@frozen
class Unknown:
    """A force or couple `name` at a point, + on the body `on`, - on the body `off`; `is_drive` names the driven velocity."""

    name: str
    on: str
    off: str
    at: Formula | None
    direction: Direction
    is_drive: str = ""


@frozen
class ForceScheme:
    """Bodies and unknowns: `bodies`, `pins` that join more than two links (by point), `unknowns` in the order of the table.

    `holds` gives the points of each body; `groups` the names of the bodies of each driven link and group in the order of
    assembly, empty if it is unknown.
    """

    bodies: tuple[Body, ...]
    pins: tuple[str, ...]
    unknowns: tuple[Unknown, ...]
    groups: tuple[tuple[str, ...], ...]
    forces: Forces
    holds: Mapping[str, tuple[str, ...]]

    @property
    def by_name(self) -> dict[str, Body]:
        """Return the bodies by their names."""
        return {body.name: body for body in self.bodies}

    def body_named(self, name: str) -> str:
        """Return the name of the body meant by a key: its name, or the point of a block."""
        return name if name in self.by_name else self.holder(name)

    def own_point(self, name: str) -> Formula | None:
        """Return a point that the body of a key holds, None if the file names none."""
        held = self.holds.get(self.body_named(name), ())
        return named(held[0]) if held else None

    @property
    def pinned(self) -> tuple[tuple[str, Formula], ...]:
        """Return each moving body with each point at which a pin joins it."""
        pins = ((name, one.at) for one in self.unknowns if one.direction.kind == "x" for name in (one.on, one.off))
        return tuple((name, at) for name, at in pins if at is not None and name in self.by_name)

    def holder(self, point: str) -> str:
        """Return the body that holds a point: the frame if the point is fixed, a block before the link it is hinged to."""
        holders = [name for name in in_order(self.holds) if point in self.holds[name]]
        if FRAME in holders:
            return FRAME
        return next((name for name in holders if len(self.holds[name]) == 1), holders[0] if holders else FRAME)


def inertia_of(
    scheme: ForceScheme, body: Body, scalar: Callable[[Formula | None], Any], square: Callable[[Formula, Formula], Any]
) -> Any:
    """Return the moment of inertia about the centre of mass, including a flywheel on the body.

    `scalar` evaluates a formula (0 for None), `square` the squared distance of two points: as rows of numbers or as expressions.
    """
    if isinstance(body.inertia, str):
        assert body.span is not None
        found = scalar(body.mass) * square(*body.span) / {ROD: 12, DISC: 2}[body.inertia]
    else:
        found = scalar(body.inertia)
    wheel = scheme.forces.flywheel
    return found if wheel is None or scheme.body_named(wheel.on) != body.name else found + scalar(wheel.inertia)


def torques_beside_drives(scheme: ForceScheme) -> Iterator[tuple[str, str, Load]]:
    """Yield body, the body it is driven from, and the law of each motor that is not the drive of a free link.

    Such a motor acts where it is; the drive of the free link gives only what is left.
    """
    couples = {(one.on, one.off) for one in drives_of(scheme) if one.direction.kind == "couple"}
    for load in scheme.forces.motor.torques if scheme.forces.motor else ():
        below = FRAME if load.source == FRAME else scheme.body_named(load.source)
        if (body := scheme.body_named(load.on), below) not in couples:
            yield body, below, load


def numbered(own: list[Unknown], found: list[Unknown]) -> list[Unknown]:
    """Return the unknowns of a joint; of the second slide or contact of two links they end in _2."""
    taken, endings = {one.name for one in found}, ("", *(f"_{number}" for number in range(2, len(found) + 2)))
    ending = next(each for each in endings if taken.isdisjoint(one.name + each for one in own))
    return [replace(one, name=one.name + ending) for one in own]


def drives_of(scheme: ForceScheme) -> tuple[Unknown, ...]:
    """Return the unknowns that move the mechanism."""
    return tuple(one for one in scheme.unknowns if one.is_drive)
