"""A small table as a notebook shows it: what it is, a head, rows of texts.

Enters: texts.  Leaves: HTML, escaped, with the looks of the notebook.  Used by records that a person holds.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def html_table(caption: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Return a table; words stand on the left, where Jupyter puts every cell on the right.

    >>> html_table("Data", ("symbol", "value"), [("r1", 0.953)])
    '<table><caption>Data</caption><tr><th>symbol<th>value</tr><tr><td style="text-align:left">r1<td>0.953</tr></table>'
    """
    from html import escape  # a notebook alone shows tables; the module brings all names of signs along

    lines = [f"<tr>{''.join(f'<td{_side(str(cell))}>{escape(str(cell))}' for cell in row)}</tr>" for row in rows]
    names = "".join(f"<th>{escape(name)}" for name in head)
    return f"<table><caption>{escape(caption)}</caption><tr>{names}</tr>{''.join(lines)}</table>"


def _side(text: str) -> str:
    return ' style="text-align:left"' if text[:1].isalpha() else ""
