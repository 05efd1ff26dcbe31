"""Names that a student writes but the variant does not have -> their meanings: a length by its end points, c3, own names.

Enters: the variant, names.  Leaves: checked formulas by name, which replace the names.
Used by `equations.py`.  Sizes are limited: a replaced name counts as if its formula had been typed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import combinations

from coursework.grading.reading.equations.formulas.names_in_text import plain_name
from coursework.grading.reading.expected import Expected
from coursework.mechanism.mechanism import build
from coursework.variant.dimensions.exponents import LENGTH
from coursework.variant.formula.reader import MAX_NODES
from coursework.variant.formula.tree import Formula, constant, mapped, named, number, terms, with_names, with_points
from coursework.variant.record.places import has_one_dimension, measures
from coursework.variant.record.variant import Variant

Meanings = Mapping[str, Formula]
_SAME = 1e-9
_IN_A_METRE = (1000, 100)  # mm, cm
_FACTOR = 2  # numbers up to this are factors and no lengths in mm or cm, as are those up to such a part of the shortest length
_LEAST_LENGTH = 0.02
_SHORT = {"c": "cos", "s": "sin", "C": "cos", "S": "sin", "cos": "cos", "sin": "sin"}
_KINDS = {**dict.fromkeys(("theta", "psi", "alpha", "beta", "gamma", "q", "p"), "rad"), **dict.fromkeys(("l", "L"), "m")}
_END_POINTS = re.compile(r"[|\s]*([A-Z]\w?'?)\s*-?\s*([A-Z]\w?'?)[|\s]*")
_LENGTH = re.compile(r"(?:[lLr]_?)?(.+)")


def meaning_of(name: str, expected: Expected, own: Meanings) -> Formula | None:
    """Return the meaning of a name that the variant does not have, None if it is unknown; `own` are the student's definitions."""
    plain = plain_name(name)
    if plain in own:
        return own[plain]
    starts = tuple((column.name, column.values[0]) for column in expected.grid.columns if column.values)
    lengths = _lengths(expected.variant, starts)
    return lengths.get(plain) or lengths.get(_LENGTH.sub(r"\1", plain)) or _of_index(plain, expected.variant)


def _of_index(name: str, variant: Variant) -> Formula | None:
    """Return cos φ₃ for c3, sin φ₃ for s3, φ₃ for θ₃, r₃ for l₃ if only one angle or length has this index; else None."""
    kind, index = name.rstrip("0123456789"), name[len(name.rstrip("0123456789")) :]
    if index and (unit := _KINDS.get(kind)):
        alike = _with_index(variant, unit, index)
        return named(alike[0]) if len(alike) == 1 else None
    for short, function in sorted(_SHORT.items(), reverse=True):
        index = name.removeprefix(short)
        if index != name and index in {one.name for one in variant.coordinates if one.unit == "rad"}:  # s_{φ3}
            return Formula("call", (named(index),), name=function)
        if index and index != name and index.isdigit():
            angles = _with_index(variant, "rad", index)
            return Formula("call", (named(angles[0]),), name=function) if len(angles) == 1 else None
    return None


def _with_index(variant: Variant, unit: str, index: str) -> list[str]:
    """Return the names of the angles (`unit` rad) or of the data that are lengths (m), with this index."""
    angles = [one.name for one in variant.coordinates if one.unit == unit]
    names = angles if unit == "rad" else [one.name for one in variant.given if one.si == unit]
    return [name for name in names if re.sub(r"\D", "", name) == index]


@lru_cache(maxsize=16)
def _lengths(variant: Variant, starts: tuple[tuple[str, float], ...]) -> Meanings:
    """Return lengths by pairs of point names in both orders: from the data's descriptions, the geometry, or equal distances."""
    found: dict[str, Formula] = {}

    def offer(first: str, second: str, length: Formula) -> None:
        for pair in (first + second, second + first):
            if pair not in variant.names:
                found.setdefault(pair, length)

    for given in variant.given:
        if given.si == "m" and (ends := _END_POINTS.fullmatch(given.means)):
            offer(ends[1], ends[2], named(given.name))
    points = dict(build(variant).points)
    for name, formula in points.items():
        parts = list(terms(formula))
        base = next((part.name for part in parts if part.op == "name" and part.name in points), "")
        for part in (part for part in parts if base and len(parts) == 2 and part.op in {"@", "pair"}):
            sides = part.args[:1] if part.op == "@" else [side for side in part.args if constant(side) != 0]
            if len(sides) == 1 and sides[0].op != "neg":
                offer(base, name, sides[0])
    placed = with_points({"t": 0.0, **variant.values, **dict(starts)}, points.items())  # in the first row of the table
    for first, second in combinations([name for name in points if name in placed], 2):
        distance = abs(placed[first] - placed[second])
        alike = [given.name for given in variant.given if given.si == "m" and abs(given.value - distance) <= _SAME * distance]
        if distance and len(alike) == 1:
            offer(first, second, named(alike[0]))
    return found


def put_in(tree: Formula, meanings: Mapping[str, Formula]) -> Formula | None:
    """Return a tree with names replaced by their meanings, None if it gets larger than a typed formula may be."""

    def changed(name: Formula) -> Formula:
        return _at(meanings[name.name], name.column) if name.name in meanings else name

    grown = sum(sum(1 for _ in meanings[node.name].walk()) for node in tree.walk() if node.op == "name" and node.name in meanings)
    return with_names(tree, changed) if grown <= MAX_NODES else None


def in_smaller_units(tree: Formula, variant: Variant) -> Iterator[Formula]:
    """Yield a tree of symbols and numbers as it is meant if its lengths are in mm, or in cm: each symbol has that many more.

    So is pi*n/30: beside pi the data that are speeds of rotation are in turns a minute.
    """
    speeds = {one.name for one in variant.given if one.si in {"1/s", "rad/s"}} & {*tree.names()}
    if speeds and "pi" in tree.names():
        turns = Formula("/", (number(30), named("pi")))
        tree = with_names(tree, lambda name: Formula("*", (name, turns)) if name.name in speeds else name)
        yield tree
    lengths = _with_lengths(variant)
    if lengths.keys().isdisjoint(tree.names()):
        return
    for factor in _IN_A_METRE:
        # Beside lengths in mm a term without one, as in … + w1, would be small enough to pass as rounding.
        if not _has_a_length_in_each_term(tree, variant, factor):
            continue

        def scaled(name: Formula, factor: int = factor) -> Formula:
            exponent = lengths.get(name.name)
            return Formula("*" if exponent == 1 else "/", (name, number(factor))) if exponent else name

        yield with_names(tree, scaled)


def _has_a_length_in_each_term(tree: Formula, variant: Variant, factor: int) -> bool:
    """Return whether some number in a line is a length in mm or cm, and whether no term lacks a length that others have."""
    least = max(_FACTOR, factor * _LEAST_LENGTH * min((one.value for one in variant.given if one.si == "m"), default=0.0))
    is_length = [node.op == "number" and abs(node.value) > least for node in tree.walk()]
    if not any(is_length):
        return False

    def told(node: Formula) -> Formula:
        """Return a formula whose small numbers are plain ones; those in arguments, sin(13.08*t), may have any unit."""
        if node.op == "call" and node.name != "sqrt":
            return node
        return replace(node, si="rad") if node.op == "number" and 0 < node.value <= least else mapped(node, told)

    return has_one_dimension(told(tree), variant)


@lru_cache(maxsize=16)
def _with_lengths(variant: Variant) -> Mapping[str, int]:
    """Return the names of which a length is a part, with its exponent, 1 or -1."""
    return {name: int(power) for name, unit in measures(variant).items() if (power := unit.get(LENGTH, 0)) in {1, -1}}


def _at(tree: Formula, column: int) -> Formula:
    return replace(mapped(tree, lambda arg: _at(arg, column)), column=column)
