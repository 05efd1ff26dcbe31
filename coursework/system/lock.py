"""A folder that one process writes into at a time.

Enters: a folder.  Leaves: nothing; while it is held a hidden file in the folder has the number of the process.
Raises `OutputError` where another process holds it.  Used by `commands/grade.py` and the desk.
The lock is the system's and ends with the process, whatever ends that; a file left behind locks nothing.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from coursework.system.whole_files import clear_leftovers, refused, take_lock
from coursework.words.errors import Fault, OutputError
from coursework.words.sentences import say

NAME = ".coursework.lock"
_PACE = 0.02  # s between two tries
_FAR = 2**30  # Windows locks bytes; this one is beyond what is read


@contextmanager
def held(folder: Path, patience: float = 0.0, *, own: bool = True) -> Iterator[None]:
    """Hold a folder while something is written into it.  Raises `OutputError` where another process does for `patience` s.

    A folder of our `own`, into which nobody else writes, is cleared of what a process that was killed had begun.
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
        with suppress(OSError):  # Windows removes no open file
            path.unlink()
        file.close()


def refuse_link(path: Path) -> None:
    """Raise `OutputError` where a path is a link: what is written there would go elsewhere."""
    if path.is_symlink():
        raise OutputError([Fault(say("fault.W017"), str(path))])


def _opened(path: Path, until: float) -> IO[bytes]:
    """Return the locked file.  The one before may have removed it between the opening and the locking: then there is another."""
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
