"""The responses to a browser and their language; an exception becomes a status and one sentence.

Enters: an `Answer`, or a request, perhaps with an exception.  Leaves: a response; a language that has a words file.
Used by `guard.py` and the routes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from urllib.parse import quote

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

from coursework.desk.job import FAULT, Answer, plain
from coursework.desk.serving.bodies import Refused
from coursework.words.errors import CourseworkError
from coursework.words.sentences import ENGLISH, load_phrases, say
from coursework.words.sentences import languages as known_languages

NOT_WRITTEN = 507
_CLOSED = {408, 413}  # the connection is closed, because the rest of such a body is not read


@cache
def languages() -> tuple[str, ...]:
    """Return the languages that have a words file, English first."""
    return tuple(sorted(known_languages(), key=lambda language: language != ENGLISH))


def language_of(request: Request, wanted: object = None, before: str = "") -> str:
    """Return the first known of these languages: `wanted`, that in the address, `before`, those of the browser, English."""
    accepted = re.findall(r"[a-z]{2}", request.headers.get("accept-language", "").lower())[:20]
    asked = (wanted, request.query_params.get("language"), before, *accepted)
    return next((language for language in asked if isinstance(language, str) and language in languages()), ENGLISH)


def reply(answer: Answer, headers: Mapping[str, str] | None = None) -> Response:
    """Return the response that carries an answer."""
    response = Response(answer.body, answer.status, headers, answer.type)
    if answer.packed:
        response.headers["Content-Encoding"] = "gzip"
    if answer.name:
        response.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(answer.name)}"
    return response


async def refusal(request: Request, error: Exception) -> Response:
    """Return the response for an error: a status and one sentence."""
    written = load_phrases(language_of(request)).written
    if isinstance(error, CourseworkError):
        # The error's own sentence advises an option that the desk does not have.
        return reply(plain(NOT_WRITTEN, {"sentence": written(say("desk.no_room"))}))
    if not isinstance(error, HTTPException):
        return reply(plain(FAULT, {"sentence": written(say("desk.our_fault"))}))
    sentence = error.sentence if isinstance(error, Refused) else say("desk.no_route")
    headers = {**(error.headers or {}), **({"Connection": "close"} if error.status_code in _CLOSED else {})}
    return reply(plain(error.status_code, {"sentence": written(sentence)}), headers)
