"""The result of a march: the rows, and why it stopped.

Enters: numbers from `integrate.py` or `exact_motion.py`.  Leaves: frozen `Motion`.  Read by checks, kinematics, report.
"""

from __future__ import annotations

import math
from dataclasses import field
from functools import cached_property

import numpy as np

from coursework.system.arrays import Array
from coursework.system.frozen import caching, frozen
from coursework.variant.record.variant import no_column
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

# A row closer to an event than this share of its time counts as at the event: its velocities may not be finite.
AT_EVENT = 1e-9


def rows_before(time: float, step: float) -> int:
    """Return the number of rows before an event at `time` (s)."""
    return max(0, math.ceil(time / step * (1 - AT_EVENT) - AT_EVENT))


@frozen
class Stop:
    """Why a motion ended before its time.

    `kind` is "dead point", "change point" (two branches meet), "step too large" or "not finite" (caused by the scheme), or a
    further kind of motion under forces (`FreeMotion.ended`);
    `time` in s; `row` as a fraction (5.84 lies between rows 5 and 6, counted from 0); `block` the unknown velocities of the
    singular block; `coordinates` the configuration there; `cause` and `meaning` are sentences for the reader; `branches` the
    velocities possible at a change point.
    """

    kind: str
    time: float
    row: float
    block: tuple[str, ...]
    coordinates: dict[str, float]
    cause: str
    meaning: str
    branches: tuple[dict[str, float], ...] = ()

    @property
    def name(self) -> Sentence:
        """Return the name of this kind of stop."""
        return say(f"event.kind.{self.kind}")

    @property
    def sentence(self) -> str:
        """Return cause and meaning as one paragraph."""
        return joined([self.cause, self.meaning])

    @property
    def refusal(self) -> InputError:
        """Return the error for a request that needs a motion that reaches its end."""
        return InputError(say("fault.D037", sentence=self.sentence))


@caching
class Motion:
    """The rows of one run.

    `t` (n,) s; `coordinates` (n, m) rad or m; `velocities` (n, k) for `velocity_names` (rates in file order, then
    unknowns); `determinants` (n, blocks) raw and `scaled` (n, blocks) dimensionless; `scheme`, `step` (s),
    `evaluations` of the right-hand side; `stop` or None.  `label` tells how the rows were made.
    """

    t: Array
    coordinates: Array
    velocities: Array
    determinants: Array
    scaled: Array
    coordinate_names: tuple[str, ...]
    velocity_names: tuple[str, ...]
    scheme: str
    step: float
    evaluations: int
    stop: Stop | None = None
    label: str = ""
    notes: tuple[str, ...] = ()
    residuals: Array = field(default_factory=lambda: np.zeros((0, 0)))

    def __post_init__(self) -> None:
        for rows in (self.t, self.coordinates, self.velocities, self.determinants, self.scaled, self.residuals):
            rows.flags.writeable = False

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Motion):
            return NotImplemented
        mine, its = ((one.names, one.scheme, one.step, one.stop, one.t.tobytes(), one.rows.tobytes()) for one in (self, other))
        return mine == its

    def __hash__(self) -> int:
        return hash((self.names, self.scheme, self.step, len(self.t)))

    def __repr__(self) -> str:
        stopped = f", stops at {self.stop.time:.6g} s" if self.stop else ""
        return f"<Motion: {self.scheme}, {len(self.t)} rows of {', '.join(self.names)}{stopped}>"

    def column(self, name: str) -> Array:
        """Return one column (n,) by its name.  Raises `KeyError` for an unknown name."""
        if name == "t":
            return self.t
        for names, rows in ((self.coordinate_names, self.coordinates), (self.velocity_names, self.velocities)):
            if name in names:
                return rows[:, names.index(name)]
        raise KeyError(str(no_column(name, ("t", *self.names))))

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Return the names of the columns after t."""
        return self.coordinate_names + self.velocity_names

    @cached_property
    def rows(self) -> Array:
        """Return all columns after t, (n, m + k)."""
        rows = np.concatenate([self.coordinates, self.velocities], axis=1)
        rows.flags.writeable = False
        return rows
