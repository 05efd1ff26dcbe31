"""The names that a file may use: schemes and kinds of group, and the entries of each kind.  Their mathematics is floors above.

Enters: nothing.  Leaves: names, and shapes.
Used by `reader.py`, `schema.py`, `shape.py` and `places.py`, and by whoever makes a motion.
A test holds the names to the records: `SCHEMES` of `motion/schemes.py` and `GROUPS` of `mechanism/groups/`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say

SCHEME_NAMES = ("euler", "midpoint", "heun", "ralston", "rk4")
FORCE_SECTIONS = frozenset({"masses", "forces", "friction", "motor"})  # a file without them has nothing to do with forces
OF_FORCES = ("semi-implicit",)  # schemes for motion under forces only
EXACT = "exact"  # in place of a scheme: the motion of the mechanism itself, which no tableau computes


@frozen
class Shape:
    """How many external points, lengths (any of these counts), guides and coordinates a group of a kind has.

    The first `angles` coordinates are angles, the others lengths; `also` names further keys of the kind; `modes` gives the
    meanings of +1 and -1, empty if there is only one way; `driven` means turned by a drive, as a crank is.  `letters` are those
    of the textbook, for the gaps in its sentences: of the points in `from`, of a point on each guide, of the meeting point.
    These sentences are in the words files under the key `words`.
    """

    points: int
    lengths: tuple[int, ...]
    guides: int
    coordinates: int
    angles: int
    letters: tuple[str, ...] = ()
    words: str = ""
    also: tuple[str, ...] = ()
    modes: Mapping[int, str] = field(default_factory=dict)
    driven: bool = False

    @property
    def counts(self) -> dict[str, tuple[int, ...]]:
        """Return how many entries each list of a group may have, by its key."""
        return {"from": (self.points,), "guides": (self.guides,), "lengths": self.lengths, "coordinates": (self.coordinates,)}

    def named(self, names: Sequence[str] = ()) -> dict[str, str]:
        """Return the words for the gaps in its sentences: the names of the points in a file where given, else the letters."""
        return {letter: name or letter for letter, name in zip(self.letters, names or self.letters, strict=False)}


_LEFT = {1: "group.mode.left", -1: "group.mode.right"}
_LARGER = {1: "group.mode.larger", -1: "group.mode.smaller"}
_TOWARDS = {1: "group.mode.towards", -1: "group.mode.away"}
GROUP_SHAPES = {
    "crank": Shape(1, (1,), 0, 1, 1, ("A", "B"), "group.role.crank", driven=True),
    "RRR": Shape(2, (2,), 0, 2, 2, ("B", "D", "C"), "group.role.RRR", modes=_LEFT),
    "RRP": Shape(1, (1,), 1, 2, 1, ("B", "K", "C"), "group.role.RRP", modes=_LARGER),
    "RPR": Shape(2, (0, 1), 0, 2, 1, ("B", "D", "E"), "group.role.RPR", ("offset",), _TOWARDS),
    "RPP": Shape(1, (0,), 1, 2, 0, ("B", "K", "D"), "group.role.RPP", ("angle",)),
    "PRP": Shape(0, (0,), 2, 2, 0, ("Ki", "Kj", "C"), "group.role.PRP"),
}
# The kinds of group, and how many of their coordinates are angles, which come first; the others are lengths.
GROUP_KINDS = {name: shape.angles for name, shape in GROUP_SHAPES.items()}


def scheme_hint(name: str, known: Sequence[str]) -> Sentence | str:
    """Return the advice about a name that is no scheme here; it may be one for motion under forces."""
    return say("hint.of_forces", name=name) if name in OF_FORCES else closest(name, known)


def scheme_names() -> tuple[str, ...]:
    """Return every name allowed for `--scheme` and in a variant file: the schemes, and the exact motion."""
    return (*SCHEME_NAMES, EXACT)
