"""Hundreds of broken files: no crash, no hang, no file opened for writing; 100 000 with `fuzz_readers`."""

from __future__ import annotations

import pytest

from tests.grading.reading.fuzz_readers import OPENED, REPEATED, run, run_repeated
from tests.sample import first

CASES = 140


def test_hundreds_of_broken_files() -> None:
    counts = run(CASES)
    assert counts.total() == CASES
    assert counts["table"] > CASES / 4
    assert len(counts) >= 8


@pytest.mark.parametrize("size", first(1, (2**13, 2**15, 2**20)))
def test_files_of_one_piece_repeated(size: int) -> None:
    assert run_repeated(size).total() == 2 * len(REPEATED)


def test_what_begins_again_and_again_and_never_ends() -> None:
    assert run_repeated(2**15, OPENED).total() == 2 * len(OPENED)
