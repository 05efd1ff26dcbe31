"""The crank: a link on a known pivot, with a given angle.

Enters: the pivot A, length, angle, angular velocity and acceleration.  Leaves: the motion of the pin B.
Source: [deck], crank; a length that varies in time as in [Pasika].
Used by `mechanism/groups/__init__.py` and `procedures.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups import assembly
from coursework.mechanism.groups.assembly import Length, numbers
from coursework.mechanism.groups.joint import REVOLUTE, Joint
from coursework.mechanism.groups.kind import Closed, GroupKind, along, plus, unknowns
from coursework.mechanism.groups.pairs import At, GroupMotion, count_rows, group_motion, pair_of
from coursework.mechanism.groups.plane import direction, vectors
from coursework.variant.record.variant import Group
from coursework.variant.record.vocabulary import GROUP_SHAPES


def crank(a: At, *, length: Length, angle: ArrayLike, rate: ArrayLike, acceleration: ArrayLike = 0.0) -> GroupMotion:
    """Return the motion of the pin, B = A + r e(angle).

    `length` r (m) or (r, r', r'') in m, m/s, m/s^2; `angle` (rad), `rate` (rad/s), `acceleration` (rad/s^2):
    one number or one per row.  The coordinate is the angle as given, not reduced to one turn.  Nothing is solved,
    so the determinant is 1.  With rate 1, acceleration 0 and r', r'' differentiated by the angle, the result is
    in analogs.
    Raises `ValueError` for a length that is not finite and above zero.

    >>> import numpy as np
    >>> from coursework.procedures import Pair, crank
    >>> pin = crank(Pair([0.0, 0.0]), length=0.1, angle=[0.0, np.pi / 2], rate=10.0).meets
    >>> pin.position.round(9).tolist(), pin.velocity.round(9).tolist()  # m, m/s
    ([[0.1, 0.0], [0.0, 0.1]], [[0.0, 1.0], [-1.0, 0.0]])
    """
    a, (r, dr, ddr) = pair_of(a), assembly.length("crank, its length", length)
    turn, w, al = (
        numbers(f"crank, {what}", value) for what, value in (("angle", angle), ("rate", rate), ("acceleration", acceleration))
    )
    n = count_rows("crank", A=a.rows, length=len(r), angle=len(turn), rate=len(w), acceleration=len(al))
    velocity, gain = a.motion("crank, pivot A")
    e = direction(turn)
    # d/dt and d2/dt2 of r e(angle), divided by e: real part along the crank, imaginary part across it
    first = 1j * (r * w)
    second = 1j * (r * al) - r * w * w
    if dr is not None and ddr is not None:
        first = first + dr
        second = second + ddr + 2j * dr * w
    one = np.ones(1)
    return group_motion(
        "crank",
        1,
        n,
        coordinates=(turn,),
        rates=(w,),
        accelerations=(al,),
        meets=(vectors(a.position) + r * e, velocity + first * e, gain + second * e),
        determinant=one,
        scaled=one,
    )


def _closure(group: Group) -> Closed:
    return (), plus(group.start_points[0], along(group.lengths[0], unknowns(group)[0]))


def _joints(group: Group, points: Sequence[str], guides: Sequence[str], own: Sequence[str]) -> tuple[Joint, ...]:
    return (Joint(REVOLUTE, (points[0], own[0]), group.start_points[0]),)


CRANK = GroupKind("crank", GROUP_SHAPES["crank"], _closure, None, _joints, carries=(0,))
