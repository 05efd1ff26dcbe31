"""Determinants of named matrices and of their columns, det(A), det([b A(:,2)]), A1(:,1) = b -> of matrices written out.

Enters: a text, its matrices by name.  Leaves: the text with the cells in each such determinant; unchanged if it has none.
Nothing is computed.  Used by `matrices.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from itertools import chain

from coursework.grading.reading.equations.notation.latex import in_one_piece
from coursework.grading.reading.equations.systems.parts import at_blanks, rows_of

_NAME = r"[^\W\d]\w{0,20}"
_COLUMN = rf"({_NAME})(?:[(\[]\s*:\s*,\s*(\d)\s*[)\]])?"
_COLUMNS = rf"(?:[\w.]{{1,20}}\(\s*)?[\[(]((?:\s*{_COLUMN}\s*[,\s]?){{2,3}})[\])]\)?"  # [b A(:,2)], np.column_stack([b, A[:, 1]])
_DETERMINANT = re.compile(rf"\b([dD]et(?:erminant)?)\(\s*(?:({_NAME})|{_COLUMNS})\s*\)")
_LINE, _MADE = r"(?m)(?:^|(?<=;))[ \t]*", r"(?:[\w.]{1,12}\(\s*)?"
_COPIED = re.compile(rf"{_LINE}({_NAME})[ \t]*=[ \t]*{_MADE}({_NAME})(?:\.(?:copy|clone)\(\)|\))?(?=[ \t]*(?:;|$))")
_PUT_IN = re.compile(rf"{_LINE}({_NAME})[(\[]\s*:\s*,\s*(\d)\s*[)\]]\s*=\s*({_NAME})[ \t]*;?")


def with_cells_in_determinants(text: str, contents: Mapping[str, str]) -> str:
    r"""Return a text with the cells of named matrices in the determinants that name them; `contents` are the matrices' texts.

    >>> with_cells_in_determinants("x = det([k A(:,2)])/det(A)", {"A": "a, b; c, d", "k": "e; f"})
    'x = det([e, b; f, d])/det([a, b; c, d])'
    >>> with_cells_in_determinants("B = A; B(:,2) = k;\ny = det(B)", {"A": "a, b; c, d", "k": "e; f"}).split()[-4:]
    ['det([a,', 'e;', 'c,', 'f])']
    """
    if not _DETERMINANT.search(text):
        return text
    columns = {name: _columns(content) for name, content in contents.items()}
    first = 0 if re.search(r":\s*,\s*0\s*[)\]]", text) else 1
    copied, put = _COPIED.findall(text), _PUT_IN.findall(text)
    for name, other in copied:
        if other in columns and name not in contents:
            columns[name] = [*columns[other]]
    made, changed = Counter(name for name, _ in copied), Counter(name for name, *_ in put)
    for name in changed:
        if (made[name], changed[name]) != (1, 1):  # what it holds depends on the place
            columns.pop(name, None)
    for name, place, vector in put:
        if name in columns and vector in columns and 0 <= int(place) - first < len(columns[name]):
            columns[name][int(place) - first] = columns[vector][0]

    def written(found: re.Match[str]) -> str:
        parts = re.findall(_COLUMN, found[3] or "")
        picked = (columns.get(name, [])[(at := int(place or first) - first) : at + 1] for name, place in parts)
        said = [*chain(*picked)] if parts else columns.get(found[2])
        square = said and len({len(said), *map(len, said)}) == 1
        return f"{found[1]}({in_one_piece(zip(*said, strict=True)).strip()})" if said and square else found[0]

    return _DETERMINANT.sub(written, text)


def _columns(content: str) -> list[tuple[str, ...]]:
    rows = at_blanks(rows_of(content))
    return [tuple(rows[0])] if len(rows) == 1 else [*zip(*rows, strict=False)]  # a vector is one column
