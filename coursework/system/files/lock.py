"""A lock on a folder, so that only one process writes into it at a time.

Enters: a folder.  Leaves: nothing; while the lock is held, a hidden file in the folder contains the number of the process.
Raises `OutputError` if another process holds it.  Used by `commands/grade.py` and the desk.
The operating system releases the lock when the process ends, for whatever reason; a file left behind locks nothing.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from coursework.system.files.whole_files import clear_leftovers, refused, take_lock
from coursework.words.errors import Fault, OutputError
from coursework.words.sentences import say

NAME = ".coursework.lock"
_PACE = 0.02  # s between two tries
_FAR = 2**30  # Windows locks single bytes; this offset is beyond the bytes that are read


@contextmanager
def held(folder: Path, patience: float = 0.0, *, own: bool = True) -> Iterator[None]:
    """Hold the lock of a folder while writing into it.  Raises `OutputError` if it cannot be had within `patience` s.

    If the folder is our `own`, so that nobody else writes into it, files that a killed process left unfinished are removed.
    """
    path = folder / NAME
    refuse_link(path)
    with refused(path):
        file = _opened(path, time.monotonic() + patience)
    try:
        file.seek(0)
        file.truncate()
        file.write(str(os.getpid()).encode("ascii"))
        if own:
            clear_leftovers(folder)
        yield
    finally:
        with suppress(OSError):  # Windows does not remove an open file
            path.unlink()
        file.close()


def refuse_link(path: Path) -> None:
    """Raise `OutputError` if `path` is a symbolic link: the text would be written elsewhere."""
    if path.is_symlink():
        raise OutputError([Fault(say("fault.W017"), str(path))])


def _opened(path: Path, until: float) -> IO[bytes]:
    """Return the locked file.  Try again if its last holder removed it between our opening and our locking it."""
    while True:
        file = path.open("a+b", buffering=0)
        try:
            take_lock(file, _FAR)
        except BlockingIOError:
            if time.monotonic() < until:
                file.close()
                time.sleep(_PACE)
                continue
            file.seek(0)
            holder = file.read(20).decode("ascii", errors="replace").strip()
            file.close()
            raise OutputError([Fault(say("fault.W018", process=holder or "?"), str(path.parent))]) from None
        with suppress(OSError):
            if os.path.samestat(os.fstat(file.fileno()), path.stat()):
                return file
        file.close()
