"""Inside a process that marks: a task -> an outcome.  The keys of variants are made once and kept.

Enters: `Setup`, tasks.  Leaves: `Outcome`s.  Every process of `workers.py` opens a workshop by its name; no module imports it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

import numpy as np

from coursework.grading.batch.decisions import overridden
from coursework.grading.batch.work import Outcome, Setup, Task, VariantSource, failed
from coursework.grading.marking.grade import Grade, Marker
from coursework.grading.marking.key.key import key_to_mark_by
from coursework.grading.marking.reasons.reasons import reasons
from coursework.grading.marking.rubric import Rubric, read_rubric
from coursework.grading.pages.feedback import feedback_page
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission
from coursework.system.processes.plain_lines import record_of
from coursework.variant.reading.reader import parse_variant
from coursework.words.custom_templates import templates_standing_in
from coursework.words.errors import InputError
from coursework.words.sentences import joined, load_phrases, say

KEPT = 8  # keys kept at once: a class shares one key, or every student has another


@contextmanager
def opened(plain_setup: Any) -> Iterator[Callable[[Any], Outcome]]:
    """Yield a function that marks one submission after the other; meanwhile the instructor's page templates are in use."""
    setup = record_of(Setup, plain_setup)
    with templates_standing_in(setup.pieces):
        yield Workshop(setup).answer


class Workshop:
    """What a child process keeps between submissions."""

    def __init__(self, setup: Setup) -> None:
        self.setup, self.words = setup, load_phrases(setup.language)
        self.rubric: Rubric = read_rubric(setup.rubric) if setup.rubric else Rubric()
        self._tables = {name: np.array(table) for name, table in setup.class_tables.items()}
        self._marker = lru_cache(KEPT)(self._made)

    def answer(self, plain_task: Any) -> Outcome:
        """Return the outcome of one task, which arrives as plain data."""
        task = record_of(Task, plain_task)
        submission, source = task.submission, task.variant
        try:
            grade = self.grade(submission, source, task.accepted_decimals)
        except MemoryError:
            return failed(task, self.setup, "unreadable", say("grading.memory"))
        except InputError as error:  # in the instructor's file: neither the student nor this program is at fault
            why_not = joined([fault.message for fault in error.faults])
            return failed(task, self.setup, "needs-review", say("grading.unusable", reason=why_not))
        why = [reason.plain() for reason in reasons(grade)]
        hidden = list((grade.table.hidden if grade.table else None) or ())
        marked = grade.plain() | {"reasons": why, "hidden": hidden}
        plain = self.words.throughout(overridden(marked, task.overrides, self.rubric, task.handed_in))
        page = feedback_page(grade, submission.id, submission.name, plain, self.words) if self.setup.pages else ""
        return Outcome(submission.id, plain, page)

    def grade(self, submission: Submission, source: VariantSource, accepted_decimals: int | None = None) -> Grade:
        """Return the grade of a submission.  Raises `InputError` if the variant itself cannot be used."""
        marker, expected = self._marker(source, accepted_decimals)
        return marker.grade(read_submission(submission, expected))

    def _made(self, source: VariantSource, accepted_decimals: int | None) -> tuple[Marker, Expected]:
        variant = parse_variant(source.content, source.name, source.tables)
        key = key_to_mark_by(variant, accepted_decimals)
        grid = key.grid
        if self.rubric.forces and key.forces is not None:
            from coursework.grading.marking.key.forces import with_forces

            grid = with_forces(grid, key.forces, self.rubric.forces)
        others = {name: table for name, table in self._tables.items() if name != source.name}
        return Marker(key, self.rubric, others), Expected(grid, variant, tuple(a.name for a in self.rubric.answers))
