"""Grading a class: new submissions go to the workers, all grades into the gradebook; what is done already is kept.

Enters: a `ClassList`, `Setup`, OUT.  Leaves: `journal.jsonl`, pages, then the files of `written.py`.  Used by the command.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

from coursework.grading.batch.class_list import ClassList
from coursework.grading.batch.decisions import Override
from coursework.grading.batch.journal import Entry, Journal
from coursework.grading.batch.work import REASONS, Outcome, Setup
from coursework.grading.batch.workers import LIMIT, Keyed, in_processes, on_cluster
from coursework.grading.collecting.sources import Source
from coursework.grading.marking.rubric import read_rubric
from coursework.grading.platforms.names import file_stem
from coursework.system.files.whole_files import write_bytes
from coursework.system.frozen import frozen

MOST_JOBS = 8
PAGES = "feedback"


@frozen
class Options:
    """How a batch is run; no option changes a mark."""

    jobs: int
    scheduler: str | None = None
    limit: float = LIMIT

    @property
    def processes(self) -> int:
        """Return how many processes work at the same time."""
        return self.jobs or min(MOST_JOBS, os.cpu_count() or 1)


@frozen
class Change:
    """A grade that differs from the last run's; `after` is "" if the submission is gone."""

    id: str
    before: str
    after: str
    reason: str


@dataclass
class Graded:
    """The result of a run: the place of each student's grade in the journal, its state, how many are new, and what changed."""

    journal: Journal
    places: dict[str, int] = field(default_factory=dict)
    states: dict[str, str] = field(default_factory=dict)
    fresh: int = 0
    changes: list[Change] = field(default_factory=list)

    def entries(self) -> Iterator[Entry]:
        """Yield all grades, sorted by id."""
        for student in sorted(self.places):
            yield self.journal.read(self.places[student])


def page_name(student: str) -> str:
    """Return the path of a student's page in OUT."""
    return f"{PAGES}/{file_stem(student)}.html"


def grade_class(
    listed: ClassList, source: Source, setup: Setup, journal: Journal, out: Path, options: Options,
    overrides: Mapping[str, tuple[Override, ...]], progress: Callable[[], None],
) -> Graded:  # fmt: skip
    """Return the grades of a class; `progress` is called once for each student.  The journal must be open.

    A submission is not graded again if its files, variant, rubric, decisions and version are those of an earlier run.
    """
    by_key, by_id = journal.places()
    timed = bool(setup.rubric) and read_rubric(setup.rubric).late is not None
    graded = Graded(journal)
    names: dict[str, list[str]] = {}

    def fresh() -> Iterator[Keyed]:
        for task in listed.tasks(source, overrides, timed):
            key = task.key(setup)
            student = task.submission.id
            if key in by_key and _page_stands(out, entry := journal.read(by_key[key]), setup.pages):
                graded.places[student], graded.states[student] = by_key[key], entry.grade["status"]
                progress()
                continue
            names.setdefault(key, []).append(student)
            yield key, task

    tasks = fresh()
    done = (
        on_cluster(tasks, setup, options.scheduler, options.limit)
        if options.scheduler
        else in_processes(tasks, setup, options.processes, options.limit)
    )
    with closing(done):
        for key, outcome in done:
            entry = Entry(key, outcome.id, outcome.grade, _page_written(out, outcome))
            graded.places[outcome.id], graded.states[outcome.id] = journal.add(entry), outcome.grade["status"]
            graded.fresh += 1
            if change := _change(entry, journal.read(by_id[outcome.id]) if outcome.id in by_id else None):
                graded.changes.append(change)
            progress()
    for student in by_id.keys() - graded.places.keys():
        before = journal.read(by_id[student])
        if _page_stands(out, before, wanted=True):  # the submission is gone
            (out / page_name(student)).unlink()
        graded.changes.append(Change(student, _mark(before), "", "withdrawn"))
    graded.changes.sort(key=lambda change: change.id)
    return graded


def _page_written(out: Path, outcome: Outcome) -> str:
    """Write the page of an outcome; return its hash, "" if there is no page."""
    if not outcome.page:
        return ""
    content = outcome.page.encode("utf-8")
    write_bytes(out / page_name(outcome.id), content)
    return hashlib.sha256(content).hexdigest()


def _page_stands(out: Path, entry: Entry, wanted: bool) -> bool:
    """Return whether an entry's page is in its place and unchanged, or is not wanted."""
    if not wanted:
        return True
    page = out / page_name(entry.id)
    return bool(entry.page) and page.is_file() and hashlib.sha256(page.read_bytes()).hexdigest() == entry.page


def _change(entry: Entry, before: Entry | None) -> Change | None:
    if before is None:
        return None
    parts = zip(REASONS, before.key.split(), entry.key.split(), strict=False)
    reason = next((name for name, old, new in parts if old != new), "again")
    if _mark(before) == _mark(entry) and reason != "overrides":  # a decision is listed even if it changed nothing
        return None
    return Change(entry.id, _mark(before), _mark(entry), reason)


def _mark(entry: Entry) -> str:
    score = entry.grade["score"]
    return entry.grade["status"] if score is None else f"{score:.2f}"
