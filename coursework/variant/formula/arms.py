"""Vectors written by components -> lengths at angles: (A.x + r*sin(phi), A.y - r*cos(phi)) is A + r @ (phi - pi/2).

Whatever reads the geometry of a file then meets one notation of an arm.  Enters and leaves: `Formula`.  Used by `parts.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction

from coursework.system.frozen import frozen
from coursework.variant.formula.made import part_of_pi, quotient_of, summed
from coursework.variant.formula.tree import Formula, factors, mapped, named, number, on_axes, signed

_Term = tuple[Formula, int]  # with its sign


@frozen
class _Side:
    """A component such as -r*sin(phi) without its sign: the function "sin", the `angle`, and what stands before it."""

    function: str
    angle: Formula
    length: tuple[_Term, ...]  # factors with their powers


def with_arms(tree: Formula) -> Formula:
    """Return a formula in which components that make a length at an angle, or are those of a point, stand together.

    >>> from coursework.variant.formula.reader import parse
    >>> from coursework.variant.formula.tree import spelled
    >>> for text in ("(d - r*cos(phi), r*sin(phi))", "A + r*(sin(phi), cos(phi))", "(s, h*cos(phi))"):
    ...     print(spelled(with_arms(parse(text, vectors=True))))
    (d, 0) + r @ (pi - phi)
    A + r @ (pi/2 - phi)
    (s, h*cos(phi))
    """
    if tree.op in {"*", "/"}:
        return _factored(tree)
    if tree.op != "pair":
        return mapped(tree, with_arms)
    across, beside = ([*signed(on_axes(side))] for side in tree.args)
    waiting: dict[object, list[_Term]] = {}
    for other in beside:
        waiting.setdefault(_shared(other, "y"), []).append(other)
    found: list[_Term] = []
    rest: list[_Term] = []
    for one in across:
        shared = _shared(one, "x")
        partners = waiting.get(shared) if shared is not None else None
        if partners:
            found.append(_vector(one, partners.pop(0)))
        else:
            rest.append(one)
    if not found:
        return tree
    points = [one for one in found if one[0].op != "@"]
    arms = [one for one in found if one[0].op == "@"]
    return summed([*points, *_rest(rest, [one for others in waiting.values() for one in others], tree.column), *arms])


def _factored(tree: Formula) -> Formula:
    """Return the length at an angle that a product such as e*(sin(b), cos(b)) or r/2*(1 @ phi) is; else the product, mapped."""
    parts = [*factors(tree, {"*", "/"})]
    vectors = [with_arms(part) for part, power in parts if part.op in {"pair", "@"} and power > 0]
    if len(vectors) != 1 or vectors[0].op != "@":
        return mapped(tree, with_arms)
    own, angle = vectors[0].args
    scales = [one for one in parts if one[0].op not in {"pair", "@"}]
    return Formula("@", (quotient_of((*scales, *((own, 1) for _ in range(own != number(1))))), angle), column=tree.column)


def _shared(one: _Term, axis: str) -> object:
    """Return what the components of one vector have in common, None if the term is no such component.

    That is a point and its sign; or an angle, the factors of a length, and which function stands along x.
    """
    term, sign = one
    if term.op == "part":
        return (term.args, sign) if term.name == axis else None
    side = _side(term)
    if side is None:
        return None
    return side.angle, frozenset(Counter(side.length).items()), (side.function == "cos") == (axis == "x")


def _rest(across: Sequence[_Term], beside: Sequence[_Term], column: int) -> Iterator[_Term]:
    """Yield the vector of what is left of two components, if anything is; one along an axis has no minus inside."""
    terms = [*across, *beside]
    if terms:
        sign = -1 if not (across and beside) and all(sign < 0 for _, sign in terms) else 1
        sides = (summed([(term, own * sign) for term, own in side]) for side in (across, beside))
        yield Formula("pair", tuple(sides), column=column), sign


def _vector(across: _Term, beside: _Term) -> _Term:
    """Return the vector with these two components, a point or a length at an angle."""
    (x, along), (_, up) = across, beside
    first = _side(x)
    if first is None:
        return x.args[0], along
    if first.function == "cos":
        sense, axis = along * up, [] if along > 0 else [(named("pi"), 1)]
    else:
        sense, axis = -along * up, [(part_of_pi(Fraction(1, 2)), up)]
    turned = [(term, sign * sense) for term, sign in signed(first.angle)]
    angle = summed([*turned, *axis] if turned[0][1] > 0 else [*axis, *turned])
    return Formula("@", (quotient_of(first.length), angle), column=x.column), 1


def _side(term: Formula) -> _Side | None:
    """Return a component of an arm, None for a formula that is not a product with one sine or cosine."""
    parts = [*factors(term, {"*", "/"})]
    turning = [part for part, power in parts if part.op == "call" and part.name in {"cos", "sin"} and power > 0]
    if len(turning) != 1:
        return None
    (part,) = turning
    return _Side(part.name, part.args[0], tuple(one for one in parts if one[0] is not part))
