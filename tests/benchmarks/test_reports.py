"""Reports of a whole class in one process: what one leaves behind."""

from __future__ import annotations

import gc
import sys
import time

import coursework
from coursework.report.pages import build_model, render_html
from coursework.report.pages.pdf import paper_of

WARM, MEASURED = 2, 4  # reports
LEFT = 1100  # blocks of memory that a report may leave: its formulas and sentences stay set, up to a fixed number; 900 measured


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
    kept = [_page(20 + number) for number in range(MEASURED)]  # what a leak would look like
    assert _blocks() - before > 2 * LEFT * MEASURED
    assert kept


def _printed(page: dict[str, object]) -> float:
    """Return the processor time (s) of one PDF."""
    begun = time.process_time_ns()
    paper_of([page])
    return (time.process_time_ns() - begun) / 1e9


def test_typst_takes_over_a_report_for_the_next_and_keeps_it_no_longer() -> None:
    pages = [build_model(coursework.solve("31", student=f"Student {n}", quantities=["table", "plots"])).plain() for n in range(3)]
    _printed(pages[0])
    kept = min(_printed(pages[0]) for _ in range(3))
    for page in pages[1:]:
        _printed(page | {"sections": page["sections"][::-1]})  # nothing of the first stands where it stood
    anew = _printed(pages[0])
    assert anew > 2 * kept
    assert min(_printed(page) for page in pages[1:]) < 0.6 * anew  # the names differ: all else is taken over
