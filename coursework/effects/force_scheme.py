"""A mechanism as Newton's laws see it: bodies with their masses, and every unknown force or couple between them.

Enters: nothing.  Leaves: the records `ForceScheme`, `Body`, `Unknown`, `Direction`, still in formulas.
Used by `scheme.py`, which reads them, `rows.py`, `kinetostatics.py` and all that follows.

R<i><j> is the force of link i on link j, 0 the frame; of a pin that more than two links hold, R<P><j> is the pin's on link j,
since pair forces are not unique there.  N is across a guide, K the couple of what cannot turn in it, T along a contact that
rolls.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from coursework.mechanism.joints import FRAME
from coursework.mechanism.structure import in_order
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.forces import DISC, ROD, Forces, Load


@frozen
class Body:
    """A moving link: its `name`, the `rate` it turns with ("" where it does not turn), a point of it, its centre of mass.

    `span` are two of its points, from which the rate follows where no name has it; of a rod's inertia they are the ends, of a
    disc's centre and contact.  `mass` None: none.
    """

    name: str
    rate: str
    centre: Formula
    mass: Formula | None
    inertia: Formula | str | None
    span: tuple[Formula, Formula] | None = None


@frozen
class Direction:
    """Where an unknown points: along +x or +y ("x", "y"), along a line or to the left of it ("along", "across"), "couple".

    The line is at an `angle`, or leads `through` two points; "tangent" is to the right of it, the way to a wheel's centre.
    "slope" is what drives a `coordinate` that no link has: the couple on an arm, a force at its end, or the force along a length.
    """

    kind: str
    angle: Formula | None = None
    through: tuple[Formula, Formula] | None = None
    coordinate: str = ""


@frozen
class Unknown:
    """A force or couple `name` at a point, + on the bodies of `on`, - on those of `off`; `is_drive`: what moves the mechanism."""

    name: str
    on: str
    off: str
    at: Formula | None
    direction: Direction
    is_drive: str = ""


@frozen
class ForceScheme:
    """`bodies`, `pins` that more than two links hold (by point), `unknowns` in the order of the table.

    `holds`: the points of each body; `groups`: the names of the bodies of each driven link and group in the order of assembly,
    none where that is not known.
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
        """Return the body that a key means, by its name or by the point of a block."""
        return name if name in self.by_name else self.holder(name)

    def own_point(self, name: str) -> Formula | None:
        """Return a point that the body of a key holds, None where the file names none."""
        held = self.holds.get(self.body_named(name), ())
        return named(held[0]) if held else None

    def holder(self, point: str) -> str:
        """Return the body that holds a point: the frame a fixed one, a block before the link that it is hinged on."""
        holders = [name for name in in_order(self.holds) if point in self.holds[name]]
        if FRAME in holders:
            return FRAME
        return next((name for name in holders if len(self.holds[name]) == 1), holders[0] if holders else FRAME)


def inertia_of(
    scheme: ForceScheme, body: Body, scalar: Callable[[Formula | None], Any], square: Callable[[Formula, Formula], Any]
) -> Any:
    """Return the moment of inertia about the centre of mass, that of a flywheel on the body included.

    In what `scalar` gives of a formula, 0 of none, and `square` of the distance of two points: rows of numbers, or expressions.
    """
    if isinstance(body.inertia, str):
        assert body.span is not None
        found = scalar(body.mass) * square(*body.span) / {ROD: 12, DISC: 2}[body.inertia]
    else:
        found = scalar(body.inertia)
    wheel = scheme.forces.flywheel
    return found if wheel is None or scheme.body_named(wheel.on) != body.name else found + scalar(wheel.inertia)


def torques_beside_drives(scheme: ForceScheme) -> Iterator[tuple[str, str, Load]]:
    """Yield body, body it stands on, and law of each motor that turns no free link from what that is driven from: it acts where
    it is, and what the free link needs is only what is left.
    """
    couples = {(one.on, one.off) for one in drives_of(scheme) if one.direction.kind == "couple"}
    for load in scheme.forces.motor.torques if scheme.forces.motor else ():
        below = FRAME if load.source == FRAME else scheme.body_named(load.source)
        if (body := scheme.body_named(load.on), below) not in couples:
            yield body, below, load


def drives_of(scheme: ForceScheme) -> tuple[Unknown, ...]:
    """Return the unknowns that move the mechanism."""
    return tuple(one for one in scheme.unknowns if one.is_drive)


def names_of(unknowns: Iterable[Unknown]) -> tuple[str, ...]:
    """Return the names of unknowns, each once: joints between the same two links are told apart by a stroke."""
    found: dict[str, None] = {}
    for one in unknowns:
        name = one.name
        while name in found:
            name += "'"
        found[name] = None
    return tuple(found)
