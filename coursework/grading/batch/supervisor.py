"""A child that is watched: silence is a timeout, a death is tried once more alone, and the batch goes on.

Enters: a `Setup`, tasks.  Leaves: `Outcome`s, one a task, whatever happens.  Used by the pool of a batch and by cluster workers.
"""

from __future__ import annotations

import queue
import subprocess
import sys
import threading
from contextlib import suppress
from typing import IO

from coursework.grading.batch.work import Outcome, Setup, Task, failed, outcome_from
from coursework.words.sentences import say

LIMIT = 10.0  # s a submission may take
STARTING = 60.0  # s for the first answer of a child, which imports everything
# What leaks somewhere in a library cannot pile up: a child is replaced when it has grown by so many MiB, and, for platforms
# that do not say how much a process holds, after so many submissions.
MOST_GROWN = 256
REPLACED_AFTER = 2000
_ENDING = 2.0  # s in which a child puts its temporary files away
CHILD = "coursework.grading.batch.child"


class Supervisor:
    """One child at a time; a context manager."""

    def __init__(self, setup: Setup, limit: float = LIMIT) -> None:
        self.setup, self.limit = setup, limit
        self._child: subprocess.Popen[bytes] | None = None
        self._answers: queue.Queue[bytes] = queue.Queue()
        self._served = self._grown = 0

    def __enter__(self) -> Supervisor:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def grade(self, task: Task) -> Outcome:
        """Return what came of a task: its grade, or "timeout" or "crashed-grader"."""
        for _ in range(2):
            answer = self._asked(task)
            if answer == _SILENT:
                return failed(task, self.setup, "timeout", say("grading.timeout", seconds=self.limit))
            with suppress(ValueError):
                return outcome_from(answer)
            self.close()
        return failed(task, self.setup, "crashed-grader", say("grading.crashed_grader"))

    def close(self) -> None:
        """End the child."""
        if self._child is None:
            return
        child, self._child = self._child, None
        with suppress(OSError):
            if child.stdin is not None:
                child.stdin.close()
        with suppress(subprocess.TimeoutExpired):
            child.wait(_ENDING if self.setup.pieces else 0)
        child.kill()
        for stream in (child.stdin, child.stdout):
            if stream is not None:
                with suppress(OSError):
                    stream.close()
        child.wait()

    def _asked(self, task: Task) -> bytes:
        """Return the child's line, `_SILENT` where it took too long, b"" where it died."""
        if self._served >= REPLACED_AFTER or self._grown >= MOST_GROWN:
            self.close()
        fresh = self._child is None
        if fresh:
            self._start()
        assert self._child is not None
        assert self._child.stdin is not None
        try:
            self._child.stdin.write(task.line())
            self._child.stdin.flush()
        except OSError:
            return b""
        try:
            line = self._answers.get(timeout=self.limit + (STARTING if fresh else 0.0))
        except queue.Empty:
            self.close()
            return _SILENT
        self._served += 1
        grown, _, outcome = line.partition(b" ")
        self._grown = int(grown) if grown.isdigit() else 0
        return outcome

    def _start(self) -> None:
        import json

        self._served = self._grown = 0
        self._answers = queue.Queue()
        self._child = subprocess.Popen(
            [sys.executable, "-m", CHILD], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )
        assert self._child.stdin is not None
        assert self._child.stdout is not None
        with suppress(OSError):
            self._child.stdin.write(json.dumps(self.setup.plain()).encode("ascii") + b"\n")
        threading.Thread(target=_forward, args=(self._child.stdout, self._answers), daemon=True).start()


_SILENT = b"silent"


def _forward(stream: IO[bytes], answers: queue.Queue[bytes]) -> None:
    """Put each line into the queue, and b"" at the end."""
    with suppress(OSError, ValueError):
        for line in stream:
            answers.put(line)
    answers.put(b"")
