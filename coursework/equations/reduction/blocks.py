"""A(q, t) u = b(q, t) -> blocks in order of solution, each with its determinant and the meaning of its zero.

Enters: `VelocityEquations`.  Leaves: `Reduction`.  Blocks of one and two by Cramer's rule, larger ones numerically (LU).
Used by `reduction/`, `scene_run.py`, `way_to_motion.py`, `integration/`, `kinematics/` and `live/`.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from coursework.equations.algebra.expression import ZERO, Expression, add
from coursework.equations.algebra.symbolic_objects import symbolic
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.independent import choose
from coursework.equations.reduction.magnitude import largest
from coursework.equations.reduction.matching import blocks as block_order
from coursework.equations.reduction.matching import match
from coursework.equations.reduction.meaning import meaning
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, factors, number
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

if TYPE_CHECKING:
    import sympy as sp

_MOST_TOLD = 3  # unknowns of a block whose determinant may be simple enough to be told
_MOST_PARTS = 400  # of an expression that is sought a simple form of


@frozen
class Block:
    """Unknown velocities that are solved together.

    `coefficients` (size, size) and `sides` (size,) may contain the velocities of earlier blocks by name.  `determinant` is the
    formula shown (None for three unknowns or more), `meaning` a sentence about its zero, `largest` a bound of its absolute value
    (0 if no bound is known).  `condition` is the formula whose zero `meaning` tells: the determinant, also of three unknowns
    where it is a product of simple factors.
    """

    unknowns: tuple[str, ...]
    equations: tuple[str, ...]
    coefficients: tuple[tuple[Expression, ...], ...]
    sides: tuple[Expression, ...]
    determinant: Formula | None
    meaning: str
    largest: float = 0.0
    condition: Formula | None = None

    @property
    def size(self) -> int:
        """Return the number of unknowns."""
        return len(self.unknowns)

    @property
    def matrix(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """Return the coefficients (size, size) as SymPy objects."""
        return tuple(tuple(map(symbolic, row)) for row in self.coefficients)

    @property
    def right_side(self) -> tuple[sp.Expr, ...]:
        """Return the right sides (size,) as SymPy objects."""
        return tuple(map(symbolic, self.sides))

    @property
    def entries(self) -> tuple[Expression, ...]:
        """Return the coefficients row by row, then the right sides."""
        return (*(entry for row in self.coefficients for entry in row), *self.sides)

    @property
    def symbols(self) -> set[Expression]:
        """Return every symbol in the matrix and the right side."""
        return {symbol for entry in self.entries for symbol in entry.free_symbols}

    @property
    def symbolic_determinant(self) -> Expression:
        """Return the determinant of a block of at most three unknowns."""
        m = self.coefficients
        if self.size == 1:
            return m[0][0]
        pairs = ((0, 1), (0, 2), (1, 2))[: 2 * self.size - 3]
        below = [m[-2][left] * m[-1][right] - m[-2][right] * m[-1][left] for left, right in pairs]
        return below[0] if self.size == 2 else m[0][0] * below[2] - m[0][1] * below[1] + m[0][2] * below[0]

    @property
    def numerators(self) -> tuple[Expression, ...]:
        """Return determinant times unknown (Cramer's rule) for a block of one or two unknowns."""
        m, r = self.coefficients, self.sides
        if self.size == 1:
            return (r[0],)
        return r[0] * m[1][1] - m[0][1] * r[1], m[0][0] * r[1] - r[0] * m[1][0]


@frozen
class Reduction:
    """`blocks` in the order of solution; names of `used` and `unused` equations; `notes` are sentences about the unused ones."""

    blocks: tuple[Block, ...]
    used: tuple[str, ...]
    unused: tuple[str, ...]
    notes: tuple[str, ...]

    @property
    def names(self) -> tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]:
        """Return the names of the equations and of the unknowns of each block, which tell two reductions apart."""
        return tuple((block.equations, block.unknowns) for block in self.blocks)

    def needed(self, wanted: Sequence[str]) -> tuple[int, ...]:
        """Return the indices of the blocks that the velocities `wanted` need, in order."""
        sought = set(map(symbol, wanted))
        chosen = []
        for index, block in reversed([*enumerate(self.blocks)]):
            if sought & set(map(symbol, block.unknowns)):
                chosen.append(index)
                sought |= block.symbols
        return tuple(sorted(chosen))


def angles_in_determinants(blocks: Sequence[Block], equations: VelocityEquations) -> set[str]:
    """Return the angles in the matrix of a block that are not driven: a large step in one can pass a dead point unnoticed."""
    key = ("in determinants", tuple((block.equations, block.unknowns) for block in blocks))
    inside = equations.once(
        key, lambda: {s for block in blocks for row in block.coefficients for entry in row for s in entry.free_symbols}
    )
    variant = equations.variant
    free = (c.name for c in variant.coordinates if c.rate not in variant.known_rates and c.unit == "rad")
    return {name for name in free if symbol(name) in inside}


def reduce(equations: VelocityEquations, start: Sequence[float]) -> Reduction:
    """Return the reduction; `start` (coordinates at t = 0) only helps to judge which equations are redundant.

    Raises `InputError` for systems that do not determine the velocities.
    """
    chosen, notes = choose(equations, start)
    used = [equations.equations[index] for index in chosen]
    names = equations.unknowns
    rows = [frozenset(names.index(name) for name in equation.coefficients) for equation in used]
    owner = match(rows, len(names))
    found = []
    for columns in block_order(rows, owner):
        # Equations of a block are in the author's order, unknowns in the order of the file.
        members = [used[row] for row in sorted(owner[column] for column in columns)]
        block = _block(tuple(members), tuple(names[column] for column in columns), equations)
        if block is None or block.size > 2:
            choose(equations, start, numbers=True)
        if block is None:
            told = say("fault.V401", names=tuple(e.name for e in members))
            raise InputError([Fault(told, equations.variant.file, members[0].line)])
        found.append(block)
    unused = tuple(e.name for i, e in enumerate(equations.equations) if i not in chosen)
    return Reduction(tuple(found), tuple(equation.name for equation in used), unused, notes)


def _block(members: tuple[VelocityEquation, ...], unknowns: tuple[str, ...], equations: VelocityEquations) -> Block | None:
    """Return the block of some equations, None if its determinant is zero in every position."""
    bare = equations.once(("block", members, unknowns), lambda: _bare(members, unknowns, equations))
    if bare is None or bare.condition is None:
        return bare
    variant = equations.variant
    bound = largest(bare.determinant, variant) if bare.determinant is not None else 0.0
    return replace(bare, meaning=meaning(bare.condition, variant, bare.unknowns), largest=bound)


def _bare(members: tuple[VelocityEquation, ...], unknowns: tuple[str, ...], equations: VelocityEquations) -> Block | None:
    """Return the part of a block that does not depend on the data."""
    matrix = tuple(tuple(equation.coefficients.get(name, ZERO) for name in unknowns) for equation in members)
    right_side = tuple(_moved(equation, unknowns) for equation in members)
    names = tuple(equation.name for equation in members)
    if len(unknowns) > 2:
        text = say("determinant.large", count=len(unknowns), names=", ".join(names))
        large = Block(unknowns, names, matrix, right_side, None, text)
        return replace(large, condition=_product(large, equations)) if len(unknowns) == _MOST_TOLD else large
    bare = Block(unknowns, names, matrix, right_side, None, "")
    determinant = as_formula(bare.symbolic_determinant, equations.order)
    return None if determinant == number(0) else replace(bare, determinant=determinant, condition=determinant)


def _product(block: Block, equations: VelocityEquations) -> Formula | None:
    """Return the determinant of three unknowns if it is a product without sums outside its functions; else None."""
    if block.symbolic_determinant.size > _MOST_PARTS:
        return None
    formula = as_formula(block.symbolic_determinant, equations.order)
    sums = any(factor.op in {"+", "-"} for factor, _ in factors(formula, ("neg", "*", "/")))
    return None if sums or formula == number(0) else formula


def _moved(equation: VelocityEquation, unknowns: Collection[str]) -> Expression:
    """Return the right side after the terms of earlier velocities are moved to it."""
    earlier = [slope * symbol(name) for name, slope in equation.coefficients.items() if name not in unknowns]
    return add(equation.right_side, *[-term for term in earlier])
