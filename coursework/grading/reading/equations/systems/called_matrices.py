"""Matrices as calls, mat(a;b;c;d;2;2) of SMath Studio, vec(a, b) of Typst, ■(a&b@c&d) of Word -> matrices in square brackets.

Enters: a text.  Leaves: the text with such brackets, "=" for the colon that assigns in SMath, and the equations of Word's █(…@…)
with semicolons between them; unchanged if it has no such call.  Used by `matrices.py`.
"""

from __future__ import annotations

import math
import re
from itertools import islice

from coursework.grading.reading.equations.notation.latex import in_one_piece
from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import at_commas, at_signs

_CALL = re.compile(r"(?<!\w)(mat|vec)\(|([█■])\(")
_AROUND = re.compile(r"[\[({├]\s*\x00([^\x00\n]*)\x00\s*[\])}┤├]")  # of Word, what encloses the call
_ASSIGNED = re.compile(r"(?m)(?<=[\w\]])[ \t]*:(?!=)(?=[^:=\n]*$)")
_INDEX = re.compile(r"(?<=[^\W\d])\.(?=\w)")  # ω.2
_MOST, _LONGEST = 20, 4000


def in_matrices(text: str) -> str:
    """Return a text with the matrices and vectors of SMath Studio, Typst and Word in brackets.

    SMath has the cells row by row and then their numbers of rows and columns.

    >>> in_matrices("mat(a;b*(c+1);2;d;2;2)*mat(x;y;2;1)"), in_matrices("mat(a, b; c, d) vec(x, y)")
    ('[a, b*(c+1); 2, d]*[x; y]', '[a, b; c, d] [x; y]')
    >>> in_matrices("[■(a&b@c&d)](■(x@y))"), in_matrices("{█(a=b@c=d)┤"), in_matrices("mat(A)*mat(;)")
    ('[a, b; c, d][x; y]', 'a=b; c=d', 'mat(A)*mat(;)')
    """
    is_smath = False
    for found in reversed([*islice(_CALL.finditer(text), _MOST)]):
        end = closing(text, found.end() - 1, _LONGEST)
        inner = text[found.end() : end]
        if found[2] == "█":
            said = "\x00" + "; ".join(at_signs(re.compile("@"), inner)).replace("&", "") + "\x00"
        elif found[2]:
            said = f"\x00{in_one_piece(row.split('&') for row in at_signs(re.compile('@'), inner)).strip()}\x00"
        else:
            listed = at_signs(re.compile(";" if ";" in inner else ","), inner)
            cells, size = listed[:-2], [one.strip() for one in listed[-2:]]
            rows = [[cell] for cell in listed] if found[1] == "vec" else [at_commas(row) for row in listed]
            if cells and all(map(str.isdecimal, size)) and math.prod(map(int, size)) == len(cells):
                is_smath, wide = True, int(size[1])
                rows = [cells[place : place + wide] for place in range(0, len(cells), wide)]
            elif len(rows) == 1 or not inner.strip(" ;,") or len({*map(len, rows)}) > 1:
                continue
            said = in_one_piece(rows).strip()
        text = text[: found.start()] + said + text[end + 1 :]
    text = _AROUND.sub(r"\1", text).replace("\x00", "") if "\x00" in text else text
    return _ASSIGNED.sub("=", _INDEX.sub("", text)) if is_smath else text
