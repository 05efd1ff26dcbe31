"""The crank and the five dyads in closed form: positions, velocities, accelerations, all rows at once.

Enters: external pairs and guides with their velocities and accelerations.  Leaves: `GroupMotion`, whose
`meets` is a pair the next group can hang on.  Used by exact motions, `kinematics`, and students' own scripts.

To add a group: write one file with one function here, and one line in `GROUPS`.
"""

from __future__ import annotations

from collections.abc import Callable

from coursework.groups.assembly import AtDeadPoint, CannotAssemble
from coursework.groups.crank import crank
from coursework.groups.pairs import GroupMotion, Guide, Pair
from coursework.groups.prp import prp
from coursework.groups.rpp import rpp
from coursework.groups.rpr import rpr
from coursework.groups.rrp import rrp
from coursework.groups.rrr import rrr

GROUPS: dict[str, Callable[..., GroupMotion]] = {
    "crank": crank,
    "RRR": rrr,
    "RRP": rrp,
    "RPR": rpr,
    "RPP": rpp,
    "PRP": prp,
}

__all__ = [
    "GROUPS",
    "AtDeadPoint",
    "CannotAssemble",
    "GroupMotion",
    "Guide",
    "Pair",
    "crank",
    "prp",
    "rpp",
    "rpr",
    "rrp",
    "rrr",
]
