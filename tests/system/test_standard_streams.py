"""What a stream that can no longer be written to says, and what it keeps to itself; in what encoding one is written to."""

from __future__ import annotations

import errno
import io
import os
import sys
from typing import Any

import pytest

from coursework.system.standard_streams import Spoken, patient_streams


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


def test_streams_are_written_to_in_utf_8_where_they_have_an_encoding(monkeypatch: Any) -> None:
    """That of the system may lack Greek; a stream that somebody put there may have none, and a window has no streams."""
    plain, own = io.BytesIO(), io.StringIO()
    for out, written in ((io.TextIOWrapper(plain, encoding="ascii"), plain), (own, own)):
        monkeypatch.setattr(sys, "stdout", out)
        monkeypatch.setattr(sys, "stderr", None)
        with patient_streams() as spoken:
            assert sys.stderr is None
            print("ω = \ud800", flush=True)
        assert spoken is not None and not spoken.lost
        assert written.getvalue() == ("ω = ?\n".encode() if written is plain else "ω = \ud800\n")
