"""The key of a table that was made otherwise: what its cells are right by where a cause has the velocities of its own.

Enters: a `Key`, a `Claim`.  Leaves: `MisreadKey`.  Used by `misconceptions.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from coursework.grading.marking.key.key import Key
from coursework.system.arrays import Array


@dataclass(frozen=True, eq=False, kw_only=True)
class MisreadKey(Key):
    """The key of a table that was made with other velocities `made_with` (t, q), and steps `part` of those of the `task`."""

    made_with: Callable[[Array, Array], Array]
    part: float
    task: Key

    def velocities_at(self, t: Array, q: Array, data: Mapping[str, float] | None = None) -> Array:
        """Return the velocities (n, r) that the table was made with."""
        return self.made_with(t, q)

    @property
    def stride(self) -> float:
        """Return the step that the table was made with, s."""
        return self.part * self.step

    @property
    def blocks(self) -> tuple[tuple[str, ...], ...]:
        """Return one block: which velocities come first is the task's only."""
        return (self.velocities,)

    @cached_property
    def coarsest(self) -> Array:
        """Return which digits count as shown: the task asks for them, whatever the table was made with."""
        return self.task.coarsest
