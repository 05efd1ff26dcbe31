"""The joints between two bodies of a mechanism; one record holds everything the program knows about a kind of joint.

Enters: two bodies, the point where they meet, the angle of a slide.  Leaves: `Joint` and the kinds, `JointKind`.
Used by the files of the groups and by `joints.py`, which make joints; all other code asks the kind of a joint.

To add a kind: write its record here, and make it in a group or from a link; mobility, drawing and plans ask the record.
"""

from __future__ import annotations

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula


@frozen
class JointKind:
    """A kind of joint.

    `takes`: how many of the three relative freedoms of two bodies it removes: 2 for a lower pair, 1 for a higher one, 3 if both
    turn as one.
    `holders`: how many of the two bodies, counted from the first, always hold its point: 2 for a pin, drawn as a hinge on the
    frame; 1 for a pin or block in a guide; 0 for a contact that moves along both.  `slides`: whether the first body moves along a
    straight guide of the second, drawn as a block.  `key` is its word in the words files; `letter` stands for it in the name of a
    group, "" if it occurs in no such name.
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
        """Return whether both bodies hold its point, and one only turns about it relative to the other."""
        return self.holders == 2 and not self.is_rigid

    @property
    def is_rigid(self) -> bool:
        """Return whether the two bodies are parts of one, such as two gears on one shaft."""
        return self.takes == 3


REVOLUTE = JointKind("revolute", takes=2, holders=2, key="turning", letter="R")
PRISMATIC = JointKind("prismatic", takes=2, holders=1, slides=True, key="sliding", letter="P")
PIN_IN_GUIDE = JointKind("pin in guide", takes=1, holders=1, slides=True)
ROLLING = JointKind("rolling without slip", takes=2, holders=0, key="rolling")
# For a wheel whose centre other joints hold: gear and rack, two gears.
MESHING = JointKind("wheels without slip", takes=1, holders=0, key="meshing")
ONE_SHAFT = JointKind("one shaft", takes=3, holders=2)


@frozen
class Joint:
    """A joint between two `bodies`; the frame is "0".

    `where` is its point, None if the formula that carries the body names none; `along` is the angle of a slide.
    """

    kind: JointKind
    bodies: tuple[str, str]
    where: Formula | None
    along: Formula | None = None

    @property
    def holders(self) -> tuple[str, ...]:
        """Return the bodies that always hold its point."""
        return self.bodies[: self.kind.holders]

    @property
    def pins(self) -> bool:
        """Return whether one body only turns about the point relative to the other."""
        return self.kind.pins
