"""The desk as a web application: its routes, and the jobs that they send to the processes that compute.

Enters: a `Plan`.  Leaves: an ASGI application.  Used by `server.py`.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from dataclasses import field
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
from coursework.desk.serving.files import Files
from coursework.desk.serving.guard import Gate, Guard, new_cookie
from coursework.desk.serving.library import Library
from coursework.desk.serving.metrics import Metrics
from coursework.desk.serving.renderers import Renderers
from coursework.desk.serving.replies import language_of, refusal, reply
from coursework.system.budget import Budget
from coursework.system.frozen import frozen
from coursework.words.errors import OutputError

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
class Plan:
    """The settings of one desk: who has access (`gate`), its `folder` (None: no files), the `opened` file, its language."""

    gate: Gate
    bounds: Budget
    workers: int
    folder: Path | None = None
    opened: Mapping[str, Any] = field(default_factory=dict)
    policy: Policy = field(default_factory=Policy)
    language: str = ""


class Application:
    """The routes of a desk and the state that they share."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.metrics = plan, Metrics()
        self.files = Files(plan.folder) if plan.folder else None
        self.renderers = Renderers(Setup(plan.bounds, plan.policy, str(plan.folder or "")), plan.workers)

    def asgi(self) -> Guard:
        """Return the ASGI application that the server runs."""
        routes = [
            Route("/", self.shell), Route("/desk/frame", self.frame), Route("/desk/{name:path}", assets.file),
            Route("/health", self.health), Route("/metrics", self.told_metrics),
            Route("/api/take/{format}", self.computed, methods=["POST"]),
            *(Route(f"/api/{kind}", self.computed, methods=["POST"]) for kind in COMPUTED if kind != "take"),
            *Library(self.answer).routes(), *(self.files.routes() if self.files else ()),
        ]  # fmt: skip
        handlers: dict[Any, Any] = dict.fromkeys((HTTPException, OutputError, Exception), refusal)
        return Guard(Starlette(routes=routes, exception_handlers=handlers, lifespan=self.life), self.plan.gate)

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
        plan, root = self.plan, self.plan.gate.root
        language = language_of(request, plan.policy.language, plan.language)
        config = await asyncio.to_thread(config_of, language, root, plan.policy, self.files, plan.opened)
        page = assets.shell(root, config, language=language, languages=config["languages"], words=config["words"])
        if not plan.gate.secret and not request.scope["state"]["client"]:
            new_cookie(page, plan.gate, secure=request.headers.get("x-forwarded-proto") == "https" and plan.gate.proxied)
        return page

    async def frame(self, request: Request) -> Response:
        """Return the page into which the report is put."""
        return assets.frame(self.plan.gate.root, language_of(request, self.plan.policy.language, self.plan.language))

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
        language = language_of(request, body.get("language"), self.plan.policy.language or self.plan.language)
        packed = self.plan.folder is None and "gzip" in request.headers.get("accept-encoding", "")
        desk = request.headers.get("x-desk", "")[:60]
        named = f"{request.scope['state']['client']} {kind} {desk}" if desk else ""
        return await self.renderers.answer(Job(kind, body, language, packed), named, _left(request))


async def _left(request: Request) -> None:
    """Wait until the browser disconnects."""
    while (await request.receive())["type"] != "http.disconnect":
        pass
