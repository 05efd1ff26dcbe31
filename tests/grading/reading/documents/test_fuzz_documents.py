"""Hundreds of spoilt documents: no crash, no hang, no file opened for writing; 100 000 with `fuzz_documents`."""

from __future__ import annotations

import pytest

from tests.grading.reading.documents.fuzz_documents import run
from tests.sample import first


@pytest.mark.parametrize("count", first(1, (130, 250)))
def test_spoilt_documents(count: int) -> None:
    counts = run(count - count // 40) + run(count // 40, with_pdf=True)
    assert counts.total() == count
    assert counts["table"] > 0.24 * count
    assert len(counts) >= 8
