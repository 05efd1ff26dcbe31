"""Matrices in round brackets, as Mathcad and people write them, (a b; c d)·(x; y) = (e; f) -> matrices in square brackets.

Enters: a text.  Leaves: the text with such matrices, each in one line; other text is unchanged.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import at_signs, vector

_OPENS = re.compile(r"(?:(?m:^)|(?<=[=*·⋅×\s)]))[ \t]*\((?=[^)])")
_BEFORE = re.compile(r"(?:(?:^|[;,])[ \t]*|=[ \t]*|\)?[ \t]*[*·⋅×][ \t]*|\)[ \t]*|⁻¹[ \t]*)$")
_BEHIND = re.compile(r"[ \t]*(?:$|[=*·⋅×(;,.]|:=|⁻¹|\^[({]?-1)", re.MULTILINE)
_GOES_ON = re.compile(r"[-+*/=−·(]\s*$|^\s*[+*/=]", re.MULTILINE)
_PRODUCT, _COMMA, _GAPS = re.compile(r"\s*[*·⋅×]\s*"), re.compile(","), re.compile(r"\s{2,}|\t")
_DIFFERENCE, _OF_VECTOR = re.compile(r"^[^,\n]*\n\s*[-−]\s?[^\s,]*\s*(?:\n|$)"), re.compile(r"(?:[)\]][ \t]*[*·⋅×=]?|:=)[ \t]*$")
_LONGEST, _MOST = 2000, 24


def in_square_brackets(text: str) -> str:
    r"""Return a text with square brackets around matrices of several rows of equally many cells.

    >>> in_square_brackets("A := (a*sin(x) −b\n0 c)\n(x\ny) := A^-1·(1; 2)")
    'A := [a*sin(x), -b; 0, c]\n\n[x; y] := A^-1·[1; 2]\n'
    >>> in_square_brackets("w = a*(b +\n c)"), in_square_brackets("f(x; y)"), in_square_brackets("w = (a*b\n + c)")
    ('w = a*(b +\n c)', 'f(x; y)', 'w = (a*b\n + c)')
    """
    place = 0
    for _ in range(_MOST):
        if (found := _OPENS.search(text, place)) is None:
            break
        opening = found.end() - 1
        end = closing(text, opening, _LONGEST)
        said = _said(text[opening + 1 : end])
        place = opening + 1
        before = text[text.rfind("\n", 0, opening) + 1 : opening]
        is_sum = _DIFFERENCE.search(text[opening:end]) and not _OF_VECTOR.search(before)  # a*(b\n - c) goes on
        if said and not is_sum and _BEFORE.search(before) and _BEHIND.match(text, end + 1):
            lines = text.count("\n", opening, end)
            rest, sign, after = text[end + 1 :].partition("\n")  # the next matrix of the product may begin in the rest
            text = f"{text[:opening]}{said}{rest}{sign}{lines * chr(10)}{after}"
            place = opening + len(said)
    return text


def _said(content: str) -> str:
    """Return the matrix in one line, "" if the content has no several rows of one width."""
    if not re.search(r"[;\n]", content) or "=" in content or _GOES_ON.search(content):
        return ""
    plainly = _PRODUCT.sub("*", content.replace("−", "-"))
    lines = [row.strip() for row in re.split(r"[;\n]", plainly) if row.strip()]
    rows = [_cells(row) for row in lines]
    if len({*map(len, rows)}) > 1 and ";" in plainly and "," not in plainly:
        rows = [[line] for line in lines]  # one column: the blanks are those of products
    is_matrix = len(rows) > 1 and len({*map(len, rows)}) == 1 and all(map(all, rows))
    return f"[{'; '.join(map(', '.join, rows))}]" if is_matrix else ""


def _cells(row: str) -> list[str]:
    """Return the cells of a row: between commas, else between wide gaps, else between blanks."""
    for sign in (_COMMA, _GAPS):
        if len(cells := at_signs(sign, row.strip())) > 1:
            return [cell.strip() for cell in cells]
    return vector(row)
