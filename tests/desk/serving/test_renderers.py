"""The queue before the processes that compute: bounded, a newer text before an older one, nothing for who has left."""

from __future__ import annotations

import asyncio
from concurrent.futures import Future

import pytest

from coursework.desk.job import Answer, Job, Setup
from coursework.desk.serving import renderers
from coursework.desk.serving.bodies import Refused
from coursework.desk.serving.renderers import KEPT, MOST_WAITING, Renderers
from coursework.system.processes.budget import Budget
from tests.desk.desks import ended

OK = Answer(200, "text/plain", b"")


class Pool:
    """In the place of processes: jobs that are answered when a test says so."""

    ended = 0

    def __init__(self, *_):
        self.jobs: list[tuple[Job, Future[Answer]]] = []
        self.dropped: list[Job] = []

    def submit(self, job):
        future: Future[Answer] = Future()
        self.jobs.append((job, future))
        return future

    def drop(self, future, job):
        self.dropped.append(job)

    def begin(self, place):
        assert self.jobs[place][1].set_running_or_notify_cancel()


@pytest.fixture
def made(monkeypatch):
    monkeypatch.setattr(renderers, "Pool", Pool)
    monkeypatch.setattr(renderers, "PATIENCE", 0.0)
    one = Renderers(Setup(Budget(1, 1)), 1)
    return one, one._pool


def test_beyond_the_bound_nobody_waits(made):
    desk, pool = made

    async def ask():
        waiting = [asyncio.ensure_future(desk.answer(Job("check", number))) for number in range(MOST_WAITING)]
        await asyncio.sleep(0)
        with pytest.raises(Refused) as refused:
            await desk.answer(Job("check", "another"))
        assert (refused.value.status_code, refused.value.headers) == (503, {"Retry-After": "2"})
        for _, future in pool.jobs:
            future.set_result(OK)
        assert await asyncio.gather(*waiting) == [OK] * MOST_WAITING
        assert desk.waiting == 0

    ended(ask())


def test_where_the_oldest_waits_for_long_nobody_is_put_behind_it(made, monkeypatch):
    desk, pool = made
    monkeypatch.setattr(renderers, "LONGEST", -1.0)

    async def ask():
        waiting = [asyncio.ensure_future(desk.answer(Job("check", number))) for number in range(3)]
        await asyncio.sleep(0)
        with pytest.raises(Refused):
            await desk.answer(Job("check", "another"))
        for _, future in pool.jobs:
            future.set_result(OK)
        await asyncio.gather(*waiting)

    ended(ask())


def test_a_newer_text_of_the_same_desk_takes_the_older_out_of_the_queue(made):
    desk, pool = made

    async def ask():
        older = asyncio.ensure_future(desk.answer(Job("page", 1), "one"))
        other = asyncio.ensure_future(desk.answer(Job("page", 2), "two"))
        await asyncio.sleep(0)
        newer = asyncio.ensure_future(desk.answer(Job("page", 3), "one"))
        assert (await older).status == 409
        assert pool.jobs[0][1].cancelled()
        for _, future in pool.jobs[1:]:
            future.set_result(OK)
        assert (await newer, await other) == (OK, OK)

    ended(ask())


def test_what_is_under_way_for_nobody_is_ended(made):
    desk, pool = made

    async def gone():
        await asyncio.sleep(0.01)

    async def ask():
        begun = asyncio.ensure_future(desk.answer(Job("page"), "", gone()))
        await asyncio.sleep(0)
        pool.begin(0)
        assert (await begun).status == 409
        await asyncio.sleep(0.01)
        assert pool.dropped == [pool.jobs[0][0]]
        assert desk.waiting == 0

    ended(ask())


def test_what_a_class_asks_alike_is_computed_once(made):
    desk, pool = made

    async def ask():
        one, other = (asyncio.ensure_future(desk.answer(Job("page", "a"), name)) for name in ("one", "two"))
        await asyncio.sleep(0)
        another = asyncio.ensure_future(desk.answer(Job("page", "b"), "one"))
        assert (await one).status == 409  # whoever leaves takes nothing from the others
        assert [job.body for job, _ in pool.jobs] == ["a", "b"]
        for _, future in pool.jobs:
            future.set_result(OK)
        assert await asyncio.gather(other, another) == [OK, OK]
        assert (await desk.answer(Job("page", "a")), len(pool.jobs), desk.waiting) == (OK, 2, 0)
        for number in range(KEPT):
            begun = asyncio.ensure_future(desk.answer(Job("page", number)))
            await asyncio.sleep(0)
            pool.jobs[-1][1].set_result(OK)
            await begun
        forgotten = asyncio.ensure_future(desk.answer(Job("page", "a")))
        await asyncio.sleep(0)
        assert len(pool.jobs) == KEPT + 3
        pool.jobs[-1][1].set_result(OK)
        await forgotten

    ended(ask())


def test_beside_a_folder_whose_tables_may_change_nothing_is_kept(made):
    pool = made[1]
    desk = Renderers(Setup(Budget(1, 1), folder="."), 1)
    desk._pool = pool

    async def ask():
        for number in (1, 2):
            begun = asyncio.ensure_future(desk.answer(Job("page", "a")))
            await asyncio.sleep(0)
            assert len(pool.jobs) == number
            pool.jobs[-1][1].set_result(OK)
            await begun

    ended(ask())


def test_what_is_quiet_is_ended_again_and_again_until_the_desk_closes(made, monkeypatch):
    one, pool = made
    rested: list[float] = []
    pool.rest = rested.append
    monkeypatch.setattr(renderers, "PACE", 0.0)

    async def some():
        resting = asyncio.ensure_future(one.rest())
        while len(rested) < 3:
            await asyncio.sleep(0)
            assert not resting.done()
        resting.cancel()

    ended(asyncio.wait_for(some(), 20))
    assert set(rested) == {renderers.QUIET}
