"""Jobs done by watched processes of our own: one that hangs, dies or leaks memory harms no job but its own.

Enters: a `Trade`, jobs as records.  Leaves: an answer for each job, whatever happens.  A process may have read a hostile file,
so its output is read only as data of the expected type (`plain_lines.py`).
Used by `several.py`, `grading/batch/` and the desk.

On every system each process is a fresh interpreter with our `sys.path`: a forked one would inherit threads and locks.
"""

from __future__ import annotations

import math
import os
import queue
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import AbstractContextManager, contextmanager, suppress
from itertools import islice
from typing import Any, Generic, TypeVar

from coursework.system.frozen import frozen
from coursework.system.processes.budget import WRONG_INPUT
from coursework.system.processes.one_thread import ONE_THREAD
from coursework.system.processes.plain_lines import line_of, plain_of, read_line, record_of
from coursework.system.processes.pool_process import Answered, Opening

Key = TypeVar("Key")
Job = TypeVar("Job")
Answer = TypeVar("Answer")

STARTING = 60.0  # s added for the first answer of a process, which imports everything
# A leak in some library must not add up: a process is replaced once it has grown by this many MiB, and after this many
# answers, for platforms that do not tell how much memory a process holds.
MOST_GROWN = 256
REPLACED_AFTER = 2000
MOST_BYTES = 64 * 2**20  # of one answer; a page has about 40 kB, a report with its graphs a few MB
AHEAD = 2  # most jobs per worker that are drawn and not yet answered
# How a process ends that has spent its budget: by its own watch, or by the system's clock of its processor time.
_SPENT = (WRONG_INPUT, -getattr(signal, "SIGPROF", -WRONG_INPUT))
_ENDING = 2.0  # s in which a process without a job may remove its temporary files
_PACE = 0.5  # s between two checks for an interrupt, which an endless wait would not notice on Windows
_START = "import sys; sys.path[:] = sys.argv[1:]; from coursework.system.processes.pool_process import main; main()"


@frozen
class Trade(Generic[Job, Answer]):
    """What the processes of a pool can do.

    `place` is "module:function".  Each process calls this function with the plain `setup`; it returns a context manager whose
    value is a function from a plain job to an `answer`.
    `unanswered(job, final)` makes the answer for a job without one.  `final` is True if the process was silent for more than
    `seconds`, was ended because its budget was spent, or was dropped: such a job is not tried again.  It is False if the
    process died in each of `tries` tries, each in a new process.  `memory` (MiB) limits the address space and `processor` (s)
    the processor time of a job, where possible; `seconds` are those of the clock, which a busy machine spends on others.
    """

    place: str
    setup: Any
    answer: type[Answer]
    unanswered: Callable[[Job, bool], Answer]
    seconds: float | None = None
    processor: float | None = None
    memory: int | None = None
    tries: int = 2
    quiet: bool = True  # discard what a process writes to standard error


class Worker(AbstractContextManager["Worker[Job, Answer]"], Generic[Job, Answer]):
    """A context manager around one process at a time, which is started when there is a job for it."""

    def __init__(self, trade: Trade[Job, Answer]) -> None:
        self.trade = trade
        self._child: subprocess.Popen[bytes] | None = None
        self._at_work = threading.Lock()
        self._naming = threading.Lock()
        self._job: Job | None = None
        self.since = 0.0
        self._answered = self._grown = 0
        self.ended = 0  # number of processes that ended, or were ended, during a job
        self._late = self._closed = self._dropped = False

    def __exit__(self, *_: object) -> None:
        self.close()

    def answer(self, job: Job) -> Answer:
        """Return the answer to a job."""
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
                if self._end() in _SPENT or self._late or self._dropped:
                    return self.trade.unanswered(job, True)
            return self.trade.unanswered(job, False)

    def drop(self, job: Job) -> None:
        """Kill the process if it is working on this very job, whose answer nobody needs any longer."""
        with self._naming:
            if self._job is job and self._child is not None:
                self._dropped = True
                self._child.kill()

    def rest(self, seconds: float) -> bool:
        """End the process if it has been idle for `seconds`; return whether one is left.  The next job starts another."""
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
            child.kill()  # the thread that waits for its answer gets none
        with self._at_work:
            self._end()

    @contextmanager
    def _named(self, job: Job) -> Iterator[None]:
        """Record which job the process is working on."""
        with self._naming:
            self._job, self._dropped = job, False
        try:
            yield
        finally:
            with self._naming:
                self._job, self.since = None, time.monotonic()

    def _asked(self, line: bytes) -> bytes:
        """Send a line to the process and return its answer line; incomplete or empty if the process died or was too slow."""
        if self._answered >= REPLACED_AFTER or self._grown >= MOST_GROWN:
            self._end()
        seconds = self.trade.seconds
        if self._child is None:
            self._start()
            seconds = seconds and seconds + STARTING
            trade = self.trade
            line = line_of(Opening(trade.place, plain_of(trade.setup), trade.memory, trade.processor, STARTING)) + line
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
        """Kill the process after `seconds` (never if None), so that nobody waits for it any longer."""

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
        if self._closed:  # closed at this very moment by another thread
            self._child.kill()

    def _end(self) -> int:
        """End the process and return its status; an idle process ends by itself once its input is closed."""
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
    """Workers of one trade, each started when needed; a context manager that ends them whatever they are doing."""

    def __init__(self, trade: Trade[Job, Answer], workers: int) -> None:
        self._workers = [Worker(trade) for _ in range(workers)]
        self._idle: queue.LifoQueue[Worker[Job, Answer]] = queue.LifoQueue()  # a warm worker comes first
        for worker in reversed(self._workers):
            self._idle.put(worker)
        self._threads = ThreadPoolExecutor(workers)

    def __exit__(self, *_: object) -> None:
        self.close()

    def submit(self, job: Job) -> Future[Answer]:
        """Submit a job; its answer comes independently of others.  A job that has not begun can be cancelled."""
        return self._threads.submit(self._answer, job)

    def drop(self, future: Future[Answer], job: Job) -> None:
        """Give up a submitted job: cancel it, or end the process that is working on it."""
        if not future.cancel():
            for worker in self._workers:
                worker.drop(job)

    def rest(self, seconds: float) -> None:
        """End the processes that have been idle for `seconds`, except the one that was busy last."""
        left = [worker for worker in self._workers if worker.rest(math.inf)]
        for worker in sorted(left, key=lambda worker: worker.since)[:-1]:
            worker.rest(seconds)

    @property
    def ended(self) -> int:
        """Return how many processes ended, or were ended, during a job."""
        return sum(worker.ended for worker in self._workers)

    def answers(self, jobs: Iterable[tuple[Key, Job]]) -> Iterator[tuple[Key, Answer]]:
        """Yield the key and answer of each job, in the order of completion; jobs are drawn as needed, in this thread."""
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
