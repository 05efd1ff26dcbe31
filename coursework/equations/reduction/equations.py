"""Mechanism -> velocity equations A(q, t) u = b(q, t), as written or differentiated from positions.

Enters: a `Mechanism`.  Leaves: `VelocityEquations` and the position equations behind them.
Raises `InputError` with the name of a term that is not linear in the unknown velocities.
Used by `reduction/`, `way_to_motion.py`, `accuracy/`, `checks/`, `drawing/` and `geometry/`.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeVar, cast

import numpy as np

from coursework.equations.algebra.calculus import without_denominators
from coursework.equations.algebra.expression import MINUS, ONE, ZERO, Expression, add
from coursework.equations.codegen.tabulated import TableLaw
from coursework.equations.reduction.bound import STILL, Geometry, Speed, rate_of, speed_of
from coursework.equations.reduction.symbolic import Symbols, placed, symbol
from coursework.equations.reduction.tidying.tidy import Order, as_sum
from coursework.mechanism.mechanism import Mechanism
from coursework.system.arrays import Array
from coursework.system.frozen import frozen, single
from coursework.variant.formula.made import with_sign
from coursework.variant.formula.tree import Formula, FormulaFault, on_axes, spelled
from coursework.variant.record.held import closed_loops, followed, largest_length, unit_of
from coursework.variant.record.variant import Constraint, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

Fact = TypeVar("Fact")
_LONGEST_WRITTEN = 60  # characters of the longest expression inside a sentence


@single
class VelocityEquation:
    """`sum coefficients[u] u = right_side`; `written` holds both sides as in the file, None if derived from positions."""

    name: str
    because: str
    coefficients: dict[str, Expression]
    right_side: Expression
    written: tuple[Formula, Formula] | None = None
    line: int = 0

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the coefficients, then the right side."""
        return (*self.coefficients.values(), self.right_side)

    @property
    def terms(self) -> list[Expression]:
        """Return the terms of the left side."""
        return [slope * symbol(name) for name, slope in self.coefficients.items()]

    def shown(self, order: Order) -> tuple[Formula, Formula]:
        """Return both sides as a page shows them."""
        return self.written or (as_sum(add(*self.terms), order), as_sum(self.right_side, order))


@frozen
class Position:
    """A position equation: `expression` (in `unit`: rad, m, m² …) keeps a value.

    `target` is "zero", "start" or the drive it follows; one that `closes` a loop should be zero, whatever its target.
    `written` is the expression, if it is short and its `name` is only a number, else "".
    """

    name: str
    expression: Expression
    target: str
    unit: str = "m"
    written: str = ""
    closes: bool = False

    @property
    def told(self) -> str:
        """Return its name in sentences: the expression, such as E.x - A.x - r*cos(phi), if the reader knows no shorter name."""
        return self.written or self.name


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)
class VelocityEquations:
    """All velocity equations of a mechanism, those of its [closure], its symbols and tabulated laws.

    `bound` holds, beside written equations, those that the geometry gives for velocities without a coordinate.

    All fields but `variant` are the same for variants that differ only in their data, also the `facts` found by `once`.
    """

    variant: Variant
    symbols: Symbols
    order: Order
    unknowns: tuple[str, ...]
    equations: tuple[VelocityEquation, ...]
    from_closure: tuple[VelocityEquation, ...]
    positions: tuple[Position, ...]
    tables: Mapping[str, TableLaw]
    geometry: Geometry
    bound: tuple[VelocityEquation, ...]
    facts: dict[Hashable, object] = field(default_factory=dict, repr=False)

    @property
    def speed_units(self) -> Array:
        """Return what counts as 1 of each unknown (k,): 1 rad/s, or the size of the mechanism in a second."""
        return self.units(self.unknowns)

    def units(self, names: Sequence[str]) -> Array:
        """Return what counts as 1 of each named coordinate or velocity (k,): 1 rad, or the size of the mechanism; a second."""
        size = largest_length(self.variant)
        return np.array([size if self.variant.unit_of(name).startswith("m") else 1.0 for name in names])

    def once(self, key: Hashable, find: Callable[[], Fact]) -> Fact:
        """Return a fact that does not depend on the data; it is computed at the first call."""
        if key not in self.facts:
            self.facts[key] = find()
        return cast("Fact", self.facts[key])


def differentiate(mechanism: Mechanism) -> VelocityEquations:
    """Return the velocity equations of a mechanism.  Raises `InputError` for terms that are not linear in the velocities."""
    variant = mechanism.variant
    symbols = Symbols(mechanism)
    order = Order([side for c in mechanism.constraints for side in c.sides], variant)
    equations: list[VelocityEquation] = []
    positions: list[Position] = []
    faults: list[Fault] = []
    taken = {constraint.name for constraint in mechanism.constraints if not constraint.is_closure}
    for constraint in mechanism.constraints:
        if not constraint.is_closure:
            try:
                with placed(variant, say("place.constraint", name=constraint.name), constraint.line):
                    equations.append(_written(constraint, variant, symbols))
            except InputError as error:
                faults += error.faults
            continue
        with placed(variant, say("place.constraint", name=constraint.name), constraint.line):
            components = _own_names(_components(constraint, symbols, variant), taken)
        for position in components:
            positions.append(position)
            equations.append(_derived(position, constraint.because, variant, symbols, constraint.line))
    if faults:
        raise InputError(faults)
    kept = _own_names(_closure_positions(variant, symbols), taken)
    from_closure = tuple(_derived(position, _reason(position), variant, symbols) for position in kept)
    geometry = Geometry(mechanism, symbols)
    bound = _bound(geometry, (*equations, *from_closure))
    if not equations:
        equations = list(from_closure)
        from_closure = ()
    if all(equation.written is None for equation in equations):
        equations += bound
        bound = ()
    positions += kept
    tables = {law.name: TableLaw(law.name, law.table, law.method) for law in variant.laws if law.table}
    return VelocityEquations(
        variant, symbols, order, variant.sought, tuple(equations), from_closure, tuple(positions), tables, geometry, bound
    )


def _bound(geometry: Geometry, equations: tuple[VelocityEquation, ...]) -> tuple[VelocityEquation, ...]:
    """Return the equations that the geometry gives for [unknowns], and for rates of links that no position determines."""
    said = geometry.bound()
    held = [equation for equation in equations if equation.written is None]
    known = {name for equation in held for name in equation.coefficients}
    if len(held) < len(known):  # positions do not determine all of these: a rolling link gets its rate by contact
        known -= {link.rate for link in geometry.variant.links if link.contact and link.rate}
    found = []
    for one in (*said, *geometry.rates_of_links(known | {one.name for one in said})):
        because = say("equation.rate_of_link", name=one.name, link=one.link) if one.link else say("equation.bound", name=one.name)
        line = geometry.variant.nearest_line("unknowns", one.name)
        found.append(VelocityEquation(one.name, because, dict(one.is_zero.coefficients), -one.is_zero.rest, line=line))
    return tuple(found)


def _components(constraint: Constraint, symbols: Symbols, variant: Variant) -> list[Position]:
    if not symbols.is_vector(constraint.left):
        both = Formula("-", (constraint.left, constraint.right))
        name, is_zero = constraint.name, constraint.right.op == "number" and not constraint.right.value
        written = spelled(on_axes(constraint.left if is_zero else both)) if len(name) == 1 and name.isalpha() else ""
        written = written if len(written) <= _LONGEST_WRITTEN else ""  # a letter alone would be taken for a coordinate
        return [Position(name, symbols.scalar(both), "zero", unit_of(both, variant), written, closes=True)]
    left, right = symbols.vector(constraint.left), symbols.vector(constraint.right)
    name = f"{constraint.name} " if constraint.name[-1:].isalpha() else constraint.name  # 1x, but "cylinder x"
    return [Position(f"{name}{axis}", a - b, "zero", closes=True) for axis, a, b in zip("xy", left, right, strict=True)]


def _own_names(positions: list[Position], taken: set[str]) -> list[Position]:
    """Return positions whose names no other equation has: the loop 2 beside an equation that the file calls 2x is 2x', 2y."""
    found = []
    for one in positions:
        name = one.name
        while name in taken:
            name += "'"
        taken.add(name)
        found.append(replace(one, name=name))
    return found


def _closure_positions(variant: Variant, symbols: Symbols) -> list[Position]:
    parts = followed(variant).items()
    kept = [Position(f"{point}.{axis}", symbols.vectors[point]["xy".index(axis)], law) for law, (point, axis) in parts]
    for index, (formula, closes) in enumerate(zip(variant.holds, closed_loops(variant), strict=True), start=1):
        plain = formula.op == "part" and formula.args[0].op == "name"
        name = f"{formula.args[0].name}.{formula.name}" if plain else say("place.hold", index=index)
        with placed(variant, f"closure.holds.{index}", variant.line_of("closure", "holds", index - 1)):
            expression, unit = symbols.scalar(formula), unit_of(formula, variant)
            written = "" if plain else spelled(on_axes(formula))
            kept.append(Position(name, expression, "start", unit, written if len(written) <= _LONGEST_WRITTEN else "", closes))
    return kept


def _reason(position: Position) -> str:
    if position.target == "start":
        return say("equation.keeps", name=position.name)
    return say("equation.follows", name=position.name, drive=position.target)


def _derived(position: Position, because: str, variant: Variant, symbols: Symbols, line: int = 0) -> VelocityEquation:
    moved = rate_of(position.expression, variant, symbols)
    drive = ZERO if position.target in {"zero", "start"} else symbol(position.target)
    return VelocityEquation(position.name, because, dict(moved.coefficients), drive - moved.rest, line=line)


def _written(constraint: Constraint, variant: Variant, symbols: Symbols) -> VelocityEquation:
    unknown = set(variant.sought)
    for side, other in (constraint.sides, constraint.sides[::-1]):
        if side.op == "/" and unknown & {*side.args[1].names()} and unknown.isdisjoint(other.names()):
            multiplied = f"{spelled(side.args[0])} = {with_sign(Formula('*', (other, side.args[1])))}"
            raise _non_linear(side, unknown & {*side.names()}, say("equation.linear.quotient", equation=multiplied))
    gap = _linear(constraint.left, unknown, symbols).plus(_linear(constraint.right, unknown, symbols), MINUS)
    names = [name for name in variant.sought if name in gap.coefficients]
    # Where a denominator is zero the equation says nothing, and the motion that it describes may well go on.
    moving = frozenset(symbol(one.name) for one in variant.coordinates)
    *slopes, rest = without_denominators([*[gap.coefficients[name] for name in names], -gap.rest], moving)
    coefficients = dict(zip(names, slopes, strict=True))
    return VelocityEquation(constraint.name, constraint.because, coefficients, rest, constraint.sides, constraint.line)


_WHERE = {"*": "product", "/": "denominator", "^": "power", "call": "function"}


def _non_linear(tree: Formula, names: set[str], advice: str = "") -> FormulaFault:
    """Return the fault of a velocity equation that is not linear in the unknown velocities, with special advice if given."""
    where = say(f"equation.within.{_WHERE[tree.op]}")
    of_size = tree.op == "^" or tree.name in {"sqrt", "abs"}
    advice = advice or say(
        f"equation.linear.{'size' if of_size else 'angle' if tree.op == 'call' else 'factor'}", function=tree.name
    )
    told = say("fault.V402", names=tuple(sorted(names)), where=where, text=spelled(tree)[:60], advice=advice)
    return FormulaFault(tree.column, told)


def _linear(tree: Formula, unknown: set[str], symbols: Symbols) -> Speed:
    """Return a scalar formula as a linear sum over the unknown velocities."""
    inside = unknown & set(tree.names())
    if not inside:
        return Speed({}, symbols.scalar(tree))
    if tree.op == "name":
        return speed_of(tree.name, unknown)
    if tree.op == "neg":
        return STILL.plus(_linear(tree.args[0], unknown, symbols), MINUS)
    if tree.op in {"+", "-"}:
        first, second = (_linear(arg, unknown, symbols) for arg in tree.args)
        return first.plus(second, ONE if tree.op == "+" else MINUS)
    if tree.op in {"*", "/"}:
        carrier, factor = tree.args
        if tree.op == "*" and not unknown & set(carrier.names()):
            carrier, factor = factor, carrier
        if unknown & set(factor.names()):
            raise _non_linear(tree, inside)
        scale = symbols.scalar(factor) if tree.op == "*" else 1 / symbols.scalar(factor)
        return STILL.plus(_linear(carrier, unknown, symbols), scale)
    raise _non_linear(tree, inside)
