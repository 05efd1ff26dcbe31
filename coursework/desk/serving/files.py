"""The routes of files, for a desk on the user's machine; the browser is told when other programs change the folder.

Enters: requests.  Leaves: the text of a variant and its version, or written files.  Used by `application.py`.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from pathlib import Path

from starlette.requests import Request
from starlette.responses import Response, StreamingResponse
from starlette.routing import Route
from watchfiles import awatch

from coursework.desk.job import OK, Answer, plain
from coursework.desk.serving.bodies import MOST_TABLE_BYTES, OTHER_SHAPE, Refused, bytes_of, json_of
from coursework.desk.serving.folder import CONFLICT, SUFFIX, Folder, Stale, etag_of
from coursework.desk.serving.replies import language_of, reply
from coursework.desk.serving.zips import packed, unpacked
from coursework.words.sentences import load_phrases, say

ALIVE = 15_000  # ms without a change after which a browser is told that the connection is alive
_SETTLED = 100  # ms within which changes are reported together


async def events(folder: Folder) -> AsyncIterator[str]:
    """Yield the list of files at once, and again after each change, as server-sent events."""
    yield "retry: 1000\n\n"
    told = ""
    watching = awatch(
        folder.path, watch_filter=lambda _, path: path.endswith((SUFFIX, ".csv")), debounce=_SETTLED, step=_SETTLED // 2,
        rust_timeout=ALIVE, yield_on_timeout=True, recursive=False,
    )  # fmt: skip
    change = None
    try:
        while True:
            change = asyncio.ensure_future(anext(watching))
            await asyncio.sleep(0)  # from here on no change is missed
            files = json.dumps(await asyncio.to_thread(folder.listed))
            yield ":\n\n" if files == told else f"event: files\ndata: {files}\n\n"
            told = files
            await change
    finally:
        if change is not None:
            change.cancel()


NEW, NO_VERSION, NO_CONTENT = 201, 428, 204
TEXT = "text/plain; charset=utf-8"


class Files:
    """The routes for the files of a folder."""

    def __init__(self, path: Path) -> None:
        self.folder = Folder(path)
        self.folder.clear()

    def routes(self) -> list[Route]:
        """Return the routes."""
        one = "/api/file/{name}"
        return [
            Route("/api/files", self.listed), Route("/api/events", self.changes), Route("/api/zip", self.packed),
            Route("/api/zip", self.unpacked, methods=["POST"]), Route(one, self.read), Route(one, self.write, methods=["PUT"]),
            Route(one, self.delete, methods=["DELETE"]), Route(one, self.change, methods=["POST"]),
        ]  # fmt: skip

    async def listed(self, request: Request) -> Response:
        """Return the variants of the folder."""
        return reply(plain(OK, await asyncio.to_thread(self.folder.listed)))

    async def changes(self, request: Request) -> Response:
        """Return a stream of the changes in the folder, which lasts as long as the browser listens."""
        return StreamingResponse(events(self.folder), media_type="text/event-stream")

    async def packed(self, request: Request) -> Response:
        """Return all variants with their tables as one zip."""
        content = await asyncio.to_thread(packed, self.folder)
        return reply(Answer(OK, "application/zip", content, f"{self.folder.path.name or 'work'}.zip"))

    async def unpacked(self, request: Request) -> Response:
        """Write the files of a zip that are not yet in the folder."""
        content = await bytes_of(request, MOST_TABLE_BYTES)
        words = load_phrases(language_of(request))
        return reply(plain(OK, await asyncio.to_thread(unpacked, self.folder, content, words)))

    async def read(self, request: Request) -> Response:
        """Return the text of a variant with its version."""
        content = await asyncio.to_thread(self.folder.present, request.path_params["name"])
        return Response(content, media_type=TEXT, headers={"ETag": etag_of(content)})

    async def write(self, request: Request) -> Response:
        """Write a text in place of the version that the browser has seen, or as a new file."""
        content = await bytes_of(request)
        is_new = await asyncio.to_thread(self.folder.write, request.path_params["name"], content, _seen(request))
        version = etag_of(content)
        return reply(plain(NEW if is_new else OK, {"etag": version}), {"ETag": version})

    async def delete(self, request: Request) -> Response:
        """Move a file to the deleted ones, from which it can be restored."""
        await asyncio.to_thread(self.folder.delete, request.path_params["name"], _seen(request) or "")
        return Response(status_code=NO_CONTENT)

    async def change(self, request: Request) -> Response:
        """Rename a file, write a copy of it, or restore it."""
        wish = await json_of(request)
        name = request.path_params["name"]
        match wish:
            case {"rename": str(other)}:
                await asyncio.to_thread(self.folder.rename, name, other)
            case {"duplicate": str(other)}:
                await asyncio.to_thread(self.folder.duplicate, name, other)
            case {"restore": True}:
                await asyncio.to_thread(self.folder.restore, name)
            case _:
                raise Refused(OTHER_SHAPE, say("desk.other_shape", wanted=("rename", "duplicate", "restore")))
        return Response(status_code=NO_CONTENT)


def _seen(request: Request) -> str | None:
    """Return the version that a change replaces, None for a new file.  Raises `Refused` if the request says neither."""
    if version := request.headers.get("if-match"):
        return version.removeprefix("W/")
    if request.headers.get("if-none-match", "").strip() == "*":
        return None
    raise Refused(NO_VERSION, say("desk.no_version"))


async def conflict(request: Request, stale: Stale) -> Response:
    """Return the response for a file that has changed since the browser saw it: both contents, if the browser sent one."""
    mine, theirs = stale.mine if request.method == "PUT" else b"", stale.theirs
    shown = None if theirs is None else theirs.decode("utf-8", "replace")
    there = None if theirs is None else etag_of(theirs)
    return reply(plain(CONFLICT, {"mine": mine.decode("utf-8", "replace"), "theirs": shown, "etag": there}))
