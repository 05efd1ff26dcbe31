"""What joins two bodies of a mechanism: one record holds all that the house knows of its kind.

Enters: two bodies, the point where they meet, the angle of what slides.  Leaves: `Joint` and the kinds, `JointKind`.
Used by the files of the groups and by `joints.py`, which make joints; all others ask a joint for what its kind is.

To add a kind: write its record here, and make it in a group or from a link; mobility, drawing and plans ask the record.
"""

from __future__ import annotations

from dataclasses import dataclass

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula


@dataclass(frozen=True, slots=True, repr=False)
class JointKind:
    """A kind of joint.

    `takes` says how many of the three freedoms that one body has beside another it takes: 2 a lower pair, 1 a higher;
    `holders` how many of the two bodies hold its point all the time, the first before the second: 2 a pin, that is drawn as
    a hinge on the frame, 1 a pin or a block in a guide, 0 a contact that wanders on both; `slides` whether the first moves
    along a straight guide of the second, which is drawn as a block.  `key` finds its word in the words files, `letter` stands
    for it in the name of a group, "" where no such name is made of it.
    """

    name: str
    takes: int
    holders: int
    slides: bool = False
    key: str = ""
    letter: str = ""

    def __repr__(self) -> str:
        return self.name

    @property
    def pins(self) -> bool:
        """Return whether both bodies hold its point, so that one only turns about it on the other."""
        return self.holders == 2


REVOLUTE = JointKind("revolute", takes=2, holders=2, key="turning", letter="R")
PRISMATIC = JointKind("prismatic", takes=2, holders=1, slides=True, key="sliding", letter="P")
PIN_IN_GUIDE = JointKind("pin in guide", takes=1, holders=1, slides=True)
ROLLING = JointKind("rolling without slip", takes=2, holders=0, key="rolling")
# Of a wheel whose centre other joints hold: gear and rack, two gears.
MESHING = JointKind("wheels without slip", takes=1, holders=0, key="meshing")


@frozen
class Joint:
    """A joint between two `bodies`; the frame is "0".

    `where` is its point, None where a formula carries the body and names none; `along` the angle of what slides.
    """

    kind: JointKind
    bodies: tuple[str, str]
    where: Formula | None
    along: Formula | None = None

    @property
    def holders(self) -> tuple[str, ...]:
        """Return the bodies that hold its point."""
        return self.bodies[: self.kind.holders]

    @property
    def pins(self) -> bool:
        """Return whether one body only turns about the point on the other."""
        return self.kind.pins
