"""The rows of a motion under forces by Euler, and all columns of any row from its free coordinates and rates.

Enters: a variant with [motor].  Leaves: `FreeRows`.  Imported only for such a variant.
Used by `key.py`.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from coursework.api import make_run
from coursework.effects.dynamics.dynamics import Dynamics
from coursework.effects.dynamics.why_ended import Open
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.scene.motor_scene import MotorScene
from coursework.system.arrays import Array
from coursework.variant.record.variant import Variant


@dataclass(frozen=True, eq=False)
class FreeRows:
    """Rows of a motion under forces; columns as in the table: coordinates, then velocities."""

    variant: Variant

    @cached_property
    def scene(self) -> MotorScene:
        """The scene in which the motion was computed."""
        scene = make_run(self.variant, DEFAULT_SCHEME.name, quantities=["table"]).scene
        assert isinstance(scene, MotorScene)
        return scene

    @cached_property
    def table(self) -> Array:
        """The rows (n, m + r) computed by Euler's scheme."""
        return np.hstack([self.scene.motion.coordinates, self.scene.motion.velocities])

    @property
    def stopped(self) -> str:
        """Return why the rows end early, "" if they do not."""
        stop = self.scene.motion.stop
        return stop.sentence if stop else ""

    @cached_property
    def accelerations(self) -> Array:
        """The derivatives (n, r) of all velocities in those rows."""
        return self.scene.accelerations_of(self.scene.motion)

    @cached_property
    def state(self) -> tuple[int, ...]:
        """The columns of the free coordinates, then of the free rates."""
        free, m = self.scene.free_equations.free, len(self.variant.coordinates)
        return (*free, *(m + place for place in free))

    def rows_of(self, state: Array) -> Array:
        """Return all columns (n, m + r) and free accelerations (n, f) of states (n, 2 f): whole tables, one after another."""
        scene, count = self.scene, len(self.state) // 2
        dynamics, m = Dynamics(scene.free_equations, list(scene.start)), len(self.variant.coordinates)
        grid = self.scene.motion.t
        times = np.tile(grid, len(state) // len(grid))
        q = np.full((len(state), m), np.nan)
        for row, (t, free) in enumerate(zip(times.tolist(), state[:, :count].tolist(), strict=True)):
            if not np.isfinite(free).all():
                continue
            dynamics.q = self.table[row % len(grid), :m].tolist()
            with suppress(Open, ZeroDivisionError, OverflowError):
                q[row] = dynamics.closed(t, free)
        found = scene.free_equations.table(times, *q.T, *state[:, count:].T)
        values = np.array([np.broadcast_to(value, times.shape) for value in found], dtype=float).T
        size = self.table.shape[1] - m
        free_places = [size + place - m for place in self.state[count:]]
        return np.hstack([q, values[:, :size], values[:, free_places]])
