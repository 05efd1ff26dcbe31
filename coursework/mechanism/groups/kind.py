"""What a group of a chain is: one record holds all that the house knows of its kind.

Enters: a group as a file writes it, in formulas, or its known side in numbers.  Leaves: `GroupKind`.
Used by the files of the kinds and `motion/geometry/chain.py`; others meet it as the kind of a group.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from coursework.mechanism.groups.joint import Joint
from coursework.mechanism.groups.pairs import GroupMotion, Guide, Pair
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named, number
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import Shape

# The two ways round a loop as vectors, none where nothing closes, and the point the next group may hang on.
Closed = tuple[tuple[Formula, ...], Formula]
QUARTER = Formula("/", (named("pi"), number(2)))


@frozen
class Known:
    """What stands before a group is put together, in all rows: pairs, `lengths` (m), guides, `offset` (m), `angle` (rad)."""

    points: Sequence[Pair]
    lengths: Sequence[Array]
    guides: Sequence[Guide]
    offset: Array
    angle: Array | None


# The names of the bodies that carry external points and guides, and of the group's own, to the joints between them.
Joints = Callable[["Group", Sequence[str], Sequence[str], Sequence[str]], tuple[Joint, ...]]


@dataclass(frozen=True, slots=True, repr=False, eq=False)
class GroupKind:
    """A kind of group.

    `shape` is what a file says of it; `closure` writes it as formulas; `solve` puts it together in a mode, None where a drive
    gives its coordinate; `meaning` is the key of the sentence about a dead point that its determinant alone does not show;
    `joints` joins its bodies, of which `carries` says which one each coordinate moves.

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
        from coursework.mechanism.groups import group_kind  # a kind travels between processes by its name

        return group_kind, (self.name,)

    @property
    def modes(self) -> Mapping[int, str]:
        """Return the assembly modes, and the key of what each means."""
        return self.shape.modes

    @property
    def driven(self) -> bool:
        """Return whether a drive turns it: a crank."""
        return self.shape.driven


def unknowns(group: Group) -> list[Formula]:
    """Return the coordinates of a group as formulas."""
    return [named(coordinate) for coordinate in group.coordinates]


def plus(*terms: Formula) -> Formula:
    """Return the sum of formulas."""
    return summed((term, 1) for term in terms)


def summed(terms: Iterable[tuple[Formula, int]]) -> Formula:
    """Return the sum of terms with their signs, 0 for none.

    >>> summed([(named("a"), -1), (named("b"), 1)]) == Formula("+", (Formula("neg", (named("a"),)), named("b")))
    True
    """
    total: Formula | None = None
    for term, sign in terms:
        if total is None:
            total = term if sign > 0 else Formula("neg", (term,))
        else:
            total = Formula("+" if sign > 0 else "-", (total, term))
    return number(0) if total is None else total


def along(length: Formula, angle: Formula) -> Formula:
    """Return the vector of a length at an angle."""
    return Formula("@", (length, angle))


def across(offset: Formula, angle: Formula) -> tuple[Formula, ...]:
    """Return the vector `offset` at right angles to `angle`, or nothing where the offset is zero.

    >>> from coursework.variant.formula.tree import spelled
    >>> spelled(across(named("e"), named("alpha"))[0]), across(number(0), named("alpha"))
    ('e @ (alpha + pi/2)', ())
    """
    zero = offset.op == "number" and offset.value == 0
    return () if zero else (along(offset, plus(angle, QUARTER)),)
