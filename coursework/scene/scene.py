"""One variant with its settings: the way to its motion, and the results of that or any other motion of it.

Enters: a `Variant` and `Settings`.  Leaves: `Scene`; `scene.over(motion)` gives the results of any motion.
Used by `quantities.py`, `exact_scene.py`, `scene/model/model.py`, and by readers who want more than a table.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from coursework.motion.geometry.start import START_TOLERANCE
from coursework.motion.integration.motion import AT_EVENT, Motion
from coursework.scene.motion_results import MotionResults
from coursework.scene.way_to_motion import WayToMotion
from coursework.system.on_demand import Ledger, Travelling
from coursework.variant.record.variant import changed
from coursework.words.errors import visible
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


@dataclass(frozen=True, eq=False, repr=False)
class Scene(WayToMotion, Travelling):
    """A variant with the settings of its run, and the results of its rows."""

    PLAIN = frozenset({  # in the order in which it was made
        "variant", "settings", "ledger", "start", "stop", "phases", "motion", "exact", "exact_accelerations", "extremes",
        "one_period", "scheme_rows", "results",
    })  # fmt: skip
    kind_of_results: ClassVar[type[MotionResults]] = MotionResults

    def __repr__(self) -> str:
        name = f"{visible(self.variant.name)}{changed(self.variant.set_values)}"
        return f"<{type(self).__name__} of {name}: {self.settings.scheme}, h = {self.variant.time.step:g} s>"

    @property
    def last_time(self) -> float:
        """Return the time (s) up to which the motion is known: the end asked for, or shortly before it stops."""
        end = self.variant.time.end
        return end if self.stop is None else min(end, self.stop.time * (1 - AT_EVENT))

    @property
    def closed_anew(self) -> Sentence | None:
        """Return a sentence on the starts of the file that other data or starts have moved; None if they moved none."""
        moved = [
            say("run.moved", name=c.name, before=c.start_guess, now=now, unit=c.unit)
            for c, now in zip(self.variant.coordinates, self.start, strict=True)
            if self.variant.changes
            and c.start is None
            and c.start_guess is not None
            and abs(now - c.start_guess) > START_TOLERANCE
        ]
        return say("run.anew", listed=tuple(moved)) if moved else None

    def over(self, motion: Motion) -> MotionResults:
        """Return the results of any motion of this scene's mechanism, with a ledger of its own."""
        return self.kind_of_results(self, motion, Ledger())

    @cached_property
    def results(self) -> MotionResults:
        """Return the results of the rows of the coursework."""
        return self.kind_of_results(self, self.motion, self.ledger)
