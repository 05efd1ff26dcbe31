"""What a file of another program says of a mechanism, as far as it can be expressed here.

Leaves: `Scheme`, `Slider`, `Turned`; `Reading`, the base class of every reader.
Used by the readers of this folder and `text.py`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence

from coursework.system.frozen import frozen
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MOST_BYTES = 1_000_000
MOST_JOINTS = 100  # more would make a page that no student could read
LARGEST = 1e9  # of a coordinate, and of a speed ratio to the crank
SHORTEST = 1e-12  # m: joints nearer to each other count as one, and no link joins them
Links = tuple[tuple[str, ...], ...]  # the joints of each link


@frozen
class Slider:
    """A joint that slides on a line `through` a place at an angle (rad), on the moving `link` of that number or on the frame."""

    through: complex
    angle: float
    link: int | None = None


@frozen
class Turned:
    """A further link that turns about a fixed joint, at `ratio` times the speed of the crank."""

    pivot: str
    link: int
    ratio: float


@frozen
class Scheme:
    """Places of joints (m) by id, the fixed ones, the joints of each moving link, sliders, and the crank.

    The crank turns about the joint `pivot`, its link is `links[crank]`, its `speed` (rad/s) is None if the file does not say it.
    `remarks` list what is left out of the file, and what the file does not say.
    """

    program: str
    title: str
    joints: Mapping[str, complex]
    fixed: frozenset[str]
    links: Links
    sliders: Mapping[str, Slider]
    pivot: str
    crank: int
    speed: float | None
    remarks: tuple[Sentence, ...]
    turned: tuple[Turned, ...] = ()


class Reading:
    """What a reader has found in a file so far, and how it refuses what it cannot read."""

    def __init__(self, program: str) -> None:
        self.program = program
        self.places: dict[str, complex] = {}
        self.fixed: set[str] = set()
        self.sliders: dict[str, Slider] = {}
        self.remarks: list[Sentence] = []

    def refused(self, place: object) -> InputError:
        """Return the error for a file that cannot be read as one of the program."""
        return InputError(say("fault.C094", program=self.program, place=place))

    def number(self, value: object, place: object) -> float:
        """Return a finite number.  Raises `InputError`."""
        try:
            found = float(str(value))
        except ValueError:
            raise self.refused(place) from None
        if not math.isfinite(found) or abs(found) > LARGEST:
            raise self.refused(place)
        return found

    def leave_out(self, what: str) -> None:
        """Add a remark that something cannot be expressed here and is left out."""
        self.remarks.append(say("foreign.left_out", what=what[:80]))

    def moving(self, links: Iterable[Collection[str]]) -> Links:
        """Return the links that are not part of the frame."""
        return tuple(tuple(link) for link in links if not self.fixed.issuperset(link))

    def no_crank(self) -> InputError:
        """Return the error for a file in which nothing turns about a fixed joint."""
        return InputError(say("fault.C095", program=self.program))

    def crank_of(self, links: Links, pivot: str) -> int:
        """Return the number of the moving link at a joint.  Raises `InputError` if there is none."""
        if (crank := link_of(links, pivot)) is None:
            raise self.no_crank()
        return crank

    def scheme(
        self, links: Links, pivot: str, crank: int, speed: float | None, turned: Sequence[Turned] = (), title: str = ""
    ) -> Scheme:
        """Return the mechanism.  Raises `InputError` if the crank has no length."""
        kept = [
            one for one in turned if abs(one.ratio) <= LARGEST and arm_of(self.places, self.fixed, links[one.link], one.pivot)
        ]
        for one in turned:
            if one not in kept:
                self.leave_out(f"input ({one.pivot})")
        if not arm_of(self.places, self.fixed, links[crank], pivot):
            raise self.no_crank()
        fixed, remarks = frozenset(self.fixed), tuple(self.remarks)
        return Scheme(self.program, title, self.places, fixed, links, self.sliders, pivot, crank, speed, remarks, tuple(kept))


def arm_of(at: Mapping[str, complex], known: Collection[str], link: Iterable[str], pivot: str) -> list[str]:
    """Return the joints of a link that can turn about a pivot: those not `known` and not at the same place."""
    return [name for name in link if name not in known and abs(at[name] - at[pivot]) > SHORTEST]


def link_of(links: Sequence[Sequence[str]], *joints: str) -> int | None:
    """Return the number of the link that has all given joints, None if there is none."""
    return next((place for place, own in enumerate(links) if set(joints) <= set(own)), None)
