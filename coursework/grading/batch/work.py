"""What a child process needs to grade one submission, as plain data that can go to another process or machine.

Enters: variants, rubric, options.  Leaves: `Setup`, `Task`, `Outcome`.  Used by `workshop.py` in the processes that mark,
by `workers.py` beside them, by the class list and the command.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from coursework.grading.batch.decisions import Override, overridden
from coursework.grading.marking.blank import blank_grade
from coursework.grading.marking.reasons.reasons import state_reason
from coursework.grading.marking.rubric import read_rubric
from coursework.grading.reading.documents.pdf import pdf
from coursework.grading.reading.submission import Submission
from coursework.system.frozen import frozen
from coursework.system.processes.plain_lines import plain_of
from coursework.system.version import VERSION
from coursework.words.sentence import Sentence
from coursework.words.sentences import ENGLISH, load_phrases

# Increased whenever marks may change: the next run then grades everything again.
GRADING_VERSION = 36


@dataclass(frozen=True)
class VariantSource:
    """A variant as bytes: its name, its file and its side tables; a child never reads them from the disk."""

    name: str
    content: bytes
    tables: Mapping[str, bytes] = field(default_factory=dict, hash=False)

    @cached_property
    def sha256(self) -> str:
        """Return the hash of the file and all side tables."""
        digest = hashlib.sha256(self.content)
        for name in sorted(self.tables):
            digest.update(name.encode() + b"\0" + self.tables[name])
        return digest.hexdigest()


@dataclass(frozen=True)
class Setup:
    """What is the same for a whole batch: the rubric's text, whether pages are wanted, Euler's tables of the class's variants.

    `pieces` are the instructor's own page templates, by name; `language` is that of pages and sentences.
    """

    rubric: str = ""
    pages: bool = True
    class_tables: Mapping[str, list[list[float]]] = field(default_factory=dict)
    memory_mib: int = 1024
    pieces: Mapping[str, bytes] = field(default_factory=dict)
    language: str = ENGLISH


@frozen
class Task:
    """One submission, its variant, the instructor's decisions about it, and the decimals accepted from its class.

    `handed_in` is the time in ISO 8601, or one of the words of `late.py`; "" if it does not matter.
    """

    submission: Submission
    variant: VariantSource
    overrides: tuple[Override, ...] = ()
    accepted_decimals: int | None = None
    handed_in: str = ""

    def key(self, setup: Setup) -> str:
        """Return the key of this work in the journal: one hash for each reason to grade again, never of a path or a clock."""
        looks = (GRADING_VERSION, VERSION, setup.pages, sorted(setup.pieces.items()), setup.language)
        missing = () if pdf.is_readable() else (pdf.EXTRA,)  # with this extra a file may become readable
        parts = {
            "files": json.dumps(plain_of(self.submission), sort_keys=True) + self.handed_in,
            "variant": " ".join(str(part) for part in (self.variant.sha256, self.accepted_decimals) if part is not None),
            "rubric": setup.rubric,
            # An empty `say` is not in the record, but keeps the reason from the student.
            "overrides": json.dumps([one.plain() | ({} if one.say is None else {"say": one.say}) for one in self.overrides]),
            "version": " ".join(map(str, (*looks, *missing))),
        }
        return " ".join(hashlib.sha256(text.encode()).hexdigest()[:_DIGITS] for text in parts.values())


# Reasons to grade a submission again, in the order of the hashes in a key.
REASONS = ("files", "variant", "rubric", "overrides", "version")
_DIGITS = 32


@frozen
class Outcome:
    """The result for one submission: its `grade` as grades.json writes it, and its page ("" if no page was asked for)."""

    id: str
    grade: dict[str, Any]
    page: str = ""


def failed(task: Task, setup: Setup, status: str, reason: Sentence) -> Outcome:
    """Return the outcome of a submission that could not be graded: it has no number, which is not a zero."""
    rubric = read_rubric(setup.rubric)
    words = load_phrases(setup.language)
    why = {"reasons": [state_reason(reason).plain()], "hidden": []}
    grade = words.throughout(overridden(blank_grade(status, reason, rubric) | why, task.overrides, rubric, task.handed_in))
    from coursework.grading.pages.feedback import short_page

    page = short_page(task.submission.id, task.submission.name, grade, words) if setup.pages else ""
    return Outcome(task.submission.id, grade, page)
