"""The formats that results are written in, one record each.

Enters: `Results`.  Leaves: the bytes of files.  Used by the command line (`--format` and its help) and `write.py`.
To add one: write a function and a line in `FORMATS`; whatever a format needs is imported when it is written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from coursework.system.frozen import frozen
from coursework.words.errors import InputError
from coursework.words.sentences import closest, say

if TYPE_CHECKING:
    from coursework.report.output.results import Results

Files = Iterator[tuple[str, bytes]]


@frozen
class Format:
    """`suffix` is its word on the command line and the ending of its files; `write` yields the name and bytes of each file;
    `serves` lists who offers it: the commands "run" and "accuracy", and `write_report`, which writes a page alone.
    """

    suffix: str
    write: Callable[[Results], Files]
    serves: tuple[str, ...]


def _html(results: Results) -> Files:
    from coursework.report.pages.html import render_html

    yield f"{results.stem}.html", render_html(results.model).encode("utf-8")


def _pdf(results: Results) -> Files:
    from coursework.report.pages.pdf import paper_of

    paper = paper_of([results.model.plain()])
    results.unprinted = paper.missing
    yield f"{results.stem}.pdf", paper.content


def _csv(results: Results) -> Files:
    for name, text in results.tables():
        yield name, text.encode("utf-8")


FORMATS: tuple[Format, ...] = (
    Format("html", _html, ("run", "accuracy", "write_report")),
    Format("pdf", _pdf, ("run", "accuracy", "write_report")),
    Format("csv", _csv, ("run", "accuracy")),
)
PAGES = "write_report"  # whoever serves this makes a page


def formats_for(user: str) -> dict[str, Format]:
    """Return the formats that a command offers, by suffix."""
    return {each.suffix: each for each in FORMATS if user in each.serves}


def chosen(suffixes: Sequence[str] | None, user: str) -> tuple[Format, ...]:
    """Return the formats of these suffixes in the order of `FORMATS`, all for None.  Raises `InputError` for another suffix."""
    known = formats_for(user)
    if suffixes is None:
        return tuple(known.values())
    for suffix in suffixes:
        if suffix not in known:
            hint = closest(suffix, list(known))
            raise InputError(say("fault.C015", suffix=suffix, hint=hint, known=", ".join(known)))
    return tuple(each for suffix, each in known.items() if suffix in suffixes)
