"""Inside a child: a task line -> an outcome.  Keys of variants are made once and kept.

Enters: `Setup`, task lines.  Leaves: `Outcome`s.  Used by `child.py` only.
"""

from __future__ import annotations

from collections import OrderedDict

import numpy as np

from coursework.grading.batch.decisions import overridden
from coursework.grading.batch.work import Outcome, Setup, VariantSource, failed, task_from
from coursework.grading.marking.grade import Grade, Marker
from coursework.grading.marking.reference import key_of
from coursework.grading.marking.rubric import Rubric, read_rubric
from coursework.grading.pages.feedback import feedback_page
from coursework.grading.reading.expected import Expected, grid_of
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import load_phrases, say

KEPT = 8  # keys at once: a class shares one, or each student has an own one


class Workshop:
    """What a child keeps between submissions."""

    def __init__(self, setup: Setup) -> None:
        self.setup, self.words = setup, load_phrases(setup.language)
        self.rubric: Rubric = read_rubric(setup.rubric) if setup.rubric else Rubric()
        self._tables = {name: np.array(table) for name, table in setup.class_tables.items()}
        self._markers: OrderedDict[str, tuple[Marker, Expected]] = OrderedDict()

    def answer(self, line: bytes) -> Outcome:
        """Return the outcome of one task line."""
        task = task_from(line)
        submission, source = task.submission, task.variant
        try:
            grade = self.grade(submission, source)
        except MemoryError:
            return failed(task, self.setup, "unreadable", say("grading.memory"))
        plain = self.words.throughout(overridden(grade.plain(), task.overrides, self.rubric))
        page = feedback_page(grade, submission.id, submission.name, plain, self.words) if self.setup.pages else ""
        return Outcome(submission.id, plain, page)

    def grade(self, submission: Submission, source: VariantSource) -> Grade:
        """Return the grade of a submission.  Raises `InputError` where the variant itself cannot be used."""
        marker, expected = self._marker(source)
        return marker.grade(read_submission(submission, expected))

    def _marker(self, source: VariantSource) -> tuple[Marker, Expected]:
        if source.sha256 in self._markers:
            self._markers.move_to_end(source.sha256)
            return self._markers[source.sha256]
        variant = parse_variant(source.content, source.name, source.tables)
        key = key_of(variant)
        if not len(key.table):
            raise InputError([Fault(say("fault.G006", stopped=key.stopped), source.name)])
        grid = grid_of(variant, {name: tuple(key.table[:, place].tolist()) for place, name in enumerate(key.names)})
        others = {name: table for name, table in self._tables.items() if name != source.name}
        made = Marker(key, self.rubric, others), Expected(grid, variant, tuple(a.name for a in self.rubric.answers))
        self._markers[source.sha256] = made
        while len(self._markers) > KEPT:
            self._markers.popitem(last=False)
        return made
