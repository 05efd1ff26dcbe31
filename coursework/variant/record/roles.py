"""The meaning of each key of a group, for the table of kinds, the comments of a draft and messages about missing entries.

Enters: the shape of a kind, and the letters or names of its points.  Leaves: sentences, in the order of the keys in a file.
Used by `groups.py` of `judging/`, `mechanism/drafts/text.py`, `motion/geometry/chain.py` and `commands/line/kinds.py`.

A new kind needs no line here: its keys follow from its shape, and their meanings are in the words files.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.variant.formula.tree import spelled
from coursework.variant.record.entries import Group
from coursework.variant.record.vocabulary import Shape
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


def letters_of(shape: Shape, group: Group) -> dict[str, str]:
    """Return the words for the gaps in sentences about a group of a file: the names of its points, where it has them."""
    points = [*map(spelled, group.start_points[: shape.points])] + [""] * (shape.points - len(group.start_points))
    guides = [spelled(guide.through) for guide in group.guides[: shape.guides]]
    return shape.named([*points, *guides, *[""] * (shape.guides - len(guides)), group.meets or say("group.nameless")])


def title(shape: Shape, letters: Mapping[str, str]) -> Sentence:
    """Return what a group of the kind is."""
    return say(f"{shape.words}.title", **letters)


def role(shape: Shape, key: str, letters: Mapping[str, str], place: int = 0) -> Sentence:
    """Return the meaning of a key; for a list, of its entry number `place` (from 1)."""
    return say(f"{shape.words}.{key}{place or ''}", **letters)


def entries(shape: Shape, key: str, letters: Mapping[str, str], first: int = 1) -> Sentence:
    """Return the meanings of the entries of a list, from number `first` on."""
    count = shape.counts[key][-1]
    if key == "guides" and count == 1:
        return role(shape, "guide", letters)
    return joined((role(shape, key, letters, place) for place in range(first, count + 1)), "join.semicolon")


def roles(shape: Shape, letters: Mapping[str, str]) -> dict[str, Sentence]:
    """Return the meaning of every key of a kind.

    >>> from coursework.variant.record.vocabulary import GROUP_SHAPES
    >>> [*roles(GROUP_SHAPES["RRP"], GROUP_SHAPES["RRP"].named())]
    ['from', 'guide', 'lengths', 'meets', 'coordinates', 'mode']
    """
    found = {}
    if shape.points:
        found["from"] = entries(shape, "from", letters)
    if shape.guides:
        found["guide" if shape.guides == 1 else "guides"] = entries(shape, "guides", letters)
    found |= {key: role(shape, key, letters) for key in shape.also}
    if shape.lengths[-1]:
        found["lengths"] = entries(shape, "lengths", letters)
    found["meets"] = role(shape, "meets", letters)
    found["coordinates"] = entries(shape, "coordinates", letters)
    if shape.modes:
        plus, minus = (mode_meaning(shape, mode, letters) for mode in (1, -1))
        found["mode"] = say("group.modes", plus=plus, minus=minus)
    return found


def mode_meaning(shape: Shape, mode: int, letters: Mapping[str, str]) -> Sentence:
    """Return the meaning of an assembly mode."""
    return say(shape.modes[mode], **letters)
