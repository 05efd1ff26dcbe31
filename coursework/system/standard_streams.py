"""Standard output that survives a reader who leaves and a full disk.

Enters: the streams of the process.  Leaves: the same streams, guarded for the time of one command.  Used by `program.py`.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO


class Spoken:
    """A text stream that goes on after a failed write; later text is dropped.

    `lost` then gives the reason, but stays empty if the reader simply left (`head`, a pager), which is nobody's fault.
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
        """Flush the text written so far."""
        try:
            self._stream.flush()
        except OSError as error:
            self._give_up(error)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def _give_up(self, error: OSError) -> None:
        """Redirect the stream to the null device, so that neither the next line nor the end of the process fails again."""
        with suppress(OSError, ValueError):
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, self._stream.fileno())
            os.close(nowhere)
        # Windows reports EINVAL for a pipe whose reader has gone.
        if not isinstance(error, BrokenPipeError) and not (os.name == "nt" and error.errno == errno.EINVAL):
            reason = "the disk is full" if error.errno == errno.ENOSPC else error.strerror
            self.lost = f"standard output could not be written: {reason}. Lead it elsewhere."


@contextmanager
def patient_streams() -> Iterator[Spoken | None]:
    """Make the standard streams write UTF-8 and survive a reader who leaves; yield standard output, None if there is none."""
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
