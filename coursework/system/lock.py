"""A folder that one process writes into at a time.

Enters: a folder.  Leaves: nothing; while it is held a hidden file in the folder has the number of the process.
Raises `OutputError` where another process holds it.  Used by `commands/grade.py`.
The lock is the system's and ends with the process, whatever ends that; a file left behind locks nothing.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from coursework.system.whole_files import clear_leftovers, refused
from coursework.words.errors import Fault, OutputError
from coursework.words.sentences import say

NAME = ".coursework.lock"
_FAR = 2**30  # Windows locks bytes; this one is beyond what is read


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Hold a folder while something is written into it.  Raises `OutputError` where another process does."""
    path = folder / NAME
    refuse_link(path)
    with refused(path):
        file = _opened(path)
    try:
        file.seek(0)
        file.truncate()
        file.write(str(os.getpid()).encode("ascii"))
        clear_leftovers(folder)
        yield
    finally:
        with suppress(OSError):  # Windows removes no open file
            path.unlink()
        file.close()


def refuse_link(path: Path) -> None:
    """Raise `OutputError` where a path is a link: what is written there would go elsewhere."""
    if path.is_symlink():
        raise OutputError([Fault(say("fault.W017"), str(path))])


def _opened(path: Path) -> IO[bytes]:
    """Return the locked file.  The one before may have removed it between the opening and the locking: then there is another."""
    while True:
        file = path.open("a+b", buffering=0)
        if not _locked(file):
            file.seek(0)
            holder = file.read(20).decode("ascii", errors="replace").strip()
            file.close()
            raise OutputError([Fault(say("fault.W018", process=holder or "?"), str(path.parent))])
        with suppress(OSError):
            if os.path.samestat(os.fstat(file.fileno()), path.stat()):
                return file
        file.close()


if sys.platform == "win32":
    import msvcrt

    def _locked(file: IO[bytes]) -> bool:
        file.seek(_FAR)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

else:
    import fcntl

    def _locked(file: IO[bytes]) -> bool:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True
