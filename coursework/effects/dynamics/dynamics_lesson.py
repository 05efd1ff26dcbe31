"""The cost of a step under forces: schemes side by side, with the error of the rates and the energy gained against slopes.

Enters: equations of motion, the start, the exact rows.  Leaves: `Row`s, and each `Trial` they are made of.
Used by `report/sections/effects/dynamics.py`, `energy_study.py` and `motor_scene.py`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from coursework.effects.dynamics.dynamics import Dynamics
from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import COMPARED, Scheme, title_of
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Time

PARTS = (1, 4, 16)  # numbers of parts of the step
MOST_SLOPES = 20_000  # of all runs together: a quarter of a second
Begin = tuple[Sequence[float], Sequence[float]]  # all coordinates at t = 0, and the free state


@frozen
class Row:
    """A scheme with its number of `slopes`, largest `error` of a free rate, and surplus of energy (J) over the exact motion."""

    title: str
    slopes: int
    error: float
    gained: float


@frozen
class Trial:
    """One trial of a scheme: number of `slopes`, largest `error` of a free rate, `energy` (n,) J in the rows of the table.

    If it `ended` early, that is the reason, and `row` the number of rows.
    """

    slopes: int
    error: float
    energy: Array
    ended: str = ""
    row: int = 0


@frozen
class Moved:
    """A motion under forces: its equations, its start, its times, and its exact rows."""

    equations: EquationsOfMotion
    begin: Begin
    time: Time
    exact: Motion

    @property
    def steps(self) -> int:
        """Return the number of steps of the table."""
        return len(self.exact.t) - 1

    def energy(self) -> tuple[Array, Array]:
        """Return the total and the kinetic energy (n,) J of the exact rows."""
        exact = self.exact
        return energy_of_rows(self.equations, exact.t, exact.coordinates, rates_of(self.equations, exact))

    def tried(self, scheme: Scheme, parts: int) -> Trial:
        """Return the trial of a scheme with each step divided into `parts`."""
        equations, (places, state) = self.equations, self.begin
        made = Dynamics(equations, list(places)).rows(scheme, state, self.time.step / parts, self.steps * parts)
        if made.ended:
            return Trial(made.slopes, float("inf"), np.zeros(0), made.ended, len(made.t))
        rows = slice(None, None, parts)
        error = float(np.abs(made.rates[rows] - rates_of(equations, self.exact)).max(initial=0.0))
        return Trial(made.slopes, error, energy_of_rows(equations, made.t[rows], made.coordinates[rows], made.rates[rows])[0])


def lesson(moved: Moved) -> list[Row]:
    """Return the rows of the lesson; empty for a long table."""
    steps, most = moved.steps, MOST_SLOPES // moved.equations.dear
    if steps < 1 or steps * sum(PARTS) * sum(one.slopes for one in COMPARED) > 12 * most:
        return []
    last = float(moved.energy()[0][-1])
    found = []
    for scheme in COMPARED:
        for parts in PARTS:
            if steps * parts * scheme.slopes > most:
                continue
            tried = moved.tried(scheme, parts)
            gained = float("inf") if tried.ended else float(tried.energy[-1]) - last
            found.append(Row(title_of(scheme), tried.slopes, tried.error, gained))
    return found


def rates_of(equations: EquationsOfMotion, motion: Motion) -> Array:
    """Return the free rates (n, f) of a motion."""
    return np.column_stack([motion.column(motion.velocity_names[place]) for place in equations.free])


def energy_of_rows(equations: EquationsOfMotion, t: Array, q: Array, v: Array) -> tuple[Array, Array]:
    """Return the total and the kinetic energy (n,) J."""
    found = equations.table(t, *q.T, *v.T)
    last = len(found) - equations.determinants
    kinetic = np.broadcast_to(found[last - 2], t.shape)
    return np.asarray(kinetic + found[last - 1]), np.asarray(kinetic)


def is_heavy(equations: EquationsOfMotion, start: Sequence[float]) -> bool:
    """Return whether, at the start, every motion of the free coordinates (two at most) moves a mass.

    The kinetic energies of each rate alone and of all together give the determinant of the mass matrix.
    """
    count = len(equations.free)
    v = np.vstack([np.eye(count), np.ones(count)])
    try:
        with np.errstate(all="ignore"):  # forces without a value there only spoil their own part of the table
            *alone, together = energy_of_rows(equations, np.zeros(count + 1), np.tile(start, (count + 1, 1)), v)[1]
    except ZeroDivisionError:  # raised by plain numbers, not arrays: no moving link has a mass at all
        return False
    masses = 4 * math.prod(alone) - (together - sum(alone)) ** 2 if count == 2 else alone[0]
    return bool(masses > 1e-12 * math.prod(alone))
