"""A text -> the same report as that of the command `run`, or its faults.

Enters: a `Desk`.  Leaves: the answers to `/api/page` and `/api/check`.  Used by `bench.py`.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace
from typing import Any

from coursework.desk.answering.controls import controls
from coursework.desk.answering.derived import agreed_of, judged
from coursework.desk.answering.typed import Desk, remarks_of
from coursework.report.formulas.svg import draw
from coursework.report.output.results import Results
from coursework.report.pages.html import render_html
from coursework.report.sections.sections import BEHIND
from coursework.scene.quantities import ACCURACY, GRAPH_CHECK, TABLE
from coursework.words.sentences import ENGLISH

KEPT = 12  # pages kept in a cache, about 300 kB each
_PAGES: OrderedDict[tuple[str, tuple[str, ...]], str] = OrderedDict()
DEAR = {ACCURACY.name, GRAPH_CHECK.name}  # costly quantities, which no other part of a page needs


def page(desk: Desk) -> dict[str, Any]:
    """Return the page and the data around it; if "study" is false, sections read last have only headings for now."""
    run, later = desk.run, tuple[str, ...]()
    if desk.body.get("study") is False:
        later = tuple(write.__name__ for write, needed in BEHIND if needed is None or run.asks(needed))
        run = replace(run, asked=tuple(name for name in run.asked if name not in DEAR) or (TABLE.name,))
    html = _written(Results(run, desk.language, later=later))
    return found(desk) | {"page": html, "later": later, "data": controls(desk)}


def _written(results: Results) -> str:
    """Return the page, from the cache if the variant is unchanged (only comments were typed) or was shown shortly before."""
    key = (results.stamp, results.later)
    if key not in _PAGES:
        results.compute(pages=True)
        _PAGES[key] = render_html(results.model, pack=False)
    _PAGES.move_to_end(key)
    while len(_PAGES) > KEPT:
        _PAGES.popitem(last=False)
    return _PAGES[key]


def check(desk: Desk) -> dict[str, Any]:
    """Return the findings on a text without computing its page."""
    Results(desk.run, desk.language).compute(pages=False)
    return found(desk)


def found(desk: Desk) -> dict[str, Any]:
    """Return the findings on a text without faults: no faults, the summary of `run`, remarks, verdicts on equations."""
    summary = desk.run.summary if desk.language == ENGLISH else desk.run.named_summary
    return {
        "faults": [],
        "summary": desk.words.written(summary) or None,
        "remarks": remarks_of(desk),
        "equations": judged(desk, agreed_of(desk.run), {}),
    }


def warm(_desk: Desk) -> dict[str, Any]:
    """Load everything for which a first page would have to wait: all imports, and Typst with its fonts."""
    draw(["omega_1"], breaks=True)
    return {}
