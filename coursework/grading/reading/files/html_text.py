"""HTML that was typed into a platform's editor -> its lines; cells of a table stay apart.

Enters: a page as text.  Leaves: plain text.  Takes time in proportion to the text, whatever is in it.
Used by `read_submission.py`.
"""

from __future__ import annotations

import html
import re

# A script or a style up to its end, or that of the page; each letter is looked at once.
_SILENT = re.compile(r"<(script|style)\b[^<>]{0,500}>[^<]*+(?:<(?!/\1)[^<]*+)*+", re.IGNORECASE)
# The ends of cells and rows may be left out.
_CELL = re.compile(r"</t[dh]\s*>\s*|(?<=[^>\s])\s?(?=<t[dh]\b)", re.IGNORECASE)
_ROW = re.compile(r"(?<=[^>\s])\s?(?=<tr\b)", re.IGNORECASE)
_LINE = re.compile(r"<(?:br|/p|/div|/li|/tr|/h[1-6]|/pre)\b[^<>]{0,500}>", re.IGNORECASE)
_TAG = re.compile(r"<[/!?a-zA-Z][^<>]{0,2000}>")


def text_of(page: str) -> str:
    r"""Return the text of a page, one line a paragraph or row.

    >>> text_of("<p>w1 = 2<br>w2 &lt; 3</p>")
    'w1 = 2\nw2 < 3'
    """
    kept = " ".join(_SILENT.sub("", page).split())  # a tab that sets a line in is no new cell
    lined = _LINE.sub("\n", _ROW.sub("\n", _CELL.sub("\t", kept)))
    plain = html.unescape(_TAG.sub("", lined)).replace("\u00a0", " ")
    # The end of a paragraph inside a cell is not the end of a row.
    rows = "\t".join(cell.rstrip("\n ") for cell in plain.split("\t"))
    return "\n".join(line.strip(" ").rstrip("\t") for line in rows.split("\n"))
