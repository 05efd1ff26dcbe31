"""Links that turn as one, such as two gears of one shaft: they have one rate and a common point.

Where an angle is counted clockwise, its link turns at minus the rate and is fixed to none that turns at the rate itself.
Enters: the links of a file, its points.  Leaves: the pairs that are fixed to each other; the first part of each body.
Used by `joints.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations

from coursework.variant.formula.tree import Formula, signed
from coursework.variant.record.entries import Link


def fixed_links(
    links: Sequence[Link], points: Mapping[str, Formula], angle_of: Mapping[str | None, str]
) -> Iterator[tuple[str, str, str]]:
    """Yield two links and their common point for each link that turns as one with an earlier one.

    `angle_of` gives the coordinate of a rate.

    >>> gear = Link("1", (), "w1", "O", "P", None)
    >>> others = [Link("2", ("O", "A"), "w1", None, None, None), Link("3", ("O",), "w3", None, None, None)]
    >>> [*fixed_links([gear, *others], {}, {})]
    [('1', '2', 'O')]
    """
    pairs: list[tuple[str, str]] = []
    for place, link in enumerate(links):
        for other in links[:place]:
            first = first_parts((one.name for one in links), pairs)
            shared = next((point for point in other.held if point in link.held), None)
            alike = link.rate == other.rate and first[other.name] != first[link.name]
            if link.rate and alike and shared and not _against(link, other, points, angle_of.get(link.rate, "")):
                pairs.append((other.name, link.name))
                yield other.name, link.name, shared


def _against(link: Link, other: Link, points: Mapping[str, Formula], angle: str) -> bool:
    """Return whether a coordinate turns one link counter-clockwise and the other clockwise, by vectors between their points."""
    return {_sense(link, points, angle), _sense(other, points, angle)} == {1, -1}


def _sense(link: Link, points: Mapping[str, Formula], angle: str) -> int:
    """Return the sign with which an angle turns a link, 0 if it has not one."""
    signs = set[int]()
    for one, two in combinations([_terms(name, points) for name in link.held], 2):
        between = (term for term in {*one} | {*two} if one[term] != two[term])
        nodes = (node for term in between for node in term.walk() if node.op == "@")
        signs |= {sign for node in nodes for term, sign in signed(node.args[1]) if term.name == angle}
    return signs.pop() if len(signs) == 1 else 0


def _terms(point: str, points: Mapping[str, Formula]) -> Counter[Formula]:
    """Return the terms of which a point is the sum, those of other points in place of their names."""
    found = Counter[Formula]()
    for term, sign in signed(points[point]) if point in points else ():
        for part, times in _terms(term.name, points).items() if term.op == "name" and term.name in points else ((term, 1),):
            found[part] += sign * times
    return found


def first_parts(bodies: Iterable[str], pairs: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Return for each body the first of all those that pairs fix to it, itself if there is none.

    >>> first_parts(["1", "2", "3", "4"], [("2", "4"), ("1", "4")])
    {'1': '1', '2': '1', '3': '3', '4': '1'}
    """
    first = {body: body for body in bodies}
    order = [*first]
    for one, other in pairs:
        kept, lost = sorted((first[one], first[other]), key=order.index)
        first = {body: kept if own == lost else own for body, own in first.items()}
    return first
