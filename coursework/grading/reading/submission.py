"""What a student handed in, before anybody has looked inside.

Enters: nothing.  Leaves: `Submission`, `SubmittedFile`, `Note`; plain data that may cross to another process.
Used by every part of this room.
"""

from __future__ import annotations

import base64
import hashlib
from dataclasses import dataclass, field
from typing import Any

from coursework.words.sentence import Sentence
from coursework.words.sentences import say

KINDS = ("table", "equations", "answers", "variant", "attachment", "ignored")


@dataclass(frozen=True, slots=True)
class Note:
    """Something the reader noticed and that costs no marks; `code` is one of grades.json's codes."""

    code: str
    text: Sentence

    def plain(self) -> dict[str, str]:
        """Return the note as grades.json writes it."""
        return {"code": self.code, "text": self.text}


def note(code: str, key: str = "", /, **values: object) -> Note:
    """Return a note; its sentence is `reading.note.<key or code>`."""
    return Note(code, say(f"reading.note.{key or code}", **values))


@dataclass(frozen=True, slots=True)
class SubmittedFile:
    """One file as it was handed in: `name` for people only (never a path to write to), `content` read once, its hash.

    `trouble` says why the content is not there or only its beginning (locked, too large); such a file is listed, not read.
    `size` is the number of bytes of the whole file.
    """

    name: str
    content: bytes = field(repr=False)
    sha256: str
    size: int
    trouble: Sentence | None = None


def submitted_file(name: str, content: bytes, trouble: Sentence | None = None, size: int | None = None) -> SubmittedFile:
    """Return the record of a file whose bytes were just read."""
    return SubmittedFile(name, content, hashlib.sha256(content).hexdigest(), len(content) if size is None else size, trouble)


@dataclass(frozen=True, slots=True)
class Submission:
    """All files of one student; `id` verbatim (NFC), `name` as the platform or roster says it.

    `review` is why a person must look before anything counts (two submissions without a time, two ids that are one).
    """

    id: str
    name: str | None
    files: tuple[SubmittedFile, ...]
    notes: tuple[Note, ...] = ()
    review: Sentence | None = None

    def plain(self) -> dict[str, Any]:
        """Return the submission as JSON can carry it to another process."""
        return {
            "id": self.id,
            "name": self.name,
            "files": [
                {
                    "name": file.name,
                    "content": base64.b64encode(file.content).decode("ascii"),
                    "trouble": _said(file.trouble),
                    "size": file.size,
                }
                for file in self.files
            ],
            "notes": [{"code": entry.code, "text": _said(entry.text)} for entry in self.notes],
            "review": _said(self.review),
        }


def submission_from(plain: dict[str, Any]) -> Submission:
    """Return the submission that `plain()` wrote."""
    return Submission(
        plain["id"],
        plain["name"],
        tuple(
            submitted_file(file["name"], base64.b64decode(file["content"]), _sentence(file["trouble"]), file["size"])
            for file in plain["files"]
        ),
        tuple(Note(entry["code"], _sentence(entry["text"]) or say("none")) for entry in plain["notes"]),
        _sentence(plain["review"]),
    )


def _said(sentence: Sentence | None) -> dict[str, Any] | None:
    if sentence is None:
        return None
    return {"key": sentence.key, "values": {name: _carried(value) for name, value in sentence.values.items()}}


def _carried(value: object) -> Any:
    if isinstance(value, tuple):
        return [_carried(part) for part in value]
    return _said(value) if isinstance(value, Sentence) else value


def _sentence(plain: dict[str, Any] | None) -> Sentence | None:
    return None if plain is None else say(plain["key"], **{name: _value(found) for name, found in plain["values"].items()})


def _value(plain: Any) -> Any:
    if isinstance(plain, list):
        return tuple(map(_value, plain))
    return _sentence(plain) if isinstance(plain, dict) else plain
