"""C and C++ as students write them, y->phi, *u = …, A << a, b, c, d; -> the same without pointers and streams of cells.

Enters: a text, the names of the task.  Leaves: the text with fields, values and matrices as elsewhere.  Used by `text_lines.py`.
"""

from __future__ import annotations

import math
import re

from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.systems.parts import at_commas

_POINTED = re.compile(r"(?<![\w.)\]])([^\W\d]\w{0,20})->([^\W\d]\w{0,20})")
_HAS_POINTERS = re.compile(r"\b(?:double|float|real)\s*\*\s*\w")
_SET, _VALUE = re.compile(r"(?m)(^[ \t]*|[;{][ \t]*)\*[ \t]*(\w{1,20})(?=[ \t]*=)"), re.compile(r"\(\*[ \t]*(\w{1,20})\)")
_CELLS = re.compile(r"(?m)(^|[;{])([ \t]*)([^\W\d]\w{0,20})[ \t]*<<[ \t]*([^;<>=]{3,2000});")
_TYPED = r"\b(?:Matrix|Vector)(\d?)\w?\b[^;]*?\b%s\b"
_SOLVED = re.compile(
    r"(?m)(^|[;{])[ \t]*(?:const[ \t]+)?(?:auto|(?:Eigen::)?Vector\w*)[ \t]+(?=\w+[ \t]*=)|(?<=\w)\.\w{1,24}\(\)(?=\.solve\()"
)
_BUILT = re.compile(r"(?m)(^|[;{])[ \t]*(?:Eigen::)?Vector\w*[ \t]+(\w{1,20})\(([^;=]*\*[^;=]*)\)(?=[ \t]*;)")
_ARRAY = re.compile(
    r"(?m)(^|[;{])[ \t]*(?:(?:const|static|double|float)[ \t]+)+([^\W\d]\w{0,20})\[[ \t]*\d?[ \t]*\][ \t]*=[ \t]*\{([^{}=]+)\}"
)


def without_pointers(text: str, spellings: Spellings) -> str:
    """Return a text with phi for y->phi and u for *u, with brackets around cells and arrays of formulas.

    What stands before an arrow may be a name of the task: w->a*b is its value.
    """
    if "->" in text:
        found = {one for one in _POINTED.findall(text) if spellings.angle(one[0]) is None and spellings.angle(one[1])}
        fields = {pointer: {field for other, field in found if other == pointer} for pointer, _ in found}
        text = _POINTED.sub(lambda one: one[2] if len(fields.get(one[1], ())) > 1 else one[0], text)
    if _HAS_POINTERS.search(text):
        text = _VALUE.sub(r"\1", _SET.sub(r"\1\2", text))
    if "<<" in text:
        text = _SOLVED.sub(r"\1", _CELLS.sub(lambda one: f"{one[1]}{one[2]}{one[3]} = {_matrix(one, text)};", text))
        text = _BUILT.sub(r"\1\2 = [\3]", text)
    return _ARRAY.sub(lambda one: f"{one[1]}{one[2]} = [{one[3]}]" if "*" in one[3] else one[0], text)


def _matrix(cells: re.Match[str], text: str) -> str:
    """Return the cells as rows of a square matrix if the name was declared as one, else as a vector; the line ends are kept."""
    found = [" ".join(cell.split()) for cell in at_commas(cells[4])]
    declared = re.search(_TYPED % re.escape(cells[3]), text[: cells.start()])
    wide = math.isqrt(len(found))
    is_matrix = wide * wide == len(found) and (declared is None or declared[0].startswith("Matrix"))
    rows = [found[place : place + wide] for place in range(0, len(found), wide)] if is_matrix else [[cell] for cell in found]
    return f"[{'; '.join(map(', '.join, rows))}]" + "\n" * cells[4].count("\n")
