"""The findings of a run for a person: a tuple that prints as one line, and as a table in a notebook.

Enters: `Finding`s.  Leaves: `Findings`.  Used by `run.py`.
"""

from __future__ import annotations

from collections import Counter

from coursework.results.checks.result import VERDICTS, Finding
from coursework.words.html_table import html_table


class Findings(tuple[Finding, ...]):
    """The findings of all checks, in the order of the checks.

    >>> import coursework
    >>> coursework.solve("31", scheme="rk4").checks
    <Findings: 14 PASS, 4 SKIP>
    """

    __slots__ = ()

    def __repr__(self) -> str:
        count = Counter(finding.verdict for finding in self)
        return f"<Findings: {', '.join(f'{count[verdict]} {verdict}' for verdict in VERDICTS if count[verdict])}>"

    def _repr_html_(self) -> str:
        rows = [(one.verdict, one.title, one.sentence) for one in self]
        return html_table("", ("", "", ""), rows)
