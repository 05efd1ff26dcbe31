"""The formats that results are written in, one record each.

Enters: `Results`.  Leaves: the bytes of files.  Used by the command line (`--format` and its help) and `write.py`.
To add one: write a function and a line in `FORMATS`; the function itself imports what it needs.  Files that a student takes
along are made in `takeaway/`, a layer above this one, and named here by module and function.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from typing import TYPE_CHECKING

from coursework.system.frozen import frozen
from coursework.system.late import late
from coursework.words.errors import InputError
from coursework.words.sentences import closest, say

if TYPE_CHECKING:
    from coursework.report.output.results import Results

Files = Iterator[tuple[str, bytes]]


@frozen
class Format:
    """A format: `suffix` is its word on the command line and the ending of its files; `write` yields name and bytes of each.

    `serves` lists who offers it: the commands "run" and "accuracy", and `write_report`, which writes a single page.  If
    `asked`, it is written only when asked for by name, and left out if the run cannot have it.  If `paged`, it is made from
    the page model.  `package` is the package of an optional extra that it needs, "" for none.
    """

    suffix: str
    write: Callable[[Results], Files]
    serves: tuple[str, ...]
    paged: bool = True
    asked: bool = False
    package: str = ""

    def is_here(self) -> bool:
        """Return whether this installation can write the format."""
        return not self.package or find_spec(self.package) is not None


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
    Format("csv", _csv, ("run", "accuracy"), paged=False),
    Format("xlsx", late("takeaway.workbook.book", "write"), ("run",), paged=False, asked=True, package="xlsxwriter"),
    Format("figures", late("takeaway.figures.drawings", "write"), ("run",), asked=True),
    Format("docx", late("takeaway.note.writer", "write_docx"), ("run",), asked=True, package="pypandoc"),
    Format("odt", late("takeaway.note.writer", "write_odt"), ("run",), asked=True, package="pypandoc"),
    Format("tex", late("takeaway.note.writer", "write_tex"), ("run",), asked=True, package="pypandoc"),
    Format("dxf", late("takeaway.figures.dxf", "write"), ("run",), asked=True, package="ezdxf"),
)


def formats_for(user: str) -> dict[str, Format]:
    """Return the formats that a command offers, by suffix."""
    return {each.suffix: each for each in FORMATS if user in each.serves}


def chosen(suffixes: Sequence[str] | None, user: str) -> tuple[Format, ...]:
    """Return the formats with these suffixes in the order of `FORMATS`; for None, all that need not be asked for by name.

    Raises `InputError` for an unknown suffix.
    """
    known = formats_for(user)
    if suffixes is None:
        return tuple(each for each in known.values() if not each.asked)
    for suffix in suffixes:
        if suffix not in known:
            hint = closest(suffix, list(known))
            raise InputError(say("fault.C015", suffix=suffix, hint=hint, known=", ".join(known)))
    return tuple(each for suffix, each in known.items() if suffix in suffixes)
