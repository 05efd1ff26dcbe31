"""The dyad RPR: a block hinged at B slides along a rod that turns about D.

Enters: pairs B, D, the offset of the hinge, the rod.  Leaves: angle of the rod, slide, motion of its end E.
At a dead point the block is level with the pivot, s = 0.  Source: [deck] 5-4, [library] 2PG3V with its offset.
Used by `mechanism/groups/__init__.py` and `procedures.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups import assembly
from coursework.mechanism.groups.assembly import TEXTBOOK, at, dead, metres, numbers, refuse, rows_where
from coursework.mechanism.groups.joint import PRISMATIC, REVOLUTE, Joint
from coursework.mechanism.groups.kind import Closed, GroupKind, Known, across, along, plus, unknowns
from coursework.mechanism.groups.pairs import At, GroupMotion, count_rows, group_motion, pair_of
from coursework.mechanism.groups.plane import angle_of, cross, dot, vectors
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import GROUP_SHAPES
from coursework.words.sentences import say

MODES = GROUP_SHAPES["RPR"].modes


def rpr(
    b: At,
    d: At,
    *,
    offset: ArrayLike = 0.0,
    end_length: ArrayLike | None = None,
    mode: int = 1,
    positions_only: bool = False,
) -> GroupMotion:
    """Return the motion of the group B = D + s e(theta) + e0 n(theta).

    `offset` e0 (m) of the hinge to the left of the rod's line; `end_length` (m) from D along the rod to its
    end E; `mode` +1: s > 0, -1: s < 0.  Coordinates theta (rad), s (m); meets E, or B if no end is given.
    determinant = -s (m); scaled = -s / L, where L is the largest BD of all rows, or the end length if that is larger.
    Raises `CannotAssemble` where BD < |e0|; `AtDeadPoint` where s = 0, unless `positions_only`, and always
    where B lies on D, because the rod may then point anywhere; `ValueError` for a wrong mode or length.

    >>> from coursework.procedures import Pair, rpr
    >>> found = rpr(Pair([0.3, 0.4], velocity=[-0.8, 0.6]), Pair([0.0, 0.0]))
    >>> found.coordinates.round(4).tolist(), found.rates.round(4).tolist()  # rad and m, rad/s and m/s
    ([[0.9273, 0.5]], [[2.0, 0.0]])
    """
    assembly.require_mode("RPR", mode, MODES)
    b, d = pair_of(b), pair_of(d)
    e0 = numbers("RPR, the offset", offset)
    end = None if end_length is None else numbers("RPR, the rod to its end", end_length, positive=True)
    n = count_rows("RPR", B=b.rows, D=d.rows, offset=len(e0), end=1 if end is None else len(end))
    at_b, at_d = vectors(b.position), vectors(d.position)
    v = at_b - at_d
    apart = np.abs(v)

    spare = apart - np.abs(e0)
    rounding = assembly.tolerance(at_b, at_d, e0)
    if (spare < -rounding).any():
        rows = rows_where(spare < -rounding, n)
        short = -at(spare, rows[0])
        apart_at, offset = (metres(at(one, rows[0]), short) for one in (apart, np.abs(e0)))
        raise refuse("RPR", rows, say("group.offset", **TEXTBOOK, apart=apart_at, offset=offset, short=metres(short)), short)
    if (apart <= rounding).any():
        raise dead("RPR", rows_where(apart <= rounding, n), say("group.dead.on_pivot", **TEXTBOOK), placed=False)
    limit = spare <= rounding
    s = mode * np.sqrt(np.where(limit, 0.0, spare * (apart + np.abs(e0))))
    e = v * (s - 1j * e0)
    e /= np.abs(e)
    coordinates = (angle_of(e), s)
    longest = apart.max(initial=0.0) if end is None else np.maximum(apart.max(initial=0.0), end)
    determinant, scaled = -s, -s / longest
    meets = at_b if end is None else at_d + end * e
    solved = partial(group_motion, "RPR", mode, n, coordinates=coordinates, determinant=determinant, scaled=scaled)
    if positions_only:
        return solved(meets=(meets, None, None))
    if limit.any():
        raise dead("RPR", rows_where(limit, n), say("group.dead.level", **TEXTBOOK))

    # a [theta'; s'] = right side; the columns of a are i v and e
    (v_b, a_b), (v_d, a_d) = b.motion("RPR, pair B"), d.motion("RPR, pair D")
    right = v_b - v_d
    rate, ds = cross(e, right) / s, dot(v, right) / s
    right = a_b - a_d - 2j * rate * ds * e + rate * rate * v
    acceleration, dds = cross(e, right) / s, dot(v, right) / s
    if end is not None:
        v_b = v_d + 1j * (rate * end) * e
        a_b = a_d + (1j * acceleration - rate * rate) * end * e
    return solved(rates=(rate, ds), accelerations=(acceleration, dds), meets=(meets, v_b, a_b))


def _closure(group: Group) -> Closed:
    (angle, slide), (block, pivot) = unknowns(group), group.start_points
    end = plus(pivot, along(group.lengths[0], angle)) if group.lengths else block
    return (block, plus(pivot, along(slide, angle), *across(group.offset, angle))), end


def _solve(known: Known, mode: int) -> GroupMotion:
    end = known.lengths[0] if known.lengths else None
    return rpr(*known.points, offset=known.offset, end_length=end, mode=mode, positions_only=True)


def _joints(group: Group, points: Sequence[str], guides: Sequence[str], own: Sequence[str]) -> tuple[Joint, ...]:
    block, rod = own
    return (
        Joint(REVOLUTE, (points[0], block), group.start_points[0]),
        Joint(PRISMATIC, (block, rod), group.start_points[0], unknowns(group)[0]),
        Joint(REVOLUTE, (rod, points[1]), group.start_points[1]),
    )


RPR = GroupKind("RPR", GROUP_SHAPES["RPR"], _closure, _solve, _joints, carries=(1, 0))
