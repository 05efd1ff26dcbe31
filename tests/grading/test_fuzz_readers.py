"""Two thousand broken files: no crash, no hang, no file opened for writing; 100 000 with `fuzz_readers`."""

from __future__ import annotations

from tests.grading.fuzz_readers import REPEATED, run, run_repeated


def test_two_thousand_broken_files() -> None:
    counts = run(2000)
    assert counts.total() == 2000
    assert counts["table"] > 500
    assert len(counts) >= 8


def test_files_of_one_piece_repeated() -> None:
    assert run_repeated(2**20).total() == 2 * len(REPEATED)
