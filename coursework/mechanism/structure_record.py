"""What the structure of a mechanism consists of: its links, pairs and Assur groups.

Enters: nothing.  Leaves: the frozen records `Structure`, `Member`, `KinematicPair`, `AssurGroup`.
Used by `structure.py` and `report/sections/structure.py`.
"""

from __future__ import annotations

from coursework.mechanism.groups.joint import JointKind
from coursework.mechanism.joints import Mobility
from coursework.system.frozen import frozen


@frozen
class Member:
    """A moving link: `name`, the named `points` it holds, the `rate` it turns with ("" where it has none of its own), its `kind`:
    wheel, slider, sleeve, lever, pivoted (crank or rocker, which its motion tells), coupler, link.
    """

    name: str
    points: tuple[str, ...]
    rate: str
    kind: str


@frozen
class KinematicPair:
    """A pair of two `links`, named, the frame "0"; `point` where it is, "" where no point is named there."""

    kind: JointKind
    links: tuple[str, str]
    point: str


@frozen
class AssurGroup:
    """Some `links` that add no mobility, `kind` such as "RRP" ("" for no dyad of R and P); `order` counts the outer pairs.

    Class I is a driven link; of it `links` begins with that on which it stands.
    """

    links: tuple[str, ...]
    group_class: str
    order: int = 0
    kind: str = ""


@frozen
class Structure:
    """Links and pairs with their sliders, `mobility` counted so and `without` the sliders, `drives` the freedoms driven.

    `groups` in the order of assembly, empty where they are not found; `driven` the point that a drive moves, "" for none.
    """

    links: tuple[Member, ...]
    pairs: tuple[KinematicPair, ...]
    mobility: Mobility
    without: Mobility
    drives: int
    driven: str = ""
    groups: tuple[AssurGroup, ...] = ()
