"""A closed contour of a chain: its vector equation and its two projections.

Enters: a `Mechanism` whose constraints are closures.  Leaves: `Contour`, in formulas.  Used by `motion_equations.py`.
Source: [library] writes a group in this way: one closed vector contour, two projections, their derivatives.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from coursework.mechanism.derivation.segments import ZERO
from coursework.mechanism.mechanism import Mechanism
from coursework.system.frozen import frozen
from coursework.variant.formula.made import sum_of
from coursework.variant.formula.tree import Formula, constant, evaluate
from coursework.variant.record.entries import reached

Pair = tuple[Formula, Formula]
RIGHT = 1e-12  # tolerance for a multiple of a right angle, in right angles


@frozen
class Contour:
    """One closure: the `name` of its constraint, and both sides, as vectors and as (x, y)."""

    name: str
    left: Formula
    right: Formula
    left_parts: Pair
    right_parts: Pair


def contours_of(mechanism: Mechanism) -> tuple[Contour, ...]:
    """Return the vector closures in the order of the chain; points that no coordinate moves are replaced by their formulas.

    >>> import coursework
    >>> [one.name for one in contours_of(coursework.solve("example-3", quantities=["table"]).scene.mechanism)]
    ['G2', 'G3']
    """
    coordinates = {coordinate.name for coordinate in mechanism.variant.coordinates}
    points = dict(mechanism.points)
    moved = {name for name in points if coordinates & reached([name], points)}
    found = []
    for one in mechanism.constraints:
        if not one.is_closure:
            continue
        left, right = _without_zeros(one.left), _without_zeros(one.right)
        found.append(Contour(one.name, left, right, _parts(left, points, moved), _parts(right, points, moved)))
    return tuple(found)


def _without_zeros(formula: Formula) -> Formula:
    """Return a formula without zero terms in its sums: a guide along x has the angle 0, a normal to it 0 + pi/2."""
    args = tuple(map(_without_zeros, formula.args))
    if formula.op in {"+", "-"}:
        return sum_of(formula.op, *(ZERO if constant(arg) == 0 else arg for arg in args))
    return replace(formula, args=args)


def _quarters(angle: Formula) -> int | None:
    """Return a fixed angle as a number of right angles (0 to 3), None if it is no multiple of a right angle or not fixed."""
    if set(angle.names()) - {"pi"}:
        return None
    turned = evaluate(angle, {}) / (math.pi / 2)
    return round(turned) % 4 if abs(turned - round(turned)) < RIGHT else None


def _parts(formula: Formula, points: Mapping[str, Formula], moved: set[str]) -> Pair:
    """Return the components of a vector; those of a factor beside it are the factor itself."""
    if formula.op == "name" and formula.name in points:
        if formula.name not in moved:
            return _parts(points[formula.name], points, moved)
        x, y = (Formula("part", (formula,), axis) for axis in "xy")
        return x, y
    if formula.op == "pair":
        return formula.args[0], formula.args[1]
    if formula.op == "@":
        length, angle = formula.args
        if (quarters := _quarters(angle)) is not None:
            far = _negative(length) if quarters > 1 else length
            return (ZERO, far) if quarters % 2 else (far, ZERO)
        cosine, sine = (Formula("*", (length, Formula("call", (angle,), function))) for function in ("cos", "sin"))
        return cosine, sine
    if formula.op not in {"neg", "+", "-", "*", "/"}:
        return formula, formula
    (x, *other_x), (y, *other_y) = zip(*[_parts(arg, points, moved) for arg in formula.args], strict=True)
    if formula.op == "neg":
        return _negative(x), _negative(y)
    join = sum_of if formula.op in {"+", "-"} else _scaled
    return join(formula.op, x, *other_x), join(formula.op, y, *other_y)


def _scaled(sign: str, first: Formula, second: Formula) -> Formula:
    return ZERO if ZERO in {first, second} else Formula(sign, (first, second))


def _negative(formula: Formula) -> Formula:
    return formula if formula == ZERO else Formula("neg", (formula,))
