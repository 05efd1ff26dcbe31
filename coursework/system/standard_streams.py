"""Standard output whose reader may leave, and a disk behind it that may be full.

Enters and leaves: the streams of the process, for the time of one command.  Used by `program.py`.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO


class Spoken:
    """A text stream that goes on where nothing can be written any more: what is said after that is dropped.

    `lost` then says why, unless the reader simply left (`head`, a pager), which is nobody's fault.
    """

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self.lost = ""

    def write(self, text: str) -> int:
        """Write text; return its length."""
        try:
            return self._stream.write(text)
        except OSError as error:
            self._give_up(error)
            return len(text)

    def flush(self) -> None:
        """Pass on what was written."""
        try:
            self._stream.flush()
        except OSError as error:
            self._give_up(error)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def _give_up(self, error: OSError) -> None:
        """Lead the stream to nowhere, so that neither the next line nor the end of the process stumbles over it again."""
        with suppress(OSError, ValueError):
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, self._stream.fileno())
            os.close(nowhere)
        # Windows says EINVAL of a pipe whose reader has gone.
        if not isinstance(error, BrokenPipeError) and not (os.name == "nt" and error.errno == errno.EINVAL):
            reason = "the disk is full" if error.errno == errno.ENOSPC else error.strerror
            self.lost = f"standard output could not be written: {reason}. Lead it elsewhere."


@contextmanager
def patient_streams() -> Iterator[Spoken | None]:
    """Let the process speak UTF-8 to readers that may leave; yields standard output, None where the process has none."""
    before = sys.stdout, sys.stderr
    for stream in before:
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors="replace")
    spoken = [Spoken(stream) if stream is not None else None for stream in before]
    sys.stdout, sys.stderr = spoken
    try:
        yield spoken[0]
    finally:
        sys.stdout, sys.stderr = before
