"""A product of matrices drawn over several lines, [ a  b ] [x] = [e] above [ c  d ] [y]   [f] -> the product in one line.

Enters: a text.  Leaves: the text with such a block in its first line; other text is unchanged.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.grading.reading.equations.systems.parts import vector

_OPENS, _CLOSES = r"[\[(|⎡⎢⎣⎛⎜⎝]", r"[\])|⎤⎥⎦⎞⎟⎠]"
_LINE = re.compile(
    rf"\s*{_OPENS}\s*(\S.{{0,500}}?)\s*{_CLOSES}\s*[*·⋅×]?\s*{_OPENS}\s*([^\W\d][\w'̇]{{0,20}})\s*{_CLOSES}"
    rf"\s*(=?)\s*{_OPENS}\s*(\S.{{0,500}}?)\s*{_CLOSES}\s*[.,;]?\s*"
)
_BETWEEN = re.compile(r"[\s\[\]()|⎡⎢⎣⎛⎜⎝⎤⎥⎦⎞⎟⎠*·⋅×]*(=?)[\s\[\]()|⎡⎢⎣⎛⎜⎝⎤⎥⎦⎞⎟⎠]*")  # with the signs of the drawing alone
_APART = re.compile(r"\s{2,}|\t|,|&")
_FEWEST, _MOST, _LONGEST = 2, 12, 600


def in_one_line(text: str) -> str:
    r"""Return a text in which each product of matrices that is drawn over several lines stands in one.

    >>> in_one_line("[ 2*a   0 ] [w1]   [ -e ]\n[ c  -d ] [w2] = [ 0 ]\nx = 1")
    '[2*a, 0; c, -d]*[w1; w2] = [-e; 0]\n\nx = 1'
    >>> in_one_line("[a 0] [w1]   [e]\n[c + d  -b] [w2] = [f]")
    '[a, 0; c + d, -b]*[w1; w2] = [e; f]\n'
    """
    lines = text.split("\n")
    begun = (len(line) < _LONGEST and sum(map(line.count, "[|(⎡⎢⎣⎛⎝")) > _FEWEST for line in lines)
    found = [_LINE.fullmatch(line) if may_be else None for line, may_be in zip(lines, begun, strict=True)]
    place = 0
    while place < len(lines):
        end, rows, relates = place, list[re.Match[str]](), False
        while end < len(lines) and len(lines[end]) < _LONGEST and len(rows) <= _MOST:
            row, between = found[end], _BETWEEN.fullmatch(lines[end]) if rows and lines[end].strip() else None
            if row is None and between is None:
                break
            rows += [row] if row else []
            relates |= bool(row[3] if row else between and between[1])
            end += 1
        if relates and len(rows) >= _FEWEST and (said := _said(rows)):
            lines[place:end] = [said, *[""] * (end - place - 1)]
        place = max(end, place + 1)
    return "\n".join(lines)


def _said(rows: Sequence[re.Match[str]]) -> str:
    """Return the product of a block as one line, "" if its matrix is not square."""
    matrix = [[cell for cell in _APART.split(row[1]) if cell.strip()] for row in rows]
    matrix = [cells if len(cells) == len(rows) else vector(row[1]) for cells, row in zip(matrix, rows, strict=True)]
    if any(len(cells) != len(rows) for cells in matrix):
        return ""
    left, names, right = "; ".join(map(", ".join, matrix)), "; ".join(row[2] for row in rows), "; ".join(row[4] for row in rows)
    return f"[{left}]*[{names}] = [{right}]"
