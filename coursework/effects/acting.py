"""Everything that acts on the links, as expressions of a row: the basis of a page that moves.

Enters: velocity equations, a `ForceScheme`.  Leaves: `Acting`.
Used by `rows.py`, `rubbed_motion.py` and `report/live/by_forces.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from coursework.effects.force_scheme import Body, ForceScheme, Unknown, inertia_of, torques_beside_drives
from coursework.equations.algebra.expression import HALF, ONE, ZERO, Expression, add
from coursework.equations.algebra.functions import call, cosine, sine
from coursework.equations.codegen.programs import Statement
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import Vector, placed, symbol
from coursework.mechanism.joints import FRAME
from coursework.motion.geometry.time_derivatives import acceleration_rest, derivative, moved_rate
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.forces import Spring

COUPLE = 2
_KINDS = {"x": 0, "y": 1, "couple": COUPLE}  # an unknown along a line has the kind 3 + the number of its direction


@frozen
class Acting:
    """The expressions a page needs for forces, and what its unknowns are.

    `wanted` holds in this order: for each body its centre (x, y), the force on it and the moment about the centre; x and y of
    each place; each direction; kinetic and potential energy.  Each of the `unknowns` is (name, body with +, body with -, place,
    kind, whether it drives); body -1 is the frame.
    """

    wanted: tuple[Expression, ...]
    bodies: int
    unknowns: tuple[tuple[str, int, int, int, int, int], ...]
    places: int


def accelerated(equations: VelocityEquations, reduction: Reduction) -> Iterator[list[Statement]]:
    """Yield, block by block, the statements for the derivatives of the velocities if laws drive the mechanism."""
    rests = {one.name: acceleration_rest(equations, one) for one in equations.equations}
    slopes = {one.name: one.coefficients for one in equations.equations}
    earlier: list[str] = []
    for index, block in enumerate(reduction.blocks):
        sides = tuple(
            rests[name] - add(ZERO, *[slopes[name][e] * derivative(e) for e in earlier if e in slopes[name]])
            for name in block.equations
        )
        yield block_statements(replace(block, sides=sides), index, [derivative(name) for name in block.unknowns])
        earlier += block.unknowns


@dataclass(slots=True)
class ActingWriter:
    """Writes what acts on the bodies as expressions of positions, velocities and their derivatives."""

    equations: VelocityEquations
    scheme: ForceScheme

    def acting(self) -> Acting:
        names = [body.name for body in self.scheme.bodies] + list(self.scheme.pins)
        index = {name: place for place, name in enumerate(names)} | {FRAME: -1}
        places: dict[Formula, Vector] = {}
        ways: list[Expression] = []
        unknowns = []
        for one in self.scheme.unknowns:
            if one.at is not None and one.at not in places:
                places[one.at] = self.vector(one.at)
            kind = _KINDS.get(one.direction.kind)
            if kind is None:
                kind = 3 + len(ways) // 2
                ways += self.along(one)
            at = -1 if one.at is None else list(places).index(one.at)
            unknowns.append((one.name, index[one.on], index[one.off], at, kind, int(bool(one.is_drive))))
        wrenches = [part for body in self.scheme.bodies for part in self.wrench(body)]
        of_places = [part for both in places.values() for part in both]
        size = 3 * len(self.scheme.bodies) + 2 * len(self.scheme.pins)
        return Acting(
            (*wrenches, *of_places, *ways, *self.energies()), len(self.scheme.bodies),
            tuple(unknowns) if size == len(unknowns) else (), len(places),
        )  # fmt: skip

    def vector(self, formula: Formula) -> Vector:
        with placed(self.equations.variant, "forces", 1):
            return self.equations.symbols.vector(formula)

    def scalar(self, formula: Formula | None) -> Expression:
        with placed(self.equations.variant, "forces", 1):
            return ZERO if formula is None else self.equations.symbols.scalar(formula)

    def rate(self, parts: Vector) -> Vector:
        x, y = map(self.equations.symbols.rate, parts)
        return x, y

    def second(self, expression: Expression) -> Expression:
        """Return the second time derivative of an expression of the positions."""
        return self.changed(self.equations.symbols.rate(expression))

    def changed(self, rate: Expression) -> Expression:
        """Return the time derivative of an expression of the velocities."""
        return moved_rate(self.equations, rate)

    def turned(self, body: Body) -> tuple[Expression, Expression]:
        """Return the angular velocity and acceleration of a body."""
        if body.rate:
            return symbol(body.rate), self.changed(symbol(body.rate))
        if body.span is None or body.span[0] == body.span[1]:
            return ZERO, ZERO
        way, square = self.way(*body.span), self.square(*body.span)
        moved, second = self.rate(way), (self.second(way[0]), self.second(way[1]))
        return cross(way, moved) / square, cross(way, second) / square

    def way(self, first: Formula, last: Formula) -> Vector:
        """Return the vector from one point to another."""
        (ax, ay), (bx, by) = self.vector(first), self.vector(last)
        return bx - ax, by - ay

    def square(self, first: Formula, last: Formula) -> Expression:
        """Return the square of the distance between two points."""
        x, y = self.way(first, last)
        return x**2 + y**2

    def inertia(self, body: Body) -> Expression:
        found: Expression = inertia_of(self.scheme, body, self.scalar, self.square)
        return found

    @property
    def gravity(self) -> Vector:
        """Return the acceleration of gravity (m/s²)."""
        x, y = map(self.scalar, self.scheme.forces.gravity or (None, None))
        return x, y

    def wrench(self, body: Body) -> Iterator[Expression]:
        """Yield the centre of a body, the force on it and its moment about the centre: inertia, weight, loads, springs."""
        centre, mass = self.vector(body.centre), self.scalar(body.mass)
        x, y = (mass * (g - self.second(part)) for g, part in zip(self.gravity, centre, strict=True))
        inertia = self.inertia(body)
        moment = -inertia * self.turned(body)[1] if inertia is not ZERO else ZERO
        for at, force, torque in (*self.loads(body), *self.pulls(body)):
            x, y = x + force[0], y + force[1]
            moment = add(moment, torque, cross((at[0] - centre[0], at[1] - centre[1]), force))
        yield from (*centre, x, y, moment)

    def loads(self, body: Body) -> Iterator[tuple[Vector, Vector, Expression]]:
        for load in self.scheme.forces.loads:
            if self.scheme.body_named(load.on) == body.name:
                still = self.vector(body.centre), (ZERO, ZERO), self.scalar(load.torque)
                yield still if load.at is None or load.force is None else (self.vector(load.at), self.vector(load.force), ZERO)
        for on, below, load in torques_beside_drives(self.scheme):
            if body.name in {on, below}:
                torque = self.scalar(load.torque)
                yield self.vector(body.centre), (ZERO, ZERO), torque if body.name == on else -torque

    def pulls(self, body: Body) -> Iterator[tuple[Vector, Vector, Expression]]:
        for spring in self.scheme.forces.springs:
            x, y = self.way(*map(named, spring.ends))
            length, pull = self.pull(spring)
            pull = pull / length
            for end, sign in zip(spring.ends, (ONE, -ONE), strict=True):
                if self.scheme.holder(end) == body.name:
                    yield self.vector(named(end)), (sign * pull * x, sign * pull * y), ZERO

    def pull(self, spring: Spring) -> tuple[Expression, Expression]:
        """Return the length of a spring and the force with which it pulls its ends together."""
        length = call("sqrt", self.square(*map(named, spring.ends)))
        pull = self.scalar(spring.stiffness) * (length - self.scalar(spring.free)) if spring.stiffness is not None else ZERO
        return length, pull + self.scalar(spring.damping) * self.equations.symbols.rate(length)

    def stretched(self) -> Iterator[Expression]:
        """Yield the energy of every spring."""
        for spring in self.scheme.forces.springs:
            if spring.stiffness is not None:
                stretch = call("sqrt", self.square(*map(named, spring.ends))) - self.scalar(spring.free)
                yield HALF * self.scalar(spring.stiffness) * stretch**2

    def along(self, one: Unknown) -> Vector:
        """Return the unit vector of an unknown, or the force at the end of an arm equivalent to a unit couple on it (1/m)."""
        way = one.direction
        if way.kind == "slope":
            assert one.at is not None
            x, y = (self.equations.symbols.partial(part, symbol(way.coordinate)) for part in self.vector(one.at))
            return x / (x**2 + y**2), y / (x**2 + y**2)
        if way.through is not None:
            (x, y), length = self.way(*way.through), call("sqrt", self.square(*way.through))
            unit = x / length, y / length
        else:
            angle = self.scalar(way.angle)
            unit = cosine(angle), sine(angle)
        return {"along": unit, "across": (-unit[1], unit[0]), "tangent": (unit[1], -unit[0])}[way.kind]

    def energies(self) -> Vector:
        gravity = self.gravity
        kinetic, potential = [ZERO], [ZERO]
        for body in self.scheme.bodies:
            centre, mass = self.vector(body.centre), self.scalar(body.mass)
            (x, y), inertia = self.rate(centre), self.inertia(body)
            kinetic += [HALF * mass * (x**2 + y**2)]
            kinetic += [HALF * inertia * self.turned(body)[0] ** 2] if inertia is not ZERO else []
            potential.append(-mass * (gravity[0] * centre[0] + gravity[1] * centre[1]))
        return add(*kinetic), add(*potential, *self.stretched())


def cross(arm: Vector, force: Vector) -> Expression:
    """Return the moment of a force at the end of an arm."""
    return arm[0] * force[1] - arm[1] * force[0]
