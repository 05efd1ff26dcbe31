"""What each key of a group means: the one table of kinds, and the comments of a file made from it.

Enters: a kind, and the letters or names of its points.  Leaves: keys with sentences, in the order in which a file has them.
Used by `text.py` and `commands/kinds.py`.

A kind needs no line here: its keys follow from its shape, and their meaning stands in the words files under its name.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.mechanism.groups import GroupKind
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


def title(kind: GroupKind, letters: Mapping[str, str]) -> Sentence:
    """Return what a group of the kind is."""
    return say(f"group.role.{kind.name}.title", **letters)


def role(kind: GroupKind, key: str, letters: Mapping[str, str], place: int = 0) -> Sentence:
    """Return what stands behind a key, of a list behind its entry of this `place` (from 1)."""
    return say(f"group.role.{kind.name}.{key}{place or ''}", **letters)


def roles(kind: GroupKind, letters: Mapping[str, str]) -> dict[str, Sentence]:
    """Return what stands behind every key of a kind, the entries of a list with commas between.

    >>> from coursework.mechanism.groups import group_kind
    >>> [*roles(group_kind("RRP"), group_kind("RRP").named())]
    ['from', 'guide', 'lengths', 'meets', 'coordinates', 'mode']
    """
    shape = kind.shape
    found = {}
    if shape.points:
        found["from"] = _listed(kind, "from", letters, shape.points)
    if shape.guides == 1:
        found["guide"] = role(kind, "guide", letters)
    elif shape.guides:
        found["guides"] = _listed(kind, "guides", letters, shape.guides)
    found |= {key: role(kind, key, letters) for key in shape.also}
    if shape.lengths[-1]:
        found["lengths"] = _listed(kind, "lengths", letters, shape.lengths[-1])
    found["meets"] = role(kind, "meets", letters)
    found["coordinates"] = _listed(kind, "coordinates", letters, shape.coordinates)
    if kind.modes:
        found["mode"] = modes(kind, letters)
    return found


def modes(kind: GroupKind, letters: Mapping[str, str]) -> Sentence:
    """Return what both modes mean."""
    plus, minus = (kind.mode_meaning(mode, letters) for mode in (1, -1))
    return say("group.modes", plus=plus, minus=minus)


def _listed(kind: GroupKind, key: str, letters: Mapping[str, str], count: int) -> Sentence:
    return joined((role(kind, key, letters, place) for place in range(1, count + 1)), "group.entries")
