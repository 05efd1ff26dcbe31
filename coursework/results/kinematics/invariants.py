"""Invariants of a stroke: displacement, velocity and acceleration without metres and without seconds.

Enters: analogs or true values of one stroke, its length S and crank angle Phi.  Leaves: a_k, b_k, c_k, or back.
Used by `extra.py` and, through `procedures.py`, by students.  Source: [Pasika], (6)-(8), with the stroke put right.

With k from 0 to 1 along the stroke, phi = phi_0 + k Phi:  a_k = s / S,  b_k = da_k/dk,  c_k = db_k/dk.

A trap of the printed text: it writes one symbol S_a for two lengths.  In its formula (5) S_a is a *position*,
that of the outer end of the slider's path, from which displacements are counted; in (6)-(8) it must be the
*stroke*, the distance between the two ends.  For a centric slider-crank in analogs the position is 1 + l2 and
the stroke is 2.  Only with the stroke does a_k reach 1 at the end.  Here both are called by their names, and
functions ask for the stroke.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from coursework.results.kinematics.analogs import acceleration_analog, true_acceleration, true_velocity, velocity_analog
from coursework.system.arrays import Array
from coursework.system.frozen import frozen, single


@single
class Invariants:
    """a_k, b_k, c_k, each (n,) and without a unit, with the `stroke` S and the crank `angle` Phi (rad).

    >>> from coursework.procedures import from_analogs
    >>> way = from_analogs([0.0, 0.1, 0.4], [0.0, 0.2, 0.4], [0.2, 0.2, 0.2], stroke=0.4, angle=2.0)
    >>> way.a.tolist(), way.b.tolist(), way.c.tolist()
    ([0.0, 0.25, 1.0], [0.0, 1.0, 2.0], [2.0, 2.0, 2.0])
    """

    a: Array
    b: Array
    c: Array
    stroke: float
    angle: float


@frozen
class Stroke:
    """One way of the slider, from its outer end to its inner end.

    `length` S in the unit of the crank, crank `angle` Phi (rad), the crank angles of both ends (rad), and
    `outer_position` of the slider: the S_a of formula (5), which is not the stroke.

    >>> import math
    >>> from coursework.procedures import crank_stroke
    >>> centric = crank_stroke(0.4, crank=0.1)
    >>> round(centric.length, 9), round(centric.outer_position, 9), round(math.degrees(centric.inner_angle))
    (0.2, 0.5, 180)
    """

    length: float
    angle: float
    outer_angle: float
    inner_angle: float
    outer_position: float


def crank_stroke(rod: float, offset: float = 0.0, crank: float = 1.0) -> Stroke:
    """Return the stroke of a slider-crank with a crank of constant length, from the outer to the inner end.

    `rod` l2, `offset` e of the slider's line, `crank` l1: in one unit; with crank 1 the result is in analogs.
    S = sqrt((l2+l1)^2 - e^2) - sqrt((l2-l1)^2 - e^2),  Phi = pi + arcsin(e/(l2-l1)) - arcsin(e/(l2+l1)).
    Raises `ValueError` unless the crank can turn fully, l2 - l1 > |e|.

    >>> import math
    >>> from coursework.procedures import crank_stroke
    >>> stroke = crank_stroke(0.4, offset=0.05, crank=0.1)
    >>> round(stroke.length, 4), round(math.degrees(stroke.angle), 2)
    (0.2017, 183.85)
    """
    if not (math.isfinite(rod + offset + crank) and crank > 0.0 and rod - crank > abs(offset)):
        raise ValueError(
            "slider-crank: the crank turns fully only if rod - crank > |offset|, "
            f"found rod {rod:g}, crank {crank:g}, offset {offset:g}."
        )
    outer = math.asin(offset / (rod + crank))
    inner = math.pi + math.asin(offset / (rod - crank))
    far = math.sqrt((rod + crank - offset) * (rod + crank + offset))
    near = math.sqrt((rod - crank - offset) * (rod - crank + offset))
    # far - near as a quotient: the difference itself loses digits when the crank is short
    return Stroke(4.0 * rod * crank / (far + near), inner - outer, outer, inner, far)


def from_analogs(s: ArrayLike, v: ArrayLike, a: ArrayLike, *, stroke: float, angle: float) -> Invariants:
    """Return a_k = s/S, b_k = v Phi/S, c_k = a Phi^2/S.

    `s`, `v`, `a` (n,) displacement from the start of the stroke and its derivatives with respect to the crank
    angle; `stroke` S in the unit of `s`, `angle` Phi (rad).  Raises `ValueError` unless S and Phi are finite
    and above zero.

    >>> from coursework.procedures import from_analogs
    >>> even = from_analogs([0.0, 0.1, 0.2], [0.1, 0.1, 0.1], [0.0, 0.0, 0.0], stroke=0.2, angle=2.0)
    >>> even.a.tolist(), even.b.tolist(), even.c.tolist()
    ([0.0, 0.5, 1.0], [1.0, 1.0, 1.0], [0.0, 0.0, 0.0])
    """
    _require_scale(stroke, angle)
    one, two, three = (np.asarray(part, dtype=np.float64) for part in (s, v, a))
    return Invariants(one / stroke, two * (angle / stroke), three * (angle * angle / stroke), stroke, angle)


def to_analogs(invariants: Invariants) -> tuple[Array, Array, Array]:
    """Return s, v, a: displacement and its derivatives by the crank angle, each (n,) in the unit of the stroke.

    >>> from coursework.procedures import from_analogs, to_analogs
    >>> even = from_analogs([0.0, 0.1, 0.2], [0.1, 0.1, 0.1], [0.0, 0.0, 0.0], stroke=0.2, angle=2.0)
    >>> [part.round(9).tolist() for part in to_analogs(even)]
    [[0.0, 0.1, 0.2], [0.1, 0.1, 0.1], [0.0, 0.0, 0.0]]
    """
    ratio = invariants.stroke / invariants.angle
    return invariants.a * invariants.stroke, invariants.b * ratio, invariants.c * (ratio / invariants.angle)


def from_true(
    s: ArrayLike, velocity: ArrayLike, acceleration: ArrayLike,
    *, stroke: float, angle: float, omega_1: ArrayLike, epsilon_1: ArrayLike = 0.0,
) -> Invariants:  # fmt: skip
    """Return the invariants of true `s` (m), `velocity` (m/s), `acceleration` (m/s^2); `stroke` S (m).

    `angle` Phi (rad), `omega_1` (rad/s), `epsilon_1` (rad/s^2) of the crank.  Raises `ValueError` as
    `from_analogs`, and where omega_1 = 0.

    >>> from coursework.procedures import from_true
    >>> from_true([0.0, 0.1, 0.2], [0.5, 0.5, 0.5], [0.0, 0.0, 0.0], stroke=0.2, angle=2.0, omega_1=5.0).b.tolist()
    [1.0, 1.0, 1.0]
    """
    first = velocity_analog(velocity, omega_1)
    second = acceleration_analog(velocity, acceleration, omega_1, epsilon_1)
    return from_analogs(s, first, second, stroke=stroke, angle=angle)


def to_true(invariants: Invariants, omega_1: ArrayLike, epsilon_1: ArrayLike = 0.0) -> tuple[Array, Array, Array]:
    """Return s (m), V = b_k S/T (m/s), A = c_k S/T^2 (m/s^2) with T = Phi/omega_1, for a stroke in metres.

    >>> from coursework.procedures import from_analogs, to_true
    >>> even = from_analogs([0.0, 0.1, 0.2], [0.1, 0.1, 0.1], [0.0, 0.0, 0.0], stroke=0.2, angle=2.0)
    >>> [part.round(9).tolist() for part in to_true(even, omega_1=5.0)]
    [[0.0, 0.1, 0.2], [0.5, 0.5, 0.5], [0.0, 0.0, 0.0]]
    """
    s, first, second = to_analogs(invariants)
    return s, true_velocity(first, omega_1), true_acceleration(first, second, omega_1, epsilon_1)


def _require_scale(stroke: float, angle: float) -> None:
    for name, value in (("stroke S", stroke), ("crank angle Phi", angle)):
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"invariants: a {name} above zero was expected, found {value:g}.")
