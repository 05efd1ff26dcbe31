"""The bodies of requests: limited in size and time, and checked for their keys and types.

Enters: a request.  Leaves: bytes, or the body as data.  Raises `Refused`.  Used by `application.py` and `files.py`.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Mapping
from typing import Any

from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request

from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MOST_BYTES, MOST_TABLE_BYTES = 10**6, 6 * 10**6
PATIENCE = 20.0  # s for a whole body
LINGER = 1.0  # s in which what is too much is read and thrown away: who is cut off while sending never hears why
TOO_LATE, TOO_LARGE, NO_JSON, OTHER_SHAPE = 408, 413, 400, 422
TEXT, TEXTS, NAMES, FLAG, NUMBER, PLACE = "text", "texts by name", "texts", "flag", "number", "two numbers"
OPTIONAL = {
    "language": TEXT, "scheme": TEXT, "step": TEXT, "tables": TEXTS, "name": TEXT, "study": FLAG, "free": FLAG,
}  # fmt: skip


class Refused(HTTPException):
    """The refusal of a request, with a status and a sentence."""

    def __init__(self, status: int, sentence: Sentence, headers: Mapping[str, str] | None = None) -> None:
        super().__init__(status, headers=headers)
        self.sentence = sentence


async def bytes_of(request: Request, most: int = MOST_BYTES) -> bytes:
    """Return the bytes of a body.  Raises `Refused` for more than `most` and for a body that takes too long."""
    length = request.headers.get("content-length", "")
    declared = int(length) if length.isdecimal() else 0
    content = bytearray()
    try:
        async with asyncio.timeout(LINGER if declared > most else PATIENCE) as limit:
            async for part in request.stream():
                if len(content) <= most < len(content) + len(part):
                    limit.reschedule(asyncio.get_running_loop().time() + LINGER)
                content += part if len(content) <= most else b""
    except (TimeoutError, ClientDisconnect):
        if max(declared, len(content)) <= most:
            raise Refused(TOO_LATE, say("desk.too_late")) from None
    if max(declared, len(content)) > most:
        raise Refused(TOO_LARGE, say("desk.too_large", most=most))
    return bytes(content)


async def json_of(request: Request, most: int = MOST_BYTES) -> Any:
    """Return a JSON body.  Raises `Refused`."""
    try:
        return json.loads(await bytes_of(request, most))
    except (ValueError, RecursionError):
        raise Refused(NO_JSON, say("desk.no_json")) from None


async def body_of(request: Request, needed: Mapping[str, str], most: int = MOST_BYTES) -> dict[str, Any]:
    """Return a JSON body with all keys in `needed`, perhaps keys in `OPTIONAL`, and no other keys.  Raises `Refused`."""
    body = await json_of(request, most)
    known = {**OPTIONAL, **needed}
    if not isinstance(body, dict):
        raise Refused(OTHER_SHAPE, say("desk.other_shape", wanted=tuple(needed)))
    for name in needed.keys() - body.keys() or body.keys() - known.keys():
        raise Refused(OTHER_SHAPE, say("desk.missing_key" if name in needed else "desk.unknown_key", name=name[:40]))
    for name, value in body.items():
        if not (value is None and name not in needed) and not _is(known[name], value):
            raise Refused(OTHER_SHAPE, say("desk.other_kind", name=name))
    return body


def _is(kind: str, value: Any) -> bool:
    if kind == TEXT:
        return isinstance(value, str) and _is_writable(value)
    if kind == TEXTS:
        return isinstance(value, dict) and all(_is(TEXT, part) for pair in value.items() for part in pair)
    if kind == NAMES:
        return isinstance(value, list) and all(_is(TEXT, part) for part in value)
    if kind == FLAG:
        return isinstance(value, bool)
    if kind == PLACE:
        return isinstance(value, list) and len(value) == 2 and all(_is(NUMBER, part) for part in value)
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e12


def _is_writable(text: str) -> bool:
    """Return whether a text has no lone surrogates, which JSON can contain but no file."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True
