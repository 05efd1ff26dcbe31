"""The files of the folder in which the desk was opened: variants by name, each written completely, none outside.

Enters: names, bytes, the version last seen.  Leaves: bytes and versions.  Raises `Stale`, `Refused`, `OutputError`.
Used by `files.py`.
"""

from __future__ import annotations

import hashlib
import os
import time
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from coursework.desk.inside import is_name, read_inside, refused_name
from coursework.desk.serving.bodies import MOST_BYTES, TOO_LARGE, Refused
from coursework.system.files.lock import held, refuse_link
from coursework.system.files.whole_files import refused, write_bytes
from coursework.system.frozen import frozen
from coursework.words.data_folders import folder as folder_of_reports
from coursework.words.reasons import reason_of
from coursework.words.sentences import say

SUFFIX = ".toml"
DELETED = ".deleted"
NOT_THERE, NO_NAME, NOT_READ, CONFLICT = 404, 403, 403, 409
PATIENCE = 5.0  # s to wait for another desk that is writing into the folder
LEFT_OVER = 60.0  # s after which an unfinished file counts as left over by a killed process
MOST_FILES = 2000


class Stale(Exception):
    """The error for a file that has changed since it was seen: `theirs` is its content now, None if there is no such file.

    `mine` is the content that was to be written in its place.
    """

    def __init__(self, theirs: bytes | None, mine: bytes) -> None:
        super().__init__()
        self.theirs, self.mine = theirs, mine


def etag_of(content: bytes) -> str:
    """Return the version of a file: its SHA-256 in quotes."""
    return f'"{hashlib.sha256(content).hexdigest()}"'


@frozen
class Folder:
    """One folder, by its absolute path."""

    path: Path

    def is_writable(self) -> bool:
        """Return whether files can be written here."""
        return os.access(self.path, os.W_OK)

    def read(self, name: str, below: str = "") -> bytes | None:
        """Return the bytes of NAME.toml, None if there is none.  Raises `Refused` if it may or can not be read."""
        if not is_name(name):
            raise Refused(NO_NAME, refused_name(name))
        try:
            content = read_inside(self.path / below if below else self.path, name + SUFFIX, MOST_BYTES)
        except OSError as error:
            raise Refused(NOT_READ, say("desk.not_read", name=name + SUFFIX, reason=reason_of(error))) from error
        if content is not None and len(content) > MOST_BYTES:
            raise Refused(TOO_LARGE, say("desk.too_large", most=MOST_BYTES))
        return content

    def listed(self) -> list[dict[str, Any]]:
        """Return names and versions of the variants, and of deleted ones that can be restored."""
        return [*self._listed(""), *self._listed(DELETED)]

    def write(self, name: str, content: bytes, seen: str | None) -> bool:
        """Write a file if its version is still `seen` (None: there is no such file); return whether it is new."""
        with self._at_rest(name, seen, content):
            write_bytes(self._file(name), content)
            self._lay_tables_beside(content)
        return seen is None

    def delete(self, name: str, seen: str) -> None:
        """Move a file to the deleted ones, from which it can be restored."""
        with self._at_rest(name, seen):
            place = self.path / DELETED
            refuse_link(place)
            with refused(place):
                place.mkdir(exist_ok=True)
                self._file(name).replace(place / (name + SUFFIX))

    def restore(self, name: str) -> None:
        """Restore a deleted file.  Raises `Stale` if another file has its name now."""
        with self._at_rest(name, None):
            self.present(name, DELETED)
            with refused(self._file(name)):
                (self.path / DELETED / (name + SUFFIX)).replace(self._file(name))

    def rename(self, name: str, other: str) -> None:
        """Rename a file.  Raises `Stale` if there is a file with the other name."""
        content = self.present(name)
        self.write(other, content, None)
        with self._at_rest(name, etag_of(content)), refused(self._file(name)):
            self._file(name).unlink()

    def duplicate(self, name: str, other: str) -> None:
        """Write a copy of a file.  Raises `Stale` if there is a file with the other name."""
        self.write(other, self.present(name), None)

    def clear(self) -> None:
        """Remove unfinished files that a killed process has left here."""
        for left in self.path.glob(".coursework-*.part"):
            if time.time() - left.lstat().st_mtime > LEFT_OVER:
                left.unlink(missing_ok=True)

    def present(self, name: str, below: str = "") -> bytes:
        """Return the bytes of NAME.toml.  Raises `Refused` if there is none."""
        content = self.read(name, below)
        if content is None:
            raise Refused(NOT_THERE, say("desk.no_file", name=name))
        return content

    def _file(self, name: str) -> Path:
        return self.path / (name + SUFFIX)

    @contextmanager
    def _at_rest(self, name: str, seen: str | None, mine: bytes = b"") -> Iterator[None]:
        """Lock the folder while a file still has the version `seen`.  Raises `Stale` if it has another."""
        self.read(name)
        with held(self.path, PATIENCE, own=False):
            there = self.read(name)
            if (None if there is None else etag_of(there)) != seen:
                raise Stale(there, mine)
            yield

    def _listed(self, below: str) -> Iterator[dict[str, Any]]:
        place = self.path / below if below else self.path
        for path in sorted(place.glob(f"*{SUFFIX}"))[:MOST_FILES]:
            if not is_name(path.stem):
                continue
            content = None
            with suppress(OSError):  # another program may hold it, or it is a link to itself
                content = read_inside(place, path.name, MOST_BYTES)
            if content is not None and len(content) <= MOST_BYTES:
                yield {"name": path.stem, "etag": etag_of(content), "bytes": len(content), "deleted": bool(below)}

    def _lay_tables_beside(self, content: bytes) -> None:
        """Copy tables of the catalogue that a text names and the folder lacks, because `run` reads them from the folder."""
        for name in tables_named(content):
            source = read_inside(folder_of_reports("variants"), name, MOST_BYTES)
            if source is not None and not (self.path / name).exists():
                write_bytes(self.path / name, source)


def tables_named(content: bytes) -> list[str]:
    """Return the files of tables that a text names; empty if it is not TOML."""
    try:
        data = tomllib.loads(content.decode("utf-8"))
    except (ValueError, RecursionError):
        return []
    laws = [law for section in ("drive", "functions") for law in _entries(data.get(section))]
    return [str(law["table"]) for law in laws if isinstance(law, dict) and isinstance(law.get("table"), str)]


def _entries(section: Any) -> list[Any]:
    return list(section.values()) if isinstance(section, dict) else []
