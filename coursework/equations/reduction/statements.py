"""Blocks -> statements for generated code: velocities, or velocities times the determinant of one block.

Enters: blocks of a `Reduction`.  Leaves: statements for `codegen`.
Used by `motion/integration/rates.py`, `scene/model/model.py`, `motion/singular/scaled_flow.py` and `report/live/functions.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from coursework.equations.algebra.calculus import derivative, replaced
from coursework.equations.algebra.expression import ZERO, Expression, add
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Solve, Statement
from coursework.equations.reduction.blocks import Block
from coursework.equations.reduction.symbolic import local, symbol


def block_statements(block: Block, index: int, targets: Sequence[Expression] = ()) -> list[Statement]:
    """Return statements for the velocities of a block, by name or as `targets`, and its determinant `_det{index}`."""
    determinant = local(f"_det{index}")
    unknowns = tuple(targets or map(symbol, block.unknowns))
    if block.size > 2:
        return [Solve(unknowns, determinant, block.entries)]
    quotients = [Assign(name, numerator / determinant) for name, numerator in zip(unknowns, block.numerators, strict=True)]
    return [Assign(determinant, block.symbolic_determinant), *quotients]


def clock_statements(blocks: Sequence[Block], clock: int, rates: Sequence[str], results: Sequence[str]) -> list[Statement]:
    """Return statements for D times each of the `rates` and for D, as `results`; D is the determinant of block `clock`.

    Nothing is divided by D.  Velocities of earlier blocks are multiplied by D, its own are adj(A) b.  Later blocks are solved
    with right sides times D, into which the earlier velocities enter already multiplied.
    """
    determinant = local(f"_det{clock}")
    scaled = {name: local(f"_scaled_{private(name)}") for block in blocks for name in block.unknowns}
    statements = [one for index in range(clock) for one in block_statements(blocks[index], index)]
    own = blocks[clock]
    targets = [scaled[name] for name in own.unknowns]
    if own.size > 2:
        statements.append(Solve(tuple(targets), determinant, own.entries, adjugate=True))
    else:
        statements += [Assign(determinant, own.symbolic_determinant), *map(Assign, targets, own.numerators)]
    statements += [Assign(scaled[name], symbol(name) * determinant) for block in blocks[:clock] for name in block.unknowns]
    for index in range(clock + 1, len(blocks)):
        block = blocks[index]
        later = replace(block, sides=tuple(_scaled_side(side, determinant, scaled) for side in block.sides))
        statements += block_statements(later, index, [scaled[name] for name in block.unknowns])
    moved = [scaled[rate] if rate in scaled else determinant * symbol(rate) for rate in rates]
    return [*statements, *map(Assign, map(local, results), [*moved, determinant])]


def _scaled_side(side: Expression, determinant: Expression, scaled: Mapping[str, Expression]) -> Expression:
    """Return a right side, linear in earlier velocities, times the determinant of block `clock`."""
    earlier = {symbol(name): target for name, target in scaled.items() if symbol(name) in side.free_symbols}
    rest = replaced(side, dict.fromkeys(earlier, ZERO))
    return add(determinant * rest, *(derivative(side, name) * target for name, target in earlier.items()))
