"""A small table for a notebook: a caption, a head, rows of texts; text escaped for a page or a drawing.

Enters: texts.  Leaves: escaped HTML, in the notebook's own style.  Used by records shown to a person, drawings, graphs.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

_SIGNS = (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;"), ("'", "&#x27;"))


def escaped(text: str) -> str:
    """Return text escaped as `html.escape` does it, which loads the names of all signs of HTML: two hundredths of a table.

    >>> escaped("a < b & 'c'")
    'a &lt; b &amp; &#x27;c&#x27;'
    """
    for sign, shown in _SIGNS:
        text = text.replace(sign, shown)
    return text


def html_table(caption: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Return a table as HTML; cells that begin with a letter are aligned left, as Jupyter aligns all cells right.

    >>> html_table("Data", ("symbol", "value"), [("r1", 0.953)])
    '<table><caption>Data</caption><tr><th>symbol<th>value</tr><tr><td style="text-align:left">r1<td>0.953</tr></table>'
    """
    lines = [f"<tr>{''.join(f'<td{_side(str(cell))}>{escaped(str(cell))}' for cell in row)}</tr>" for row in rows]
    names = "".join(f"<th>{escaped(name)}" for name in head)
    return f"<table><caption>{escaped(caption)}</caption><tr>{names}</tr>{''.join(lines)}</table>"


def _side(text: str) -> str:
    return ' style="text-align:left"' if text[:1].isalpha() else ""
