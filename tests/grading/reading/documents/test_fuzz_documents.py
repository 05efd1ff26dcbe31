"""Hundreds of spoilt documents: no crash, no hang, no file opened for writing; 100 000 with `fuzz_documents`."""

from __future__ import annotations

from tests.grading.reading.documents.fuzz_documents import run


def test_spoilt_documents() -> None:
    counts = run(245) + run(5, with_pdf=True)
    assert counts.total() == 250
    assert counts["table"] > 60
    assert len(counts) >= 8
