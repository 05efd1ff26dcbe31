"""Matrices of SMath Studio, mat(a;b;c;d;2;2):…, -> matrices in square brackets and "=" for the colon that assigns.

Enters: a text.  Leaves: the text with such brackets; unchanged if it has no such matrix.  Used by `matrices.py`.
"""

from __future__ import annotations

import math
import re
from itertools import islice

from coursework.grading.reading.equations.notation.latex import in_one_piece
from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import at_signs

_SMATH = re.compile(r"(?<!\w)mat\(")
_ASSIGNED = re.compile(r"(?m)(?<=[\w\]])[ \t]*:(?!=)(?=[^:=\n]*$)")
_INDEX = re.compile(r"(?<=[^\W\d])\.(?=\w)")  # ω.2
_MOST, _LONGEST = 20, 4000


def of_smath(text: str) -> str:
    """Return a text with the matrices of SMath Studio, cells row by row and then their numbers of rows and columns, in brackets.

    >>> of_smath("mat(a;b*(c+1);2;d;2;2)*mat(x;y;2;1)")
    '[a, b*(c+1); 2, d]*[x; y]'
    >>> of_smath("mat(A)*mat(;)")
    'mat(A)*mat(;)'
    """
    before = len(text)
    for found in reversed([*islice(_SMATH.finditer(text), _MOST)]):
        end = closing(text, found.end() - 1, _LONGEST)
        inner = text[found.end() : end]
        listed = at_signs(re.compile(";" if ";" in inner else ","), inner)
        cells, size = listed[:-2], [one.strip() for one in listed[-2:]]
        if cells and all(map(str.isdecimal, size)) and math.prod(map(int, size)) == len(cells):
            wide = int(size[1])
            said = in_one_piece(cells[place : place + wide] for place in range(0, len(cells), wide)).strip()
            text = text[: found.start()] + said + text[end + 1 :]
    return _ASSIGNED.sub("=", _INDEX.sub("", text)) if len(text) < before else text
