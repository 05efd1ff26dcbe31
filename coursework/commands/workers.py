"""Work handed out to processes of our own, which may die over it without taking the others along.

Enters: a task that can be sent to another process, and items.  Leaves: outcomes as they come.  Used by `several.py`.
"""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any, Protocol


class Task(Protocol):
    """What a process does: made ready once, then done for one item after the other."""

    def ready(self) -> AbstractContextManager[Callable[[Any], Any]]: ...
    def lost(self, item: Any) -> Any:
        """Return the outcome of an item over which its process died."""
        ...


def outcomes(task: Task, items: Sequence[Any], jobs: int) -> Iterator[tuple[int, Any]]:
    """Yield (index, outcome) of every item as it is done: in this process for one job, else in so many others."""
    if jobs == 1:
        with task.ready() as work:
            for index, item in enumerate(items):
                yield index, work(item)
        return
    waiting = list(range(len(items)))[::-1]
    busy: dict[Connection, _Worker] = {}
    try:
        for _ in range(min(jobs, len(items))):
            _Worker(task).take(waiting, items, busy)
        while busy:
            for ready in wait(list(busy)):
                worker = busy.pop(ready)  # type: ignore[call-overload]
                index = worker.index
                try:
                    outcome = worker.ours.recv()
                except (EOFError, OSError):
                    outcome = task.lost(items[index])
                    worker.end()
                    worker = _Worker(task) if waiting else worker
                yield index, outcome
                worker.take(waiting, items, busy)
    finally:
        for worker in busy.values():
            worker.end()


class _Worker:
    """One process and our end of the line to it."""

    def __init__(self, task: Task) -> None:
        # A fresh interpreter on every system: what is forked inherits threads and locks.
        context = multiprocessing.get_context("spawn")
        self.ours, theirs = context.Pipe()
        self.process: SpawnProcess = context.Process(target=_serve, args=(task, theirs), daemon=True)
        self.process.start()
        theirs.close()
        self.index = -1

    def take(self, waiting: list[int], items: Sequence[Any], busy: dict[Any, _Worker]) -> None:
        """Give the worker its next item, or let it go where there is none."""
        if not waiting:
            self.end()
            return
        self.index = waiting.pop()
        with suppress(OSError):  # whoever is gone is noticed when nothing comes back
            self.ours.send(items[self.index])
        busy[self.ours] = self

    def end(self) -> None:
        """End the process, whatever it is doing, and wait until it has."""
        self.ours.close()
        if self.process.is_alive() and self.index >= 0:
            self.process.join(0.5)  # an idle one ends by itself when the line is closed
        if self.process.is_alive():
            self.process.terminate()
        self.process.join()


def _serve(task: Task, line: Connection) -> None:
    """Do what comes over the line until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent hears it too, and ends us
    with suppress(EOFError, OSError, KeyboardInterrupt), task.ready() as work:
        while True:
            line.send(work(line.recv()))
