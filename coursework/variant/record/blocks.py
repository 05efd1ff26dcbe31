"""Blocks and racks: links that do not turn, given by one point or by points that keep their places beside each other.

Enters: a `Variant`.  Leaves: the link of each of their points.  Used by `joints.py` and `unused.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from coursework.variant.formula.tree import Formula, signed
from coursework.variant.record.entries import Link
from coursework.variant.record.variant import Variant


def blocks_of(variant: Variant) -> dict[str, str]:
    r"""Return the link of each point of a block or rack: on a guide such a link slides and cannot turn.

    >>> import coursework
    >>> from coursework.variant.catalogue import load
    >>> text = load("v112").path.read_text(encoding="utf-8").replace('points = ["C"] ', 'points = ["C", "B"] ')
    >>> blocks_of(coursework.parse_variant(text.replace("[links]", 'B = "C + (2*R, 0)"\n[links]', 1)))
    {'C': '5', 'B': '5'}
    """
    points = dict(variant.points)
    still = {"pi", *variant.values}
    return {
        name: link.name for link in variant.links
        if link.points and not (link.rate or link.wheel or link.slides) and _moves_as_one(link, points, still)
        for name in link.points
    }  # fmt: skip


def _moves_as_one(link: Link, points: Mapping[str, Formula], still: set[str]) -> bool:
    """Return whether the points of a link differ by constant vectors alone."""
    if len(link.points) == 1 or not points.keys() >= {*link.points}:
        return len(link.points) == 1
    first, *others = (_moving(points[name], points, still) for name in link.points)
    return all(other == first for other in others)


def _moving(formula: Formula, points: Mapping[str, Formula], still: set[str]) -> dict[tuple[str, Formula], int]:
    """Return what moves a point: each moving term of its sum, on both axes or on one, with its factor."""
    found: Counter[tuple[str, Formula]] = Counter()
    for axis, term, sign in _terms(formula, points):
        if not still.issuperset(term.names()):
            found[axis, term] += sign
    return {key: factor for key, factor in found.items() if factor}


def _terms(formula: Formula, points: Mapping[str, Formula], outer: int = 1) -> Iterator[tuple[str, Formula, int]]:
    for term, sign in signed(formula, outer):
        if term.op == "name" and term.name in points:
            yield from _terms(points[term.name], points, sign)
        elif term.op == "pair":
            yield from ((axis, one, way) for axis, part in zip("xy", term.args, strict=True) for one, way in signed(part, sign))
        else:
            yield "", term, sign
