"""The input of the force computation for all rows of a motion at once: places, velocities and accelerations of the bodies.

Enters: equations, a `ForceScheme`, a motion with its accelerations.  Leaves: `Rows`; vectors are complex, x + iy, SI.
Used by `effects.py`, `kinetostatics.py`, `virtual_power.py`, `energy.py` and `analysis.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from coursework.effects.acting import ActingWriter
from coursework.effects.force_scheme import Body, ForceScheme, Unknown, inertia_of
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import placed, symbol
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array, Complex
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.forces import Spring

# Level of a value: the place, its rate, its second rate.
PLACE, RATE, SECOND = 0, 1, 2
Wanted = tuple[Formula, bool, int | str]  # a formula, whether it is a vector, a level or the coordinate of a derivative


@dataclass(frozen=True, eq=False)
class Rows:
    """The values of every row (n,).

    `values` holds those of formulas by level, `turning` the angular velocities and accelerations by rate, `slopes` the
    derivatives of the centres by the coordinates (n,) complex, `spanned` those from end to end of a body whose rate has no name.
    """

    motion: Motion
    scheme: ForceScheme
    values: Mapping[Wanted, Any]
    turning: Mapping[str, tuple[Array, Array]]
    slopes: Mapping[tuple[str, str], Complex]
    spanned: Mapping[tuple[str, str], Complex]

    @property
    def count(self) -> int:
        """Return how many rows there are."""
        return len(self.motion.t)

    def vector(self, formula: Formula, level: int | str = PLACE) -> Complex:
        """Return a point, its velocity or its acceleration (n,) complex, m, m/s, m/s²."""
        found: Complex = self.values[formula, True, level]
        return found

    def scalar(self, formula: Formula | None) -> Array:
        """Return the values of a number (n,), 0 if the file gives none."""
        found: Array = np.zeros(self.count) if formula is None else self.values[formula, False, PLACE]
        return found

    def along(self, unknown: Unknown) -> Complex:
        """Return the force (n,) complex for an unknown of 1: a unit vector, or the force of a unit couple on an arm (1/m)."""
        direction = unknown.direction
        if direction.kind == "slope" and unknown.at is not None:
            return np.asarray(1 / np.conj(self.vector(unknown.at, direction.coordinate)))
        if direction.kind in {"x", "y"}:
            return np.full(self.count, 1.0 if direction.kind == "x" else 1j, dtype=complex)
        if direction.through is not None:
            way = self.vector(direction.through[1]) - self.vector(direction.through[0])
            unit: Complex = way / np.abs(way)
        else:
            unit = np.exp(1j * self.scalar(direction.angle))
        return unit * {"along": 1, "across": 1j, "tangent": -1j}[direction.kind]

    def omega(self, body: Body) -> Array:
        """Return the angular velocity (n,) rad/s."""
        return self.turns[body.name][0]

    def epsilon(self, body: Body) -> Array:
        """Return the angular acceleration (n,) rad/s²."""
        return self.turns[body.name][1]

    @cached_property
    def turns(self) -> dict[str, tuple[Array, Array]]:
        """Return the angular velocity and acceleration of each body."""
        return {body.name: self._turn(body) for body in self.scheme.bodies}

    def _turn(self, body: Body) -> tuple[Array, Array]:
        if body.rate:
            return self.turning[body.rate]
        still = np.zeros(self.count)
        if body.span is None or body.span[0] == body.span[1]:
            return still, still
        way, rate, second = (self.vector(body.span[1], level) - self.vector(body.span[0], level) for level in (0, 1, 2))
        return _turn(way, rate), _turn(way, second)

    def turned_by(self, body: Body, coordinate: str) -> Array:
        """Return how far (n,) a body whose rate has no name turns for a unit of a coordinate, by the line between its ends."""
        if body.span is None or (body.name, coordinate) not in self.spanned:
            return np.zeros(self.count)
        way = self.vector(body.span[1]) - self.vector(body.span[0])
        return _turn(way, self.spanned[body.name, coordinate])

    def stretch(self, spring: Spring) -> tuple[Complex, Array]:
        """Return the vector from end to end of a spring (n,) complex m, and the rate of its length (n,) m/s."""
        first, second = map(named, spring.ends)
        way = self.vector(second) - self.vector(first)
        return way, (np.conj(way) * (self.vector(second, RATE) - self.vector(first, RATE))).real / np.abs(way)

    def velocity(self, body: Body, at: Complex) -> Complex:
        """Return the velocity (n,) complex m/s of the point of a body that is at the place `at`."""
        return self.vector(body.centre, RATE) + 1j * self.omega(body) * (at - self.vector(body.centre))

    def mass(self, body: Body) -> Array:
        """Return the mass (n,) kg."""
        return self.scalar(body.mass)

    def inertia(self, body: Body) -> Array:
        """Return the moment of inertia about the centre of mass (n,) kg m², including a flywheel on the body."""
        vector = self.vector
        found: Array = inertia_of(self.scheme, body, self.scalar, lambda first, last: np.abs(vector(last) - vector(first)) ** 2)
        return found

    @cached_property
    def length(self) -> float:
        """Return a length of the mechanism (m): the largest distance of a joint from the first one."""
        places = [self.vector(one.at) for one in self.scheme.unknowns if one.at is not None]
        return float(max((np.abs(one - places[0]).max(initial=0.0) for one in places), default=0.0)) or 1.0


def _turn(way: Complex, moved: Complex) -> Array:
    """Return how far (n,) a line along `way` turns as its end moves by `moved` against its begin."""
    return np.asarray((np.conj(way) * moved).imag / np.abs(way) ** 2)


def wanted_of(scheme: ForceScheme) -> Iterator[Wanted]:
    """Yield every value that the force computation for a scheme needs."""
    for unknown in scheme.unknowns:
        if unknown.at is not None:
            yield unknown.at, True, PLACE
        yield from _numbers(unknown.direction.angle)
        for point in unknown.direction.through or ():
            yield point, True, PLACE
        if unknown.direction.kind == "across" and unknown.direction.angle is not None and unknown.at is not None:
            yield from ((unknown.direction.angle, False, RATE), (unknown.at, True, RATE))
        if unknown.is_drive and unknown.at is not None:
            yield unknown.at, True, RATE
            if unknown.direction.coordinate:
                yield unknown.at, True, unknown.direction.coordinate
    for body in scheme.bodies:
        for level in (PLACE, RATE, SECOND):
            yield body.centre, True, level
        if body.span is not None and (not body.rate or isinstance(body.inertia, str)):
            levels = (PLACE,) if body.rate else (PLACE, RATE, SECOND)
            yield from ((point, True, level) for point in body.span for level in levels)
        yield from _numbers(body.mass, body.inertia)
    forces = scheme.forces
    yield from _numbers(*(forces.gravity or ()))
    for load in (*forces.loads, *(forces.motor.torques if forces.motor else ())):
        if load.at is not None and load.force is not None:
            yield from ((load.at, True, PLACE), (load.at, True, RATE), (load.force, True, PLACE))
        yield from _numbers(load.torque)
    for spring in forces.springs:
        yield from ((named(end), True, level) for end in spring.ends for level in (PLACE, RATE))
        yield from _numbers(spring.stiffness, spring.free, spring.damping)
    for rubs in forces.friction:
        yield from _numbers(rubs.coefficient, rubs.radius, rubs.length, rubs.arm)
    yield from ((point, True, RATE) for _, point in scheme.pinned)
    for name in (*scheme.by_name, *(load.on for load in forces.loads)):
        if (own := scheme.own_point(name)) is not None:
            yield from ((own, True, PLACE), (own, True, RATE))
    if forces.flywheel is not None:
        yield from _numbers(forces.flywheel.inertia, forces.flywheel.unevenness)


def _numbers(*given: object) -> Iterator[Wanted]:
    """Yield the values of numbers, as far as the file gives formulas for them."""
    return ((one, False, PLACE) for one in given if isinstance(one, Formula))


@dataclass(frozen=True, eq=False)
class Program:
    """The program that computes `Rows`, compiled once for a mechanism."""

    scheme: ForceScheme
    wanted: tuple[Wanted, ...]
    expressions: tuple[Expression, ...]

    def rows(self, equations: VelocityEquations, motion: Motion, second: Array) -> Rows:
        """Return the values for a motion's rows with their accelerations (n, k)."""
        compiled = compile_rows(equations, self.expressions, 2)
        found = compiled(motion.t, motion.coordinates, motion.velocities, second)
        # A drive that starts infinitely fast, as a root does, has no forces there: not a number, rather than warnings all along.
        columns = iter(np.where(np.isfinite(found), found, np.nan).T)
        values = {
            one: next(columns) + 1j * next(columns) if one[1] else next(columns) for one in self.wanted
        }  # fmt: skip
        turning = {rate: (next(columns), next(columns)) for rate in _rates(self.scheme)}
        coordinates = [c.name for c in equations.variant.coordinates]
        slopes = {(body.name, name): next(columns) + 1j * next(columns) for body in self.scheme.bodies for name in coordinates}
        spanned = {
            (body.name, name): next(columns) + 1j * next(columns) for body, _ in _spans(self.scheme) for name in coordinates
        }
        return Rows(motion, self.scheme, values, turning, slopes, spanned)


def compile_program(equations: VelocityEquations, scheme: ForceScheme) -> Program:
    """Return the program of a scheme.  Raises `InputError` if a formula of the forces has no value."""
    wanted = tuple(dict.fromkeys(wanted_of(scheme)))
    symbols, writer, found = equations.symbols, ActingWriter(equations, scheme), list[Expression]()

    def raised(expr: Expression, level: int | str) -> Expression:
        if isinstance(level, str):
            return symbols.partial(expr, symbol(level))
        return writer.second(expr) if level == SECOND else symbols.rate(expr) if level else expr

    for formula, is_vector, level in wanted:
        with placed(equations.variant, "forces", 1):
            parts = symbols.vector(formula) if is_vector else (symbols.scalar(formula),)
            found += [raised(part, level) for part in parts]
    for rate in _rates(scheme):
        found += [symbol(rate), writer.changed(symbol(rate))]
    for body in scheme.bodies:
        centre = symbols.vector(body.centre)
        found += [symbols.partial(part, symbol(c.name)) for c in equations.variant.coordinates for part in centre]
    for _, span in _spans(scheme):
        first, last = (symbols.vector(end) for end in span)
        found += [
            symbols.partial(there - here, symbol(c.name))
            for c in equations.variant.coordinates
            for here, there in zip(first, last, strict=True)
        ]
    return Program(scheme, wanted, tuple(found))


def _spans(scheme: ForceScheme) -> list[tuple[Body, tuple[Formula, Formula]]]:
    """Return the bodies whose rate has no name, each with the two ends that show how it turns."""
    return [(one, one.span) for one in scheme.bodies if not one.rate and one.span is not None and one.span[0] != one.span[1]]


def _rates(scheme: ForceScheme) -> tuple[str, ...]:
    return tuple(dict.fromkeys(body.rate for body in scheme.bodies if body.rate))
