"""Many tasks at once: in a pool of processes here, or on a Dask cluster, each of whose workers supervises one process.

Enters: tasks by the key of their work, lazily.  Leaves: (key, `Outcome`) pairs as they come, each key once.
Used by `gradebook.py` and the command; both ways give the same outcomes, in different orders.
"""

from __future__ import annotations

import itertools
import threading
from collections.abc import Generator, Iterable, Iterator
from typing import Any

from coursework.grading.batch.work import Outcome, Setup, Task, failed
from coursework.system.extras import installing_extra
from coursework.system.processes.plain_lines import line_of, plain_of, read_line, record_of
from coursework.system.processes.pool import Pool, Trade, Worker
from coursework.words.errors import InputError
from coursework.words.sentences import say

Keyed = tuple[str, Task]
CHUNK = 100  # submissions in a cluster task: they take far longer than their transport
PATIENCE = 10  # s to wait for a scheduler
AHEAD = 2  # chunks waiting for each worker thread
LIMIT = 10.0  # s of processor time that a submission may take
SLOWER = 6.0  # times as long it may take by the clock: the machine may be busy, or its system may not tell the processor time
OPENED = "coursework.grading.batch.workshop:opened"


def trade_of(setup: Setup, limit: float = LIMIT) -> Trade[Task, Outcome]:
    """Return the work of the marking processes: each submission may take `limit` seconds and the memory that `setup` allows.

    The seconds are those of the processor: on a busy machine right work is marked as on an idle one.
    """

    def unanswered(task: Task, late: bool) -> Outcome:
        if late:
            return failed(task, setup, "timeout", say("grading.timeout", seconds=limit))
        return failed(task, setup, "crashed-grader", say("grading.crashed_grader"))

    return Trade(OPENED, setup, Outcome, unanswered, seconds=SLOWER * limit, processor=limit, memory=setup.memory_mib)


def in_processes(
    tasks: Iterable[Keyed], setup: Setup, jobs: int, limit: float = LIMIT
) -> Generator[tuple[str, Outcome], None, None]:
    """Yield the outcome of each task from `jobs` processes; tasks are drawn only as they are needed."""
    with Pool(trade_of(setup, limit), jobs) as pool:
        yield from pool.answers(tasks)


def on_cluster(
    tasks: Iterable[Keyed], setup: Setup, address: str, limit: float = LIMIT
) -> Generator[tuple[str, Outcome], None, None]:
    """Yield the outcome of each task from the workers of a Dask cluster.  Raises `InputError` if there is no cluster.

    The chunks of a killed worker are computed again elsewhere; each chunk's result is taken once, so none is lost or doubled.
    """
    try:
        import distributed
    except ImportError:
        raise InputError(say("fault.G032", command=installing_extra("cluster"))) from None
    cluster: Any = distributed  # its calls carry no types
    try:
        client = cluster.Client(address, timeout=PATIENCE)
    except (OSError, TimeoutError, ValueError) as error:
        raise InputError(say("fault.G033", address=address, error=error)) from None
    with client:
        shared = plain_of(setup)
        chunks = _chunks(tasks)
        running: dict[Any, list[str]] = {}
        results = cluster.as_completed()
        most = max(1, AHEAD * sum(client.nthreads().values()))

        def more() -> None:
            while len(running) < most and (chunk := next(chunks, None)):
                lines = [line_of(task) for _, task in chunk]
                future = client.submit(grade_chunk, shared, lines, limit, pure=False, retries=0)
                running[future.key] = [key for key, _ in chunk]
                results.add(future)

        more()
        for future in results:
            keys = running.pop(future.key)
            lines = future.result()
            yield from zip(keys, (read_line(Outcome, line) for line in lines), strict=True)
            more()


def _chunks(tasks: Iterable[Keyed]) -> Iterator[list[Keyed]]:
    waiting = iter(tasks)
    while chunk := list(itertools.islice(waiting, CHUNK)):
        yield chunk


_keeping = threading.local()


def grade_chunk(setup: dict[str, Any], lines: list[bytes], limit: float) -> list[bytes]:
    """Return the outcomes of some tasks, both as lines; runs on a worker, whose process is kept from chunk to chunk."""
    if getattr(_keeping, "wanted", None) != (setup, limit):
        if kept := getattr(_keeping, "worker", None):
            kept.close()
        _keeping.worker = Worker(trade_of(record_of(Setup, setup), limit))
        _keeping.wanted = setup, limit
    return [line_of(_keeping.worker.answer(read_line(Task, line))) for line in lines]
