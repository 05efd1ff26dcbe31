"""Jobs done by processes of our own, which are watched: silence, a death or a leak costs one process and nobody else's job.

Enters: a `Trade`, jobs as records.  Leaves: an answer a job, whatever happens.  A process may have read a hostile file, so what
it sends is read as data of the kind expected and nothing else (`plain_lines.py`).
Used by `several.py`, `grading/batch/` and the desk.

Every process is a fresh interpreter on every system, with the paths of this one: what is forked inherits threads and locks.
"""

from __future__ import annotations

import math
import os
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import AbstractContextManager, contextmanager, suppress
from itertools import islice
from typing import Any, Generic, TypeVar

from coursework.system.budget import WRONG_INPUT
from coursework.system.frozen import frozen
from coursework.system.one_thread import ONE_THREAD
from coursework.system.plain_lines import line_of, plain_of, read_line, record_of
from coursework.system.pool_process import Answered, Opening

Key = TypeVar("Key")
Job = TypeVar("Job")
Answer = TypeVar("Answer")

STARTING = 60.0  # s for the first answer of a process, which imports everything
# What leaks somewhere in a library cannot pile up: a process is replaced when it has grown by so many MiB, and, for platforms
# that do not say how much a process holds, after so many answers.
MOST_GROWN = 256
REPLACED_AFTER = 2000
MOST_BYTES = 64 * 2**20  # of an answer; a page has some 40 kB, a report with its graphs a few MB
AHEAD = 2  # jobs a worker that are drawn before they can be done
_ENDING = 2.0  # s in which a process without a job puts its temporary files away
_PACE = 0.5  # s between two looks for an interrupt, which on Windows no endless wait hears
_START = "import sys; sys.path[:] = sys.argv[1:]; from coursework.system.pool_process import main; main()"


@frozen
class Trade(Generic[Job, Answer]):
    """What the processes of a pool can do.

    `place` is "module:function": called with the plain `setup` in each process, it returns a context whose value is a function
    from a plain job to an `answer`.  `unanswered` gives the answer for a job over which a process was silent for more than
    `seconds` or ended itself, its budget being spent (True: it is not tried again), or died `tries` times, alone from the second
    on.
    `memory` (MiB) bounds the address space of a process, where the platform can.
    """

    place: str
    setup: Any
    answer: type[Answer]
    unanswered: Callable[[Job, bool], Answer]
    seconds: float | None = None
    memory: int | None = None
    tries: int = 2
    quiet: bool = True  # nothing that a process writes to standard error is shown


class Worker(AbstractContextManager["Worker[Job, Answer]"], Generic[Job, Answer]):
    """One process at a time, started when there is a job for it; a context manager."""

    def __init__(self, trade: Trade[Job, Answer]) -> None:
        self.trade = trade
        self._child: subprocess.Popen[bytes] | None = None
        self._at_work = threading.Lock()
        self._naming = threading.Lock()
        self._job: Job | None = None
        self.since = 0.0
        self._answered = self._grown = 0
        self.ended = 0  # processes that ended, or were ended, over a job
        self._late = self._closed = self._dropped = False

    def __exit__(self, *_: object) -> None:
        self.close()

    def answer(self, job: Job) -> Answer:
        """Return what came of a job."""
        line = line_of(job)
        with self._at_work, self._named(job):
            for _ in range(self.trade.tries):
                if self._closed:
                    break
                with suppress(ValueError):
                    answered = read_line(Answered, self._asked(line))
                    answer = record_of(self.trade.answer, answered.answer)
                    self._answered, self._grown = self._answered + 1, answered.grown
                    return answer
                self.ended += 1
                if self._end() == WRONG_INPUT or self._late or self._dropped:
                    return self.trade.unanswered(job, True)
            return self.trade.unanswered(job, False)

    def drop(self, job: Job) -> None:
        """End the process where it is at this very job, for whose answer nobody waits any longer."""
        with self._naming:
            if self._job is job and self._child is not None:
                self._dropped = True
                self._child.kill()

    def rest(self, seconds: float) -> bool:
        """End the process where it has had no job for so long; return whether one is left.  The next job starts another."""
        if self._at_work.acquire(blocking=False):
            try:
                if time.monotonic() - self.since > seconds:
                    self._end()
            finally:
                self._at_work.release()
        return self._child is not None

    def close(self) -> None:
        """End the process, from any thread and whatever it is doing, and start no other."""
        self._closed = True
        child = self._child
        if child is not None and self._at_work.locked():
            child.kill()  # whoever waits for its answer gets none
        with self._at_work:
            self._end()

    @contextmanager
    def _named(self, job: Job) -> Iterator[None]:
        """Let it be known which job the process is at."""
        with self._naming:
            self._job, self._dropped = job, False
        try:
            yield
        finally:
            with self._naming:
                self._job, self.since = None, time.monotonic()

    def _asked(self, line: bytes) -> bytes:
        """Return the line of the process, less than one where it died or was silent for too long."""
        if self._answered >= REPLACED_AFTER or self._grown >= MOST_GROWN:
            self._end()
        seconds = self.trade.seconds
        if self._child is None:
            self._start()
            seconds = seconds and seconds + STARTING
            line = line_of(Opening(self.trade.place, plain_of(self.trade.setup), self.trade.memory)) + line
        assert self._child is not None
        assert self._child.stdin is not None
        assert self._child.stdout is not None
        answer = b""
        with suppress(OSError), self._clocked(self._child, seconds):
            self._child.stdin.write(line)
            self._child.stdin.flush()
            answer = self._child.stdout.readline(MOST_BYTES)
        return b"" if self._late else answer

    @contextmanager
    def _clocked(self, child: subprocess.Popen[bytes], seconds: float | None) -> Iterator[None]:
        """Kill the process after so many seconds, so that nobody waits for it any longer."""

        def late() -> None:
            self._late = True
            child.kill()

        self._late = False
        clock = threading.Timer(threading.TIMEOUT_MAX if seconds is None else seconds, late)
        clock.daemon = True
        clock.start()
        try:
            yield
        finally:
            clock.cancel()
            clock.join()

    def _start(self) -> None:
        self._answered = self._grown = 0
        self._child = subprocess.Popen(
            [sys.executable, "-c", _START, *sys.path], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL if self.trade.quiet else None, env=ONE_THREAD | os.environ,
        )  # fmt: skip
        if self._closed:  # in this very moment
            self._child.kill()

    def _end(self) -> int:
        """End the process, and return its status: one without a job ends by itself when its line is closed."""
        if self._child is None:
            return 0
        child, self._child = self._child, None
        for stream in (child.stdin, child.stdout):
            if stream is not None:
                with suppress(OSError):
                    stream.close()
        with suppress(subprocess.TimeoutExpired):
            child.wait(_ENDING)
        child.kill()
        return child.wait()


class Pool(AbstractContextManager["Pool[Job, Answer]"], Generic[Job, Answer]):
    """Workers of one trade, each started when it is needed; a context manager, which ends them whatever they are doing."""

    def __init__(self, trade: Trade[Job, Answer], workers: int) -> None:
        self._workers = [Worker(trade) for _ in range(workers)]
        self._idle: queue.LifoQueue[Worker[Job, Answer]] = queue.LifoQueue()  # what is warm comes first
        for worker in reversed(self._workers):
            self._idle.put(worker)
        self._threads = ThreadPoolExecutor(workers)

    def __exit__(self, *_: object) -> None:
        self.close()

    def submit(self, job: Job) -> Future[Answer]:
        """Hand in a job; its answer comes when it comes, without regard to others.  One not yet begun can be cancelled."""
        return self._threads.submit(self._answer, job)

    def drop(self, future: Future[Answer], job: Job) -> None:
        """Give up a job that was handed in: it is not begun, or the process that is at it is ended."""
        if not future.cancel():
            for worker in self._workers:
                worker.drop(job)

    def rest(self, seconds: float) -> None:
        """End the processes that have had no job for so long, all but one."""
        left = [worker for worker in self._workers if worker.rest(math.inf)]
        for worker in sorted(left, key=lambda worker: worker.since)[:-1]:
            worker.rest(seconds)

    @property
    def ended(self) -> int:
        """Return how many processes ended, or were ended, over a job."""
        return sum(worker.ended for worker in self._workers)

    def answers(self, jobs: Iterable[tuple[Key, Job]]) -> Iterator[tuple[Key, Answer]]:
        """Yield the answer of each job with its key, as they come; jobs are drawn as they are needed, in this thread."""
        waiting = iter(jobs)
        running: dict[Future[Answer], Key] = {}
        while True:
            for key, job in islice(waiting, AHEAD * len(self._workers) - len(running)):
                running[self.submit(job)] = key
            if not running:
                return
            for done in wait(running, _PACE, FIRST_COMPLETED).done:
                yield running.pop(done), done.result()

    def close(self) -> None:
        """Begin no further job, and end the processes."""
        self._threads.shutdown(wait=False, cancel_futures=True)
        for worker in self._workers:
            worker.close()
        self._threads.shutdown()

    def _answer(self, job: Job) -> Answer:
        worker = self._idle.get()
        try:
            return worker.answer(job)
        finally:
            self._idle.put(worker)
