"""Values, rates and second rates of expressions of the positions along a motion.

Enters: expressions of a scene.  Leaves: arrays.  Used for points, closed-form chains and accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from coursework.equations.algebra.calculus import derivative as derivative_by
from coursework.equations.algebra.calculus import replaced
from coursework.equations.algebra.expression import ZERO, Expression, add
from coursework.equations.codegen.names import acceleration, private
from coursework.equations.codegen.programs import compile_function
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.symbolic import local, symbol
from coursework.equations.reduction.system import bound_values
from coursework.system.arrays import Array, as_columns


def derivative(velocity: str) -> Expression:
    """Return the symbol for the time derivative of a velocity."""
    return local(acceleration(velocity))


def compile_rows(equations: VelocityEquations, wanted: Sequence[Expression], order: int) -> Callable[..., Array]:
    """Return `rows(t, q, u, du)` -> (n, len(wanted)); u is read from order 1 on, du from order 2 on.

    `t` (n,), `q` (n, m) coordinates, `u` (n, k) rates then unknowns in file order, `du` (n, k) their derivatives.
    """
    variant = equations.variant
    velocities = variant.velocities if order >= 1 else ()
    arguments = [private(name) for name in ("t", *(c.name for c in variant.coordinates), *velocities)]
    if order >= 2:
        arguments += map(acceleration, velocities)
    body, results = bound_values(equations, wanted, list(map(symbol, velocities)))
    function: Callable[..., Any] = compile_function("rows", arguments, body, results, numpy=True)

    def rows(t: Array, q: Array, u: Array | None = None, du: Array | None = None) -> Array:
        columns = [*q.T, *(u.T if u is not None and order >= 1 else ()), *(du.T if du is not None and order >= 2 else ())]
        return as_columns(function(t, *columns), t.shape)

    return rows


def second_rate(equations: VelocityEquations, rate: Expression) -> Expression:
    """Return d rate / d t, in which `derivative(NAME)` is the derivative of the velocity NAME; that of a given rate is known."""
    symbols = equations.symbols
    total = symbols.rate(rate)
    for name in equations.variant.velocities:
        if symbol(name) not in symbols.definitions:
            total += derivative_by(rate, symbol(name)) * derivative(name)
    return total


def moved_rate(equations: VelocityEquations, rate: Expression) -> Expression:
    """Return d rate / d t like `second_rate`; rates that forces move change by forces, not by laws."""
    motor = equations.variant.motor
    free = motor.rates if motor is not None else ()
    return add(second_rate(equations, rate), *[derivative_by(rate, symbol(name)) * derivative(name) for name in free])


def acceleration_rest(
    equations: VelocityEquations, equation: VelocityEquation, change: Callable[..., Expression] = second_rate
) -> Expression:
    """Return db/dt - dA/dt u for one velocity equation A u = b: the right side of its acceleration equation.

    `change` is `second_rate`, as if free rates were constant, or `moved_rate`.
    """
    moving = add(*equation.terms, -equation.right_side)
    still = {derivative(name): ZERO for name in equations.unknowns}
    return -replaced(change(equations, moving), still)


def jets(equations: VelocityEquations, wanted: Sequence[Expression], order: int) -> list[Callable[..., Array]]:
    """Return the row functions for the values, rates (order >= 1) and second rates (order 2) of some expressions."""
    levels = [list(wanted)]
    if order >= 1:
        levels.append([equations.symbols.rate(expr) for expr in wanted])
    if order >= 2:
        levels.append([moved_rate(equations, expr) for expr in levels[1]])
    return [compile_rows(equations, exprs, level) for level, exprs in enumerate(levels)]
