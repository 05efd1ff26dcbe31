"""A determinant of two or three rows -> the sum of products that it is.

Enters: its rows.  Leaves: text.  Used by `latex.py` and, for the determinants of programs, by `matrices.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

_SIZES = (2, 3)


def determinant(rows: Sequence[Sequence[str]]) -> str:
    """Return a determinant as a sum, "" if it is not square or has more rows than one writes out.

    >>> determinant([["a", "b"], ["c", "d + e"]]), determinant([["a", "b"]])
    ('((a)*(d + e) - (b)*(c))', '')
    """
    if len(rows) not in _SIZES or any(len(row) != len(rows) for row in rows):
        return ""
    if len(rows) == _SIZES[0]:
        (a, b), (c, d) = rows
        return f"(({a})*({d}) - ({b})*({c}))"
    first, *others = rows
    minors = (determinant([[*row[:column], *row[column + 1 :]] for row in others]) for column in range(3))
    return (
        "(" + "".join(f" {'+-'[k % 2]} ({cell})*{minor}" for k, (cell, minor) in enumerate(zip(first, minors, strict=True))) + ")"
    )
