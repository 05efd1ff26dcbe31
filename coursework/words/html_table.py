"""A small table for a notebook: a caption, a head, rows of texts.

Enters: texts.  Leaves: escaped HTML, in the notebook's own style.  Used by records that a person displays.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def html_table(caption: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Return a table as HTML; cells that begin with a letter are aligned left, as Jupyter aligns all cells right.

    >>> html_table("Data", ("symbol", "value"), [("r1", 0.953)])
    '<table><caption>Data</caption><tr><th>symbol<th>value</tr><tr><td style="text-align:left">r1<td>0.953</tr></table>'
    """
    from html import escape  # imported here, as only notebooks need it and it loads all HTML entities

    lines = [f"<tr>{''.join(f'<td{_side(str(cell))}>{escape(str(cell))}' for cell in row)}</tr>" for row in rows]
    names = "".join(f"<th>{escape(name)}" for name in head)
    return f"<table><caption>{escape(caption)}</caption><tr>{names}</tr>{''.join(lines)}</table>"


def _side(text: str) -> str:
    return ' style="text-align:left"' if text[:1].isalpha() else ""
