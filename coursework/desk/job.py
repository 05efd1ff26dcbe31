"""The records that the server sends to the processes that compute, and those that it gets back.

Enters: the request of a browser.  Leaves: records that are sent as lines.  Used by `serving/` and `answering/`.
"""

from __future__ import annotations

import json
import sys
import traceback
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from coursework.system.frozen import frozen
from coursework.system.processes.budget import Budget
from coursework.words.sentences import load_phrases, say

OK, FORBIDDEN, BUSY, FAULT = 200, 403, 503, 500
JSON = "application/json"


@dataclass(frozen=True, eq=False)
class Job:
    """One task: its `kind`, the `body` of the request (JSON), the language, whether the answer is to be compressed (`packed`)."""

    kind: str
    body: Any = field(default_factory=dict)
    language: str = "en"
    packed: bool = False


@frozen
class Answer:
    """The answer for the browser; `name` of a file to be downloaded, "" for none; `packed`: the body is compressed."""

    status: int
    type: str
    body: bytes
    name: str = ""
    packed: bool = False


@frozen
class Policy:
    """What a desk offers; empty `formats` mean all formats, an empty `language` means that of the browser."""

    equations: bool = True
    exact: bool = True
    formats: tuple[str, ...] = ()
    language: str = ""


@frozen
class Setup:
    """The settings of each process: the `bounds` of one job, policy, and the `folder` with the tables of a text ("" for none)."""

    bounds: Budget
    policy: Policy = field(default_factory=Policy)
    folder: str = ""


def plain(status: int, content: Any) -> Answer:
    """Return an answer with `content` as JSON."""
    return Answer(status, JSON, json.dumps(content, ensure_ascii=False, allow_nan=False).encode("utf-8", "replace"))


def told(status: int, language: str, key: str, /, **values: object) -> Answer:
    """Return an answer of one sentence, such as a refusal; `key` and `values` name the sentence and fill its gaps."""
    return plain(status, {"sentence": load_phrases(language).written(say(key, **values))})


def fault_entry(code: str, sentence: str, line: int = 0, column: int = 0, mend: Any = None) -> dict[str, Any]:
    """Return a fault as the browser shows it; a fault without a place in the text (`line` 0) has no line.

    >>> [(one["line"], one["column"]) for one in (fault_entry("", "", 3, 7), fault_entry("", "", 3), fault_entry("", ""))]
    [(3, 7), (3, 1), (None, None)]
    """
    return {
        "code": code, "line": line or None, "column": max(column, 1) if line else None, "sentence": sentence, "mend": mend,
    }  # fmt: skip


def tell_place(error: Exception) -> None:
    """Tell the log the kind and the place of an error, but nothing of the text, which its own message may quote."""
    place = traceback.extract_tb(error.__traceback__)[-1]
    sys.stderr.write(f"{type(error).__name__} in {Path(place.filename).name}:{place.lineno}\n")


def faulty(kind: str, faults: list[dict[str, Any]], **more: Any) -> Answer:
    """Return the answer to a text with faults; `more` are further entries of it."""
    return plain(OK, {"faults": faults, "summary": None, **({"page": None} if kind == "page" else {}), **more})
