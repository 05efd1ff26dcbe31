"""Matrices that a program fills cell by cell or row by row, A[0, 1] = …, A(1, :) = [a, b] -> the same written as a whole.

Enters: a text.  Leaves: the text with such matrices in square brackets where their first cell stood; nothing is computed.
Used by `matrices.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.systems.parts import vector

# An assignment to one cell of a matrix or right side, A(1,2) = … or b[0] = …
_ELEMENT = re.compile(
    r"(?m)(?:^|(?<=;))[ \t]*([^\W\d]\w{0,20})[ \t]*[\[(]\s*(\d{1,2})\s*(?:(?:,|\]\s*\[)\s*(\d{1,2})\s*)?[\])]"
    r"[ \t]*:?=(?!=)([^=;\n]+);?"
)
_ROW_OF_CELLS = re.compile(
    r"(?m)(?:^|(?<=;))[ \t]*([^\W\d]\w{0,20})[ \t]*[\[(]\s*(\d{1,2})\s*(?:,\s*:\s*)?[\])][ \t]*=[ \t]*(?:[\w.]{1,12}\()?"
    r"\[((?:[^\[\]\n]|\[\d{1,2}\]){1,1000})\]\)?"
)
_SOLVED_WITH = r"(?:\\\s*|[,*@]\s*)%s\b"  # A\b, solve(A, b), inv(A)*b
_MOST = 20


def as_wholes(text: str) -> str:
    r"""Return a text in which each matrix that is filled cell by cell is written as a whole.

    >>> as_wholes("A[0, 0] = a\nA[0, 1] = b\nA[1, 0] = c\nA[1, 1] = d").strip()
    'A = [a, b; c, d];'
    """
    first = min([1, *(int(row[2]) for row in _ROW_OF_CELLS.finditer(text))])  # columns are counted from 0 or 1 as rows are
    text = _ROW_OF_CELLS.sub(lambda row: _as_cells(row, first), text)
    cells: dict[str, list[re.Match[str]]] = {}
    for one in _ELEMENT.finditer(text):
        cells.setdefault(one[1], []).append(one)
    matrices = {name: found for name, found in cells.items() if any(one[3] for one in found)}
    for name, found in cells.items():  # the right side that belongs to the only matrix
        if len(matrices) == 1 and name not in matrices and re.search(_SOLVED_WITH % re.escape(name), text):
            matrices[name] = found
    pieces: list[tuple[int, int, str]] = []
    size = max((int(index) for found in matrices.values() for one in found for index in (one[2], one[3]) if index), default=0)
    base = 0 if any(index == "0" for found in matrices.values() for one in found for index in (one[2], one[3])) else 1
    for name, filled in matrices.items():
        values = {(int(one[2]), int(one[3] or base)): one[4].strip() for one in filled}
        columns = range(base, size + 1) if any(one[3] for one in filled) else (base,)
        rows = [", ".join(values.get((row, column), "0") for column in columns) for row in range(base, size + 1)]
        pieces += [(*one.span(), "" if k else f"{name} = [{'; '.join(rows)}];") for k, one in enumerate(filled)]
    for begin, end, said in sorted(pieces, reverse=True) if size < _MOST else ():
        text = text[:begin] + said + text[end:]
    return text


def _as_cells(row: re.Match[str], first: int) -> str:
    """Return a row that is assigned to a matrix, A[0] = [a, b] or A(1, :) = [a, b], cell by cell: A[0, 0] = a; A[0, 1] = b"""
    cells = enumerate(filter(None, vector(row[3])), first)
    return "; ".join(f"{row[1]}[{row[2]}, {place}] = {cell}" for place, cell in cells)
