"""A block of two velocities solved by Cramer's rule, with every determinant shown.

Enters: `VelocityEquations` and their `Reduction`.  Leaves: `Cramer`, in formulas.  Used by `solution.py`, `columns.py`
and `commands/check.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from coursework.equations.algebra.calculus import replaced
from coursework.equations.algebra.expression import ONE, ZERO, Expression
from coursework.equations.reduction.blocks import Block, Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import expanded, symbol
from coursework.equations.reduction.tidying.tidy import Order, as_sum, product, quotient
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, number

Rows = tuple[tuple[Formula, Formula], tuple[Formula, Formula]]


@frozen
class Cramer:
    """`coefficients` of the `unknowns` and `right_sides` of both equations; `determinant`; `numerators`, one per unknown.

    `put_in` names earlier velocities that were replaced by their formulas, because this makes the right sides shorter.
    `sign` times the determinant of the block is the one here.
    """

    unknowns: tuple[str, str]
    coefficients: Rows
    right_sides: tuple[Formula, Formula]
    determinant: Formula
    numerators: tuple[Formula, Formula]
    put_in: tuple[str, ...]
    sign: int


def cramer(equations: VelocityEquations, reduction: Reduction, wanted: Sequence[bool]) -> tuple[Cramer | None, ...]:
    """Return the solution of each block that is `wanted` and has two unknowns, None for all others.

    The leading coefficient of each row is made positive, as it is written by hand.  The result does not depend on the data: it
    is computed once for all variants of a template.

    >>> import coursework
    >>> scene = coursework.solve("31", quantities=["table"]).scene
    >>> one, two, both = cramer(scene.equations, scene.reduction, [True] * 3)
    >>> from coursework.variant.formula.tree import spelled
    >>> (one, two), spelled(both.determinant), [spelled(side) for side in both.right_sides]
    ((None, None), 'r2*r1*sin(phi1 - phi2)', ['-2*r3*w3*sin(phi3)', 'r3*w3*sin(phi3)'])
    """
    key = ("cramer", *wanted, *reduction.names)
    return equations.once(key, lambda: tuple(_worked(equations, reduction, wanted)))


def _worked(equations: VelocityEquations, reduction: Reduction, wanted: Sequence[bool]) -> Iterator[Cramer | None]:
    order, moving = equations.order, {symbol(coordinate.name) for coordinate in equations.variant.coordinates}
    before: dict[str, Expression] = {}
    for block, is_wanted in zip(reduction.blocks, wanted, strict=True):
        if block.size == 2 and is_wanted:
            yield _of_two(block, before, order)
            continue
        if block.size == 1 and is_wanted and not block.symbolic_determinant.free_symbols & moving:
            before[block.unknowns[0]] = expanded(block.sides[0] / block.symbolic_determinant)
        yield None


def _of_two(block: Block, before: dict[str, Expression], order: Order) -> Cramer:
    signs = [-1 if row[0].has_minus or (row[0] is ZERO and row[1].has_minus) else 1
             for row in block.coefficients]  # fmt: skip
    (a, b), (c, d) = ([sign * entry for entry in row] for sign, row in zip(signs, block.coefficients, strict=True))
    plain = [sign * side for sign, side in zip(signs, block.sides, strict=True)]
    known = {name: value for name, value in before.items() if any(symbol(name) in side.free_symbols for side in plain)}
    put = [expanded(replaced(side, {symbol(name): value for name, value in known.items()})) for side in plain]
    shorter = bool(known) and sum(_size(side, order) for side in put) < sum(_size(side, order) for side in plain)
    first, second = put if shorter else plain
    numerators = (first * d - b * second, a * second - c * first)
    determinant = _factored(a * d - b * c, order)
    return Cramer(
        (block.unknowns[0], block.unknowns[1]),
        ((_side(a, order), _side(b, order)), (_side(c, order), _side(d, order))),
        (_side(first, order), _side(second, order)),
        determinant,
        (_factored(numerators[0], order), _factored(numerators[1], order)),
        tuple(known) if shorter else (),
        signs[0] * signs[1],
    )


def _factored(expression: Expression, order: Order) -> Formula:
    return quotient(expression, product(ONE, order), order)


def _side(expression: Expression, order: Order) -> Formula:
    return as_sum(expression, order) if expression is not ZERO else number(0)


def _size(expression: Expression, order: Order) -> int:
    return sum(1 for _ in _side(expression, order).walk())
