"""Any expression of the positions -> its value, rate and second rate along a motion.

Enters: expressions of a scene.  Leaves: arrays.  Used for points, closed-form chains and accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from coursework.equations.algebra.calculus import derivative as derivative_by
from coursework.equations.algebra.calculus import replaced
from coursework.equations.algebra.expression import ZERO, Expression, add
from coursework.equations.codegen.names import acceleration, private
from coursework.equations.codegen.programs import Assign, Program, as_columns, compile_function
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.symbolic import TIME, constants, local, symbol
from coursework.equations.reduction.system import scene_program
from coursework.system.arrays import Array

RowFunction = Callable[..., Any]


def derivative(velocity: str) -> Expression:
    """Return the symbol of the derivative of a velocity."""
    return local(acceleration(velocity))


def compile_rows(equations: VelocityEquations, wanted: Sequence[Expression], order: int) -> Callable[..., Array]:
    """Return `rows(t, q, u, du)` -> (n, len(wanted)); u and du are read from order 1 and 2 on.

    `t` (n,), `q` (n, m) coordinates, `u` (n, k) rates then unknowns in file order, `du` (n, k) their derivatives.
    """
    variant = equations.variant
    names = [c.name for c in variant.coordinates]
    velocities = [*variant.rates, *(name for name, _ in variant.unknowns)]
    arguments = [private(name) for name in ("t", *names, *(velocities if order >= 1 else ()))]
    if order >= 2:
        arguments += map(acceleration, velocities)
    results = [f"_out{place}" for place in range(len(wanted))]
    known = [symbol(name) for name in velocities] if order >= 1 else ()

    def written() -> Program:
        return scene_program(equations, [Assign(local(name), value) for name, value in zip(results, wanted, strict=True)], known)

    body = equations.once(("rows", order, *wanted), written).bind(constants(variant))
    function: RowFunction = compile_function("rows", arguments, body, results, numpy=True)

    def rows(t: Array, q: Array, u: Array | None = None, du: Array | None = None) -> Array:
        columns = [*q.T, *(u.T if u is not None and order >= 1 else ()), *(du.T if du is not None and order >= 2 else ())]
        values = function(t, *columns)
        return as_columns(values, t.shape)

    return rows


def second_rate(equations: VelocityEquations, rate: Expression) -> Expression:
    """Return d rate / d t, with `derivative(NAME)` for that of the velocity NAME."""
    symbols = equations.symbols
    total = symbols.partial(rate, TIME)
    for coordinate, its_rate in symbols.rates.items():
        total += symbols.partial(rate, coordinate) * its_rate
    for name in (*equations.variant.rates, *(name for name, _ in equations.variant.unknowns)):
        if symbol(name) not in symbols.definitions:
            total += derivative_by(rate, symbol(name)) * derivative(name)
    return total


def acceleration_rest(equations: VelocityEquations, equation: VelocityEquation) -> Expression:
    """Return db/dt - dA/dt u of one velocity equation A u = b: what its coefficients times the accelerations are equal to."""
    moving = add(*[slope * symbol(name) for name, slope in equation.coefficients.items()], -equation.right_side)
    still = {derivative(name): ZERO for name in equations.unknowns}
    return -replaced(second_rate(equations, moving), still)


def jets(equations: VelocityEquations, wanted: Sequence[Expression], order: int) -> list[Callable[..., Array]]:
    """Return the row functions of value, rate (order >= 1) and second rate (order 2) of some expressions."""
    levels = [list(wanted)]
    if order >= 1:
        levels.append([equations.symbols.rate(expr) for expr in wanted])
    if order >= 2:
        levels.append([second_rate(equations, expr) for expr in levels[1]])
    return [compile_rows(equations, exprs, level) for level, exprs in enumerate(levels)]
