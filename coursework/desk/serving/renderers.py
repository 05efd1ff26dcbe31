"""The processes that compute, as the server sees them: a bounded queue; a newer text replaces an older one of the same desk;
equal jobs get the same answer.

Enters: `Job`s.  Leaves: `Answer`s.  Raises `Refused` if the queue is full.  Used by `application.py`.
"""

from __future__ import annotations

import asyncio
import hashlib
import time
from collections import OrderedDict
from collections.abc import Awaitable
from concurrent.futures import Future
from dataclasses import dataclass, field
from typing import Any

from coursework.desk.job import BUSY, OK, Answer, Job, Setup, fault_entry, faulty, plain, told
from coursework.desk.serving.bodies import Refused
from coursework.system.processes.budget import out_of_time
from coursework.system.processes.plain_lines import line_of, plain_of
from coursework.system.processes.pool import Pool, Trade
from coursework.words.sentences import load_phrases, say

CONFLICT = 409
QUIET = 120.0  # s without a job after which all processes but one are ended
PACE = 10.0  # s between two checks for that
PATIENCE = 1.0  # s that a process may go on with a job for which nobody waits: starting another process costs more
MOST_WAITING = 32  # jobs per process
LONGEST = 5.0  # s that the oldest job may have waited before new ones are refused: nobody waits longer than some seconds
KEPT = 256  # answers kept in a cache, about 70 kB each: a class opens the same variant within a minute
RETRY = {"Retry-After": "2"}
_SLOWER = 4.0  # time that a job may take on a busy machine, in multiples of its processor time


@dataclass(slots=True)
class _Asked:
    """A submitted job, its future answer, and how many requests are waiting for that."""

    job: Job
    future: Future[Answer]
    answer: asyncio.Future[Answer]
    waiting: int = 0
    begun: float = field(default_factory=time.monotonic)


class Renderers:
    """The processes of a desk, with their queue and the cache of answers."""

    def __init__(self, setup: Setup, workers: int) -> None:
        seconds = setup.bounds.seconds

        def unanswered(job: Job, is_spent: bool) -> Answer:
            if not is_spent:
                return told(BUSY, job.language, "desk.process_ended")
            spent = out_of_time(seconds) if setup.folder else say("desk.over_time", limit=f"{seconds:g}")
            return faulty(job.kind, [fault_entry("E001", load_phrases(job.language).written(spent))])

        place = "coursework.desk.answering.bench:opened"
        trade = Trade(place, plain_of(setup), Answer, unanswered, seconds * _SLOWER + PACE, quiet=False)
        self._pool: Pool[Job, Answer] = Pool(trade, workers)
        self._newest: dict[str, asyncio.Future[None]] = {}
        self._workers = workers
        self._alike = not setup.folder  # equal jobs have equal answers, because there are no tables beside the text
        self._asked: dict[bytes, _Asked] = {}
        self._kept: OrderedDict[bytes, Answer] = OrderedDict()
        self.waiting = 0  # jobs under way and in the queue

    @property
    def ended(self) -> int:
        """Return how many processes have ended during a job."""
        return self._pool.ended

    def warm(self) -> None:
        """Start a process before a request needs it."""
        self._pool.submit(Job("warm"))

    async def rest(self) -> None:
        """End idle processes at intervals of `PACE`, until cancelled."""
        while True:
            await asyncio.sleep(PACE)
            await asyncio.to_thread(self._pool.rest, QUIET)

    async def answer(self, job: Job, desk: str = "", gone: Awaitable[None] | None = None) -> Answer:
        """Return the answer to a job; waiting ends if a newer job of the same `desk` comes or the client is `gone`."""
        newer: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        stops: list[asyncio.Future[None]] = [newer, *([asyncio.ensure_future(gone)] if gone is not None else [])]
        if desk:
            if (older := self._newest.get(desk)) is not None and not older.done():
                older.set_result(None)
            self._newest[desk] = newer
        try:
            return await self._found(job, stops)
        finally:
            for each in stops:
                each.cancel()
            if self._newest.get(desk) is newer:
                del self._newest[desk]

    async def _found(self, job: Job, stops: list[asyncio.Future[None]]) -> Answer:
        """Return the answer to a job, shared with equal jobs before or beside it, or a cancellation if one of `stops` is done."""
        key = hashlib.sha256(line_of(job)).digest() if self._alike else job.kind.encode() + id(job).to_bytes(8)
        if (kept := self._kept.get(key)) is not None:
            self._kept.move_to_end(key)
            return kept
        ended, asked = self._pool.ended, self._asked.get(key)
        if asked is None:
            if self._is_full():
                raise Refused(BUSY, say("desk.busy"), RETRY)
            future = self._pool.submit(job)
            asked = self._asked[key] = _Asked(job, future, asyncio.wrap_future(future))
            self.waiting += 1
        asked.waiting += 1
        try:
            waited: set[asyncio.Future[Any]] = {asked.answer, *stops}
            await asyncio.wait(waited, return_when=asyncio.FIRST_COMPLETED)
            if stops[0].done() or not asked.answer.done():
                return plain(CONFLICT, {"cancelled": True})
            answer = asked.answer.result()
            if self._alike and answer.status == OK:
                self._kept[key] = answer
                while len(self._kept) > KEPT:
                    self._kept.popitem(last=False)
            return answer
        finally:
            asked.waiting -= 1
            if not asked.waiting:
                self._leave(key, asked)
            if self._pool.ended > ended:
                self.warm()

    def _is_full(self) -> bool:
        """Return whether a new job would wait for too long."""
        oldest = next(iter(self._asked.values()), None)
        late = oldest is not None and time.monotonic() - oldest.begun > LONGEST
        return self.waiting >= self._workers * MOST_WAITING or (late and self.waiting > 2 * self._workers)

    def _leave(self, key: bytes, asked: _Asked) -> None:
        """Give up a job for which nobody waits; it is dropped after `PATIENCE`, and a process that computes it is ended."""
        del self._asked[key]
        self.waiting -= 1
        asked.answer.cancel()
        if not asked.future.done():
            asyncio.get_running_loop().call_later(PATIENCE, self._pool.drop, asked.future, asked.job)

    def close(self) -> None:
        """End all processes, even busy ones."""
        self._pool.close()
