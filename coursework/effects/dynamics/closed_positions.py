"""Newton's correction of the coordinates that follow from others by closed positions, as lines of code.

Enters: velocity equations with their positions, the start, the indices of those coordinates.  Leaves: statements.
Used by `motion_writer.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.equations.algebra.expression import ZERO, Expression, add
from coursework.equations.codegen.programs import Statement
from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.independent import independent_rows
from coursework.equations.reduction.matching import blocks as block_order
from coursework.equations.reduction.matching import match
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import local, symbol
from coursework.equations.reduction.system import compile_values
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


def newton_statements(
    equations: VelocityEquations, start: Sequence[float], others: Sequence[int]
) -> tuple[list[Statement], tuple[float, ...], list[Expression]]:
    """Return the statements for Newton's correction of the coordinates `others`, the values positions keep, and their formulas.

    A formula is 0 if its position is kept at zero.
    """
    if not others:
        return [], (), []
    variant, symbols = equations.variant, equations.symbols
    names = [variant.coordinates[place].name for place in others]
    listed = [one for one in equations.positions if one.target in {"zero", "start"}]
    values = [one.expression for one in listed]
    slopes = [[symbols.partial(value, symbol(name)) for name in names] for value in values]
    found = compile_values(equations, [*values, *(slope for row in slopes for slope in row)])[0](0.0, *start)
    matrix = np.array(found[len(values) :], dtype=float).reshape(len(values), len(names))
    used = independent_rows(matrix)
    if len(used) < len(names):
        told = say("fault.V742", names=tuple(names), number=len(used))
        raise InputError([Fault(told, variant.file, variant.nearest_line("closure"))])
    rows = [frozenset(k for k, slope in enumerate(slopes[row]) if slope is not ZERO) for row in used]
    owner = match(rows, len(names))
    statements: list[Statement] = []
    done: list[int] = []
    for index, columns in enumerate(block_order(rows, owner)):
        members = sorted(owner[column] for column in columns)
        sides = tuple(
            local(f"_kept{member}") - values[used[member]]
            - add(ZERO, *[slopes[used[member]][e] * local(f"_step{others[e]}") for e in done])
            for member in members
        )  # fmt: skip
        coefficients = tuple(tuple(slopes[used[member]][column] for column in columns) for member in members)
        block = Block(tuple(names[c] for c in columns), (), coefficients, sides, None, "")
        targets = [local(f"_step{others[column]}") for column in columns]
        statements += block_statements(block, index, targets)
        done += columns
    kept = tuple(0.0 if listed[row].target == "zero" else float(found[row]) for row in used)
    return statements, kept, [ZERO if listed[row].target == "zero" else values[row] for row in used]
