"""Reports of a whole class in one process: what one leaves behind."""

from __future__ import annotations

import gc
import sys

import coursework
from coursework.report import build_model, render_html

WARM, MEASURED = 2, 4  # reports
LEFT = 400  # blocks of memory that a report may leave behind: the formulas of its first step stay set, up to a fixed number


def _page(number: int) -> tuple[object, str]:
    run = coursework.solve(coursework.load("31").with_data(given={"r1": 0.953 + number / 5000}), student=f"Student {number}")
    model = build_model(run, live=True)
    return model, render_html(model)


def _blocks() -> int:
    gc.collect()
    return sys.getallocatedblocks()


def test_reports_of_a_class_leave_nothing_behind() -> None:
    for number in range(WARM):
        _page(number)
    before = _blocks()
    for number in range(WARM, WARM + MEASURED):
        _page(number)
    assert _blocks() - before < LEFT * MEASURED
    kept = _page(20)  # what a leak would look like
    assert _blocks() - before > 2 * LEFT * MEASURED
    assert kept
