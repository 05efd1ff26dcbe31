"""Energy of the moving links and the power of everything that acts on them, row by row.

Enters: `Rows` and the computed drives.  Leaves: `Energy`, J (T, potential) and W.  Computed on request only.
Used by `analysis.py`.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from coursework.effects.effects import LOADS, MOTOR, Action
from coursework.effects.force_scheme import Unknown
from coursework.effects.rows import RATE, SECOND, Rows
from coursework.mechanism.joints import FRAME
from coursework.results.kinematics.extra import ExtraTable
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.words.sentences import say

HEAD = ("t", "T", "potential", "P_drive", "P_loads", "P_friction", "P_dampers")
UNITS = ("s", "J", "J", "W", "W", "W", "W")


@frozen
class Energy:
    """Kinetic energy, `potential` energy of weight and springs, and the powers by cause, each (n,)."""

    kinetic: Array
    potential: Array
    drive: Array
    loads: Array
    friction: Array
    dampers: Array

    def as_table(self, t: Array) -> ExtraTable:
        """Return the columns of `energy.csv`."""
        rows = np.column_stack([t, self.kinetic, self.potential, self.drive, self.loads, self.friction, self.dampers])
        return ExtraTable(say("section.energy"), HEAD, UNITS, rows, blanks=True)


def velocity_of_drive(rows: Rows, drive: Unknown) -> Array:
    """Return the velocity (n,) that gives the power of a driving couple or force: of the driven body relative to its base."""
    bodies = rows.scheme.by_name
    if drive.direction.kind == "couple":
        turned = rows.omega(bodies[drive.off]) if drive.off in bodies else 0.0
        return rows.omega(bodies[drive.on]) - turned
    assert drive.at is not None
    if drive.direction.coordinate:
        return rows.motion.column(drive.is_drive)
    moved, unit = rows.vector(drive.at, RATE), rows.along(drive)
    if drive.off != FRAME:
        moved = moved - rows.velocity(bodies[drive.off], rows.vector(drive.at))
    return (np.conj(unit) * moved).real


def energy_of(rows: Rows, drives: dict[Unknown, Array], friction: tuple[Action, ...] = ()) -> Energy:
    """Return energies and powers; `drives` are the driving couples and forces (n,), `friction` its actions."""
    scheme, still = rows.scheme, np.zeros(rows.count)
    kinetic, potential, dampers = still.copy(), still.copy(), still.copy()
    x, y = (rows.scalar(part) for part in scheme.forces.gravity or (None, None))
    for body in scheme.bodies:
        if body.mass is not None:
            kinetic += rows.mass(body) * np.abs(rows.vector(body.centre, RATE)) ** 2 / 2
            potential -= rows.mass(body) * (np.conj(x + 1j * y) * rows.vector(body.centre)).real
        kinetic += rows.inertia(body) * rows.omega(body) ** 2 / 2
    for spring in scheme.forces.springs:
        way, rate = rows.stretch(spring)
        potential += rows.scalar(spring.stiffness) * (np.abs(way) - rows.scalar(spring.free)) ** 2 / 2
        dampers -= rows.scalar(spring.damping) * rate**2
    driven = sum((value * velocity_of_drive(rows, one) for one, value in drives.items()), still)
    driven += _power(rows, MOTOR.acts(rows))
    return Energy(kinetic, potential, driven, _power(rows, LOADS.acts(rows)), _power(rows, friction), dampers)


def reduced_inertia(rows: Rows, rate: Array, change: Array) -> tuple[Array, Array]:
    """Return J(phi) = sum (m S'^2 + J phi'^2) and its derivative by phi, (n,) kg m^2.

    `rate` (n,) is that of the crank, `change` its derivative; the result is nan where the crank stands still.
    """
    total, slope = np.zeros(rows.count), np.zeros(rows.count)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for body in rows.scheme.bodies:
            if body.mass is not None:
                first = rows.vector(body.centre, RATE) / rate
                second = (rows.vector(body.centre, SECOND) - first * change) / rate**2
                total += rows.mass(body) * np.abs(first) ** 2
                slope += 2 * rows.mass(body) * (np.conj(first) * second).real
            turned = rows.omega(body) / rate
            total += rows.inertia(body) * turned**2
            slope += 2 * rows.inertia(body) * turned * (rows.epsilon(body) - turned * change) / rate**2
    return np.where(np.isfinite(total), total, np.nan), np.where(np.isfinite(slope), slope, np.nan)


def _power(rows: Rows, actions: Iterable[Action]) -> Array:
    """Return the power (n,) of forces and couples on moving bodies."""
    bodies = rows.scheme.by_name
    total = np.zeros(rows.count)
    for action in actions:
        body = bodies[action.body]
        if action.couple is not None:
            total += action.couple * rows.omega(body)
        elif action.force is not None and action.at is not None:
            total += (np.conj(action.force) * rows.velocity(body, action.at)).real
    return total
