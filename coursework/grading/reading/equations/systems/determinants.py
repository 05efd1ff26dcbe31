"""The determinants in a text, det([a, b; c, d]), np.linalg.det(np.array([[a, b], [c, d]])) -> the sums that they are.

Enters: a text.  Leaves: the text with a sum in place of each determinant whose rows are written in it.  Used by `matrices.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.notation.determinants import determinant
from coursework.grading.reading.equations.notation.signs import depths
from coursework.grading.reading.equations.systems.parts import rows_of

_CALLED = re.compile(r"(?:(?<![\w.])(?:[A-Za-z]{1,13}(?:\.|:-)){1,2}|(?<![\w.]))(?:[dD]et|[dD]eterminant)\s*(?=[(\[])")
_WRAPPED = re.compile(r"\s*[\w.]{0,20}\s*\(?\s*(\[.*\])\s*\)?\s*", re.DOTALL)
_BRACES = str.maketrans("{}", "[]")
_MOST, _LONGEST = 20, 2000


def with_determinants(text: str) -> str:
    """Return a text with its determinants as sums.

    >>> with_determinants("w1 = det([a, b; c, d])/np.linalg.det(np.array([[e, f], [g, h]]))")
    'w1 = ((a)*(d) - (b)*(c))/((e)*(h) - (f)*(g))'
    """
    start = 0
    for _ in range(_MOST):
        if (found := _CALLED.search(text, start)) is None:
            break
        inside = depths(text[found.end() : found.end() + _LONGEST])
        end = found.end() + inside.index(0) if 0 in inside else found.end()
        inner = text[found.end() + 1 : end]
        wrapped = _WRAPPED.fullmatch(inner.translate(_BRACES) if inner.lstrip().startswith("{") else inner)
        said = determinant(rows_of(wrapped[1][1:-1])) if wrapped else ""
        start = found.end()
        if said:
            text = text[: found.start()] + said + "\n" * inner.count("\n") + text[end + 1 :]
            start = found.start() + len(said)
    return text
