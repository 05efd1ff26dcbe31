"""Many tasks at once: threads that each watch a child, or the workers of a Dask cluster that do the same.

Enters: tasks by the key of their work, lazily.  Leaves: (key, `Outcome`) pairs as they come, each key once.
Used by `gradebook.py`; both ways give the same outcomes in another order.
"""

from __future__ import annotations

import itertools
import queue
import threading
from collections.abc import Iterable, Iterator
from typing import Any

from coursework.grading.batch.supervisor import LIMIT, Supervisor
from coursework.grading.batch.work import Outcome, Setup, Task, outcome_from, setup_from, task_from
from coursework.words.errors import InputError
from coursework.words.sentences import say

Keyed = tuple[str, Task]
CHUNK = 100  # submissions a cluster task: far longer than its way there and back
PATIENCE = 10  # s to reach a scheduler
AHEAD = 2  # chunks a worker thread has waiting
_END = object()


def in_threads(tasks: Iterable[Keyed], setup: Setup, jobs: int, limit: float = LIMIT) -> Iterator[tuple[str, Outcome]]:
    """Yield the outcome of each task from `jobs` threads with a child each; tasks are drawn as they are needed."""
    waiting = iter(tasks)
    drawing = threading.Lock()
    done: queue.Queue[Any] = queue.Queue(maxsize=2 * jobs)
    ended = threading.Event()

    def work() -> None:
        try:
            with Supervisor(setup, limit) as supervisor:
                while not ended.is_set():
                    with drawing:
                        drawn = next(waiting, None)
                    if drawn is None:
                        break
                    done.put((drawn[0], supervisor.grade(drawn[1])))
        except BaseException as error:
            done.put(error)
        finally:
            done.put(_END)

    threads = [threading.Thread(target=work, daemon=True) for _ in range(jobs)]
    for thread in threads:
        thread.start()
    try:
        open_threads = len(threads)
        while open_threads:
            found = done.get()
            if found is _END:
                open_threads -= 1
            elif isinstance(found, BaseException):
                raise found
            else:
                yield found
    finally:
        ended.set()
        while any(thread.is_alive() for thread in threads):
            try:  # threads that wait to hand over an outcome nobody takes any more
                done.get(timeout=0.05)
            except queue.Empty:
                continue


def on_cluster(tasks: Iterable[Keyed], setup: Setup, address: str, limit: float = LIMIT) -> Iterator[tuple[str, Outcome]]:
    """Yield the outcome of each task from the workers of a Dask cluster.  Raises `InputError` where there is none.

    A killed worker's chunks are computed anew elsewhere; a chunk's result is taken once, so nothing is lost or doubled.
    """
    try:
        import distributed
    except ImportError:
        raise InputError(say("fault.G032")) from None
    cluster: Any = distributed  # its calls carry no types
    try:
        client = cluster.Client(address, timeout=PATIENCE)
    except (OSError, TimeoutError, ValueError) as error:
        raise InputError(say("fault.G033", address=address, error=error)) from None
    with client:
        shared = setup.plain()
        chunks = _chunks(tasks)
        running: dict[Any, list[str]] = {}
        results = cluster.as_completed()
        most = max(1, AHEAD * sum(client.nthreads().values()))

        def more() -> None:
            while len(running) < most and (chunk := next(chunks, None)):
                lines = [task.line() for _, task in chunk]
                future = client.submit(grade_chunk, shared, lines, limit, pure=False, retries=0)
                running[future.key] = [key for key, _ in chunk]
                results.add(future)

        more()
        for future in results:
            keys = running.pop(future.key)
            lines = future.result()
            yield from zip(keys, map(outcome_from, lines), strict=True)
            more()


def _chunks(tasks: Iterable[Keyed]) -> Iterator[list[Keyed]]:
    waiting = iter(tasks)
    while chunk := list(itertools.islice(waiting, CHUNK)):
        yield chunk


_keeping = threading.local()


def grade_chunk(setup: dict[str, Any], lines: list[bytes], limit: float) -> list[bytes]:
    """Return the outcome lines of some task lines; runs on a worker, whose child stays warm from chunk to chunk."""
    wanted = setup_from(setup)
    kept: Supervisor | None = getattr(_keeping, "supervisor", None)
    if kept is None or kept.setup != wanted or kept.limit != limit:
        if kept is not None:
            kept.close()
        kept = _keeping.supervisor = Supervisor(wanted, limit)
    return [kept.grade(task_from(line)).line() for line in lines]
