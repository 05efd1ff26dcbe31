"""What is raised on the way to an answer -> the answer: a status and one sentence.

Enters: a request and an exception.  Leaves: a response.  Used by `application.py`.
"""

from __future__ import annotations

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

from coursework.desk.job import plain
from coursework.desk.serving.bodies import Refused
from coursework.desk.serving.replies import language_of, reply
from coursework.words.errors import CourseworkError
from coursework.words.sentences import load_phrases, say

NOT_WRITTEN = 507
_CLOSED = {408, 413}  # what is still coming of such a body nobody reads


async def refusal(request: Request, error: Exception) -> Response:
    """Return what is told of a request that cannot be answered."""
    written = load_phrases(language_of(request)).written
    if isinstance(error, CourseworkError):
        return reply(plain(NOT_WRITTEN, {"sentence": " ".join(fault.said(written) for fault in error.faults)}))
    assert isinstance(error, HTTPException)
    sentence = error.sentence if isinstance(error, Refused) else say("desk.no_route")
    headers = {**(error.headers or {}), **({"Connection": "close"} if error.status_code in _CLOSED else {})}
    return reply(plain(error.status_code, {"sentence": written(sentence)}), headers)
