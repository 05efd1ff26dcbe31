"""What has been graded already, by content: the next run continues here, however the last one ended.

Enters: outcomes as they come.  Leaves: `journal.jsonl` in OUT, one flushed line each.  Used by the batch only.
Memory holds places in the file, not grades: a university's journal is larger than the memory of a laptop.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import IO, Any

from coursework.system.files.whole_files import refused
from coursework.system.frozen import frozen
from coursework.system.processes.plain_lines import line_of, read_line
from coursework.words.errors import Fault, OutputError
from coursework.words.sentences import say

NAME = "journal.jsonl"
_DIGITS = 32
AGAIN = ("timeout", "crashed-grader")  # graded again in the next run: a fault of ours or of the machine may be gone by then


@frozen
class Entry:
    """One graded submission: the key to its content, its grade as grades.json writes it, the hash of its page or ""."""

    key: str
    id: str
    grade: dict[str, Any]
    page: str = ""


@frozen
class _Line:
    """One line of the file: the entry as text, and its checksum."""

    sum: str
    entry: str


def _written(entry: Entry) -> bytes:
    text = line_of(entry).decode("ascii").rstrip("\n")
    return line_of(_Line(_sum_of(text), text))


def _sum_of(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:_DIGITS]


def _read(line: bytes) -> Entry | None:
    """Return the entry of a line; None if the line is torn, damaged, or not written by this program."""
    try:
        found = read_line(_Line, line)
        return read_line(Entry, found.entry.encode()) if found.sum == _sum_of(found.entry) else None
    except ValueError:
        return None


class Journal:
    """The journal of one OUT folder; a context manager that holds the file open."""

    _file: IO[bytes]

    def __init__(self, folder: Path) -> None:
        self.path = folder / NAME

    def __enter__(self) -> Journal:
        """Open the file.  Raises `OutputError` if the name belongs to a link, a folder or a pipe instead of a file."""
        if self.path.is_symlink() or (self.path.exists() and not self.path.is_file()):
            raise OutputError([Fault(say("fault.W016"), str(self.path))])
        with refused(self.path):
            self._file = self.path.open("a+b", buffering=0)
        end = self._file.seek(0, 2)
        if end:
            self._file.seek(end - 1)
            if self._file.read(1) != b"\n":
                self._file.write(b"\n")
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def places(self) -> tuple[dict[str, int], dict[str, int]]:
        """Return the places of finished work by key, and of the last grade by id; torn lines are skipped."""
        by_key: dict[str, int] = {}
        by_id: dict[str, int] = {}
        place = self._file.seek(0)
        for line in self._file:
            entry = _read(line)
            if entry is not None:
                by_id[entry.id] = place
                if entry.grade.get("status") not in AGAIN:
                    by_key[entry.key] = place
            place += len(line)
        return by_key, by_id

    def read(self, place: int) -> Entry:
        """Return the entry at a place.  Raises `RuntimeError` if its line was changed meanwhile."""
        entry = _read(self._line(place))
        if entry is None:
            raise RuntimeError(f"{self.path}: the line at {place} was changed while the class was graded")
        return entry

    def _line(self, place: int) -> bytes:
        self._file.seek(place)
        return self._file.readline()

    def add(self, entry: Entry) -> int:
        """Append one entry without buffering, so that it is there even if the program ends now; return its place."""
        line = _written(entry)
        with refused(self.path):
            left = line  # written in one piece at the end of the file, wherever that is now; on a full disk only its beginning
            while left:
                left = left[self._file.write(left) :]
        return self._file.tell() - len(line)

    def rewrite(self, places: Iterable[int]) -> None:
        """Keep only the entries at `places`, in that order, so that the file does not grow from run to run.

        Raises `OutputError` if there is no room for it; the journal is then as it was.
        """
        part = self.path.with_name(f".{NAME}.part")
        with refused(self.path):
            try:
                with part.open("wb") as file:
                    for place in places:
                        file.write(self._line(place))
                self._file.close()
                part.replace(self.path)
            except BaseException:
                part.unlink(missing_ok=True)
                raise
