"""Links that turn as one, such as two gears of one shaft: they have one rate and a common point.

Enters: the links of a file.  Leaves: the pairs that are fixed to each other; the first part of each body.  Used by `joints.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from coursework.variant.record.entries import Link


def fixed_links(links: Sequence[Link]) -> Iterator[tuple[str, str, str]]:
    """Yield two links and their common point for each link that turns as one with an earlier one.

    >>> gear = Link("1", (), "w1", "O", "P", None)
    >>> [*fixed_links([gear, Link("2", ("O", "A"), "w1", None, None, None), Link("3", ("O",), "w3", None, None, None)])]
    [('1', '2', 'O')]
    """
    pairs: list[tuple[str, str]] = []
    for place, link in enumerate(links):
        for other in links[:place]:
            first = first_parts((one.name for one in links), pairs)
            shared = next((point for point in other.held if point in link.held), None)
            if link.rate and link.rate == other.rate and shared and first[other.name] != first[link.name]:
                pairs.append((other.name, link.name))
                yield other.name, link.name, shared


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
