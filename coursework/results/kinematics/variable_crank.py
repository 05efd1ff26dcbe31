"""The slider-crank whose crank changes its length: its analogs, and the crank for constant slider speed.

Enters: crank angle, crank length and derivatives, rod, offset.  Leaves: analogs of slider and rod, or the length.
Used by students, through `procedures.py`; the tool itself uses the general method, as in `variants/variable-crank.toml`.
Source: [Pasika], formulas (5), (9)-(12) with the printing repaired.

Lengths are divided by l1 unless stated otherwise: lr = r/l1, l2 the rod, l3 the offset of the slider's line; lr', lr''
derivatives with respect to the crank angle phi.  The slider lies at x = lr cos phi + l2 cos phi2 on the line
y = l3, and its displacement is counted from the outer end *inwards*, so s grows while x falls.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups.assembly import at, dead, numbers, refuse, require_mode, rows_where, tolerance
from coursework.system.arrays import Array
from coursework.words.sentences import say

MODES = {1: "group.mode.outside", -1: "group.mode.inside"}
# How far the synthesised crank may differ at its first angle from the length asked for there, as a part of
# the rod. Where the constant crank moves its slider fastest dx/dr is almost 0, so the last digits of x are
# magnified in r.
START = 1e-9
OFF_LINE = ("group.off.line", "group.line.of_slider")


@dataclass(frozen=True, slots=True, eq=False)
class SliderAnalogs:
    """Analogs (n,) of slider and rod, divided by l1: `phi2` (rad), `s`, `v`, `a`, `omega_2`, `epsilon_2`.

    >>> import numpy as np
    >>> from coursework.procedures import slider_crank
    >>> dead_centres = slider_crank([0.0, np.pi], 1.0, l2=2.0)
    >>> dead_centres.s.round(9).tolist(), dead_centres.a.round(9).tolist()
    ([0.0, 2.0], [1.5, -0.5])
    """

    phi2: Array
    s: Array
    v: Array
    a: Array
    omega_2: Array
    epsilon_2: Array


@dataclass(frozen=True, slots=True, eq=False)
class CrankLaw:
    """A crank length (n,) that depends on the crank angle: `r`, `first` dr/dphi, `second` d2r/dphi2, m.

    >>> from coursework.procedures import constant_speed_crank
    >>> law = constant_speed_crank([1.34, 1.44], speed=0.65, omega_1=6.28, crank=0.1, rod=0.4)
    >>> law.r.round(4).tolist(), law.first.round(4).tolist()
    ([0.1, 0.1005], [0.0268, 0.0039])
    """

    r: Array
    first: Array
    second: Array


def slider_crank(
    phi: ArrayLike, lr: ArrayLike, first: ArrayLike = 0.0, second: ArrayLike = 0.0,
    *, l2: float, l3: float = 0.0, outer: float | None = None,
) -> SliderAnalogs:  # fmt: skip
    """Return all analogs by (5), (9)-(12); a crank of constant length is lr = 1 with both derivatives 0.

    `phi` (n,) rad; `lr`, `first`, `second` the crank length and its derivatives, (n,) or a number; `l2` the
    rod, `l3` the offset; `outer` the position displacements are counted from, by default S_a with the first
    crank length.
    Raises `CannotAssemble` and `AtDeadPoint` as `rod_angle`.

    >>> from coursework.procedures import slider_crank
    >>> slider_crank([0.0, 1.0, 2.0], 1.0, l2=4.0).v.round(4).tolist()
    [0.0, 0.9577, 0.8122]
    """
    f, r, dr, ddr = np.broadcast_arrays(*(numbers("slider-crank", part) for part in (phi, lr, first, second)))
    for name, value in (("rod", l2), ("offset", l3)):
        numbers(f"slider-crank, {name}", value, positive=name == "rod")
    phi2 = rod_angle(f, r, l2, l3)
    omega = rod_velocity(f, r, dr, phi2, l2)
    epsilon = rod_acceleration(f, r, dr, ddr, phi2, omega, l2)
    zero = outer_position(float(r[0]), l2, l3) if outer is None else outer
    moved, velocity = displacement(f, r, phi2, l2, zero), slider_velocity(f, r, dr, phi2, omega, l2)
    acceleration = slider_acceleration(f, r, dr, ddr, phi2, omega, epsilon, l2)
    return SliderAnalogs(phi2, moved, velocity, acceleration, omega, epsilon)


def rod_angle(phi: Array, lr: Array, l2: float, l3: float = 0.0) -> Array:
    """Return phi2 = arcsin((l3 - lr sin phi)/l2) in rad, (n,); `phi` (n,) rad.

    Raises `CannotAssemble` where the rod is too short to reach the slider's line, `AtDeadPoint` where it
    stands perpendicular to it, cos phi2 = 0, by which the formulas divide.

    >>> import numpy as np
    >>> from coursework.procedures import rod_angle
    >>> np.rad2deg(rod_angle(np.array([0.0, np.pi / 2]), np.ones(2), l2=2.0)).round(9).tolist()
    [0.0, -30.0]
    """
    drop = np.atleast_1d(l3 - lr * np.sin(phi))
    _spare("slider-crank", drop, l2, OFF_LINE)
    return np.asarray(np.arcsin(drop / l2))


def outer_position(lr: float, l2: float, l3: float = 0.0) -> float:
    """Return S_a = sqrt((lr + l2)^2 - l3^2): the slider with crank and rod in one line; not the stroke.

    >>> from coursework.procedures import outer_position
    >>> outer_position(1.0, l2=4.0, l3=3.0)
    4.0
    """
    return math.sqrt((lr + l2 - l3) * (lr + l2 + l3))


def displacement(phi: Array, lr: Array, phi2: Array, l2: float, outer: float) -> Array:
    """Return s = S_a - lr cos phi - l2 cos phi2: formula (5), (n,); `phi`, `phi2` (n,) rad.

    >>> import numpy as np
    >>> from coursework.procedures import displacement
    >>> displacement(np.array([0.0, np.pi]), np.ones(2), np.zeros(2), l2=2.0, outer=3.0).tolist()
    [0.0, 2.0]
    """
    return np.asarray(outer - lr * np.cos(phi) - l2 * np.cos(phi2))


def rod_velocity(phi: Array, lr: Array, first: Array, phi2: Array, l2: float) -> Array:
    """Return omega_2 = dphi2/dphi: formula (10), (n,); `phi`, `phi2` (n,) rad.

    >>> import numpy as np
    >>> from coursework.procedures import rod_velocity
    >>> rod_velocity(np.array([0.0, np.pi]), np.ones(2), np.zeros(2), np.zeros(2), l2=2.0).tolist()
    [-0.5, 0.5]
    """
    return np.asarray(-(lr * np.cos(phi) + first * np.sin(phi)) / (l2 * np.cos(phi2)))


def slider_velocity(phi: Array, lr: Array, first: Array, phi2: Array, omega_2: Array, l2: float) -> Array:
    """Return v = ds/dphi: formula (9), (n,); `phi`, `phi2` (n,) rad.

    >>> import numpy as np
    >>> from coursework.procedures import slider_velocity
    >>> phi, phi2 = np.array([np.pi / 2]), np.array([-np.pi / 6])
    >>> slider_velocity(phi, np.ones(1), np.zeros(1), phi2, omega_2=np.zeros(1), l2=2.0).tolist()
    [1.0]
    """
    return np.asarray(lr * np.sin(phi) - first * np.cos(phi) + l2 * omega_2 * np.sin(phi2))


def rod_acceleration(phi: Array, lr: Array, first: Array, second: Array, phi2: Array, omega_2: Array, l2: float) -> Array:
    """Return epsilon_2 = d2phi2/dphi2: formula (12), with (10) put in for its terms in omega_2; (n,).

    >>> import numpy as np
    >>> from coursework.procedures import rod_acceleration
    >>> phi, phi2 = np.array([np.pi / 2]), np.array([-np.pi / 6])
    >>> rod_acceleration(phi, np.ones(1), np.zeros(1), np.zeros(1), phi2, omega_2=np.zeros(1), l2=2.0).round(4).tolist()
    [0.5774]
    """
    sine = np.sin(phi)
    epsilon: Array = (lr - second) * sine - 2.0 * first * np.cos(phi) + l2 * omega_2 * omega_2 * np.sin(phi2)
    return epsilon / (l2 * np.cos(phi2))


def slider_acceleration(
    phi: Array, lr: Array, first: Array, second: Array, phi2: Array, omega_2: Array, epsilon_2: Array, l2: float
) -> Array:
    """Return a = d2s/dphi2: formula (11), (n,); in the outer dead centre 1 + 1/l2.

    >>> import numpy as np
    >>> from coursework.procedures import slider_acceleration
    >>> still = np.zeros(1)
    >>> slider_acceleration(still, np.ones(1), still, still, still, omega_2=np.array([-0.5]), epsilon_2=still, l2=2.0).tolist()
    [1.5]
    """
    rod = l2 * (omega_2 * omega_2 * np.cos(phi2) + epsilon_2 * np.sin(phi2))
    return np.asarray((lr - second) * np.cos(phi) + 2.0 * first * np.sin(phi) + rod)


def constant_speed_crank(
    phi: ArrayLike, *, speed: float, omega_1: float, crank: float, rod: float, offset: float = 0.0, mode: int = 1
) -> CrankLaw:
    """Return the crank length that moves the slider at one speed, exactly, over the angles `phi` (n,) rad.

    `speed` V (m/s) of the slider inwards; `omega_1` (rad/s); `crank` l1 (m) the length at phi[0]; `rod`,
    `offset` (m). With x = x0 - (V/omega_1)(phi - phi[0]) the pin lies on the circle of radius l2 about the
    slider (x, e): r = p + m sqrt(l2^2 - q^2), p = x cos phi + e sin phi, q = x sin phi - e cos phi; `mode` m
    picks the root.
    Raises `CannotAssemble` where the crank's line passes the slider at more than the rod, `AtDeadPoint` where
    it touches that circle (dr/dphi grows beyond bounds), `ValueError` where the mode does not give `crank` at
    phi[0], or the crank would shrink to nothing.

    >>> from coursework.procedures import constant_speed_crank
    >>> constant_speed_crank([1.34, 1.44, 1.54], speed=0.65, omega_1=6.28, crank=0.1, rod=0.4).r.round(4).tolist()
    [0.1, 0.1005, 0.1011]
    """
    owner = "crank for constant speed"
    require_mode(owner, mode, MODES)
    f = numbers("crank angle", phi)
    l1, l2 = (float(numbers(name, part, positive=True)[0]) for name, part in (("crank l1", crank), ("rod l2", rod)))
    if not (math.isfinite(speed + omega_1 + offset) and omega_1 != 0.0):
        raise ValueError(
            f"{owner}: finite speed and offset and a turning crank were expected, found "
            f"speed {speed:g}, offset {offset:g}, omega_1 {omega_1:g}."
        )
    drop = offset - l1 * np.sin(f[:1])
    first_x = l1 * math.cos(f[0]) + np.sqrt(_spare(owner, drop, l2, OFF_LINE) * (l2 + np.abs(drop)))
    slope = -speed / omega_1  # dx/dphi
    x = first_x + slope * (f - f[0])
    cosine, sine = np.cos(f), np.sin(f)
    p, q = x * cosine + offset * sine, x * sine - offset * cosine
    spare = _spare(owner, q, l2, ("group.off.crank", "group.line.of_crank"))
    root = mode * np.sqrt(spare * (l2 + np.abs(q)))
    r = p + root
    if abs(r[0] - l1) > START * l2:
        raise ValueError(
            f"{owner}: mode {mode:+d} starts with {r[0]:.6g} m where {l1:.6g} m was asked for; take mode {-mode:+d}."
        )
    if (r <= 0.0).any():
        row = int(np.argmax(r <= 0.0))
        raise ValueError(f"{owner}: the crank would have to be {r[row]:.6g} m long at row {row}.")
    # the derivatives of p, q and of root^2 = l2^2 - q^2 with respect to phi
    dq = p + slope * sine
    dp = slope * cosine - q
    ddq = dp + slope * cosine
    ddp = -dq - slope * sine
    first = -q * dq / root
    second = -(dq * dq + q * ddq + first * first) / root
    return CrankLaw(r, dp + first, ddp + second)


def _spare(owner: str, gap: Array, rod: float, keys: tuple[str, str]) -> Array:
    """Return what the rod has left over, rod - |gap|, (n,), in the unit of both.

    Raises `CannotAssemble` where it is negative and `AtDeadPoint` where it is zero but for rounding.
    """
    off, line = (say(key) for key in keys)
    spare, rounding = rod - np.abs(gap), tolerance(gap, np.full(1, rod))
    if (spare < -rounding).any():
        rows = rows_where(spare < -rounding, gap.size)
        short = -at(spare, rows[0])
        raise refuse(owner, rows, say("group.pin", found=off, gap=at(np.abs(gap), rows[0]), length=rod, short=short), short)
    if (spare <= rounding).any():
        raise dead(owner, rows_where(spare <= rounding, gap.size), say("group.dead.across", line=line), placed=False)
    return spare
