"""Equations of motion in one or two free coordinates: M(q) v' = Q(q, v, t) - h(q, v), all other coordinates by closed positions.

Enters: velocity equations, their blocks, a `ForceScheme`, the start.  Leaves: `EquationsOfMotion`, plain functions.
Used by `rubbed_motion.py`, `scene/motor_scene.py`, `report/live/by_forces.py` and `takeaway/listing/by_forces.py`.

Each velocity is U v, where the blocks give the analogs U for a unit of each free rate; likewise the velocity of each centre of
mass is S v.  M = sum (m S S + J w w), h is the part of the inertia without v', Q the power of loads, weight, springs and
motors in each of these motions.  The code is straight-line, each value computed once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from coursework.effects.acting import ActingWriter, accelerated
from coursework.effects.dynamics.closed_positions import newton_statements
from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.effects.force_scheme import Body, ForceScheme, inertia_of
from coursework.equations.algebra.calculus import derivative as derivative_by
from coursework.equations.algebra.expression import HALF, ONE, ZERO, Expression, add
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Statement, compile_function, program
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import constants, local, placed, symbol
from coursework.equations.reduction.system import compile_values
from coursework.mechanism.joints import FRAME
from coursework.motion.geometry.drives.drive import breaks, resolution
from coursework.motion.geometry.time_derivatives import derivative, second_rate
from coursework.variant.record.forces import Load
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


@dataclass(slots=True)
class MotionWriter:
    """Writes a mechanism's equations of motion as statements; `weights` are masses and inertias, `numbers` their values."""

    equations: VelocityEquations
    reduction: Reduction
    scheme: ForceScheme
    start: tuple[float, ...]
    weights: dict[str, Expression] = field(default_factory=dict)
    numbers: dict[str, float] = field(default_factory=dict)

    @property
    def rates(self) -> tuple[str, ...]:
        assert self.scheme.forces.motor is not None
        return self.scheme.forces.motor.rates

    @property
    def acting(self) -> ActingWriter:
        """Return the writer of the forces that act on the bodies."""
        return ActingWriter(self.equations, self.scheme)

    @property
    def free(self) -> tuple[int, ...]:
        """Return the indices of the free coordinates."""
        by_rate = {c.rate: place for place, c in enumerate(self.equations.variant.coordinates)}
        return tuple(by_rate[rate] for rate in self.rates)

    @property
    def others(self) -> tuple[int, ...]:
        """Return the indices of the coordinates that follow from closed positions."""
        return tuple(place for place in range(len(self.equations.variant.coordinates)) if place not in self.free)

    @property
    def arguments(self) -> list[str]:
        """Return the names of t, all coordinates and the free rates."""
        return [private(name) for name in ("t", *(c.name for c in self.equations.variant.coordinates), *self.rates)]

    @property
    def solved(self) -> list[Expression]:
        """Return the symbols of the free accelerations."""
        return [local(f"_acc{k}") for k in range(len(self.rates))]

    def statements(self) -> list[Statement]:
        """Return the statements for all velocities and the free accelerations, for known masses and inertias."""
        self._weigh()
        return [*self._velocities(), *self._motion(), *self._solved(self.solved)]

    def made(self) -> EquationsOfMotion:
        """Return the equations as functions."""
        variant = self.equations.variant
        free, others, common = self.free, self.others, self.statements()
        values = compile_values(self.equations, [*self.weights.values()])[0](0.0, *self.start) if self.weights else ()
        self.numbers = dict(zip(self.weights, map(float, values), strict=True))
        own = [symbol(variant.coordinates[place].rate) for place in others]
        slope = self.compiled("slope", common, [*self.solved, *own])
        blocks, kept, _ = newton_statements(self.equations, self.start, others)
        deltas = [local(f"_step{place}") for place in others]
        newton = self.compiled(
            "newton", [*blocks], deltas, [*self.arguments[: -len(free)], *(f"_kept{k}" for k in range(len(kept)))]
        )
        sizes = self.equations.units([one.name for one in variant.coordinates])
        return EquationsOfMotion(
            free, others, slope, newton, kept, self._table(common), len(self.reduction.blocks), tuple(sizes.tolist()),
            breaks=breaks(variant), acting=resolution(self.equations).edges,
        )  # fmt: skip

    def compiled(
        self, name: str, statements: Sequence[Statement], results: Sequence[Expression], arguments: Sequence[str] = (),
        numpy: bool = False,
    ) -> Callable[..., Any]:  # fmt: skip
        """Return a function for `results` after the statements; by default its arguments are t, coordinates and free rates."""
        known = {**constants(self.equations.variant), **self.numbers}
        definitions = self.equations.symbols.definitions.without({symbol(rate) for rate in self.rates})
        outs = [Assign(local(f"_out{place}"), value) for place, value in enumerate(results)]
        body = program([*statements, *outs], definitions, known, self.equations.tables).bind(known)
        return compile_function(
            name, arguments or self.arguments, body, [f"_out{place}" for place in range(len(results))], numpy=numpy
        )

    def _velocities(self) -> Iterator[Statement]:
        """Yield statements for all analogs and velocities, and for the velocities' derivatives at zero free accelerations."""
        earlier: list[str] = []
        both = zip(self.reduction.blocks, accelerated(self.equations, self.reduction), strict=True)
        for index, (block, changes) in enumerate(both):
            for k, rate in enumerate(self.rates):
                sides = tuple(
                    derivative_by(side, symbol(rate)) + add(*[derivative_by(side, symbol(e)) * _analog(k, e) for e in earlier])
                    for side in block.sides
                )
                targets = [_analog(k, name) for name in block.unknowns]
                yield from block_statements(replace(block, sides=sides), index, targets)
            for name in block.unknowns:
                yield Assign(symbol(name), add(*[_analog(k, name) * symbol(rate) for k, rate in enumerate(self.rates)]))
            yield from changes
            earlier += block.unknowns

    def _weigh(self) -> None:
        """Collect masses and inertias as numbers: they do not change with the motion."""
        symbols, wanted = self.equations.symbols, self.weights
        for place, body in enumerate(self.scheme.bodies):
            with placed(self.equations.variant, "masses", 1):
                if body.mass is not None:
                    wanted[f"_m{place}"] = symbols.scalar(body.mass)
                inertia = inertia_of(
                    self.scheme, body, lambda one: ZERO if one is None else symbols.scalar(one), self.acting.square
                )
            if inertia is not ZERO:
                wanted[f"_j{place}"] = inertia

    def _analog_of(self, expression: Expression, k: int) -> Expression:
        """Return the derivative of the rate of an expression of the positions by the free rate k."""
        slopes = [
            (c.rate, self.equations.symbols.partial(expression, symbol(c.name))) for c in self.equations.variant.coordinates
        ]
        return add(ZERO, *[slope * self.rate_of(rate, k) for rate, slope in slopes if slope is not ZERO])

    def rate_of(self, rate: str, k: int) -> Expression:
        """Return the derivative of a velocity by the free rate k."""
        if rate in self.rates:
            return ONE if rate == self.rates[k] else ZERO
        return _analog(k, rate) if rate else ZERO

    def _turning(self, body: Body) -> tuple[list[Expression], Expression]:
        """Return the analogs of a body's rate, and its acceleration for zero free accelerations."""
        if not body.rate and body.span is not None and body.inertia is not None:
            variant = self.equations.variant
            raise InputError([Fault(say("fault.V741", name=body.name), variant.file, variant.nearest_line("masses", body.name))])
        bias = ZERO if not body.rate or body.rate in self.rates else derivative(body.rate)
        return [self.rate_of(body.rate, k) for k in range(len(self.rates))], bias

    def _motion(self) -> Iterator[Statement]:
        """Yield the statements for M, Q - h, kinetic and potential energy."""
        symbols, count = self.equations.symbols, len(self.rates)
        matrix = [[ZERO for _ in range(count)] for _ in range(count)]
        right = [ZERO for _ in range(count)]
        potential = [ZERO]
        gravity = self.acting.gravity
        for place, body in enumerate(self.scheme.bodies):
            mass, inertia = (local(name) if name in self.weights else ZERO for name in (f"_m{place}", f"_j{place}"))
            if mass is inertia:
                continue
            centre = symbols.vector(body.centre)
            ways = [tuple(self._analog_of(part, k) for part in centre) for k in range(count)]
            second = tuple(second_rate(self.equations, symbols.rate(part)) for part in centre)
            turned, bias = self._turning(body) if inertia is not ZERO else ([ZERO] * count, ZERO)
            for k in range(count):
                for other in range(k, count):
                    matrix[k][other] += mass * (ways[k][0] * ways[other][0] + ways[k][1] * ways[other][1])
                    matrix[k][other] += inertia * turned[k] * turned[other]
                force = [mass * (g - a) for g, a in zip(gravity, second, strict=True)]
                right[k] += force[0] * ways[k][0] + force[1] * ways[k][1] - inertia * turned[k] * bias
            potential.append(-mass * (gravity[0] * centre[0] + gravity[1] * centre[1]))
        for k in range(count):
            for other in range(k, count):
                yield Assign(local(f"_mass{k}{other}"), matrix[k][other])
            yield Assign(local(f"_force{k}"), add(right[k], *self._powers(k)))
        rates = [symbol(rate) for rate in self.rates]
        kinetic = add(*[
            (HALF if k == other else ONE) * local(f"_mass{k}{other}") * rates[k] * rates[other]
            for k in range(count) for other in range(k, count)
        ])  # fmt: skip
        yield Assign(local("_kinetic"), kinetic)
        yield Assign(local("_potential"), add(*potential, *self.acting.stretched()))

    def _powers(self, k: int) -> Iterator[Expression]:
        """Yield the power of each load, spring and motor in the motion of the free rate k alone, for a rate of 1."""
        forces = self.scheme.forces
        for load in (*forces.loads, *(forces.motor.torques if forces.motor else ())):
            with placed(self.equations.variant, f"forces.{load.name}", 1):
                yield self._power(load, k)
        for spring in forces.springs:
            length, pull = self.acting.pull(spring)
            yield -pull * self._analog_of(length, k)

    def _power(self, load: Load, k: int) -> Expression:
        symbols = self.equations.symbols
        if load.torque is not None:
            turned = self._turn_of(load.on, k)
            if load.source != FRAME:
                turned = turned - self._turn_of(load.source, k)
            return symbols.scalar(load.torque) * turned
        assert load.at is not None and load.force is not None
        force, at = symbols.vector(load.force), symbols.vector(load.at)
        return force[0] * self._analog_of(at[0], k) + force[1] * self._analog_of(at[1], k)

    def _turn_of(self, name: str, k: int) -> Expression:
        return self.rate_of(self.scheme.by_name[self.scheme.body_named(name)].rate, k)

    def _solved(self, targets: Sequence[Expression]) -> Iterator[Statement]:
        """Yield the statements for the free accelerations."""
        if len(targets) == 1:
            yield Assign(targets[0], local("_force0") / local("_mass00"))
            return
        a, b, c = (local(f"_mass{key}") for key in ("00", "01", "11"))
        first, second = local("_force0"), local("_force1")
        yield Assign(local("_mass"), a * c - b * b)
        yield Assign(targets[0], (first * c - b * second) / local("_mass"))
        yield Assign(targets[1], (a * second - b * first) / local("_mass"))

    def acceleration_of(self, name: str, free: Sequence[Expression] = ()) -> Expression:
        """Return the derivative of a velocity, for use after the statements, with the free accelerations given or solved."""
        free = free or self.solved
        if name in self.rates:
            return free[self.rates.index(name)]
        return derivative(name) + add(*[_analog(k, name) * one for k, one in enumerate(free)])

    def _table(self, common: Sequence[Statement]) -> Callable[..., Any]:
        variant = self.equations.variant
        # With friction, its contribution to the free accelerations is a further argument.
        taken = [f"_rub{k}" for k in range(len(self.rates))] if self.scheme.forces.friction else []
        free = [add(one, *map(local, taken[k : k + 1])) for k, one in enumerate(self.solved)]
        names = (*variant.rates, *(name for name, _ in variant.unknowns))
        results = [
            *map(symbol, names),
            *(self.acceleration_of(name, free) for name in names),
            local("_kinetic"),
            local("_potential"),
        ]
        results += [local(f"_det{index}") for index in range(len(self.reduction.blocks))]
        return self.compiled("table", common, results, [*self.arguments, *taken], numpy=True)


def _analog(k: int, name: str) -> Expression:
    return local(f"_u{k}_{private(name)}")
