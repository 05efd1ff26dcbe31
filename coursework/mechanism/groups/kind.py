"""The kinds of groups in a chain; one record holds everything the program knows about a kind.

Enters: a group as a file writes it, in formulas, or its known data in numbers.  Leaves: `GroupKind`.
Used by the files of the kinds and `motion/geometry/chain.py`; other code meets it as the kind of a group.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from coursework.mechanism.groups.joint import Joint
from coursework.mechanism.groups.pairs import GroupMotion, Guide, Pair
from coursework.system.arrays import Array
from coursework.system.frozen import frozen, single
from coursework.variant.formula.made import summed
from coursework.variant.formula.tree import Formula, named, number
from coursework.variant.record.entries import Guide as GuideInFile
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import Shape

# Both sides of the closure as vectors (empty if nothing closes), and the point the next group may hang on.
Closed = tuple[tuple[Formula, ...], Formula]
QUARTER = Formula("/", (named("pi"), number(2)))


@frozen
class Known:
    """What is known before a group is assembled, in all rows: pairs, `lengths` (m), guides, `offset` (m), `angle` (rad)."""

    points: Sequence[Pair]
    lengths: Sequence[Array]
    guides: Sequence[Guide]
    offset: Array
    angle: Array | None


# Makes the joints of a group from the bodies that carry its external points, those that carry its guides, and its own.
Joints = Callable[["Group", Sequence[str], Sequence[str], Sequence[str]], tuple[Joint, ...]]


@single
class GroupKind:
    """A kind of group.

    `shape` describes what a file says about it; `closure` writes it as formulas; `solve` assembles it in a mode, None if a drive
    gives its coordinate; `meaning` is the key of a sentence about its dead point, "" if the determinant alone shows it;
    `joints` makes the joints of its bodies; `carries` gives for each coordinate the index of the body it moves.

    >>> from coursework.mechanism.groups import group_kind
    >>> group_kind("PRP").shape.guides, group_kind("PRP").driven, group_kind("crank").driven
    (2, False, True)
    """

    name: str
    shape: Shape
    closure: Callable[[Group], Closed]
    solve: Callable[[Known, int], GroupMotion] | None
    joints: Joints
    meaning: str = ""
    carries: tuple[int, ...] = (0, 1)

    def __repr__(self) -> str:
        return self.name

    def __reduce__(self) -> tuple[Callable[[str], GroupKind], tuple[str]]:
        from coursework.mechanism.groups import group_kind  # a kind is pickled by its name

        return group_kind, (self.name,)

    @property
    def modes(self) -> Mapping[int, str]:
        """Return the assembly modes, each with the key of its meaning."""
        return self.shape.modes

    @property
    def driven(self) -> bool:
        """Return whether a drive turns it, as it does a crank."""
        return self.shape.driven


def unknowns(group: Group) -> list[Formula]:
    """Return the coordinates of a group as formulas."""
    return [named(coordinate) for coordinate in group.coordinates]


def plus(*terms: Formula) -> Formula:
    """Return the sum of formulas."""
    return summed((term, 1) for term in terms)


def along(length: Formula, angle: Formula) -> Formula:
    """Return the vector of a length at an angle."""
    return Formula("@", (length, angle))


def across(offset: Formula, angle: Formula) -> tuple[Formula, ...]:
    """Return the vector `offset` at right angles to `angle` in a tuple, empty if the offset is zero.

    >>> from coursework.variant.formula.tree import spelled
    >>> spelled(across(named("e"), named("alpha"))[0]), across(number(0), named("alpha"))
    ('e @ (alpha + pi/2)', ())
    """
    zero = offset.op == "number" and offset.value == 0
    return () if zero else (along(offset, plus(angle, QUARTER)),)


def slid(guide: GuideInFile, slide: Formula) -> Formula:
    """Return the place of the pin of a block that has moved by a slide along its guide."""
    return plus(guide.through, along(slide, guide.angle), *across(guide.offset, guide.angle))
