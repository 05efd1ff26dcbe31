"""Files of a folder, each read once: regular files only, no link followed, never waiting for a pipe.

Enters: a path, how many bytes may still be read.  Leaves: `SubmittedFile`s and notes; what was read is what is hashed.
Used by `sources.py`.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from pathlib import Path

from coursework.grading.platforms.names import legible
from coursework.grading.reading.files.kinds import is_ignored, is_named_as_table
from coursework.grading.reading.limits import FILE_BYTES
from coursework.grading.reading.submission import Note, SubmittedFile, note, submitted_file
from coursework.words.sentences import say

HEAD = 4096  # bytes kept of a file that is too large, enough to tell what it is
_DEPTH = 6
_FLAGS = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC", "O_BINARY"))


def files_below(folder: Path) -> Iterator[tuple[str, Path | Note]]:
    """Give what stands in a folder, in the order of names: paths of what may be a file, notes for what is left aside."""
    yield from _walk(folder, "", _DEPTH)


def _walk(folder: Path, before: str, depth: int) -> Iterator[tuple[str, Path | Note]]:
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError as error:
        yield before, note("ignored_file", name=legible(before or folder.name), why=error.strerror or str(error))
        return
    for entry in entries:
        name = before + entry.name  # as the disk has it, which may be no text
        if is_ignored(entry.name):
            continue
        if entry.is_symlink():
            yield name, note("ignored_file", name=legible(name), why=say("reading.why.link"))
        elif entry.is_dir(follow_symlinks=False):
            if depth > 1 and not is_named_as_table(entry.name):
                yield from _walk(folder / entry.name, f"{name}/", depth - 1)
            else:
                yield name, note("ignored_file", name=legible(name), why=say("reading.why.folder"))
        else:
            yield name, folder / entry.name


def read_regular(path: Path, name: str, left: int) -> SubmittedFile | Note:
    """Return a file's bytes, at most 4 MB and `left`; a note for what is no regular file of its own."""
    try:
        handle = os.open(path, _FLAGS)
    except OSError as error:
        return submitted_file(name, b"", say("reading.trouble.locked", why=error.strerror or str(error)))
    with os.fdopen(handle, "rb") as file:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            return note("ignored_file", name=name, why=say("reading.why.not_regular"))
        if status.st_nlink > 1:
            return note("ignored_file", name=name, why=say("reading.why.hard_link"))
        try:
            # A file may grow while it is read; one byte more than allowed is enough to know.
            content = b"" if status.st_size > FILE_BYTES else file.read(min(FILE_BYTES, left) + 1)
            if status.st_size > FILE_BYTES or len(content) > min(FILE_BYTES, left):
                head = content[:HEAD] or file.read(HEAD)
                return too_large(name, head, max(status.st_size, len(content)))
        except OSError as error:
            return submitted_file(name, b"", say("reading.trouble.locked", why=error.strerror or str(error)))
    return submitted_file(name, content)


def too_large(name: str, head: bytes, size: int) -> SubmittedFile:
    """Return the record of a file of which only the beginning was kept."""
    return submitted_file(name, head, say("reading.trouble.too_large", limit=FILE_BYTES // 2**20), size)
