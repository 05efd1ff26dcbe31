"""Matrices as R writes them, matrix(c(…), nrow=2, byrow=TRUE), rbind(c(…), c(…)) -> nested brackets, [[a, b], [c, d]].

Enters: a text.  Leaves: the text with such brackets and "=" for "<-"; unchanged if it has no such matrix.
Used by `matrices.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import at_commas

_CALL = re.compile(r"\b(matrix|rbind|cbind)\s*\(")
_VECTOR = re.compile(r"\s*(?:\w{1,20}\s*=\s*)?c\s*\((.*)\)\s*", re.DOTALL)
_KEY = re.compile(r"\s*(\w{1,9})\s*=\s*(\w+)\s*|\s*(\d+)\s*")
_OTHER = (
    (re.compile(r"(?m)((?:^|;)[ \t]*[\w.]{1,20}[ \t]*)<-[ \t]*"), r"\1= "),
    (re.compile(r"\bsolve\(\s*(\w{1,20})\s*\)\s*%\*%\s*(\w{1,20})"), r"solve(\1, \2)"),
    (re.compile(r"(?m)^[ \t]*(?=solve\()"), "x = "),
    (re.compile(r"(?<=[=,*])\s*\bc\(((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)\)"), r" [\1]"),
)
_GIVEN = re.compile(
    r"(?m)^[ \t]*([\w.]{1,20})[ \t]*(?:<-|=)[ \t]*function\([^()]{0,60}\)[ \t]*\{[^{}]{0,4000}?"
    r"\n[ \t]*solve\([^{}\n]*\)[ \t]*\n?\}"
)
_MOST = 12


def in_brackets(text: str) -> str:
    r"""Return a text with the matrices and vectors of R in brackets.

    >>> in_brackets("A <- matrix(c(a, b,\n c, d), 2, 2, byrow=TRUE)\nb <- c(e, f)\nsolve(A) %*% b")
    'A = [[a, b], [c, d]]\n\nb = [e, f]\nx = solve(A, b)'
    >>> in_brackets("A <- matrix(c(a, b, c, d), nrow=2)"), in_brackets("A = cbind(c(a, b), c(d, e))")
    ('A = [[a, c], [b, d]]', 'A = [[a, d], [b, e]]')
    """
    place = 0
    for _ in range(_MOST):
        if (found := _CALL.search(text, place)) is None:
            break
        end = closing(text, found.end() - 1) + 1
        rows = _rows(found[1], at_commas(text[found.end() : end - 1]))
        place = end
        if rows:
            matrix = "[" + ", ".join("[" + ", ".join(row) + "]" for row in rows) + "]"
            lines = "\n" * text.count("\n", found.start(), end)
            place = found.start() + len(matrix)
            text = text[: found.start()] + matrix + lines + text[end:]
    if place:
        for name in _GIVEN.findall(text):  # a function that ends with what it solves for: om(phi)[1] is x[1]
            text = re.sub(rf"(?<![\w.]){re.escape(name)}\([\w\s,.]{{0,40}}\)(?=\[)", "x", text)
        for pattern, by in _OTHER:
            text = pattern.sub(by, text)
    return text


def _rows(kind: str, parts: Sequence[str]) -> list[list[str]]:
    """Return the rows of a matrix from the arguments of the call that makes it, [] if they do not tell."""
    vectors = [_cells(found[1]) for part in parts if (found := _VECTOR.fullmatch(part))]
    if kind != "matrix":
        whole = len(vectors) == len(parts) and len({*map(len, vectors)}) == 1
        return [] if not whole else vectors if kind == "rbind" else [[*row] for row in zip(*vectors, strict=True)]
    said = [_KEY.fullmatch(part) for part in parts[1:]]
    if len(vectors) != 1 or None in said:
        return []
    places = iter(("nrow", "ncol", "byrow"))
    keys = {found[1] or next(places): found[2] or found[3] for found in said if found}
    cells = vectors[0]
    count = int(keys.get("nrow") or 0) or (len(cells) // (int(keys.get("ncol") or 0) or 1))
    width = len(cells) // max(count, 1)
    if not count * width == len(cells) <= _MOST**2:
        return []
    if keys.get("byrow", "F").startswith("T"):
        return [cells[row * width : (row + 1) * width] for row in range(count)]
    return [cells[row::count] for row in range(count)]


def _cells(content: str) -> list[str]:
    return [" ".join(cell.split()) for cell in at_commas(content)]
