"""Blocks -> the velocities as in a textbook: ω3 = V_My / (r (2 cos φ3 + sin φ3)); equations as a page shows them.

Enters: `VelocityEquations` and their `Reduction`.  Leaves: formulas for a page.  No computation uses them.
Used by `way_to_motion.py` and `scene_run.py`.
"""

from __future__ import annotations

from coursework.equations.algebra.calculus import replaced
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import expanded, symbol
from coursework.equations.reduction.tidying.tidy import product, quotient
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, number, spelled

Solution = tuple[tuple[str, Formula], ...]
# Characters of the longest formula that a reader would read; a page shows "solved numerically" instead of a longer one.
MOST_LETTERS = 2000


@frozen
class ShownEquation:
    """A velocity equation as a page shows it; `derived` from positions, or written; if not `used`, it is kept as a check."""

    name: str
    because: str
    left: Formula
    right: Formula
    derived: bool
    used: bool


def shown_equations(equations: VelocityEquations, reduction: Reduction) -> tuple[ShownEquation, ...]:
    """Return the velocity equations, written or derived, in the order of the file."""
    sides = equations.once("sides", lambda: [equation.shown(equations.order) for equation in equations.equations])
    return tuple(
        ShownEquation(e.name, e.because, left, right, e.written is None, e.name in reduction.used)
        for e, (left, right) in zip(equations.equations, sides, strict=True)
    )


def solutions(equations: VelocityEquations, reduction: Reduction) -> tuple[Solution, ...]:
    """Return (velocity, its formula) for every block; empty for a block that a page calls solved numerically.

    These are blocks of three or more unknowns, and blocks with a formula of more than `MOST_LETTERS` characters.
    Earlier velocities stay names, or are replaced by their formulas if that is shorter.  The result does not depend on the
    data: it is computed once for all variants of a template.
    """
    key = ("solutions", MOST_LETTERS, reduction.names)
    return equations.once(key, lambda: _solutions(equations, reduction))


def _solutions(equations: VelocityEquations, reduction: Reduction) -> tuple[Solution, ...]:
    order = equations.order
    before: dict[Expression, Expression] = {}
    found: list[Solution] = []
    for block in reduction.blocks:
        if block.size > 2:
            found.append(())
            continue
        determinant = block.symbolic_determinant
        bottom = product(determinant, order)
        shown = []
        for name, numerator in zip(block.unknowns, block.numerators, strict=True):
            plain = quotient(numerator, bottom, order)
            if before.keys() & numerator.free_symbols:
                other = quotient(replaced(numerator, before), bottom, order)
                plain = other if _size(other) < _size(plain) else plain
            shown.append((name, plain))
            if block.size == 1 and not _divisor(plain).names():
                before[symbol(name)] = expanded(numerator / determinant)
        is_short = all(len(spelled(formula)) <= MOST_LETTERS for _, formula in shown)
        found.append(tuple(shown) if is_short else ())
    return tuple(found)


def _divisor(tree: Formula) -> Formula:
    """Return the denominator of a shown solution."""
    inner = tree.args[0] if tree.op == "neg" else tree
    return inner.args[1] if inner.op == "/" else number(1)


def _size(tree: Formula) -> int:
    return sum(1 for _ in tree.walk())
