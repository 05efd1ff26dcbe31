"""Motion with friction: the states of a mechanism moved by forces, with its reactions as functions of the state.

Enters: a `MotionWriter`.  Leaves: equations of motion that include friction.  Raises `InputError`.
Used by `scene/motor_scene.py`, for a file with [friction] only.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from coursework.effects.acting import cross
from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.effects.dynamics.motion_writer import MotionWriter
from coursework.effects.force_scheme import Unknown
from coursework.effects.friction.friction import partner, rubbing
from coursework.effects.friction.rubbing import Pair, Rubbing, State
from coursework.effects.kinetostatics.kinetostatics import places_of
from coursework.equations.algebra.calculus import derivative as derivative_by
from coursework.equations.algebra.expression import ONE, ZERO, Expression, add
from coursework.equations.codegen.programs import Assign
from coursework.equations.reduction.symbolic import Vector, symbol
from coursework.motion.geometry.time_derivatives import derivative
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


def rubbed_motion(writer: MotionWriter) -> EquationsOfMotion:
    """Return the equations of motion with the friction of the file.  Raises `InputError` if reactions are not unique."""
    ideal, own = writer.made(), _Writer(writer).made()

    def table(*rows: Any) -> Any:
        return ideal.table(*rows, *own.taken(len(ideal.free), *np.broadcast_arrays(*rows)))

    return replace(ideal, slope=own.slope, table=table, rubbing=own)


class _Writer:
    """Writes the state as expressions: the columns of the unknowns, the acting forces, a unit of friction for each pair."""

    def __init__(self, motion: MotionWriter) -> None:
        self.motion, self.acting, self.scheme = motion, motion.acting, motion.scheme
        self.places = places_of(motion.scheme)  # the first equation of each body and pin
        self.entries: dict[tuple[int, int], Expression] = {}  # row and column in the equations of the unknown forces -> entry

    def made(self) -> Rubbing:
        scheme, entries, free, count = self.scheme, self.entries, len(self.motion.rates), len(self.scheme.unknowns)
        if count != 3 * len(scheme.bodies) + 2 * len(scheme.pins):
            variant = self.motion.equations.variant
            raise InputError([Fault(say("fault.V718"), variant.file, variant.nearest_line("friction"))])
        for place, one in enumerate(scheme.unknowns):
            for name, sign in ((one.on, ONE), (one.off, -ONE)):
                self.acts(place, name, one, sign)
        for place, body in enumerate(scheme.bodies):
            for row, value in enumerate([*self.acting.wrench(body)][2:], 3 * place):
                entries[row, count] = -value
                for k in range(free):
                    entries[row, count + 1 + k] = -self.by_free(value, k)
        pairs: list[Pair] = []
        beside: list[Expression] = []
        for rubs in scheme.forces.friction:
            for place, kind in rubbing(scheme.unknowns, rubs):
                column = count + 1 + free + len(pairs)
                one, factor = scheme.unknowns[place], self.acting.scalar(rubs.arm if kind == "wheel" else rubs.coefficient)
                factor = factor * self.acting.scalar(rubs.radius) if kind == "pin" else factor
                speed = (self.slides if kind == "guide" else self.turns)(column, one)
                following = scheme.unknowns[place + 1].name if place + 1 < count else ""
                pairs.append(Pair(rubs.at, kind, place, kind == "guide" and following == f"K{one.name[1:]}"))
                change = self.acting.changed(speed)
                own = [factor, self.acting.scalar(rubs.length), speed, change]
                beside += [*own, *(self.by_free(change, k) for k in range(free))]
        drives = [place for place, one in enumerate(scheme.unknowns) if one.is_drive]
        others = [symbol(self.motion.equations.variant.coordinates[place].rate) for place in self.motion.others]
        results = [*self.motion.solved, *others, *entries.values(), *beside]
        still = [Assign(derivative(rate), ZERO) for rate in self.motion.rates]
        compiled = self.motion.compiled("rubbing", [*self.motion.statements(), *still], results)
        sizes = count, free, len(self.motion.others)
        return Rubbing(tuple(pairs), partial(_state, compiled, sizes, tuple(entries), tuple(drives)))

    def by_free(self, value: Expression, k: int) -> Expression:
        """Return the derivative by the free acceleration k of a value that is linear in the accelerations."""
        variant = self.motion.equations.variant
        names = dict.fromkeys([*variant.rates, *(name for name, _ in variant.unknowns)])
        return add(ZERO, *[derivative_by(value, derivative(name)) * self.motion.rate_of(name, k) for name in names])

    def acts(self, column: int, name: str, one: Unknown, sign: Expression) -> None:
        """Add the entries of a unit of an unknown in the equations of a body or pin."""
        if name not in self.places:
            return  # the frame
        if one.direction.kind == "couple":
            self.entries[self.places[name] + 2, column] = sign
            return
        x, y = self.unit(one)
        self.force(column, name, one, (sign * x, sign * y))

    def force(self, column: int, name: str, one: Unknown, force: Vector) -> None:
        first, body = self.places[name], self.scheme.by_name.get(name)
        self.entries[first, column], self.entries[first + 1, column] = force
        if body is not None and one.at is not None:
            at, centre = self.acting.vector(one.at), self.acting.vector(body.centre)
            self.entries[first + 2, column] = cross((at[0] - centre[0], at[1] - centre[1]), force)

    def unit(self, one: Unknown) -> Vector:
        return {"x": (ONE, ZERO), "y": (ZERO, ONE)}.get(one.direction.kind) or self.acting.along(one)

    def turns(self, column: int, one: Unknown) -> Expression:
        """Enter a couple on two bodies that turn about each other, and return their relative angular velocity."""
        speed = ZERO
        for name, sign in ((one.on, ONE), (partner(self.scheme, one), -ONE)):
            if (body := self.scheme.by_name.get(name)) is not None:
                self.entries[self.places[name] + 2, column] = sign
                speed = speed + sign * self.acting.turned(body)[0]
        return speed

    def slides(self, column: int, one: Unknown) -> Expression:
        """Enter a force along a guide on block and guide, and return the sliding speed of the block."""
        assert one.at is not None
        (x, y), at, speed = self.unit(one), self.acting.vector(one.at), ZERO
        along = y, -x
        for name, sign in ((one.on, ONE), (one.off, -ONE)):
            if (body := self.scheme.by_name.get(name)) is not None:
                self.force(column, name, one, (sign * along[0], sign * along[1]))
                centre, turned = self.acting.vector(body.centre), self.acting.turned(body)[0]
                (u, v), arm = self.acting.rate(centre), (at[0] - centre[0], at[1] - centre[1])
                speed = speed + sign * (along[0] * (u - turned * arm[1]) + along[1] * (v + turned * arm[0]))
        return speed


def _state(
    compiled: Callable[..., Any],
    sizes: tuple[int, int, int],
    at: tuple[tuple[int, int], ...],
    drives: tuple[int, ...],
    *state: float,
) -> State:
    """Return the state computed by the compiled expressions; `sizes` count unknown forces, free rates and other coordinates."""
    found, (count, free, beside_free) = compiled(*state), sizes
    begin, width = free + beside_free, 4 + free
    a, others = list(found[:free]), list(found[free:begin])
    beside = [found[k : k + width] for k in range(begin + len(at), len(found), width)]
    matrix = np.zeros((count, count + 1 + free + len(beside)))
    for place, value in zip(at, found[begin:], strict=False):
        matrix[place] = value
    try:
        solved = np.linalg.solve(matrix[:, :count], matrix[:, count:])
        slopes, units = solved[:, 1 : 1 + free], solved[:, 1 + free :]
        changes = -np.linalg.solve(slopes[list(drives)], units[list(drives)])
    except np.linalg.LinAlgError:
        raise ZeroDivisionError from None
    loose, reactions = solved[:, 0] + slopes @ np.array(a), units + slopes @ changes
    return State(
        a, others, loose.tolist(), reactions.T.tolist(), changes.T.tolist(), [one[:2] for one in beside],
        [one[2] for one in beside], [one[3] for one in beside], [list(one[4:]) for one in beside],
    )  # fmt: skip
