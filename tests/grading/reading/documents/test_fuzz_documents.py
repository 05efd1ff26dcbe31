"""Five hundred spoilt documents: no crash, no hang, no file opened for writing; 100 000 with `fuzz_documents`."""

from __future__ import annotations

from tests.grading.reading.documents.fuzz_documents import run


def test_spoilt_documents() -> None:
    counts = run(490) + run(10, with_pdf=True)
    assert counts.total() == 500
    assert counts["table"] > 125
    assert len(counts) >= 8
