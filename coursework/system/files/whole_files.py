"""Whole files or none: written under a temporary name in the same folder, then renamed in one step.

Enters: bytes and a path.  Leaves: the file.  Raises `OutputError`; no half-written file is left.
Used by every module that writes a single file; files that belong together go through `file_set.py`.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO

from coursework.words.errors import Fault, OutputError
from coursework.words.reasons import reason_of
from coursework.words.sentences import say

_BEGUN = ".coursework-"
_FAULTS = {
    errno.ENOSPC: "fault.W001", errno.EDQUOT: "fault.W002", errno.EROFS: "fault.W004", errno.EISDIR: "fault.W006",
    errno.ENAMETOOLONG: "fault.W007", **dict.fromkeys((errno.EACCES, errno.EPERM), "fault.W003"),
    **dict.fromkeys((errno.ENOTDIR, errno.EEXIST), "fault.W005"),
}  # fmt: skip


@contextmanager
def refused(target: Path) -> Iterator[None]:
    """Turn an error of the operating system while `target` is written into an `OutputError` that names it."""
    try:
        yield
    except OSError as error:
        if key := _FAULTS.get(error.errno or 0):
            raise OutputError([Fault(say(key), str(target))]) from error
        raise OutputError([Fault(say("fault.W008", reason=reason_of(error)), str(target))]) from error
    except ValueError as error:  # an impossible file name, for instance with a zero byte
        raise OutputError([Fault(say("fault.W009", reason=str(error)), str(target))]) from error


def free_name(stem: str, taken: set[str]) -> str:
    """Return a name that is not taken and add it, without its case, as some systems do not distinguish A and a.

    >>> taken = {"a", "b"}
    >>> free_name("A", taken), sorted(taken)
    ('A-2', ['a', 'a-2', 'b'])
    """
    name, number = stem, 2
    while name.casefold() in taken:
        name, number = f"{stem}-{number}", number + 1
    taken.add(name.casefold())
    return name


def wrong_ending(path: Path, endings: str) -> OutputError:
    """Return the error for a file name whose ending does not suit its format."""
    return OutputError([Fault(say("fault.W011", endings=endings, found=path.suffix or "–"), str(path))])


def write_bytes(path: Path | str, content: bytes) -> None:
    """Write a whole file and make missing folders.  Raises `OutputError`; the old file is then still there."""
    target = Path(path)
    with refused(target):
        if not target.name:  # "." or "/"
            raise IsADirectoryError(errno.EISDIR, "")
        part = target.with_name(f"{_BEGUN}{os.urandom(6).hex()}.part")
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            write_through(part, content)
            part.replace(target)
        except BaseException:
            part.unlink(missing_ok=True)
            raise


def clear_leftovers(folder: Path) -> None:
    """Remove the unfinished files that a killed process left in a folder; nobody else may be writing into it now."""
    for left in folder.rglob(f"{_BEGUN}*.part"):
        left.unlink(missing_ok=True)


def take_lock(file: IO[bytes], at: int = 0) -> None:
    """Lock a file (on Windows its byte `at`) until the process ends.  Raises `BlockingIOError` if another process holds it."""
    if sys.platform == "win32":
        import msvcrt

        file.seek(at)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        except OSError as error:
            raise BlockingIOError from error
    else:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def write_through(path: Path, content: bytes) -> None:
    """Write a new file and force it to the disk.  Raises `OSError`."""
    with path.open("xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
