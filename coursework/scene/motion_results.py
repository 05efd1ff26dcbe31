"""The results of one motion of a scene: rows of a scheme, exact rows, or a student's own table, by the same code.

Enters: the `WayToMotion` of a scene and any `Motion` of its mechanism.  Leaves: `MotionResults`, each property computed
once, when it is first read.
Used by `scene.py`, which makes it, `api.py`, `quantities.py`, `scene_run.py`, `report/` and `grading/marking/key/key.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import SCHEMES
from coursework.scene.way_to_motion import WayToMotion
from coursework.system.arrays import Array
from coursework.system.on_demand import Ledger, Travelling, computed
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT, scheme_names
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.effects.kinetostatics.analysis import ForceAnalysis
    from coursework.effects.kinetostatics.energy import Energy
    from coursework.results.checks.evidence import Evidence
    from coursework.results.checks.result import Finding
    from coursework.results.kinematics.extra import ExtraTable

Named = tuple[tuple[str, ...], Array]
# Largest number of rows for a march in extended precision: a row there costs a hundred times one of the table.
MOST_EXTENDED = 2001


def needs_all(name: str, columns: Sequence[str]) -> Sentence:
    """Return the sentence that a quantity needs the whole table, where only some columns are asked for."""
    return say("fault.C001", name=name, columns=tuple(columns))


def given_constants(variant: Variant, names: Sequence[str], rows: Array) -> dict[str, float]:
    """Return the rates that the drive keeps constant in all rows (n, m + r), as name -> value; empty if all are constant."""
    found = {
        name: float(rows[0, place])
        for place, name in enumerate(names)
        if name in variant.known_rates and len(rows) > 1 and not np.ptp(rows[:, place])
    }
    return found if len(found) < len(names) else {}


@dataclass(frozen=True, eq=False, repr=False)
class MotionResults(Travelling):
    """The results of the `motion` of a `scene`; every result is kept here and nowhere else."""

    PLAIN = frozenset({  # drawings and evidence contain programs
        "scene", "motion", "ledger", "by_scheme", "accelerations", "points", "point_accelerations", "checks", "accuracy",
        "analogs", "invariants", "table", "plots", "extended_precision",
    })  # fmt: skip
    scene: WayToMotion
    motion: Motion
    ledger: Ledger

    def __repr__(self) -> str:
        return f"<MotionResults of {self.motion!r}>"

    def charged(self, error: Exception) -> Exception | None:
        """Return the fault of a formula that has no value somewhere on the way, None if every formula has one."""
        return self.scene.charged(error)

    @cached_property
    def by_scheme(self) -> MotionResults:
        """Return the results of rows made by a scheme: these rows, or those beside an exact table."""
        rows = self.scene.scheme_rows
        return self if rows is None else MotionResults(self.scene, rows, Ledger())

    @computed("motion", "equations", "reduction", "search")
    def accelerations(self) -> Array:
        """The accelerations (n, k) of every row, from the differentiated equations (rad/s², m/s²)."""
        if (columns := self.scene.settings.columns) and len(self.motion.names) < len(self.scene.variant.columns):
            raise InputError(needs_all("accelerations", columns))
        return self.scene.accelerations_of(self.motion)

    @computed("motion", "equations")
    def points(self) -> Named:
        """Positions and velocities of the named points (m, m/s)."""
        from coursework.results.kinematics.points import point_rows

        return point_rows(self.scene.equations, self.motion)

    @computed("motion", "equations", "accelerations")
    def point_accelerations(self) -> Named:
        """Positions, velocities and accelerations of the named points (m, m/s, m/s²)."""
        from coursework.results.kinematics.points import point_rows

        return point_rows(self.scene.equations, self.motion, self.accelerations)

    @computed("motion", "mechanism", "equations", "accelerations")
    def forces(self) -> ForceAnalysis:
        """The reactions in every joint and what must drive the mechanism, of every row (N, N m)."""
        from coursework.effects.kinetostatics.analysis import analyse

        moved = self.scene.stirred(self.motion)
        return analyse(self.scene.mechanism, self.scene.equations, self.motion, self.accelerations, moved)

    @computed("forces")
    def energy(self) -> Energy:
        """Kinetic and potential energy, and the powers of drive, loads, friction and dampers (J, W)."""
        return self.forces.energy

    @computed("forces")
    def dynamics(self) -> ExtraTable:
        """The motion that forces make: coordinates, rates and the energy that it has."""
        from coursework.effects.told import dynamics_table

        return dynamics_table(self.forces)

    @computed("forces", "motion", "exact")
    def exact_forces(self) -> ForceAnalysis | None:
        """Return the forces of the exact motion on the same rows; None if it is unknown."""
        exact = self.scene.exact
        if self.motion.scheme == EXACT:
            return self.forces
        return replace(self, motion=exact, ledger=Ledger()).forces if len(exact.t) else None

    @computed("forces", "exact_forces")
    def force_checks(self) -> tuple[Finding, ...]:
        """Return the checks of forces: agreement of three methods, power, what the joints bear."""
        from coursework.effects.kinetostatics.checks import check_forces

        return check_forces(self.forces, self.exact_forces)

    @computed("motion", "rates", "reduction", "start", "search")
    def extended_precision(self) -> Array | None:
        """Return the same rows in extended precision, which shows the effect of round-off; None if they cannot be computed."""
        from coursework.motion.integration.extended_precision import has_extended, march_in

        motion, scene = self.motion, self.scene
        small = len(motion.t) <= MOST_EXTENDED and all(block.size <= 2 for block in scene.reduction.blocks)
        corrected = scene.settings.project or scene.settings.gain
        ended = scene.search.passages or motion.stop is not None
        if not (small and has_extended()) or ended or corrected or motion.scheme not in SCHEMES:
            return None
        return np.asarray(march_in(np.longdouble, scene.rates, motion.scheme, scene.begin, motion.step, len(motion.t) - 1))

    @computed(
        "motion", "exact", "extended_precision", "equations", "rates", "start", "closure", "stop", "reduction", "search", "flow"
    )
    def evidence(self) -> Evidence:
        """Return the evidence for the checks: the rows beside the exact ones, and ways to make them again."""
        from coursework.motion.geometry.drives.swings import drive_frequency
        from coursework.motion.geometry.judging.agreement import confirmed
        from coursework.motion.integration.replay import Replay
        from coursework.results.checks.evidence import Evidence

        scene, motion = self.scene, self.motion
        rates, scheme = scene.passing(scene.rates), SCHEMES.get(motion.scheme)
        replay = Replay(rates, scheme, scene.begin, scene.correction) if scheme else None
        rerun = scene.rerun if motion.scheme in scheme_names() else None
        return Evidence(
            scene.variant, scene.equations, rates, motion, scene.exact, self.extended_precision, scene.closure,
            confirmed(scene.equations, scene.closure, scene.start),
            scene.stop, scene.reduction.used, drive_frequency(scene.equations, scene.fastest_wave),
            scene.search, replay, rerun, scene.search.passages, scene.settings.order,
        )  # fmt: skip

    @computed("evidence")
    def checks(self) -> tuple[Finding, ...]:
        """The checks of the page."""
        from coursework.results.checks.check import check_motion

        return check_motion(self.evidence)
