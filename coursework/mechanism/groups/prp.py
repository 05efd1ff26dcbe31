"""The dyad PRP: a hinge C between two blocks, each on its own guide.

Enters: two guides with their offsets.  Leaves: both slides and the motion of the hinge C.
At a dead point the guides are parallel, and the position is not defined either.  Source: [deck], PRP, with the missing
b5 restored; [library] 2PG4V.
Used by `mechanism/groups/__init__.py` and `procedures.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from coursework.mechanism.groups.assembly import require_crossing
from coursework.mechanism.groups.joint import PRISMATIC, REVOLUTE, Joint
from coursework.mechanism.groups.kind import Closed, GroupKind, Known, slid, unknowns
from coursework.mechanism.groups.line import Line
from coursework.mechanism.groups.pairs import GroupMotion, Guide, count_rows, group_motion
from coursework.mechanism.groups.plane import cross
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import GROUP_SHAPES


def prp(guide_i: Guide, guide_j: Guide, *, positions_only: bool = False) -> GroupMotion:
    """Return the motion of the group C = K_i + s_i e(t_i) + r_i n(t_i) = K_j + s_j e(t_j) + r_j n(t_j).

    The offsets r_i, r_j (m) are those of the guides.  Coordinates s_i, s_j (m); meets C.
    determinant = scaled = sin(t_i - t_j).  There is one assembly mode.
    Raises `CannotAssemble` where the guides are parallel and the lines of the pin are apart; `AtDeadPoint` where
    these lines coincide, even with `positions_only`: the hinge may then be anywhere on them.

    >>> import numpy as np
    >>> from coursework.procedures import Guide, Pair, prp
    >>> found = prp(Guide(Pair([0.0, 0.0]), angle=np.pi / 4), Guide(Pair([0.3, 0.0]), angle=np.pi / 2))
    >>> found.coordinates.round(4).tolist(), found.meets.position.round(9).tolist()  # m
    ([[0.4243, 0.3]], [[0.3, 0.3]])
    """
    i, j = Line(guide_i, "PRP, guide i"), Line(guide_j, "PRP, guide j")
    n = count_rows("PRP", guide_i=guide_i.rows, guide_j=guide_j.rows)
    w = j.k - i.k
    sine = np.sin(guide_j.angle - guide_i.angle)
    turned = np.maximum(np.abs(guide_i.angle), np.abs(guide_j.angle))
    require_crossing("PRP", sine, turned, cross(i.e, w), (i.k, j.k), "group.line.of_pin")
    s_i, s_j = cross(w, j.e) / sine, cross(w, i.e) / sine
    at_c = i.point(s_i)
    solved = partial(group_motion, "PRP", 1, n, coordinates=(s_i, s_j), determinant=-sine, scaled=-sine)
    if positions_only:
        return solved(meets=(at_c, None, None))

    # a [s_i'; s_j'] = right side; the columns of a are e(t_i) and -e(t_j)
    carried = i.carried(s_i)
    right = j.carried(s_j) - carried
    ds_i, ds_j = cross(right, j.e) / sine, cross(right, i.e) / sine
    carried_on = i.carried_acceleration(s_i, ds_i)
    right = j.carried_acceleration(s_j, ds_j) - carried_on
    dds_i, dds_j = cross(right, j.e) / sine, cross(right, i.e) / sine
    return solved(
        rates=(ds_i, ds_j),
        accelerations=(dds_i, dds_j),
        meets=(at_c, carried + ds_i * i.e, carried_on + dds_i * i.e),
    )


def _closure(group: Group) -> Closed:
    sides = tuple(map(slid, group.guides, unknowns(group)))
    return sides, sides[0]


def _solve(known: Known, mode: int) -> GroupMotion:
    return prp(known.guides[0], known.guides[1], positions_only=True)


def _joints(group: Group, points: Sequence[str], guides: Sequence[str], own: Sequence[str]) -> tuple[Joint, ...]:
    hinge = _closure(group)[1]
    pairs = zip(zip(own, guides, strict=True), group.guides, strict=True)
    slides = [Joint(PRISMATIC, pair, hinge, guide.angle) for pair, guide in pairs]
    return (*slides, Joint(REVOLUTE, (own[0], own[1]), hinge))


PRP = GroupKind("PRP", GROUP_SHAPES["PRP"], _closure, _solve, _joints, meaning="determinant.parallel")
