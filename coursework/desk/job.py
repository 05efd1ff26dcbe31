"""What the server hands to the processes that compute, and what it gets back.

Enters: what a browser asked.  Leaves: records that travel as lines.  Used by `serving/` and `answering/`.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any

from coursework.system.frozen import frozen
from coursework.words.sentences import load_phrases, say

OK, FORBIDDEN, BUSY, FAULT = 200, 403, 503, 500
JSON = "application/json"


@dataclass(frozen=True, eq=False)
class Job:
    """One thing to be done: its `kind`, the `body` of the request (JSON), the language, whether the answer is compressed."""

    kind: str
    body: Any = field(default_factory=dict)
    language: str = "en"
    packed: bool = False


@frozen
class Answer:
    """What goes back to the browser; `name` of a file to be kept, `packed`: compressed."""

    status: int
    type: str
    body: bytes
    name: str = ""
    packed: bool = False


@frozen
class Bounds:
    """What one job may take: `seconds` of processor time, `memory` in MiB beyond the start."""

    seconds: float
    memory: float


@frozen
class Policy:
    """What a desk offers; an empty `formats` is every one, an empty `language` that of the browser."""

    equations: bool = True
    exact: bool = True
    formats: tuple[str, ...] = ()
    language: str = ""


@frozen
class Setup:
    """What each process knows: bounds, policy, and in `folder` where tables lie beside the text ("": nowhere)."""

    bounds: Bounds
    policy: Policy = field(default_factory=Policy)
    folder: str = ""


def plain(status: int, content: Any) -> Answer:
    """Return an answer of JSON."""
    return Answer(status, JSON, json.dumps(content, ensure_ascii=False, allow_nan=False).encode("utf-8", "replace"))


def told(status: int, language: str, key: str, /, **values: object) -> Answer:
    """Return a refusal in one sentence."""
    return plain(status, {"sentence": load_phrases(language).written(say(key, **values))})


def fault_entry(code: str, sentence: str, line: int = 0, column: int = 0, mend: Any = None) -> dict[str, Any]:
    """Return a fault as the browser shows it; what stands nowhere in the text has no line.

    >>> [(one["line"], one["column"]) for one in (fault_entry("", "", 3, 7), fault_entry("", "", 3), fault_entry("", ""))]
    [(3, 7), (3, 1), (None, None)]
    """
    return {
        "code": code, "line": line or None, "column": max(column, 1) if line else None, "sentence": sentence, "mend": mend,
    }  # fmt: skip


def faulty(kind: str, faults: list[dict[str, Any]], **more: Any) -> Answer:
    """Return the answer to a text with faults, and what `more` is known of it."""
    return plain(OK, {"faults": faults, "summary": None, **({"page": None} if kind == "page" else {}), **more})
