"""The dyad RPP: block i, hinged at B, slides on block j, which slides on a guide.

Enters: pair B, the guide, the angle between the slides.  Leaves: both slides, and the motion of D on block j.
At a dead point the slides are parallel, and the position is not defined either.  Source: [deck] 5-5 with the sign of b
corrected, [library] 2PG5V.
Used by `mechanism/groups/__init__.py` and `procedures.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups.assembly import numbers, require_crossing
from coursework.mechanism.groups.joint import PRISMATIC, REVOLUTE, Joint
from coursework.mechanism.groups.kind import QUARTER, Closed, GroupKind, Known, along, plus, slid, unknowns
from coursework.mechanism.groups.line import Line
from coursework.mechanism.groups.pairs import At, GroupMotion, Guide, count_rows, group_motion, pair_of
from coursework.mechanism.groups.plane import cross, direction, vectors
from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import GROUP_SHAPES


def rpp(b: At, guide: Guide, *, slide_angle: ArrayLike, positions_only: bool = False) -> GroupMotion:
    """Return the motion of the group B = K + h n(t_j) + s_j e(t_j) + s_i e(t_i + t_j).

    `guide` through K at the angle t_j with the offset h of block j; `slide_angle` t_i (rad), constant, from
    the guide to the slide of block i.  Coordinates s_i, s_j (m), in this order; meets D of block j.
    determinant = scaled = -sin(t_i).  There is one assembly mode.
    Raises `CannotAssemble` where the slides are parallel and B is off the line of D; `AtDeadPoint` where they
    are parallel and B is on it, even with `positions_only`: block j may then be anywhere on the line.

    >>> import numpy as np
    >>> from coursework.procedures import Guide, Pair, rpp
    >>> found = rpp(Pair([0.3, 0.4], velocity=[1.0, 2.0]), Guide(Pair([0.0, 0.0]), angle=0.0), slide_angle=np.pi / 2)
    >>> found.coordinates.round(9).tolist(), found.rates.round(9).tolist()  # m, m/s
    ([[0.4, 0.3]], [[2.0, 1.0]])
    """
    b, t_i = pair_of(b), numbers("RPP, the slide angle", slide_angle)
    line = Line(guide, "RPP, guide")
    n = count_rows("RPP", B=b.rows, guide=guide.rows, slide_angle=len(t_i))
    at_b, e = vectors(b.position), line.e
    f = e * direction(t_i)
    w = at_b - line.k
    sine = np.sin(t_i)
    require_crossing("RPP", sine, np.abs(t_i), cross(e, w), (at_b, line.k), "group.line.of_b")
    s_i, s_j = cross(e, w) / sine, cross(w, f) / sine
    at_d = line.point(s_j)
    solved = partial(group_motion, "RPP", 1, n, coordinates=(s_i, s_j), determinant=-sine, scaled=-sine)
    if positions_only:
        return solved(meets=(at_d, None, None))

    # a [s_i'; s_j'] = right side; the columns of a are f and e; block i slides on j, and both turn with the guide
    v_b, a_b = b.motion("RPP, pair B")
    turn, gain = guide.rate, guide.acceleration
    carried = line.carried(s_j)
    right = v_b - carried - (1j * turn * s_i) * f
    ds_i, ds_j = cross(e, right) / sine, cross(right, f) / sine
    carried_on = line.carried_acceleration(s_j, ds_j)
    right = a_b - carried_on - ((1j * gain - turn * turn) * s_i + 2j * turn * ds_i) * f
    dds_i, dds_j = cross(e, right) / sine, cross(right, f) / sine
    return solved(rates=(ds_i, ds_j), accelerations=(dds_i, dds_j), meets=(at_d, carried + ds_j * e, carried_on + dds_j * e))


def _slide(group: Group) -> Formula:
    return plus(group.guides[0].angle, group.angle or QUARTER)


def _closure(group: Group) -> Closed:
    (on_block, on_guide), guide = unknowns(group), group.guides[0]
    met = slid(guide, on_guide)
    return (group.start_points[0], plus(met, along(on_block, _slide(group)))), met


def _solve(known: Known, mode: int) -> GroupMotion:
    angle = known.angle if known.angle is not None else np.pi / 2
    return rpp(known.points[0], known.guides[0], slide_angle=angle, positions_only=True)


def _joints(group: Group, points: Sequence[str], guides: Sequence[str], own: Sequence[str]) -> tuple[Joint, ...]:
    return (
        Joint(REVOLUTE, (points[0], own[0]), group.start_points[0]),
        Joint(PRISMATIC, (own[0], own[1]), group.start_points[0], _slide(group)),
        Joint(PRISMATIC, (own[1], guides[0]), _closure(group)[1], group.guides[0].angle),
    )


RPP = GroupKind("RPP", GROUP_SHAPES["RPP"], _closure, _solve, _joints, meaning="determinant.parallel")
