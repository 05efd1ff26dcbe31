"""The crank and the five dyads in closed form: positions, velocities, accelerations, all rows at once.

Enters: external pairs and guides with their velocities and accelerations.  Leaves: `GroupMotion`, whose
`meets` is a pair that the next group can hang on.  Used by exact motions, `kinematics`, and students' own scripts.

The exact motion of a chain uses only the positions of a group: velocities come from the reduction, which also includes
drives and equations outside the chain.  With velocities and accelerations the functions are procedures for students.
Sources: B. B. Ponomarev, coursework guide, Irkutsk 1995 (variant 31); [deck] slides on kinematic simulation with basic Assur
groups; [library] a library of Assur-group procedures; V. R. Pasika, slider-crank with variable crank length.  Their misprints are
shown by tests in `tests/mechanism/groups/test_printed_faults.py`; reference numbers are in `tests/reference/`.

To add a group: write one file with its function and its `GroupKind`, add this kind to `GROUPS`, its shape to
`variant/record/vocabulary.py`, and the meanings of its keys to the words files.
"""

from __future__ import annotations

from coursework.mechanism.groups.assembly import AtDeadPoint, CannotAssemble
from coursework.mechanism.groups.crank import CRANK, crank
from coursework.mechanism.groups.kind import GroupKind
from coursework.mechanism.groups.pairs import GroupMotion, Guide, Pair
from coursework.mechanism.groups.prp import PRP, prp
from coursework.mechanism.groups.rpp import RPP, rpp
from coursework.mechanism.groups.rpr import RPR, rpr
from coursework.mechanism.groups.rrp import RRP, rrp
from coursework.mechanism.groups.rrr import RRR, rrr

GROUPS: tuple[GroupKind, ...] = (CRANK, RRR, RRP, RPR, RPP, PRP)


def group_kind(name: str) -> GroupKind:
    """Return the kind of a group by its name.  Raises `KeyError` for an unknown name.

    >>> from coursework.mechanism.groups import group_kind
    >>> group_kind("RRP"), group_kind("RRP").shape.guides
    (RRP, 1)
    """
    return {kind.name: kind for kind in GROUPS}[name]


__all__ = [
    "GROUPS",
    "AtDeadPoint",
    "CannotAssemble",
    "GroupKind",
    "GroupMotion",
    "Guide",
    "Pair",
    "crank",
    "group_kind",
    "prp",
    "rpp",
    "rpr",
    "rrp",
    "rrr",
]
