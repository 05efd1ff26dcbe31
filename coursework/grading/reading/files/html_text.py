"""HTML typed into a platform's editor -> its lines of text; the cells of a table stay separate.

Enters: a page as text.  Leaves: plain text.  The time is proportional to the length of the text, whatever it contains.
Used by `read_submission.py`.
"""

from __future__ import annotations

import html
import re

# A script or style up to its end tag, or to the end of the page; the pattern looks at each character once.
_SILENT = re.compile(r"<(script|style)\b[^<>]{0,500}>[^<]*+(?:<(?!/\1)[^<]*+)*+", re.IGNORECASE)
_AS_TYPED = re.compile(r"<pre\b[^<>]{0,500}>[^<]*+(?:<(?!/pre)[^<]*+)*+", re.IGNORECASE)  # its lines are lines
# The end tags of cells and rows may be left out.
_CELL = re.compile(r"</t[dh]\s*>\s*|(?<=[^>\s])\s?(?=<t[dh]\b)", re.IGNORECASE)
_ROW = re.compile(r"</tr\b[^<>]{0,500}>|(?<=[^>\s])\s?(?=<tr\b)", re.IGNORECASE)
_ROW_END = "\v"
_LINE = re.compile(r"<(?:br|/p|/div|/li|/h[1-6]|/pre)\b[^<>]{0,500}>", re.IGNORECASE)
_BOLD = re.compile(r"<(b|strong)>([^<>]{1,300}+)</\1>(?=\s<\1>([^<>]{1,300}+)</\1>)", re.IGNORECASE)  # and the next one
_TAG = re.compile(r"<[/!?a-zA-Z][^<>]{0,2000}>")


def text_of(page: str) -> str:
    r"""Return the text of a page, with one line per paragraph or table row and a tab between cells.

    >>> text_of("<p>w1 = 2<br>w2 &lt; 3</p>")
    'w1 = 2\nw2 < 3'
    >>> text_of("<p><b>a = b</b> <b>c = d</b> <b>and</b> <b>e</b></p>")
    'a = b\nc = d and e'
    """
    page = _AS_TYPED.sub(lambda found: found[0].replace("\n", "<br>"), _SILENT.sub("", page))
    kept = " ".join(page.split())  # a tab that indents a line does not begin a new cell
    kept = _BOLD.sub(lambda found: f"{found[2]}<br>" if "=" in found[2] and "=" in found[3] else found[0], kept)
    lined = _LINE.sub("\n", _ROW.sub(_ROW_END, _CELL.sub("\t", kept)))
    plain = html.unescape(_TAG.sub("", lined)).replace("\u00a0", " ")
    # The end of a paragraph inside a cell does not end the row.
    rows = "\t".join(cell.rstrip("\n ") for cell in plain.split("\t"))
    rows = rows.replace(f"\n{_ROW_END}", "\n").replace(_ROW_END, "\n")
    return "\n".join(line.strip(" ").rstrip("\t") for line in rows.split("\n"))
