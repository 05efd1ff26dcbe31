"""The dyad RRP: a rod from B to a block on a guide.

Enters: pair B, the guide, the rod, assembly mode.  Leaves: angle of the rod, slide, and motion of the pin C.
At a dead point the rod is perpendicular to the guide.  Source: [deck] 5-3, [library] 2PG2V with its offset.
Used by `mechanism/groups/__init__.py` and `procedures.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from coursework.mechanism.groups import assembly
from coursework.mechanism.groups.assembly import TEXTBOOK, Length, at, dead, metres, refuse, rows_where
from coursework.mechanism.groups.joint import PRISMATIC, REVOLUTE, Joint
from coursework.mechanism.groups.kind import Closed, GroupKind, Known, along, plus, slid, unknowns
from coursework.mechanism.groups.line import Line
from coursework.mechanism.groups.pairs import At, GroupMotion, Guide, count_rows, group_motion, pair_of
from coursework.mechanism.groups.plane import angle_of, cross, dot, vectors
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import GROUP_SHAPES
from coursework.words.sentences import say

MODES = GROUP_SHAPES["RRP"].modes


def rrp(b: At, guide: Guide, *, length: Length, mode: int, positions_only: bool = False) -> GroupMotion:
    """Return the motion of the group C = B + r e(theta) = K + s e(t_j) + h n(t_j).

    `guide` through K at the angle t_j with the offset h; `length` r (m) of the rod, constant or (value, rate,
    second rate); `mode` +1: the larger s, -1: the smaller.  Coordinates theta (rad), s (m); meets C.
    determinant = r cos(theta - t_j) (m), scaled = cos(theta - t_j).
    Raises `CannotAssemble` where B is farther from the line of C than r; `AtDeadPoint` where the rod is
    perpendicular to the guide, unless `positions_only`; `ValueError` for a wrong mode or length.

    >>> from coursework.procedures import Guide, Pair, rrp
    >>> found = rrp(Pair([0.0, 0.3], velocity=[0.0, 0.4]), Guide(Pair([0.0, 0.0]), angle=0.0), length=0.5, mode=1)
    >>> found.coordinates.round(4).tolist(), found.rates.round(4).tolist()  # rad and m, rad/s and m/s
    ([[-0.6435, 0.4]], [[-1.0, -0.3]])
    """
    assembly.require_mode("RRP", mode, MODES)
    b, (r, dr, ddr) = pair_of(b), assembly.length("RRP, the rod", length)
    line = Line(guide, "RRP, guide")
    n = count_rows("RRP", B=b.rows, guide=guide.rows, rod=len(r))
    at_b, e = vectors(b.position), line.e
    w = at_b - line.k
    q = cross(e, w)  # B lies this far to the left of the line of C

    spare = r - np.abs(q)
    rounding = assembly.tolerance(at_b, line.k, r)
    if (spare < -rounding).any():
        rows = rows_where(spare < -rounding, n)
        far, short = at(np.abs(q), rows[0]), -at(spare, rows[0])
        reason = say("group.rod", **TEXTBOOK, far=metres(far, short), length=metres(at(r, rows[0]), short), short=metres(short))
        raise refuse("RRP", rows, reason, short)
    limit = spare <= rounding
    along = mode * np.sqrt(np.where(limit, 0.0, spare * (r + np.abs(q))))
    s = dot(e, w) + along
    u = (along - 1j * q) * e  # from B to C
    coordinates = (angle_of(u), s)
    at_c = line.point(s)
    solved = partial(group_motion, "RRP", mode, n, coordinates=coordinates, determinant=along, scaled=along / r)
    if positions_only:
        return solved(meets=(at_c, None, None))
    if limit.any():
        raise dead("RRP", rows_where(limit, n), say("group.dead.perpendicular"))

    # a [theta'; s'] = right side; the columns of a are i u and -e
    v_b, a_b = b.motion("RRP, pair B")
    lengthening = 0.0 if dr is None else u * (dr / r)
    carried = line.carried(s)
    right = carried - v_b - lengthening
    rate, ds = cross(e, right) / along, -dot(u, right) / along
    carried_on = line.carried_acceleration(s, ds)
    right = carried_on - a_b + rate * rate * u - 2j * rate * lengthening
    if ddr is not None:
        right = right - u * (ddr / r)
    acceleration, dds = cross(e, right) / along, -dot(u, right) / along
    return solved(rates=(rate, ds), accelerations=(acceleration, dds), meets=(at_c, carried + ds * e, carried_on + dds * e))


def _closure(group: Group) -> Closed:
    (angle, slide), guide = unknowns(group), group.guides[0]
    pin = plus(group.start_points[0], along(group.lengths[0], angle))
    return (pin, slid(guide, slide)), pin


def _solve(known: Known, mode: int) -> GroupMotion:
    return rrp(known.points[0], known.guides[0], length=known.lengths[0], mode=mode, positions_only=True)


def _joints(group: Group, points: Sequence[str], guides: Sequence[str], own: Sequence[str]) -> tuple[Joint, ...]:
    pin = _closure(group)[1]
    return (
        Joint(REVOLUTE, (points[0], own[0]), group.start_points[0]),
        Joint(REVOLUTE, (own[0], own[1]), pin),
        Joint(PRISMATIC, (own[1], guides[0]), pin, group.guides[0].angle),
    )


RRP = GroupKind("RRP", GROUP_SHAPES["RRP"], _closure, _solve, _joints, meaning="determinant.right_angle")
