"""What a student handed in, before any file is interpreted.

Enters: nothing.  Leaves: `Submission`, `SubmittedFile`, `Note`; plain data that may cross to another process.
Used by every part of this room.
"""

from __future__ import annotations

import hashlib
from dataclasses import field

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


@frozen
class Note:
    """A remark of the reader that costs no marks; `code` is one of the note codes of grades.json."""

    code: str
    text: Sentence

    def plain(self) -> dict[str, str]:
        """Return the note as grades.json writes it."""
        return {"code": self.code, "text": self.text}


def note(code: str, key: str = "", /, **values: object) -> Note:
    """Return a note; its sentence has the key `reading.note.<key or code>`."""
    return Note(code, say(f"reading.note.{key or code}", **values))


@frozen
class SubmittedFile:
    """One file as handed in: `name` is for people only (never a path to write to), `content` its bytes, `sha256` their hash.

    `trouble` says why the content is missing or cut off (locked, too large); such a file is listed but not read.
    `size` is the number of bytes of the whole file.
    """

    name: str
    content: bytes = field(repr=False)
    size: int
    trouble: Sentence | None = None
    sha256: str = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "sha256", hashlib.sha256(self.content).hexdigest())


def submitted_file(name: str, content: bytes, trouble: Sentence | None = None, size: int | None = None) -> SubmittedFile:
    """Return the record of a file with its content; `size` is needed only if the content is not the whole file."""
    return SubmittedFile(name, content, len(content) if size is None else size, trouble)


@frozen
class Submission:
    """All files of one student; `id` is kept verbatim (in NFC), `name` is as the platform or roster gives it.

    `review` says why a person must look first (two submissions without a time, two ids that are the same), None if not needed.
    """

    id: str
    name: str | None
    files: tuple[SubmittedFile, ...]
    notes: tuple[Note, ...] = ()
    review: Sentence | None = None
