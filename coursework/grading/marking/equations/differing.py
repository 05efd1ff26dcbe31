"""Which term of a wrong line is wrong, if no single slip of the pen is found: one too many, another factor, or one missing.

Enters: a wrong equation as a tree, a `Probe`.  Leaves: `Difference`.  Used by the desk.
The residual of the line at the points of the probe is compared with the line's own terms, then with terms in one velocity. Their
coefficient is a number, or a sine and cosine of an angle or of a difference of two; a length that varies may multiply either.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Literal

import numpy as np

from coursework.grading.marking.equations.edits import Edit, Values, column_of, places
from coursework.grading.marking.equations.linear import Linear, is_same, linear
from coursework.grading.marking.equations.numbers import NoValue, are_same, real, value_of
from coursework.grading.marking.equations.probe import POINTS, Probe
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named, number, replaced
from coursework.variant.record.variant import Variant

_SAME = 1e-8  # relative difference up to which two quantities agree at all points of a probe


@frozen
class Difference:
    """How a line differs: `term` is the wrong term ("extra", "factor"), or the velocity whose term is missing or another one.

    `column` is its place in the line, 0 if it has none.
    """

    kind: Literal["extra", "factor", "missing", "other"]
    term: Formula
    column: int = 0


def difference_of(tree: Formula, variant: Variant, probe: Probe, others: Sequence[Linear]) -> Difference | None:
    """Return the one term that makes a line (`left - right`) wrong, None if no single term explains it.

    A change that turns the line into one of the `others`, which are right already, does not count as an explanation.
    """
    try:
        values = Values(tree, probe.names)
        left = real(value_of(tree, probe.names), probe.count)
        line = linear(tree, probe)
    except NoValue:
        return None
    if probe.count < POINTS or not np.all(np.isfinite(left)) or not line.is_affine or not np.any(left):
        return None
    return _own_term(tree, values, left, probe, others) or _lacking(tree, variant, left, line.slopes, probe)


def _own_term(tree: Formula, values: Values, left: Array, probe: Probe, others: Sequence[Linear]) -> Difference | None:
    """Return the term to which the residual `left` is proportional; it is one too many if the residual equals it."""
    found = []
    for path, node, is_term, _ in places(tree):
        if not is_term or not _is_linear(tree, path):
            continue
        without = Edit("factor", path, number(0), column_of(node))
        rest = values.after(without)
        if rest is None or np.iscomplexobj(rest) or not np.all(np.isfinite(rest)):
            continue
        part = left - rest
        size = float(np.dot(part, left) / (np.dot(part, part) or np.inf))
        if not size or not are_same(size * part, left, _SAME):
            continue
        is_extra = abs(size - 1) <= _SAME
        other = number(0) if is_extra else Formula("*", (number(Fraction(1 - size)), node))
        mended = linear(replaced(tree, path, other), probe)
        if np.any(mended.directions) and not any(is_same(mended, one) for one in others):
            found.append((not is_extra, -len(path), without.column, node))  # a part of a sum comes before the whole sum
    if not found:
        return None
    is_part, _, column, term = min(found, key=lambda one: one[:3])
    return Difference("factor" if is_part else "extra", term, column)


def _is_linear(tree: Formula, path: Sequence[int]) -> bool:
    """Return whether a formula is linear in the node that `path` leads to."""
    for place in path:
        if tree.op not in {"+", "-", "neg", "*", "/"} or (tree.op == "/" and place):
            return False
        tree = tree.args[place]
    return True


def _lacking(tree: Formula, variant: Variant, left: Array, slopes: Array, probe: Probe) -> Difference | None:
    """Return the missing term, by its velocity: the simplest coefficient first, then a velocity that the line does not name."""
    written = {node.name: column_of(node) for node in reversed([*tree.walk()]) if node.op == "name"}
    driven = [*(law.name for law in variant.drive), *variant.known_rates]
    found = []
    for name in dict.fromkeys([*probe.sought, *driven]):
        velocity = np.broadcast_to(np.asarray(probe.names[name], dtype=float), left.shape)
        if not np.all(velocity):
            continue
        term = -left / velocity
        sizes = _sizes(term, variant, probe)
        if sizes is None or (name in probe.sought and _nothing_left(slopes, probe.sought.index(name), term)):
            continue
        found.append((sizes, name in written, name))
    if not found:
        return None
    size, is_written, name = min(found)
    is_other = is_written and size > 1  # b*cos - a*sin makes up for one of the two written instead of the other
    return Difference("other" if is_other else "missing", named(name), written[name] if is_other else 0)


def _nothing_left(slopes: Array, place: int, term: Array) -> bool:
    """Return whether the line with the new term would be 0 = 0: all its coefficients of velocities vanish."""
    after = slopes.copy()
    after[:, place] += term
    return bool(np.all(np.abs(after) <= _SAME * np.max(np.abs(slopes))))


def _sizes(term: Array, variant: Variant, probe: Probe) -> int | None:
    """Return how many functions of one simple basis add up to the coefficient `term`, None if no basis fits."""
    for basis in _simple(variant, probe):
        sizes = np.linalg.lstsq(basis, term, rcond=None)[0]
        if are_same(basis @ sizes, term, _SAME):
            return int(np.sum(np.abs(sizes) > _SAME * np.max(np.abs(sizes))))
    return None


def _simple(variant: Variant, probe: Probe) -> Iterator[Array]:
    ones = np.ones(probe.count)
    yield ones[:, None]
    of = {unit: [probe.names[one.name] for one in variant.coordinates if one.unit == unit] for unit in ("rad", "m")}
    angles = [*of["rad"], *(one - other for one, other in combinations(of["rad"], 2))]
    for length in (ones, *of["m"]):
        yield length[:, None]
        yield from (np.column_stack([length * np.sin(angle), length * np.cos(angle)]) for angle in angles)
