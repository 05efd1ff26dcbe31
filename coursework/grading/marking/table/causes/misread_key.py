"""The key for a table made with other velocities or another step: by it the table is marked as if these were the task's.

Enters: a `Key`, a `Claim`.  Leaves: `MisreadKey`.  Used by `closer.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from coursework.grading.marking.key.key import Key
from coursework.system.arrays import Array


@dataclass(frozen=True, eq=False, kw_only=True)
class MisreadKey(Key):
    """The key of a table made with the velocities `made_with` (t, q) and with steps that are `part` of those of the `task`."""

    made_with: Callable[[Array, Array], Array]
    part: float
    task: Key

    def velocities_at(self, t: Array, q: Array, data: Mapping[str, float] | None = None) -> Array:
        """Return the velocities (n, r) with which the table was made."""
        return self.made_with(t, q)

    @property
    def stride(self) -> float:
        """Return the step with which the table was made, s."""
        return self.part * self.step

    @property
    def blocks(self) -> tuple[tuple[str, ...], ...]:
        """Return one block with all velocities: an order of solution exists only for the task."""
        return (self.velocities,)

    @cached_property
    def coarsest(self) -> Array:
        """Return the coarsest digits that count as shown: the task decides them, whatever the table was made with."""
        return self.task.coarsest
