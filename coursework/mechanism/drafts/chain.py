"""A chain of groups of the kinds asked for: which group hangs on which, all names, and dimensions with which it closes.

Enters: names of kinds, cranks and dyads, the first a crank.  Leaves: `Draft`.  Used by `text.py`, `commands/new.py` and the desk.

A dyad hangs on the points that have waited longest: pins of cranks, and meeting points of earlier dyads.  Any further support
it needs is a pivot or a guide on the frame.  A dyad without an external point rides on the body of a waiting point, which
carries its last guide.  On a turning crank such a guide would be parallel to a fixed one twice a turn, so this crank swings.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from coursework.mechanism.drafts.candidates import ROWS, End, Placement, place
from coursework.mechanism.groups import GroupKind, GroupMotion, group_kind
from coursework.mechanism.groups.plane import Vectors, vectors
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.entries import Coordinate
from coursework.variant.record.vocabulary import GROUP_KINDS

CRANK, TURNED = 0.1, (30, 120, 75, 165)  # m; degrees: the angles of the cranks at the start, one after the other
SWING = 0.6  # rad: amplitude of a swinging crank, which carries a guide
_APART = 4 * CRANK  # m, in x: from the last waiting point to the pivot of a further crank


@frozen
class GuideOf:
    """A guide of a group: the point it passes `through`, the name of its `angle`, the coordinate it `turns` with ("" if none)."""

    through: str
    angle: str
    turns: str = ""


@frozen
class GroupDraft:
    """One group: its kind, and the names of its points, guides, lengths, meeting point and coordinates.

    A crank also has the number of its drive (`crank`), and `swings` if it does not turn all the way.
    """

    kind: GroupKind
    points: tuple[str, ...]
    guides: tuple[GuideOf, ...]
    lengths: tuple[str, ...]
    meets: str
    coordinates: tuple[Coordinate, ...]
    crank: int = 0
    swings: bool = False

    @property
    def letters(self) -> dict[str, str]:
        """Return the letters to insert into the sentences about its kind."""
        return self.kind.shape.named((*self.points, *(guide.through for guide in self.guides), self.meets))


@dataclass(slots=True)
class Draft:
    """The groups, the points of the frame (m), and the numbers by name: lengths (m) and angles (degrees)."""

    groups: list[GroupDraft] = field(default_factory=list)
    places: dict[str, complex] = field(default_factory=dict)
    lengths: dict[str, float] = field(default_factory=dict)
    angles: dict[str, int] = field(default_factory=dict)

    @property
    def cranks(self) -> list[GroupDraft]:
        """Return the groups that a drive turns."""
        return [group for group in self.groups if group.kind.driven]

    @property
    def turns_one_crank(self) -> bool:
        """Return whether the whole motion follows the angle of one crank that turns all the way."""
        return len(self.cranks) == 1 and not self.cranks[0].swings

    @property
    def rails(self) -> list[GuideOf]:
        """Return the guides that are fixed to the frame."""
        return [guide for group in self.groups for guide in group.guides if guide.through in self.places]

    @property
    def hinges(self) -> list[str]:
        """Return the points of the frame about which links turn."""
        return [point for point in self.places if point not in {guide.through for guide in self.rails}]

    @property
    def slides(self) -> bool:
        """Return whether any coordinate is a length."""
        return any(own.unit == "m" for group in self.groups for own in group.coordinates)


class DoesNotClose(ValueError):
    """No dimensions were found with which group `number` (from 1) closes during the whole turn."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number


def draft_of(names: Sequence[str]) -> Draft:
    """Return a chain of the kinds `names`.  Raises `DoesNotClose`.

    >>> draft = draft_of(["crank", "RRR"])
    >>> [(str(group.kind), group.points, group.meets) for group in draft.groups]
    [('crank', ('A',), 'B'), ('RRR', ('B', 'C'), 'D')]
    """
    swinging: set[int] = set()
    while True:
        drafting = _Drafting(swinging)
        try:
            for name in names:
                drafting.add(group_kind(name))
        except _MustSwing as needed:
            swinging.add(needed.crank)
            continue
        return drafting.draft


def draft_on(name: str, ends: Sequence[End], taken: Collection[str], body: int) -> Draft:
    """Return a draft of one group `name` that hangs on points (`ends`) of an existing chain.  Raises `DoesNotClose`.

    `taken` are the names of the existing points, `body` is the number of its first coordinate.
    """
    drafting = _Drafting(set(), ends, taken, body)
    try:
        drafting.add(group_kind(name))
    except (_MustSwing, IndexError):  # a guide would be on a crank that turns all the way; there is no point to ride on
        raise DoesNotClose(1) from None
    return drafting.draft


class _MustSwing(Exception):
    """The chain must be drafted again, with this crank swinging."""

    def __init__(self, crank: int) -> None:
        self.crank = crank


class _Drafting:
    """The chain drafted so far; `waiting` are the points on which nothing hangs yet."""

    def __init__(self, swinging: set[int], ends: Sequence[End] = (), taken: Collection[str] = (), body: int = 1) -> None:
        self.draft = Draft()
        self.waiting = list(ends)
        self._swinging = swinging
        self._letters = (letter for letter in letters() if letter not in taken)
        self._bodies, self._first_crank = itertools.count(body), body
        self._turning: dict[str, int] = {}  # pins of cranks that turn all the way, and the crank of each

    def add(self, kind: GroupKind) -> None:
        """Add a group of a kind."""
        bodies = [next(self._bodies) for _ in range(kind.shape.coordinates)]
        coordinates = tuple(self._coordinate(kind, place, body) for place, body in enumerate(bodies))
        if kind.driven:
            self._add_crank(kind, bodies[0], coordinates)
        else:
            self._add_dyad(kind, bodies, coordinates)

    def _coordinate(self, kind: GroupKind, index: int, body: int) -> Coordinate:
        angle = index < GROUP_KINDS[kind.name]
        return Coordinate(f"phi{body}", f"w{body}", None, "rad") if angle else Coordinate(f"s{body}", f"u{body}", None, "m")

    def _add_crank(self, kind: GroupKind, body: int, coordinates: tuple[Coordinate, ...]) -> None:
        number = len(self.draft.cranks) + self._first_crank
        beside = round(self.waiting[-1].middle.real + _APART, 2) if self.waiting else 0.0
        height = round(self.waiting[-1].middle.imag, 2) if self.waiting else 0.0
        pivot, pin = self._new_point(complex(beside, height)), next(self._letters)
        swings = number in self._swinging
        start = np.radians(TURNED[(number - 1) % len(TURNED)])
        time = 2 * np.pi * np.arange(ROWS) / ROWS
        angle = start + (SWING * np.sin(time) if swings else time)
        self.draft.lengths[f"r{body}"] = CRANK
        self.draft.groups.append(GroupDraft(kind, (pivot,), (), (f"r{body}",), pin, coordinates, number, swings))
        if not swings:
            self._turning[pin] = number
        self.waiting.append(End(pin, self.draft.places[pivot] + CRANK * np.exp(1j * angle), coordinates[0].name, angle))

    def _add_dyad(self, kind: GroupKind, bodies: list[int], coordinates: tuple[Coordinate, ...]) -> None:
        number = len(self.draft.groups) + 1
        carrier = None if kind.shape.points else self._carrier()
        ends = self.waiting[: kind.shape.points]
        taken = [*self.draft.places.values(), *(end.middle for end in self.waiting)]
        placed = place(kind, ends, carrier, taken)
        if placed is None and len(ends) > 1:  # two moving points may come too close to each other
            ends = ends[:1]
            placed = place(kind, ends, carrier, taken)
        if placed is None:
            raise DoesNotClose(number)
        hung = [end.name for end in (*ends, *([carrier] if carrier else ()))]
        self.waiting = [end for end in self.waiting if end.name not in hung]
        group = self._named(kind, bodies, coordinates, [end.name for end in ends], placed[0], carrier)
        self.draft.groups.append(group)
        self.waiting.append(self._end(group, placed[1]))

    def _carrier(self) -> End:
        """Return the first waiting point whose body can carry a guide.  Raises `_MustSwing` if all bodies are turning cranks."""
        for end in self.waiting:
            if end.name not in self._turning:
                return end
        raise _MustSwing(self._turning[self.waiting[0].name])

    def _named(
        self, kind: GroupKind, bodies: list[int], coordinates: tuple[Coordinate, ...], hung: list[str], found: Placement,
        carrier: End | None,
    ) -> GroupDraft:  # fmt: skip
        """Return the group with names for everything new; record the numbers in the draft."""
        points = [*hung, *(self._new_point(pivot) for pivot in found.pivots)]
        slides = [coordinate.name[1:] for coordinate in coordinates if coordinate.unit == "m"]
        guides = []
        for (through, angle), number in zip(found.fixed, reversed(slides), strict=False):
            self.draft.angles[f"gamma{number}"] = angle
            guides.append(GuideOf(self._new_point(through), f"gamma{number}"))
        if carrier is not None and found.carried is not None:
            self.draft.angles[f"delta{slides[-1]}"] = found.carried
            guides.append(GuideOf(carrier.name, f"delta{slides[-1]}", carrier.turns))
        lengths = [f"r{body}" for body, _ in zip(bodies, found.lengths, strict=False)]
        self.draft.lengths.update(zip(lengths, found.lengths, strict=True))
        return GroupDraft(kind, tuple(points), tuple(guides), tuple(lengths), next(self._letters), coordinates)

    def _end(self, group: GroupDraft, motion: GroupMotion) -> End:
        """Return the meeting point of a group, with the body that goes with it: the last one that turns, if there is one."""
        path: Vectors = vectors(motion.meets.position)
        angles = [place for place, coordinate in enumerate(group.coordinates) if coordinate.unit == "rad"]
        if not angles:
            return End(group.meets, path, "", np.zeros(ROWS))
        angle: Array = np.unwrap(motion.coordinates[:, angles[-1]])
        return End(group.meets, path, group.coordinates[angles[-1]].name, angle)

    def _new_point(self, place: complex) -> str:
        name = next(self._letters)
        self.draft.places[name] = place
        return name


def letters() -> Iterator[str]:
    """Yield A, B, C … Z, A2, B2 …"""
    for turn in itertools.count(1):
        for code in range(ord("A"), ord("Z") + 1):
            yield f"{chr(code)}{turn if turn > 1 else ''}"
