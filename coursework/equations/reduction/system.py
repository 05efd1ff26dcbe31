"""Velocity equations -> the numbers of A(q, t) u = b(q, t) at any time and position.

Enters: `VelocityEquations`.  Leaves: `LinearSystem`: A (m, n) and b (m,) as arrays.
Used where the equations themselves are checked: independence, residuals, dead points, closure of positions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Bound, Program, Statement, compile_later, program
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.system.arrays import Array, as_columns
from coursework.system.frozen import frozen


@frozen
class LinearSystem:
    """`matrix(t, q)` returns A (m, n), b (m,), known rates (k,); `matrices` for r rows returns (r, m, n), (r, m), (r, k)."""

    names: tuple[str, ...]
    unknowns: tuple[str, ...]
    known: tuple[str, ...]
    entries: tuple[tuple[int, int], ...]
    scalar: Callable[..., Any]
    rows: Callable[..., Any]

    def matrix(self, t: float, q: Sequence[float]) -> tuple[Array, Array, Array]:
        """Return A, b and the driven rates at one time (s) and position."""
        return self._fill(np.array(self.scalar(t, *q), dtype=float))

    def matrices(self, t: Array, q: Array) -> tuple[Array, Array, Array]:
        """Return A (r, m, n), b (r, m) and the driven rates (r, k) for r rows at once."""
        return self._fill(as_columns(self.rows(t, *q.T), t.shape))

    def _fill(self, values: Array) -> tuple[Array, Array, Array]:
        m, n, count = len(self.names), len(self.unknowns), len(self.entries)
        matrix = np.zeros((*values.shape[:-1], m, n))
        for position, (row, column) in enumerate(self.entries):
            matrix[..., row, column] = values[..., position]
        return matrix, values[..., count : count + m], values[..., count + m :]


def scene_program(equations: VelocityEquations, statements: Sequence[Statement], given: Iterable[Expression] = ()) -> Program:
    """Return the program of some statements; `given` symbols are arguments, even if laws define them."""
    definitions = equations.symbols.definitions.without(set(given))
    return program(statements, definitions, constants(equations.variant), equations.tables)


def compile_system(equations: VelocityEquations, rows: Sequence[VelocityEquation]) -> LinearSystem:
    """Return the linear system of the velocity equations `rows`."""
    known = equations.variant.known_rates
    entries = tuple((row, equations.unknowns.index(name)) for row, equation in enumerate(rows) for name in equation.coefficients)
    wanted = [slope for equation in rows for slope in equation.coefficients.values()]
    wanted += [*(equation.right_side for equation in rows), *map(symbol, known)]
    names = tuple(equation.name for equation in rows)
    return LinearSystem(names, equations.unknowns, known, entries, *compile_values(equations, wanted))


def compile_values(equations: VelocityEquations, wanted: Sequence[Expression]) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """Return (scalar, rows) functions of (t, *coordinates) that give the values of `wanted`."""
    body, results = bound_values(equations, wanted)
    arguments = [private(name) for name in ("t", *(c.name for c in equations.variant.coordinates))]
    return compile_later("values", arguments, body, results), compile_later("values", arguments, body, results, numpy=True)


def bound_values(
    equations: VelocityEquations, wanted: Sequence[Expression], given: Sequence[Expression] = ()
) -> tuple[Bound, list[str]]:
    """Return a program for the values `wanted` with the data of the variant, and its results; `given` as in `scene_program`."""
    results = [f"_out{place}" for place in range(len(wanted))]

    def written() -> Program:
        return scene_program(equations, [Assign(local(name), value) for name, value in zip(results, wanted, strict=True)], given)

    return equations.once(("values", *given, None, *wanted), written).bind(constants(equations.variant)), results
