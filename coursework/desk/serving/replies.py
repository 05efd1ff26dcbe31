"""What goes back to a browser, and in which language.

Enters: an `Answer`, or a request.  Leaves: a response; a language that has a words file.
Used by `guard.py` and the routes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from urllib.parse import quote

from starlette.requests import Request
from starlette.responses import Response

from coursework.desk.job import Answer
from coursework.words.data_folders import REPORTS, folder
from coursework.words.sentences import ENGLISH


@cache
def languages() -> tuple[str, ...]:
    """Return the languages that have a words file, English first."""
    found = (path.name.split(".")[1] for path in folder(REPORTS).glob("words.*.toml"))
    return tuple(sorted(found, key=lambda language: (language != ENGLISH, language)))


def language_of(request: Request, wanted: object = None, before: str = "") -> str:
    """Return the language that is `wanted` of a request, or asked for in its address, or that of the desk, or of the browser."""
    accepted = re.findall(r"[a-z]{2}", request.headers.get("accept-language", "").lower())[:20]
    asked = (wanted, request.query_params.get("language"), before, *accepted)
    return next((language for language in asked if isinstance(language, str) and language in languages()), ENGLISH)


def reply(answer: Answer, headers: Mapping[str, str] | None = None) -> Response:
    """Return the response that an answer goes back with."""
    response = Response(answer.body, answer.status, headers, answer.type)
    if answer.packed:
        response.headers["Content-Encoding"] = "gzip"
    if answer.name:
        response.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(answer.name)}"
    return response
