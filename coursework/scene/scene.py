"""One variant with its settings: the way to its motion, and what follows from that or any other motion of it.

Enters: a `Variant` and `Settings`.  Leaves: `Scene`; what depends on a motion is `scene.over(motion)`, for any motion.
Used by `quantities.py`, `exact_scene.py`, `scene/model/model.py`, and by readers who want more than a table.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from coursework.motion.integration.motion import Motion
from coursework.scene.motion_results import MotionResults
from coursework.scene.way_to_motion import WayToMotion
from coursework.system.on_demand import Ledger


@dataclass(frozen=True, eq=False, repr=False)
class Scene(WayToMotion):
    """A variant and how it is to be run, with the results of its rows."""

    def over(self, motion: Motion) -> MotionResults:
        """Return what follows from a motion, any motion of this scene's mechanism, with a ledger of its own."""
        return MotionResults(self, motion, Ledger())

    @cached_property
    def results(self) -> MotionResults:
        """What follows from the rows of the coursework."""
        return MotionResults(self, self.motion, self.ledger)
