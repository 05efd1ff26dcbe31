"""Marking in the process of the tests, for those that ask nothing of processes: one that starts takes longer than a class.

Enters: submissions.  Leaves: their outcomes, through the same lines as between two processes.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from unittest.mock import patch

from coursework.commands import grade
from coursework.grading.batch import gradebook
from coursework.grading.batch.work import Outcome, Setup, Task
from coursework.grading.batch.workers import Keyed, trade_of
from coursework.grading.batch.workshop import opened
from coursework.system.processes.plain_lines import line_of, plain_of, read_line
from coursework.system.processes.pool import Trade


class Here(ExitStack):
    """Stands in for a worker with a process of its own."""

    def __init__(self, trade: Trade[Task, Outcome]) -> None:
        super().__init__()
        self._answer = self.enter_context(opened(plain_of(trade.setup)))

    def answer(self, task: Task) -> Outcome:
        """Return what came of a task."""
        return read_line(Outcome, line_of(self._answer(json.loads(line_of(task)))))


@contextmanager
def in_this_process() -> Iterator[None]:
    """Let a class, or a single submission, be marked here, whatever number of processes is asked for."""

    def marked(tasks: Iterable[Keyed], setup: Setup, _jobs: int, limit: float) -> Iterator[tuple[str, Outcome]]:
        with Here(trade_of(setup, limit)) as worker:
            yield from ((key, worker.answer(task)) for key, task in tasks)

    with patch.object(gradebook, "in_processes", marked), patch.object(grade, "Worker", Here):
        yield
