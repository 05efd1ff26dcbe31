"""Whole files or none: written beside their place, then put there in one move.

Enters: bytes and a path.  Leaves: the file.  Raises `OutputError`; nothing half-written is left.
Used by whoever writes a file; files that belong together go through `file_set.py`.
"""

from __future__ import annotations

import errno
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from coursework.errors import OutputError

_ADVICE = {
    errno.ENOSPC: "the disk is full. Free some space, or choose another folder with --out.",
    errno.EDQUOT: "your share of the disk is used up. Free some space, or choose another folder with --out.",
    errno.EACCES: "the folder or file is not writable. Close it in other programs, or choose another folder with --out.",
    errno.EPERM: "the folder or file is not writable. Close it in other programs, or choose another folder with --out.",
    errno.EROFS: "the disk is read-only. Choose another folder with --out.",
    errno.ENOTDIR: "a part of the path is a file, not a folder. Choose another folder with --out.",
    errno.EEXIST: "a part of the path is a file, not a folder. Choose another folder with --out.",
    errno.EISDIR: "there is a folder of this name. Remove it, or choose another folder with --out.",
    errno.ENAMETOOLONG: "the name is too long. Choose a shorter one.",
}


@contextmanager
def refused(target: Path) -> Iterator[None]:
    """Turn what the system refuses while `target` is written into an `OutputError` that names it."""
    try:
        yield
    except OSError as error:
        advice = _ADVICE.get(error.errno or 0, f"{error.strerror or error}. Choose another folder with --out.")
        raise OutputError(f"{target}: could not be written: {advice}") from error
    except ValueError as error:  # a name that no file can have: a zero byte in it
        raise OutputError(f"{str(target)!r}: could not be written: {error}. Choose another name.") from error


def write_bytes(path: Path | str, content: bytes) -> None:
    """Write a whole file; folders on the way are made.  Raises `OutputError`, leaving what was there before."""
    target = Path(path)
    part = target.with_name(f".coursework-{secrets.token_hex(6)}.part")
    with refused(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            write_through(part, content)
            part.replace(target)
        except BaseException:
            part.unlink(missing_ok=True)
            raise


def write_through(path: Path, content: bytes) -> None:
    """Write a new file down to the disk.  Raises `OSError`."""
    with path.open("xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
