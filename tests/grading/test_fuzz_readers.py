"""Two thousand broken files: no crash, nothing slow, no file opened for writing; 100 000 with `fuzz_readers`."""

from __future__ import annotations

from tests.grading.fuzz_readers import run


def test_two_thousand_broken_files() -> None:
    counts = run(2000)
    assert counts.total() == 2000
    assert counts["table"] > 500
    assert len(counts) > 10
