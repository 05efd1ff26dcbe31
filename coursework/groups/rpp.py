"""The dyad RPP: block i, hinged at B, slides on block j, which slides on a guide.

Enters: pair B, the guide, the angle between the slides.  Leaves: both slides, and the motion of D on block j.
Dead when the slides are parallel, and then without a position too.  Source: [deck] 5-5 with the sign of b put
right, [library] 2PG5V.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from coursework.groups.assembly import numbers, require_crossing
from coursework.groups.line import Line
from coursework.groups.pairs import GroupMotion, Guide, Pair, count_rows, group_motion
from coursework.groups.plane import cross, direction, vectors


def rpp(b: Pair, guide: Guide, *, slide_angle: ArrayLike, positions_only: bool = False) -> GroupMotion:
    """Return the motion of the group B = K + h n(t_j) + s_j e(t_j) + s_i e(t_i + t_j).

    `guide` through K at the angle t_j with the offset h of block j; `slide_angle` t_i (rad), constant, from
    the guide to the slide of block i.  Coordinates s_i, s_j (m), in this order; meets D of block j.
    determinant = scaled = -sin(t_i).  There is one assembly mode.
    Raises `CannotAssemble` where the slides are parallel and B is off the line of D; `AtDeadPoint` where they
    are parallel and B is on it, whatever `positions_only`: block j may then stand anywhere.
    """
    t_i = numbers("RPP, the slide angle", slide_angle)
    n = count_rows("RPP", B=b.rows, guide=guide.rows, slide_angle=len(t_i))
    line = Line(guide, "RPP, guide")
    at_b, e = vectors(b.position), line.e
    f = e * direction(t_i)
    w = at_b - line.k
    sine = np.sin(t_i)
    require_crossing("RPP", sine, np.abs(t_i), cross(e, w), (at_b, line.k), "B and the line of D")
    s_i, s_j = cross(e, w) / sine, cross(w, f) / sine
    at_d = line.point(s_j)
    solved = partial(group_motion, "RPP", 1, n, coordinates=(s_i, s_j), determinant=-sine, scaled=-sine)
    if positions_only:
        return solved(meets=(at_d, None, None))

    # a [s_i'; s_j'] = right side; the columns of a are f and e; block i rides on j, both turn with the guide
    v_b, a_b = b.motion("RPP, pair B")
    turn, gain = guide.rate, guide.acceleration
    carried = line.carried(s_j)
    right = v_b - carried - (1j * turn * s_i) * f
    ds_i, ds_j = cross(e, right) / sine, cross(right, f) / sine
    carried_on = line.carried_acceleration(s_j, ds_j)
    right = a_b - carried_on - ((1j * gain - turn * turn) * s_i + 2j * turn * ds_i) * f
    dds_i, dds_j = cross(e, right) / sine, cross(right, f) / sine
    return solved(
        rates=(ds_i, ds_j),
        accelerations=(dds_i, dds_j),
        meets=(at_d, carried + ds_j * e, carried_on + dds_j * e),
    )
