"""A desk in this process, asked as a browser asks it: all but its sockets and the processes that compute is the real thing."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from starlette.testclient import TestClient

from coursework.desk.answering import bench
from coursework.desk.job import Answer, Job, Policy, Setup
from coursework.desk.serving.application import Application, Wish
from coursework.desk.serving.config import opened
from coursework.desk.serving.guard import Gate
from coursework.desk.serving.limits import Limits
from coursework.system.processes.budget import Budget

PORT, SECRET = 8531, "s" * 43
HOST = f"127.0.0.1:{PORT}"
COOKIE = f"coursework-desk-{PORT}"
VARIANTS = Path(__file__).parents[2] / "variants"
TEXT = (VARIANTS / "31.toml").read_text(encoding="utf-8")


class Here:
    """In the place of `Renderers`: the same jobs, done by this process."""

    ended = waiting = 0

    def __init__(self, setup: Setup) -> None:
        self.setup, self.jobs = setup, list[Job]()

    def warm(self) -> None: ...

    async def rest(self) -> None: ...

    def close(self) -> None: ...

    async def answer(self, job: Job, desk: str = "", gone: Any = None) -> Answer:
        if gone is not None:
            gone.close()
        self.jobs.append(job)
        return bench.answer(job, self.setup)


@contextlib.contextmanager
def desk(folder: Path | None = None, *, name: str = "", policy: Policy | None = None, **gate: Any) -> Iterator[TestClient]:
    """A desk over a folder, or one that is open to others, and a browser that has opened it."""
    secret = SECRET if folder else ""
    with contextlib.ExitStack() as stack:
        before, bench.watched = bench.watched, lambda *_: contextlib.nullcontext()  # signals arrive in the main thread alone
        stack.callback(setattr, bench, "watched", before)
        wish = Wish(PORT, Budget(60, 1024), policy or Policy(), name, folder)
        application = Application(wish, Gate(PORT, secret, limits=None if folder else Limits(), **gate), opened(name, folder))
        application.renderers = Here(Setup(wish.bounds, wish.policy, str(folder or "")))
        client = stack.enter_context(TestClient(application.asgi(), f"http://{HOST}", follow_redirects=False))
        if folder:
            client.cookies.set(COOKIE, SECRET)
        yield client


def ended(work: Coroutine[Any, Any, Any]) -> Any:
    """Return what work comes to, done in a thread of its own: a browser of the suite may have its loop running in this one."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(asyncio.run, work).result()
