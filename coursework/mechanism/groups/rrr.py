"""The dyad RRR: two links with three revolute joints; B and D known, C unknown.

Enters: pairs B, D, lengths, assembly mode.  Leaves: angles of both links and the motion of C.
At a dead point both links lie on one line.  Source: [deck] 5-2, [library] 2PG1V with equation (1).
Used by `mechanism/groups/__init__.py` and `procedures.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from coursework.mechanism.groups import assembly
from coursework.mechanism.groups.assembly import TEXTBOOK, CannotAssemble, Length, at, dead, metres, refuse, rows_where
from coursework.mechanism.groups.joint import REVOLUTE, Joint
from coursework.mechanism.groups.kind import Closed, GroupKind, Known, along, plus, unknowns
from coursework.mechanism.groups.pairs import At, GroupMotion, count_rows, group_motion, pair_of
from coursework.mechanism.groups.plane import Vectors, angle_of, dot, vectors
from coursework.system.arrays import Array
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import GROUP_SHAPES
from coursework.words.sentences import say

MODES = GROUP_SHAPES["RRR"].modes


def rrr(b: At, d: At, *, lengths: tuple[Length, Length], mode: int, positions_only: bool = False) -> GroupMotion:
    """Return the motion of the group C = B + r_i e(theta_i) = D + r_j e(theta_j).

    `lengths` (m) of the link from B and of the link from D, each constant or (value, rate, second rate);
    `mode` +1: C to the left of the ray from B to D, -1: right.  Coordinates theta_i, theta_j (rad); meets C.
    determinant = r_i r_j sin(theta_i - theta_j) (m^2), scaled = sin(theta_i - theta_j).
    Raises `CannotAssemble` unless |r_i - r_j| <= BD <= r_i + r_j; `AtDeadPoint` where the links lie on one
    line, unless `positions_only`, and always where B lies on D, because equal links may then point anywhere;
    `ValueError` for a wrong mode or length, or a number of lengths other than two.

    >>> import numpy as np
    >>> from coursework.procedures import Pair, rrr
    >>> found = rrr(Pair([0.0, 0.0]), Pair([0.5, 0.0]), lengths=(0.4, 0.3), mode=1)
    >>> found.meets.position.round(9).tolist(), np.rad2deg(found.coordinates).round(2).tolist()
    ([[0.32, 0.24]], [[36.87, 126.87]])
    >>> rrr(Pair([0.0, 0.0]), Pair([0.8, 0.0]), lengths=(0.4, 0.3), mode=1)
    Traceback (most recent call last):
        ...
    coursework.mechanism.groups.assembly.CannotAssemble: RRR cannot be assembled at row 0:
    B and D are 0.8000 m apart, the two links reach 0.7000 m; together they are 0.1000 m too short.
    """
    assembly.require_mode("RRR", mode, MODES)
    if not hasattr(lengths, "__len__") or len(lengths) != 2:
        raise ValueError(f"RRR: two lengths were expected, of the link from B and of the link from D, found {lengths!r}.")
    b, d = pair_of(b), pair_of(d)
    r_i, dr_i, ddr_i = assembly.length("RRR, the link from B", lengths[0])
    r_j, dr_j, ddr_j = assembly.length("RRR, the link from D", lengths[1])
    n = count_rows("RRR", B=b.rows, D=d.rows, link_from_B=len(r_i), link_from_D=len(r_j))
    at_b, at_d = vectors(b.position), vectors(d.position)
    v = at_d - at_b
    apart = np.abs(v)

    stretched = r_i + r_j - apart  # distances (m) left until the links are stretched, and until they are folded
    folded = apart - np.abs(r_i - r_j)
    spare = np.minimum(stretched, folded)
    rounding = assembly.tolerance(at_b, at_d, r_i + r_j)
    if (spare < -rounding).any():
        raise _out_of_reach(rows_where(spare < -rounding, n), apart, r_i, r_j)
    if (apart <= rounding).any():  # only links of equal length get here: they may point anywhere
        raise dead("RRR", rows_where(apart <= rounding, n), say("group.dead.equal", **TEXTBOOK), placed=False)
    limit = spare <= rounding

    # Heron's product keeps the digits that r_i^2 - x^2 loses near a dead point
    area = np.where(limit, 0.0, stretched * folded * (r_i + r_j + apart) * (apart + np.abs(r_i - r_j)))
    across = mode * np.sqrt(area) / (2.0 * apart)
    skew = (r_i - r_j) * (r_i + r_j) / apart
    ray = v / apart
    u_i = (0.5 * (apart + skew) + 1j * across) * ray  # from B to C
    u_j = (0.5 * (skew - apart) + 1j * across) * ray  # from D to C
    theta = (angle_of(u_i), angle_of(u_j))
    determinant = -apart * across
    scaled = determinant / (r_i * r_j)
    at_c = at_b + u_i
    solved = partial(group_motion, "RRR", mode, n, coordinates=theta, determinant=determinant, scaled=scaled)
    if positions_only:
        return solved(meets=(at_c, None, None))
    if limit.any():
        rows = rows_where(limit, n)
        how = "group.dead.stretched" if at(stretched, rows[0]) < at(folded, rows[0]) else "group.dead.folded"
        raise dead("RRR", rows, say(how, **TEXTBOOK))

    # a [theta_i'; theta_j'] = right side; the columns of a are i u_i and -i u_j
    (v_b, a_b), (v_d, a_d) = b.motion("RRR, pair B"), d.motion("RRR, pair D")
    grow_i, grow_j = _growth(u_i, r_i, dr_i), _growth(u_j, r_j, dr_j)
    right = v_d + grow_j - v_b - grow_i
    w_i, w_j = -dot(u_j, right) / determinant, -dot(u_i, right) / determinant
    # acceleration of each end without angular acceleration: centripetal, and Coriolis of a varying length
    free_i = _growth(u_i, r_i, ddr_i) + 2j * w_i * grow_i - w_i * w_i * u_i
    free_j = _growth(u_j, r_j, ddr_j) + 2j * w_j * grow_j - w_j * w_j * u_j
    right = a_d + free_j - a_b - free_i
    al_i, al_j = -dot(u_j, right) / determinant, -dot(u_i, right) / determinant
    return solved(
        rates=(w_i, w_j),
        accelerations=(al_i, al_j),
        meets=(at_c, v_b + grow_i + 1j * w_i * u_i, a_b + free_i + 1j * al_i * u_i),
    )


def _growth(u: Vectors, r: Array, rate: Array | None) -> Vectors:
    """Return the velocity that a varying length adds along its link: rate * u / r, zero for a constant length."""
    return np.zeros(1, dtype=np.complex128) if rate is None else u * (rate / r)


def _out_of_reach(rows: tuple[int, ...], apart: Array, r_i: Array, r_j: Array) -> CannotAssemble:
    row = rows[0]
    short = at(apart - (r_i + r_j), row)
    if short > 0.0:
        key, name, other = "group.short", "reach", at(r_i + r_j, row)
    else:
        key, name, other = "group.fold", "gap", at(np.abs(r_i - r_j), row)
        short = at(np.abs(r_i - r_j) - apart, row)
    lengths = {"apart": metres(at(apart, row), short), name: metres(other, short), "short": metres(short)}
    return refuse("RRR", rows, say(key, **TEXTBOOK, **lengths), short)


def _closure(group: Group) -> Closed:
    arms = zip(group.start_points, group.lengths, unknowns(group), strict=True)
    sides = tuple(plus(point, along(length, angle)) for point, length, angle in arms)
    return sides, sides[0]


def _solve(known: Known, mode: int) -> GroupMotion:
    return rrr(*known.points, lengths=(known.lengths[0], known.lengths[1]), mode=mode, positions_only=True)


def _joints(group: Group, points: Sequence[str], guides: Sequence[str], own: Sequence[str]) -> tuple[Joint, ...]:
    ends = [Joint(REVOLUTE, pair, point) for pair, point in zip(zip(points, own, strict=True), group.start_points, strict=True)]
    return (*ends, Joint(REVOLUTE, (own[0], own[1]), _closure(group)[1]))


RRR = GroupKind("RRR", GROUP_SHAPES["RRR"], _closure, _solve, _joints)
