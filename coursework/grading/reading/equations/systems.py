r"""A system that a program is given as matrices with names, A = [...], b = [...], x = A\b -> its equations, row by row.

Enters: a text.  Leaves: the text with the rows in the place of the matrix, the other pieces left out; as it stands where it is
nothing of the kind.  Nothing is computed.  Used by `lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.parts import at_commas
from coursework.grading.reading.equations.signs import depths

_DEFINED = re.compile(r"(?<![\w.])([^\W\d]\w{0,20})[ \t]*+:?=[ \t]*+(?:[A-Za-z]{1,12}\.)?(?:[A-Za-z]{1,12}[ \t]*+)?\(?\s*+(?=\[)")
_NAME = r"([^\W\d]\w{0,20})"
_PRODUCTS = (
    re.compile(rf"(?m)^[ \t]*{_NAME}[ \t]*(?:[*@·⋅×]|\.dot\()[ \t]*{_NAME}\)?[ \t]*={{1,2}}[ \t]*{_NAME}[ \t]*[;.]?[ \t]*$"),
    re.compile(
        rf"(?m)^[ \t]*(?:{_NAME}|[(\[]?((?:[^\W\d]\w{{0,20}}[ \t]*,[ \t]*)+[^\W\d]\w{{0,20}})[)\]]?)[ \t]*=[ \t]*(?:"
        rf"(?:[A-Za-z]{{1,9}}\.){{0,2}}(?:solve|linsolve|lsolve|LinearSolve)\s*[(\[]\s*{_NAME}\s*,\s*{_NAME}\s*[)\]]"
        rf"|{_NAME}[ \t]*\\[ \t]*{_NAME}|(?:[A-Za-z]{{1,9}}\.){{0,2}}inv\(\s*{_NAME}\s*\)[ \t]*[*@][ \t]*{_NAME})[ \t]*;?[ \t]*$"
    ),
)
_TAKEN = rf"(?m)(?:^|(?<=;))[ \t]*{_NAME}[ \t]*=[ \t]*%s[ \t]*[\[(][ \t]*(\d{{1,2}})[ \t]*[\])][ \t]*(?:;|$)"  # w1 = x(1)
_MOST, _MOST_ROWS, _LONGEST, _MOST_CHARACTERS = 20, 12, 4000, 200_000


def in_rows(text: str) -> str:
    r"""Return a text with the equations of a system in the place of its matrix.

    >>> in_rows("A = [a, b; c, d]; k = [e; f];\nw1, w2 = np.linalg.solve(A, k)")
    '(a)*(w1) + (b)*(w2) = e; (c)*(w1) + (d)*(w2) = f; ;\n'
    """
    is_one = "[" in text and len(text) < _MOST_CHARACTERS
    product = next((found for pattern in _PRODUCTS if is_one and (found := pattern.search(text))), None)
    if product is None:
        return text
    named = {name: (begin, end, rows) for name, begin, end, rows in _matrices(text)}
    groups = [group for group in product.groups() if group]
    matrix, unknowns, right = groups if product.re is _PRODUCTS[0] else (groups[1], groups[0], groups[2])
    taken = [] if "," in unknowns else sorted(re.finditer(_TAKEN % re.escape(unknowns), text), key=lambda found: int(found[2]))
    columns = [name.strip() for name in unknowns.split(",")] if "," in unknowns else _column(named, unknowns)
    columns = columns or [found[1] for found in taken]
    values = _column(named, right)
    rows = named[matrix][2] if matrix in named else []
    if not 0 < len(rows) == len(values) <= _MOST_ROWS or any(len(row) != len(columns) for row in rows):
        return text
    lines = [" + ".join(f"({cell})*({name})" for cell, name in zip(row, columns, strict=True)) for row in rows]
    equations = "; ".join(f"{line} = {value}" for line, value in zip(lines, values, strict=True))
    pieces = [(*named[name][:2], equations if name == matrix else "") for name in {matrix, unknowns, right} if name in named]
    pieces += [(*found.span(), "") for found in (product, *taken)]
    for begin, end, said in sorted(pieces, reverse=True):
        text = text[:begin] + said + "\n" * text.count("\n", begin, end) + text[end:]
    return text


def _matrices(text: str) -> list[tuple[str, int, int, list[list[str]]]]:
    """Return the matrices of a text: name, where each begins and ends, its rows of cells."""
    found = []
    for begun in list(_DEFINED.finditer(text))[:_MOST]:
        inside = depths(text[begun.end() : begun.end() + _LONGEST])
        if 0 not in inside:
            continue
        end = begun.end() + inside.index(0) + 1
        content = text[begun.end() + 1 : end - 1].replace("...", " ")
        listed = [row.strip(" \t\n[]") for row in at_commas(content)] if "[" in content else re.split(r"[;\n]", content)
        rows = [[cell.strip() for cell in at_commas(row) if cell.strip()] for row in listed]
        closed = end + (text[end : end + 1] == ")") if "(" in begun[0] else end
        found.append((begun[1], begun.start(), closed, [row for row in rows if row]))
    return found


def _column(named: dict[str, tuple[int, int, list[list[str]]]], name: str) -> list[str]:
    """Return the cells of a vector, lying or standing, [] where the name has none."""
    rows = named[name][2] if name in named else []
    return rows[0] if len(rows) == 1 else [row[0] for row in rows] if all(len(row) == 1 for row in rows) else []
