"""Marking in the process of the tests, for those that ask nothing of processes: one that starts takes longer than a class.

Enters: the tasks of a class.  Leaves: their outcomes, through the same lines as between two processes.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from unittest.mock import patch

from coursework.grading.batch import gradebook
from coursework.grading.batch.work import Outcome, Setup
from coursework.grading.batch.workers import Keyed
from coursework.grading.batch.workshop import opened
from coursework.system.plain_lines import line_of, plain_of, read_line


@contextmanager
def in_this_process() -> Iterator[None]:
    """Let a class be marked here, whatever number of processes is asked for."""

    def marked(tasks: Iterable[Keyed], setup: Setup, _jobs: int, _limit: float) -> Iterator[tuple[str, Outcome]]:
        with opened(plain_of(setup)) as answer:
            for key, task in tasks:
                yield key, read_line(Outcome, line_of(answer(json.loads(line_of(task)))))

    with patch.object(gradebook, "in_processes", marked):
        yield
