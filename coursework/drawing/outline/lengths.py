"""Lengths between two points that a file gives, found in its formulas.

Enters: a `Mechanism`.  Leaves: formulas by pairs of points.
Used by `tracing.py`, `naming.py`, `dimensions.py` and `drawing/plans/plans.py`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Container, Iterator, Mapping
from contextlib import suppress
from itertools import combinations, permutations
from string import ascii_uppercase

from coursework.mechanism.groups import group_kind
from coursework.mechanism.mechanism import Mechanism
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate_any, named, signed, terms, with_points
from coursework.variant.record.held import held_vectors, is_gap, is_origin
from coursework.variant.record.variant import Variant

# The terms of an angle that move, with their signs.
Turning = frozenset[tuple[Formula, int]]
_TWO, _MOST_POINTS = Formula("number", name="2"), 40
_SHARES, _SAME = (0.6180339887498949, 0.7548776662466927), 1e-9  # shares of 1: coordinates taken at random


def arm_base(formula: Formula, coordinate: str) -> str:
    """Return X of a point "X + L @ angle" whose angle contains the coordinate, "" for any other formula."""
    parts = [*terms(formula)]
    if len(parts) != 2 or parts[0].op != "name" or parts[1].op != "@":
        return ""
    return parts[0].name if coordinate in parts[1].args[1].names() and coordinate not in parts[1].args[0].names() else ""


def rigid_arm(formula: Formula, moving: Container[str]) -> tuple[str, Turning] | None:
    """Return X of a point "X + L @ angle" or "X + a @ angle + b @ (angle + pi/2)" of one link, and how the link turns.

    None for any other formula; `moving` are the coordinates.
    """
    base, *arms = terms(formula)
    if base.op != "name" or any(arm.op != "@" or any(name in moving for name in arm.args[0].names()) for arm in arms):
        return None
    turned = {
        frozenset((term, sign) for term, sign in signed(arm.args[1]) if any(name in moving for name in term.names()))
        for arm in arms
    }
    return (base.name, turned.pop()) if len(turned) == 1 else None


def gaps_of(variant: Variant) -> list[Formula]:
    """Return the sums of vectors that a file holds at zero along one axis or both, such as C - B - r @ phi."""
    points = {name for name, _ in variant.points}
    along_one = (hold.args[0] for hold in variant.holds if hold.op == "part" and is_gap(hold.args[0], points))
    return [*dict.fromkeys((*along_one, *held_vectors(variant)))]


def unnamed_joints(mechanism: Mechanism) -> dict[str, tuple[Formula, Formula]]:
    """Return both sides of each closure "B + r2 @ phi2 = D + r3 @ phi3" at a joint that has no point, by the next free letter."""
    variant, points = mechanism.variant, dict(mechanism.points)
    taken = {*points, *variant.values, *(coordinate.name for coordinate in variant.coordinates)}
    free = (letter for letter in ascii_uppercase if letter not in taken)
    sides = [one.sides for one in mechanism.constraints if one.is_closure]
    arms = [both for both in sides if all([part.op for part in terms(side)] == ["name", "@"] for side in both)]
    ways = _ways(mechanism) if arms else {}
    unnamed = (both for both in arms if not any(_steps(side, ways) in ways.values() for side in both))
    return dict(zip(free, unnamed, strict=False))


def lengths(mechanism: Mechanism) -> dict[frozenset[str], Formula]:
    """Return the length formulas by pair of points, as in "B = A + r2 @ phi2", "P = C - (0, R)" or a group.

    If a point lies at the origin, "D = (d, 0)" and "A = r @ phi" give their distance from that point too.
    """
    variant = mechanism.variant
    minus = [Formula("-", (named(name), formula)) for name, formula in mechanism.points]
    for group in variant.groups:
        met = named(group.meets or "")
        minus += [Formula("-", (met, side)) for side in group_kind(group.kind).closure(group)[0] if group.meets]
    for joint, sides in unnamed_joints(mechanism).items():
        minus += [Formula("-", (named(joint), side)) for side in sides]
    minus += gaps_of(variant)
    found: dict[frozenset[str], Formula] = {}
    for formula in minus:
        parts = [*terms(formula)]
        ends = frozenset(part.name for part in parts if part.op == "name")
        said = [length for part in parts if part.op != "name" and (length := _length(part)) is not None]
        if len(parts) == 3 and len(ends) == 2 and len(said) == 1:
            found.setdefault(ends, said[0])
    for ends, length in (*_across_loops(mechanism), *squared_lengths(mechanism)):
        found.setdefault(ends, length)
    return found


def _across_loops(mechanism: Mechanism) -> Iterator[tuple[frozenset[str], Formula]]:
    """Yield the lengths of vectors between two points, of a loop too: c in A + a @ q1 + b @ q2 = D + f @ q4 + c @ q3."""
    ways = _ways(mechanism)
    loops = [Formula("-", one.sides) for one in mechanism.constraints if one.is_closure]
    wholes = [Counter(), *(_steps(one, ways) for one in (*loops, *held_vectors(mechanism.variant)))]
    vectors = [*dict.fromkeys(step for steps in (*wholes, *ways.values()) for step in steps)]
    # Counted in the order of `vectors`: to ask a formula its hash takes as long as all the rest.
    counts = {name: [way[step] for step in vectors] for name, way in ways.items()}
    for around in [[whole[step] for step in vectors] for whole in wholes]:
        for (first, one), (last, other) in permutations(counts.items(), 2):
            left = [whole - before + behind for whole, before, behind in zip(around, one, other, strict=True)]
            rest = [place for place, times in enumerate(left) if times]
            if len(rest) == 1 and abs(left[rest[0]]) == 1 and (length := _length(vectors[rest[0]])) is not None:
                yield frozenset((first, last)), length


def _ways(mechanism: Mechanism) -> dict[str, Counter[Formula]]:
    """Return for each point the vectors that lead to it from the origin."""
    ways: dict[str, Counter[Formula]] = {}
    for name, formula in mechanism.points[:_MOST_POINTS]:
        ways[name] = _steps(formula, ways)
    return ways


def _steps(formula: Formula, ways: Mapping[str, Counter[Formula]]) -> Counter[Formula]:
    """Return the vectors that lead to a point, each with how often it is added; a point stands for those that lead to it."""
    steps: Counter[Formula] = Counter()
    for term, sign in signed(formula):
        own = ways.get(term.name, {term: int(not is_origin(term))})
        for step, times in own.items():
            steps[step] += sign * times
    return steps


def squared_lengths(mechanism: Mechanism) -> Iterator[tuple[frozenset[str], Formula]]:
    """Yield the lengths that a file gives by their squares, x^2 + y^2 - r^2, however the square of a distance is written."""
    variant = mechanism.variant
    sums = [*variant.holds, *(Formula("-", one.sides) for one in mechanism.constraints if one.is_closure)]
    squares = [
        (one, sign, part.args[0])
        for one in sums
        for part, sign in signed(one)
        if part.op == "^" and part.args[1] == _TWO and variant.values.keys() >= {*part.names()}
    ]
    poses = [_anywhere(mechanism, share) for share in _SHARES] if squares else []
    for one, sign, length in squares:
        for ends in combinations([name for name, _ in mechanism.points][:_MOST_POINTS], 2):
            with suppress(FormulaFault, KeyError):  # a law of time has no value here
                if all(_is_square(one, sign, abs(pose[ends[0]] - pose[ends[1]]), length, pose) for pose in poses):
                    yield frozenset(ends), length


def _is_square(formula: Formula, sign: int, apart: float, length: Formula, pose: Mapping[str, complex]) -> bool:
    wanted = -sign * (apart**2 - evaluate_any(length, pose).real ** 2)
    return math.isclose(evaluate_any(formula, pose).real, wanted, rel_tol=_SAME, abs_tol=_SAME)


def _anywhere(mechanism: Mechanism, share: float) -> dict[str, complex]:
    """Return the points (x + iy) and all other names in a position that need not close, each coordinate another number."""
    pose: dict[str, complex] = {**mechanism.variant.values, "pi": math.pi}
    pose |= {one.name: 1 + share * place % 1 for place, one in enumerate(mechanism.variant.coordinates, start=1)}
    return with_points(pose, mechanism.points)


def stretching(mechanism: Mechanism) -> frozenset[frozenset[str]]:
    """Return the pairs of points whose distance can change, because a coordinate, a function or t occurs in it."""
    variant = mechanism.variant
    changing = {c.name for c in variant.coordinates} | {law.name for law in (*variant.functions, *variant.drive)} | {"t"}
    return frozenset(ends for ends, length in lengths(mechanism).items() if changing & set(length.names()))


def _length(part: Formula) -> Formula | None:
    if part.op == "@":
        return part.args[0]
    if part.op == "pair":
        x, y = part.args
        zero = [arg.op == "number" and arg.value == 0 for arg in (x, y)]
        length = y if zero[0] else x
        return None if sum(zero) != 1 else length.args[0] if length.op == "neg" else length
    return None
