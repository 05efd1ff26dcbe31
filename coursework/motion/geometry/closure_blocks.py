"""The order in which position equations are solved: blocks of equations, or sums of them, with as few coordinates as can be.

Enters: expressions, the names of free coordinates.  Leaves: blocks of a `Closure`.  Used by `closure.py`.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.matching import blocks as block_order
from coursework.equations.reduction.matching import match
from coursework.equations.reduction.symbolic import expanded
from coursework.system.arrays import Array

MOST_COMBINED = 12  # largest number of equations for which sums and differences of pairs are tried


def blocks_of(
    expressions: list[Expression], names: list[Expression], equations: VelocityEquations, free: tuple[int, ...]
) -> tuple[tuple[Array, list[int], list[int]], ...]:
    """Return the blocks of a `Closure` in the order of solution, with sums of equations in which fewer coordinates occur.

    There are none if the equations cannot be matched one to one with the coordinates.
    """
    places = {name: i for i, name in enumerate(names)}
    definitions = equations.symbols.definitions

    def inside(expr: Expression) -> frozenset[int]:
        return frozenset(places[name] for name in definitions.behind(expr.free_symbols) if name in places)

    count = len(expressions)
    combination = np.eye(count)
    rows = [inside(expr) for expr in expressions]
    # With products multiplied out once, equal terms cancel in sums and differences.
    flat = [expanded(expr) for expr in expressions] if count <= MOST_COMBINED else []
    for i, j, sign in product(range(len(flat)), range(len(flat)), (-1, 1)):
        if i != j and rows[i] & rows[j]:
            joined = flat[i] + sign * flat[j]
            fewer = inside(joined)
            if fewer < rows[i]:
                flat[i], rows[i] = joined, fewer
                combination[i] = combination[i] + sign * combination[j]
    owner = match(rows, len(names))
    if count != len(names) or -1 in owner:
        return ()
    return tuple(
        (combination[[owner[column] for column in columns]], columns, [free[column] for column in columns])
        for columns in block_order(rows, owner)
    )
