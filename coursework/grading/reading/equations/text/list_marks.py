"""The marks of lines: dashes, numbers that count up by one, numbers of the lines of a program.

Enters: lines.  Leaves: the pattern of their mark, or the text without its numbers.
Used by `lines.py`, `text_lines.py` and `meant_together.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import pairwise

from coursework.grading.reading.equations.formulas.equations import DASH
from coursework.grading.reading.equations.formulas.labels import without_labels

_COUNT = re.compile(r"^\s*([A-Z]{0,2}\.?)(\d{1,2}(?:\.\d{1,2})*)\s+(?=[\w(\\+−-])")  # the number of a line in a list: 1.1, L2
_DASHED = re.compile(r"^\s*(\d{1,2})\s?[-–—]\s+")  # the lines 1-, 2-, 3- … of a list
_LONG_DASH = re.compile(r"\s*[–—]\s+")
_APART = re.compile(r"^\s*[-–—]\s+")  # a dash with a blank behind it: the mark of an item, or a minus; − is a minus
_CELL = re.compile(r'^\s*"?(\d{1,3})"?,\s*"?')  # the number of a row and its comma in a file of cells
_CELL_OF_LETTERS = re.compile(rf"{_CELL.pattern}[^\d\s]")
_LINE_NUMBER = re.compile(r"^\s*(\d{1,5})\s+(?=[^\W\d])")
_STEPS, _SEVERAL_LINES = (5, 10, 100), 2


def sign_of_list(lines: Sequence[str], is_name: Callable[[str], object]) -> re.Pattern[str] | None:
    """Return the pattern of the marks of lines: a dash, growing numbers and a comma, numbers that count up by one; None if none.

    A dash before some lines only may be a mark or a minus, and is read as both.

    >>> texts = ["- a = b", "- c = d"], ["1.1 a = b", "1.2 c = d"], ["2 a = b", "0.5 c = d"]
    >>> [bool(sign_of_list(lines, {"r1"}.__contains__)) for lines in texts]
    [True, True, False]
    """
    if len(lines) > 1 and all(DASH.match(without_labels(line)) for line in lines):
        return DASH
    if dash := dash_apart(lines):
        return re.compile(rf"^\s*{dash}\s+")
    cells = [int(found[1]) for line in lines if (found := _CELL.match(line))]
    if len(lines) == len(cells) > 1 and cells == sorted({*cells}) and any(map(_CELL_OF_LETTERS.match, lines)):
        return _CELL
    dashed = [int(found[1]) for line in lines if (found := _DASHED.match(line))]
    if len(dashed) == len(lines) > 1 and dashed == [*range(1, len(lines) + 1)]:
        return _DASHED
    begun = [found for line in lines if (found := _COUNT.match(line)) and not (found[1] and is_name(found[1] + found[2]))]
    numbers = [([found[1], *found[2].split(".")[:-1]], int(found[2].rpartition(".")[2])) for found in begun]
    steps = [(one[0] == other[0], other[1] - one[1]) for one, other in pairwise(numbers)]
    if steps and all(step == (True, 1) for step in steps):
        return _COUNT
    return _APART if any(_APART.match(without_labels(line)) for line in lines) else None


def dash_apart(lines: Sequence[str]) -> str | None:
    """Return the long dash with a blank that some lines begin with, if it is no minus in any of them; None if there is none.

    >>> dash_apart(["– a - b = 0", "-a = c"]), dash_apart(["– a – b = 0", "a = c"]), dash_apart(["- a = 0"])
    ('–', None, None)
    """
    bare = map(without_labels, lines)
    begun = [(found[0].strip(), line[found.end() :]) if (found := _LONG_DASH.match(line)) else ("", line) for line in bare]
    dashes = {dash for dash, _ in begun} - {""}
    return min(dashes) if len(dashes) == 1 and not any(dashes & {*rest} for _, rest in begun) else None


def without_line_numbers(text: str) -> str:
    r"""Return a program without the numbers of its lines, 10, 20, 30 …, as BASIC has them.

    >>> without_line_numbers("10 V = 1\n20 W = 2\n30 END"), without_line_numbers("2 a = b\n3 c = d\n")
    ('V = 1\nW = 2\nEND', '2 a = b\n3 c = d\n')
    """
    lines = text.split("\n")
    begun = [_LINE_NUMBER.match(line) for line in lines if line.strip()]
    numbers = [int(found[1]) for found in begun if found]
    steps = {after - before for before, after in pairwise(numbers)}
    is_numbered = len(numbers) == len(begun) > _SEVERAL_LINES and len(steps) == 1 and min(steps) in _STEPS
    return "\n".join(_LINE_NUMBER.sub("", line) for line in lines) if is_numbered else text
