"""One driven crank at constant speed: mean torque, and the flywheel needed for a given unevenness.

Enters: a `ForceAnalysis` of exact rows over a period.  Leaves: `Flywheel`.  Computed on request only.
Used by `told.py`.

J(phi) = sum (m S'^2 + J phi'^2).  The largest excess of energy is the range of the integral of mean - M_d over a turn.  It
includes the energy of the links (Merzalov); the same integral with the loads alone would give another number.
"""

from __future__ import annotations

import numpy as np

from coursework.effects.force_scheme import drives_of
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

_GRID, _NEWTON = 2048, 6
_STEADY = 1e-9  # relative change below which the speed of a crank is constant


@frozen
class Flywheel:
    """`mean` torque (N m), `excess` of energy (J), and the crank angles (rad) at which the torque crosses its mean (`crossings`).

    `inertia` (kg m²) is needed in the group that turns uniformly, `own` is that of the crank, `needed` the flywheel's.
    """

    mean: float
    excess: float
    crossings: tuple[float, ...]
    inertia: float | None
    own: float
    needed: float | None


def crank_of(own: ForceAnalysis) -> tuple[Array, Array, Array] | None:
    """Return angle, torque and speed (n,) of the only driven crank, None if there is not exactly one."""
    drives = drives_of(own.rows.scheme)
    variant = own.equations.variant
    if len(drives) != 1 or drives[0].direction.kind != "couple":
        return None
    coordinate = next(c.name for c in variant.coordinates if c.rate == drives[0].is_drive)
    motion = own.rows.motion
    return motion.column(coordinate), own.column(own.drive_names[0]), motion.column(drives[0].is_drive)


def find_flywheel(own: ForceAnalysis, period: float | None) -> Flywheel | None:
    """Return the flywheel for rows over one whole period; None if they hold none, or the crank is not uniform or locks."""
    crank = crank_of(own)
    t = own.rows.motion.t
    if crank is None or period is None or len(t) < 3:
        return None
    angle, torque, speed = crank
    count = round(period / float(t[1] - t[0]))
    even = np.ptp(speed) <= _STEADY * np.abs(speed).max() and bool(np.isfinite(torque).all())
    if not even or count < 3 or len(t) <= count or abs(count * (t[1] - t[0]) - period) > 1e-9 * period or not speed[0]:
        return None
    torque, angle, omega = torque[: count + 1], angle[: count + 1], float(speed[0])
    mean = float(torque[:-1].mean())
    excess, crossings = _excess(torque[:-1] - mean, float(angle[0]), float(angle[-1] - angle[0]))
    forces = own.rows.scheme.forces
    uneven = own.rows.scalar(forces.flywheel.unevenness)[0] if forces.flywheel and forces.flywheel.unevenness else None
    inertia = excess / (float(uneven) * omega**2) if uneven else None
    body = own.rows.scheme.by_name[drives_of(own.rows.scheme)[0].on]
    arm = np.abs(own.rows.vector(body.centre)[0] - _pivot(own))
    crank_inertia = float(own.rows.inertia(body)[0] + own.rows.mass(body)[0] * arm**2)
    return Flywheel(mean, excess, crossings, inertia, crank_inertia, None if inertia is None else inertia - crank_inertia)


def _pivot(own: ForceAnalysis) -> complex:
    drive = drives_of(own.rows.scheme)[0]
    pins = [one for one in own.rows.scheme.unknowns if {one.on, one.off} == {drive.on, drive.off} and one.at is not None]
    return complex(own.rows.vector(pins[0].at)[0]) if pins and pins[0].at is not None else 0j


def _excess(wave: Array, begin: float, turn: float) -> tuple[float, tuple[float, ...]]:
    """Return the range of the integral of a periodic wave given at equal angles, and the angles at which it crosses zero.

    The wave is interpolated by trigonometric functions, which is as accurate as the trapezoid rule over a period.
    """
    count = len(wave)
    series = np.fft.rfft(wave) / count
    if count % 2 == 0:
        series[-1] = 0.0  # for an even count the highest harmonic has no phase
    orders = np.arange(1, len(series))

    def at(x: Array, power: int) -> Array:
        return np.asarray((np.exp(1j * np.outer(x, orders)) @ (2.0 * series[1:] * (1j * orders) ** power)).real)

    grid = np.linspace(0.0, 2 * np.pi, _GRID + 1)
    # The turn begins where the wave is largest: a zero at its seam could be lost by rounding.
    grid = grid + grid[np.argmax(np.abs(at(grid, 0)))]
    values = at(grid, 0)
    places = np.flatnonzero((values[:-1] < 0) != (values[1:] < 0))
    if not len(places):
        return 0.0, ()
    x = grid[places]
    for _ in range(_NEWTON):
        x = x - at(x, 0) / at(x, 1)
    x = np.sort(x % (2 * np.pi))
    energy = -at(x, -1) * abs(turn) / (2 * np.pi)
    return float(np.ptp(energy)), tuple((begin + x * turn / (2 * np.pi)).tolist())
