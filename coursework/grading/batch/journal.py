"""What has been graded already, by content: the next run continues here, whatever ended the last one.

Enters: outcomes as they come.  Leaves: `journal.jsonl` in OUT, one flushed line each.  Used by the batch only.
Memory holds places in the file, not grades: a university's journal is larger than a laptop's memory.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType
from typing import IO, Any

from coursework.system.frozen import frozen
from coursework.system.plain_lines import line_of, read_line
from coursework.system.whole_files import refused
from coursework.words.errors import Fault, OutputError
from coursework.words.sentences import say

NAME = "journal.jsonl"
_DIGITS = 32
AGAIN = ("timeout", "crashed-grader")  # a fault of ours or of the machine may be gone by the next run


@frozen
class Entry:
    """One graded submission: the content it is known by, its grade as grades.json says it, the hash of its page or ""."""

    key: str
    id: str
    grade: dict[str, Any]
    page: str = ""


@frozen
class _Line:
    """One line: the entry as text, and the check sum by which it is believed."""

    sum: str
    entry: str


def _written(entry: Entry) -> bytes:
    text = line_of(entry).decode("ascii").rstrip("\n")
    return line_of(_Line(_sum_of(text), text))


def _sum_of(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:_DIGITS]


def _read(line: bytes) -> Entry | None:
    """Return the entry of a line, None for one that is torn, damaged, or was written by somebody else."""
    try:
        found = read_line(_Line, line)
        return read_line(Entry, found.entry.encode()) if found.sum == _sum_of(found.entry) else None
    except ValueError:
        return None


class Journal:
    """The journal of one OUT folder; a context manager that holds the file open."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / NAME
        self._file: IO[bytes] | None = None

    def __enter__(self) -> Journal:
        """Open the file.  Raises `OutputError` for what is no file of its own in OUT: a link, a folder, a pipe."""
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

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        if self._file is not None:
            self._file.close()

    def places(self) -> tuple[dict[str, int], dict[str, int]]:
        """Return where each work (by key) and the last grade of each id stand; torn lines are dropped."""
        file = self._open()
        by_key: dict[str, int] = {}
        by_id: dict[str, int] = {}
        place = file.seek(0)
        for line in file:
            entry = _read(line)
            if entry is not None:
                by_id[entry.id] = place
                if entry.grade.get("status") not in AGAIN:
                    by_key[entry.key] = place
            place += len(line)
        return by_key, by_id

    def read(self, place: int) -> Entry:
        """Return the entry that stands at a place."""
        file = self._open()
        file.seek(place)
        entry = _read(file.readline())
        if entry is None:
            raise RuntimeError(f"{self.path}: the line at {place} was changed while the class was graded")
        return entry

    def add(self, entry: Entry) -> int:
        """Write one entry so that it is there even if the power goes now; return its place."""
        file = self._open()
        line = _written(entry)
        with refused(self.path):
            file.write(line)  # at the end of the file, wherever that is now, in one piece
        return file.tell() - len(line)

    def rewrite(self, places: Iterable[int]) -> None:
        """Keep the entries of this run only, in the order given, so that the file does not grow from run to run."""
        part = self.path.with_name(f".{NAME}.part")
        with part.open("wb") as file:
            for place in places:
                file.write(_written(self.read(place)))
        self._open().close()
        part.replace(self.path)

    def _open(self) -> IO[bytes]:
        assert self._file is not None
        return self._file
