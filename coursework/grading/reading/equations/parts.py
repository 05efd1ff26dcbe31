"""One line as typed -> the equations in it: parted by commas, semicolons, arrows, blanks, "and"; a product of matrices by rows.

Enters: a line.  Leaves: pieces of it, each with one equation, in the order of the line.
Used by `lines.py` and `systems.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from coursework.grading.reading.equations.signs import ARROWS, depths, relates_two_sides
from coursework.variant.formula.reader import MAX_CHARACTERS

_BETWEEN = re.compile(rf"{ARROWS.pattern}|\\q?quad(?![A-Za-z])|\t+|\s{{3,}}|&&|\s(?:and|und|et|y|и|та|і|且|和)\s")
# Behind "= 0" another equation begins: nothing is multiplied by nought, or added to it.
_VANISHED = re.compile(
    r"=\s*0(?:[.,]0+)?((?:\\(?:(?:tag|label)\*?\s*\{[^{}]*\}|nonumber|notag)|\s)+)(?=[^\s=*/^\\]|\\(?!tag|label|no))"
)
_MATRICES = re.compile(r"\s*\[([^\[\]]*)\]\s*[*·⋅×]?\s*\[([^\[\]]*)\]\s*=\s*\[([^\[\]]*)\]\s*[.,;]?\s*")
_BRACKETS = re.compile(r"\\(?:left|right)\s*[()\[\]|.]|(?<=\[)\s*\[|\](?=\s*\])")  # round a matrix that has its own
_LIST = re.compile(r"\s*(?:\w{1,20}\s*:?=\s*)?(?:[A-Za-z.]{1,20}\s*[(\[]\s*)?[\[{]")
_MOST_ROWS = 12
_BETWEEN_DOLLARS = re.compile(r"\$\$?([^$]{3,})\$\$?")


def parts_of(line: str) -> list[str]:
    """Return the equations of one line, each piece with a sign of equality; a piece without one goes to the piece before it.

    >>> parts_of("w3 = 0,5*w1, w4 = atan2(1, w3)"), parts_of("(16) 2*w3 = w1 ⇒ w3 = w1/2")
    (['w3 = 0,5*w1', 'w4 = atan2(1, w3)'], ['(16) 2*w3 = w1', 'w3 = w1/2'])
    """
    if rows := _rows(line) or _listed(line):
        return rows
    if len(line) > MAX_CHARACTERS:
        return [line]
    if line.count("$") > 2 and not relates_two_sides(_BETWEEN_DOLLARS.sub(" ", line)):
        # Prose round formulas: of those, what relates two sides.
        formulas = [found[1].strip() for found in _BETWEEN_DOLLARS.finditer(line)]
        return [piece for formula in formulas if relates_two_sides(formula) for piece in parts_of(formula)] or [line]
    spans: list[tuple[int, int, bool]] = []  # where a piece begins and ends, and whether it relates two sides
    start = 0
    for cut, after in [*_cuts(line), (len(line), len(line))]:
        if cut < start:
            continue
        relates = relates_two_sides(line[start:cut])
        if spans and not (relates and spans[-1][2]):
            start, _, before = spans.pop()
            relates = relates or before
        spans.append((start, cut, relates))
        start = after
    return [piece for begin, end, _ in spans if (piece := line[begin:end].strip())] or [line]


def _cuts(line: str) -> list[tuple[int, int]]:
    """Return where a piece may end and the next begin."""
    found = [(found.start(), found.end()) for found in _BETWEEN.finditer(line)]
    found += [(found.start(1), found.end()) for found in _VANISHED.finditer(line)]
    for place, (sign, depth) in enumerate(zip(line, depths(line), strict=True)):
        is_decimal = sign == "," and line[place - 1 : place].isdigit() and line[place + 1 : place + 2].isdigit()
        if sign in ",;，；" and depth <= 0 and not is_decimal:
            found.append((place, place + 1))
    return sorted(found, key=lambda cut: (cut[0], -cut[1]))  # "= 0 and": not before the word alone


def _rows(line: str) -> list[str]:
    """Return the equations of "[a, b; c, d] * [x; y] = [e; f]", row by row; none where it is nothing of the kind."""
    found = _MATRICES.fullmatch(_BRACKETS.sub("", line))
    if found is None:
        return []
    matrix, unknowns, right = ([_cells(row) for row in part.split(";") if row.strip()] for part in found.groups())
    columns = [cell for row in unknowns for cell in row]
    rest = [cell for row in right for cell in row]
    if len(rest) != len(matrix) or len(matrix) > _MOST_ROWS or any(len(row) != len(columns) for row in matrix):
        return []
    return [
        f"{' + '.join(f'({cell})*({name})' for cell, name in zip(row, columns, strict=True))} = {value}"
        for row, value in zip(matrix, rest, strict=True)
    ]


def _listed(line: str) -> list[str]:
    """Return the equations of a list that a program is given: "solve([a = b, c = d], [x, y])", "eqs := {a = b, c = d}"."""
    found = _LIST.match(line)
    inside = depths(line[found.end() :]) if found else []
    if found is None or -1 not in inside:
        return []
    pieces = [piece.strip() for piece in at_commas(line[found.end() : found.end() + inside.index(-1)])]
    return pieces if len(pieces) > 1 and all(map(relates_two_sides, pieces)) else []


def _cells(row: str) -> list[str]:
    return [cell.strip() for cell in at_commas(row) if cell.strip()]


def at_commas(row: str) -> Iterator[str]:
    """Give what stands between the commas of a row that are in no parentheses."""
    start = 0
    for place, (sign, depth) in enumerate(zip(row, depths(row), strict=True)):
        if sign == "," and depth == 0:
            yield row[start:place]
            start = place + 1
    yield row[start:]
