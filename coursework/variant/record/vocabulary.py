"""What a file may name: schemes, kinds of group, and what a group of a kind has.  Their mathematics stands floors above.

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
FORCE_SECTIONS = frozenset({"masses", "forces", "friction", "motor"})  # a file without them knows nothing of forces
OF_FORCES = ("semi-implicit",)  # schemes of motion under forces alone
EXACT = "exact"  # stands for a scheme: the motion of the mechanism itself, which no tableau makes


@frozen
class Shape:
    """How many external points, lengths (any of these counts), guides and coordinates a group of a kind has.

    The first so many coordinates are `angles` (the others are lengths); `also` names the keys that the kind reads beside these;
    `modes` says what +1 and -1 mean, empty where there is one way; `driven` that a drive turns it: a crank.  `letters` are the
    textbook's, which its sentences have gaps for: of the points in `from`, of a point on each guide, of the one where it meets;
    these sentences stand in the words files under the key `words`.
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
        """Return what stands in the gaps of its sentences: the names of a file's points, as far as there are, or the letters."""
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
# The kinds of group, and how many of the coordinates of each, the first ones, are angles; the others are lengths.
GROUP_KINDS = {name: shape.angles for name, shape in GROUP_SHAPES.items()}


def scheme_hint(name: str, known: Sequence[str]) -> Sentence | str:
    """Return what to do about a name that is no scheme here: one of motion under forces is a scheme elsewhere."""
    return say("hint.of_forces", name=name) if name in OF_FORCES else closest(name, known)


def scheme_names() -> tuple[str, ...]:
    """Return every name that `--scheme` and a variant file may give: the schemes, and the exact motion."""
    return (*SCHEME_NAMES, EXACT)
