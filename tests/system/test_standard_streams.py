"""What a stream that can no longer be written to says, and what it keeps to itself."""

from __future__ import annotations

import errno
import io
import os
from typing import Any

import pytest

from coursework.system.standard_streams import Spoken


class Refusing(io.StringIO):
    """A stream that takes nothing more."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.error = OSError(number, os.strerror(number))

    def write(self, _: str) -> int:
        raise self.error


@pytest.mark.parametrize(
    ("number", "system", "lost"),
    [
        (errno.EPIPE, "posix", ""), (errno.EPIPE, "nt", ""), (errno.EINVAL, "nt", ""),
        (errno.EINVAL, "posix", os.strerror(errno.EINVAL)), (errno.ENOSPC, "nt", "the disk is full"),
    ],
)  # fmt: skip
def test_a_reader_that_has_gone_is_no_fault_and_all_else_is(number: int, system: str, lost: str, monkeypatch: Any) -> None:
    spoken = Spoken(Refusing(number))
    monkeypatch.setattr(os, "name", system)
    assert spoken.write("text") == 4
    assert lost in (spoken.lost or "")
    assert bool(spoken.lost) is bool(lost)
