"""The records of the structure of a mechanism: its links, pairs and Assur groups.

Enters: nothing.  Leaves: the frozen records `Structure`, `Member`, `KinematicPair`, `AssurGroup`.
Used by `structure.py` and `report/sections/structure.py`.
"""

from __future__ import annotations

from coursework.mechanism.groups.joint import JointKind
from coursework.mechanism.joints import Mobility
from coursework.system.frozen import frozen


@frozen
class Member:
    """A moving link: its `name`, its named `points`, its `rate` ("" if it has none of its own) and its `kind`.

    Kinds: wheel, slider, sleeve, lever, pivoted (crank or rocker, depending on its motion), coupler, link.
    """

    name: str
    points: tuple[str, ...]
    rate: str
    kind: str


@frozen
class KinematicPair:
    """A pair of two `links` by name, the frame being "0"; `point` is where it is, "" if no point is named there."""

    kind: JointKind
    links: tuple[str, str]
    point: str


@frozen
class AssurGroup:
    """`links` that add no mobility; `kind` is a name such as "RRP" ("" if no dyad of R and P); `order` counts the outer pairs.

    Class I is a driven link; its `links` begin with the link on which it is mounted.
    """

    links: tuple[str, ...]
    group_class: str
    order: int = 0
    kind: str = ""


@frozen
class Structure:
    """Links and pairs with sliders; the `mobility` with sliders and `without` them; `drives`, the number of driven freedoms.

    `groups` are in the order of assembly, empty if it was not found; `driven` is the point that a drive moves, "" if none.
    """

    links: tuple[Member, ...]
    pairs: tuple[KinematicPair, ...]
    mobility: Mobility
    without: Mobility
    drives: int
    driven: str = ""
    groups: tuple[AssurGroup, ...] = ()
