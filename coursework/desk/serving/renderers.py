"""The processes that compute, as the server sees them: a bounded queue, a newer text before an older one of the same desk.

Enters: `Job`s.  Leaves: `Answer`s.  Raises `Refused` where the queue is full.  Used by `application.py`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable
from typing import Any

from coursework.desk.job import BUSY, Answer, Job, Setup, fault_entry, faulty, plain, told
from coursework.desk.serving.bodies import Refused
from coursework.system.budget import out_of_time
from coursework.system.plain_lines import plain_of
from coursework.system.pool import Pool, Trade
from coursework.words.sentences import load_phrases, say

CONFLICT = 409
QUIET = 120.0  # s without a job after which all processes but one end
PACE = 10.0  # s between two looks for them
PATIENCE = 1.0  # s that a process may go on with what nobody waits for any longer: it is dearer to start another
MOST_WAITING = 32  # jobs for each process; more than some seconds nobody waits
RETRY = {"Retry-After": "2"}
_SLOWER = 4.0  # a process may wait for others so many times as long as it computes


class Renderers:
    """Some processes of one trade."""

    def __init__(self, setup: Setup, workers: int) -> None:
        seconds = setup.bounds.seconds

        def unanswered(job: Job, is_spent: bool) -> Answer:
            if not is_spent:
                return told(BUSY, job.language, "desk.process_ended")
            return faulty(job.kind, [fault_entry("E001", load_phrases(job.language).written(out_of_time(seconds)))])

        place = "coursework.desk.answering.bench:opened"
        trade = Trade(place, plain_of(setup), Answer, unanswered, seconds * _SLOWER + PACE, quiet=False)
        self._pool: Pool[Job, Answer] = Pool(trade, workers)
        self._newest: dict[str, asyncio.Future[None]] = {}
        self._most = workers * MOST_WAITING
        self.waiting = 0  # jobs under way and in the queue

    @property
    def ended(self) -> int:
        """Return how many processes have ended over a job."""
        return self._pool.ended

    def warm(self) -> None:
        """Start a process, before somebody waits for it."""
        self._pool.submit(Job("warm"))

    async def rest(self) -> None:
        """End again and again what has been quiet for long, until cancelled."""
        while True:
            await asyncio.sleep(PACE)
            await asyncio.to_thread(self._pool.rest, QUIET)

    async def answer(self, job: Job, desk: str = "", gone: Awaitable[None] | None = None) -> Answer:
        """Return the answer of a job; a newer one of the same `desk`, or its asker being `gone`, ends the waiting for it."""
        if self.waiting >= self._most:
            raise Refused(BUSY, say("desk.busy"), RETRY)
        ended = self._pool.ended
        newer: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        if desk:
            if (older := self._newest.get(desk)) is not None and not older.done():
                older.set_result(None)
            self._newest[desk] = newer
        future = self._pool.submit(job)
        answer = asyncio.wrap_future(future)
        stops: list[asyncio.Future[None]] = [newer, *([asyncio.ensure_future(gone)] if gone is not None else [])]
        waited: set[asyncio.Future[Any]] = {answer, *stops}
        self.waiting += 1
        try:
            await asyncio.wait(waited, return_when=asyncio.FIRST_COMPLETED)
            return plain(CONFLICT, {"cancelled": True}) if newer.done() or not answer.done() else answer.result()
        finally:
            self.waiting -= 1
            for each in waited:
                each.cancel()
            if not future.done():  # a process is at it; it may end by itself, for to start another is dearer
                asyncio.get_running_loop().call_later(PATIENCE, self._pool.drop, future, job)
            if self._newest.get(desk) is newer:
                del self._newest[desk]
            if self._pool.ended > ended:
                self.warm()

    def close(self) -> None:
        """End all processes, whatever they are doing."""
        self._pool.close()
