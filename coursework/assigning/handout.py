"""One student's variant -> everything that the sheet and the key say about it, drawn and computed once.

Enters: an `Individual` and its `Student`.  Leaves: `Handout`.
Used by `assign.py`; read by `sheet.py`, `key.py` and `class_page.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass

from coursework.assigning.variants import Individual
from coursework.drawing.check_sheet.graph_check import GraphCheck, check_graph
from coursework.drawing.figures import draw_start
from coursework.drawing.paper.record import Drawing
from coursework.grading.marking.decimals import SHARED, SHOWN, decimals_accepted, decimals_asked
from coursework.grading.platforms.names import file_stem
from coursework.grading.platforms.roster import Student
from coursework.motion.integration.integrate import March
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.motion.settings import Settings
from coursework.report.wording.data_meanings import meanings
from coursework.scene.scene import Scene
from coursework.variant.record.variant import Variant
from coursework.words.errors import InputError


@dataclass(frozen=True, eq=False)
class Handout:
    """What one student gets, and its key.

    `motion` is the Euler table, `start` all coordinates at t = 0 (rad, m), `mechanism` the drawing of the start (None if the
    file places no points). `meanings` says what each datum is; `check` is the construction in the check row (None if there is
    none); `of_class` is the number of decimals accepted from everyone.
    """

    student: Student
    individual: Individual
    motion: Motion
    start: tuple[float, ...]
    mechanism: Drawing | None
    meanings: Mapping[str, str]
    check: GraphCheck | None
    scene: Scene
    of_class: int

    @property
    def stem(self) -> str:
        """Return the name of the student's files."""
        return file_stem(self.student.id)

    @property
    def variant(self) -> Variant:
        """Return the variant with the student's data."""
        return self.individual.variant

    @property
    def least_decimals(self) -> int:
        """Return how many decimals the task sheet asks for, so that every slip in the table shows."""
        return decimals_asked(self.individual.accepted.numbers["one_step_gap"])

    @property
    def accepted_decimals(self) -> int:
        """Return how many decimals the sheet may call enough: those of the class, unless these data need more."""
        gap = self.individual.accepted.numbers["one_step_gap"] / max(1.0, self.variant.time.step)
        enough = 10.0**-self.of_class <= SHARED * SHOWN * gap
        return min(self.of_class if enough else decimals_accepted(gap), self.least_decimals)


def make_handout(student: Student, individual: Individual, of_class: int) -> Handout:
    """Return the handout of a student whose motion is known to be possible; `of_class` decimals are accepted from everyone."""
    variant = individual.variant
    scene = Scene(variant, Settings(DEFAULT_SCHEME.name))
    time = variant.time
    motion = March(scene.rates, DEFAULT_SCHEME, time.step).until(scene.start, time.end)
    mechanism = draw_start(scene.mechanism, scene.equations, motion, scene.start, lambda: scene.exact)
    check = None
    if time.check_row is not None and variant.links:
        # The key compares the drawing with the table; the report of a run tells Euler's error.
        with suppress(InputError):  # for a mechanism that cannot be constructed by centres there is no check
            check = check_graph(scene.mechanism, scene.equations, motion, motion)
    return Handout(student, individual, motion, tuple(scene.start), mechanism, meanings(scene.mechanism), check, scene, of_class)


def difficulty_text(value: float) -> str:
    """Return a measure of difficulty as text with four digits and without an exponent.

    >>> difficulty_text(0.0132), difficulty_text(17.905)
    ('0.01320', '17.91')
    """
    exponent = int(f"{value:.3e}".partition("e")[2])
    return f"{value:.{max(0, 3 - exponent)}f}"
