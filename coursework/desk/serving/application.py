"""The desk as a web application: its routes, and the jobs that they send to the processes that compute.

Enters: a `Wish`.  Leaves: an ASGI application.  Used by `server.py`.
"""

from __future__ import annotations

import asyncio
import os
import time
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route

from coursework.desk.job import Answer, Job, Policy, Setup
from coursework.desk.serving import assets
from coursework.desk.serving.bodies import MOST_BYTES, MOST_TABLE_BYTES, NAMES, PLACE, TEXT, body_of
from coursework.desk.serving.config import config_of
from coursework.desk.serving.files import Files, conflict
from coursework.desk.serving.folder import Stale
from coursework.desk.serving.guard import Gate, Guard, new_cookie
from coursework.desk.serving.library import Library
from coursework.desk.serving.metrics import Metrics
from coursework.desk.serving.renderers import Renderers
from coursework.desk.serving.replies import language_of, refusal, reply
from coursework.system.frozen import frozen
from coursework.system.processes.budget import Budget
from coursework.words.errors import OutputError

MOST_WORKERS = 4
# The kinds of job that a browser may ask for, with the keys that the body of each must have.
COMPUTED: dict[str, dict[str, str]] = {
    "page": {"text": TEXT},
    "check": {"text": TEXT},
    "table": {"text": TEXT, "name": TEXT, "data": TEXT},
    "take": {"text": TEXT},
    "equations": {"text": TEXT},
    "piece": {"text": TEXT, "kind": TEXT, "on": NAMES},
    "drag": {"text": TEXT, "joint": TEXT, "place": PLACE},
}


@frozen
class Wish:
    """The options of the command line; `host` "" means only this machine, `folder` None a desk without files."""

    port: int
    bounds: Budget
    policy: Policy
    name: str = ""
    folder: Path | None = None
    host: str = ""
    workers: int | None = None
    root_path: str = ""
    proxied: bool = False
    hosts: tuple[str, ...] = ()
    language: str = ""
    browser: bool = False


class Application:
    """The routes of a desk and the state that they share; `gate` says who has access, `opened` is the file at the start."""

    def __init__(self, wish: Wish, gate: Gate, opened: Mapping[str, Any]) -> None:
        self.wish, self.gate, self.opened, self.metrics = wish, gate, opened, Metrics()
        self.files = Files(wish.folder) if wish.folder else None
        workers = wish.workers or min(os.cpu_count() or 1, MOST_WORKERS)
        self.renderers = Renderers(Setup(wish.bounds, wish.policy, str(wish.folder or "")), workers)

    def asgi(self) -> Guard:
        """Return the ASGI application that the server runs."""
        routes = [
            Route("/", self.shell), Route("/desk/frame", self.frame), Route("/desk/{name:path}", assets.file),
            Route("/health", self.health), Route("/metrics", self.told_metrics),
            Route("/api/take/{format}", self.computed, methods=["POST"]),
            *(Route(f"/api/{kind}", self.computed, methods=["POST"]) for kind in COMPUTED if kind != "take"),
            *Library(self.answer).routes(), *(self.files.routes() if self.files else ()),
        ]  # fmt: skip
        handlers: dict[Any, Any] = dict.fromkeys((HTTPException, OutputError, Exception), refusal) | {Stale: conflict}
        return Guard(Starlette(routes=routes, exception_handlers=handlers, lifespan=self.life), self.gate)

    @asynccontextmanager
    async def life(self, _app: Starlette) -> AsyncIterator[None]:
        """Start a process before the first request, and end all processes at the end."""
        self.renderers.warm()
        resting = asyncio.create_task(self.renderers.rest())
        try:
            yield
        finally:
            resting.cancel()
            await asyncio.to_thread(self.renderers.close)

    async def shell(self, request: Request) -> Response:
        """Return the page of the desk."""
        wish, gate, root = self.wish, self.gate, self.gate.root
        language = language_of(request, wish.policy.language, wish.language)
        config = await asyncio.to_thread(config_of, language, root, wish.policy, self.files, self.opened)
        page = assets.shell(root, config, language=language, languages=config["languages"], words=config["words"])
        if not gate.secret and not request.scope["state"]["client"]:
            new_cookie(page, gate, secure=request.headers.get("x-forwarded-proto") == "https" and gate.proxied)
        return page

    async def frame(self, request: Request) -> Response:
        """Return the page into which the report is put."""
        return assets.frame(self.gate.root, language_of(request, self.wish.policy.language, self.wish.language))

    async def health(self, request: Request) -> Response:
        """Return a sign that the server answers."""
        return PlainTextResponse("ok\n")

    async def told_metrics(self, request: Request) -> Response:
        """Return the metrics of the server."""
        return PlainTextResponse(self.metrics.text(self.renderers.ended, self.renderers.waiting))

    async def computed(self, request: Request) -> Response:
        """Return the result of a job, computed by a process."""
        begun, wanted = time.monotonic(), request.path_params.get("format")
        kind = "take" if wanted else request.url.path.rpartition("/")[2]
        body = await body_of(request, COMPUTED[kind], MOST_TABLE_BYTES if kind == "table" else MOST_BYTES)
        if wanted:
            body["format"] = wanted
        answer = await self.answer(request, kind, body)
        self.metrics.count(kind, answer.status, time.monotonic() - begun)
        return reply(answer, {"Retry-After": "1"} if answer.status == 503 else None)

    async def answer(self, request: Request, kind: str, body: Any) -> Answer:
        """Return the answer of a process to a job; waiting ends if the browser disconnects."""
        language = language_of(request, body.get("language"), self.wish.policy.language or self.wish.language)
        packed = self.wish.folder is None and "gzip" in request.headers.get("accept-encoding", "")
        desk = request.headers.get("x-desk", "")[:60]
        named = f"{request.scope['state']['client']} {kind} {desk}" if desk else ""
        return await self.renderers.answer(Job(kind, body, language, packed), named, _left(request))


async def _left(request: Request) -> None:
    """Wait until the browser disconnects."""
    while (await request.receive())["type"] != "http.disconnect":
        pass
