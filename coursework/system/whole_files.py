"""Whole files or none: written beside their place, then put there in one move.

Enters: bytes and a path.  Leaves: the file.  Raises `OutputError`; nothing half-written is left.
Used by whoever writes a file; files that belong together go through `file_set.py`.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO

from coursework.words.errors import Fault, OutputError, reason_of
from coursework.words.sentences import say

_BEGUN = ".coursework-"
_FAULTS = {
    errno.ENOSPC: "fault.W001", errno.EDQUOT: "fault.W002", errno.EROFS: "fault.W004", errno.EISDIR: "fault.W006",
    errno.ENAMETOOLONG: "fault.W007", **dict.fromkeys((errno.EACCES, errno.EPERM), "fault.W003"),
    **dict.fromkeys((errno.ENOTDIR, errno.EEXIST), "fault.W005"),
}  # fmt: skip


@contextmanager
def refused(target: Path) -> Iterator[None]:
    """Turn what the system refuses while `target` is written into an `OutputError` that names it."""
    try:
        yield
    except OSError as error:
        if key := _FAULTS.get(error.errno or 0):
            raise OutputError([Fault(say(key), str(target))]) from error
        raise OutputError([Fault(say("fault.W008", reason=reason_of(error)), str(target))]) from error
    except ValueError as error:  # a name that no file can have: a zero byte in it
        raise OutputError([Fault(say("fault.W009", reason=str(error)), str(target))]) from error


def wrong_ending(path: Path, endings: str) -> OutputError:
    """Return the fault of a name that does not end as a file of its kind does."""
    return OutputError([Fault(say("fault.W011", endings=endings, found=path.suffix or "–"), str(path))])


def write_bytes(path: Path | str, content: bytes) -> None:
    """Write a whole file; folders on the way are made.  Raises `OutputError`, leaving what was there before."""
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
    """Remove what a process that was killed had begun to write into a folder, which nobody else writes into now."""
    for left in folder.rglob(f"{_BEGUN}*.part"):
        left.unlink(missing_ok=True)


def take_lock(file: IO[bytes], at: int = 0) -> None:
    """Take a lock, on Windows of one byte, that ends with the process.  Raises `BlockingIOError` where another process has it."""
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
    """Write a new file down to the disk.  Raises `OSError`."""
    with path.open("xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
