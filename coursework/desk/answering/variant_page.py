"""A text -> the very report of `run`, or its faults.

Enters: a `Desk`.  Leaves: what `/api/page` and `/api/check` answer.  Used by `bench.py`.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace
from typing import Any

from coursework.desk.answering.controls import controls
from coursework.desk.answering.derived import verdicts
from coursework.desk.answering.typed import Desk, remarks_of
from coursework.report.formulas.svg import draw
from coursework.report.output.results import Results
from coursework.report.pages.html import render_html
from coursework.report.sections.sections import BEHIND
from coursework.scene.quantities import ACCURACY, GRAPH_CHECK, TABLE
from coursework.words.sentences import ENGLISH

KEPT = 12  # pages, some 300 kB each
_PAGES: OrderedDict[tuple[str, tuple[str, ...]], str] = OrderedDict()
DEAR = {ACCURACY.name, GRAPH_CHECK.name}  # nothing else on a page needs them


def page(desk: Desk) -> dict[str, Any]:
    """Return the page and what stands around it; of what is read last only the headings where that is asked for later."""
    run, later = desk.run, tuple[str, ...]()
    if desk.body.get("study") is False:
        later = tuple(write.__name__ for write, needed in BEHIND if needed is None or run.asks(needed))
        run = replace(run, asked=tuple(name for name in run.asked if name not in DEAR) or (TABLE.name,))
    html = _written(Results(run, desk.language, later=later))
    return found(desk) | {"page": html, "later": later, "data": controls(desk)}


def _written(results: Results) -> str:
    """Return the page, the one of before where only remarks were typed, or a hand went back."""
    key = (results.stamp, results.later)
    if key not in _PAGES:
        results.compute(pages=True)
        _PAGES[key] = render_html(results.model, pack=False)
    _PAGES.move_to_end(key)
    while len(_PAGES) > KEPT:
        _PAGES.popitem(last=False)
    return _PAGES[key]


def check(desk: Desk) -> dict[str, Any]:
    """Return faults, none, and the first sentence of `run`."""
    Results(desk.run, desk.language).compute(pages=False)
    return found(desk)


def found(desk: Desk) -> dict[str, Any]:
    """Return what is told of a text without faults."""
    summary = desk.run.summary if desk.language == ENGLISH else desk.run.named_summary
    return {
        "faults": [],
        "summary": desk.words.written(summary) or None,
        "remarks": remarks_of(desk),
        "equations": verdicts(desk),
    }


def warm(_desk: Desk) -> dict[str, Any]:
    """Have what a first page would wait for: everything imported, and the typesetter with its faces."""
    draw(["omega_1"], breaks=True)
    return {}
