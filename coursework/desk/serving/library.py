"""The routes that help to begin a text: the catalogue, the text of a variant, the words and pieces for a text.

Enters: requests.  Leaves: answers computed once per language, and files of the package.  Used by `application.py`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from coursework.desk.job import OK, Answer, plain
from coursework.desk.serving.bodies import Refused
from coursework.desk.serving.folder import NOT_THERE, SUFFIX, tables_named
from coursework.desk.serving.replies import language_of, reply
from coursework.variant.catalogue import names
from coursework.words.data_folders import folder
from coursework.words.sentences import say

KINDS = ("catalogue", "keys", "pieces")
KEPT = {"Cache-Control": "private, max-age=600"}


class Library:
    """The routes whose answers are the same for everybody; `answer` computes the answer to a request."""

    def __init__(self, answer: Callable[[Request, str, dict[str, Any]], Awaitable[Answer]]) -> None:
        self._answer = answer
        self._kept: dict[tuple[str, str, bool], Answer] = {}

    def routes(self) -> list[Route]:
        """Return the routes."""
        one = "/api/variant/{name}"
        made = [Route(f"/api/{kind}", self.made_once) for kind in KINDS]
        return [*made, Route(one, self.text), Route(f"{one}/tables", self.tables)]

    async def made_once(self, request: Request) -> Response:
        """Return an answer that is computed for the first request in a language and kept for all others."""
        kind = request.url.path.rpartition("/")[2]
        asked = (kind, language_of(request), "gzip" in request.headers.get("accept-encoding", ""))
        answer = self._kept.get(asked) or await self._answer(request, kind, {})
        if answer.status == OK:
            self._kept[asked] = answer
        return reply(answer, KEPT if answer.status == OK else None)

    async def text(self, request: Request) -> Response:
        """Return the text of a variant of the catalogue."""
        return Response(await asyncio.to_thread(_text, request.path_params["name"]), media_type="text/plain", headers=KEPT)

    async def tables(self, request: Request) -> Response:
        """Return the tables that a variant of the catalogue reads, by name."""
        text = await asyncio.to_thread(_text, request.path_params["name"])
        read = {name: (folder("variants") / name).read_text(encoding="utf-8") for name in tables_named(text)}
        return reply(plain(OK, read), KEPT)


def _text(name: str) -> bytes:
    if name.lower() not in names():
        raise Refused(NOT_THERE, say("desk.no_file", name=name[:60]))
    return (folder("variants") / f"{name.lower()}{SUFFIX}").read_bytes()
