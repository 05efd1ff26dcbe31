"""Rows of values -> the text of a CSV file, identical on every system.

Enters: a header and rows.  Leaves: text.  Used by `tables.py`, `written.py`, `assign.py` and `several.py`.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable


def csv_text(head: Iterable[str], rows: Iterable[Iterable[object]], line_end: str = "\n") -> str:
    r"""Return the text of a CSV file: a float as the shortest text that reads back as the same number, None as an empty cell.

    >>> csv_text(["t", "w"], [[0.1, None]])
    't,w\n0.1,\n'
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator=line_end)
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()
