"""A text line by line -> the equations and answers in it, alone or beside a table.

Enters: decoded text, `Expected`, how a table in the text was read.  Leaves: `Lines`.
Used by `read_submission.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise

from coursework.grading.reading.equations.answers import read_answer
from coursework.grading.reading.equations.equations import (
    definition,
    is_equation_without_sign,
    most_lines,
    names_in,
    read_line,
    spellings_for,
)
from coursework.grading.reading.equations.latex import logical_lines
from coursework.grading.reading.equations.meanings import key
from coursework.grading.reading.equations.names_in_text import Spellings
from coursework.grading.reading.equations.plain_text import without_labels
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.student_work import AnswerLine, EquationLine, Reading
from coursework.variant.formula.reader import MAX_CHARACTERS
from coursework.variant.formula.tree import Formula

_SIGNS = {";": ";", "tab": "\t"}  # a comma may stand in an equation, a blank always does
_EDGES = " \t;,\"'"  # what a spreadsheet puts round a line that was typed into one cell
_WORD = re.compile(r"[^\W\d]\w*")
# So many lines of a text are tried for each equation that may be handed in, and so many characters: each costs its time.
_TRIED, _CHARACTERS = 10, 60_000
_MOST_LINES, _MOST_DEFINITIONS = 20_000, 100


@dataclass(slots=True)
class Lines:
    """What stands in a text; `unread` counts the lines that may hold an equation too and were not tried."""

    equations: list[EquationLine] = field(default_factory=list)
    answers: list[AnswerLine] = field(default_factory=list)
    unread: int = 0


def read_lines(text: str, name: str, expected: Expected, beside: Reading | None = None) -> Lines:
    """Return the equations and answers in a text; `#` begins a remark, prose without "=" is passed over.

    `beside` is the table in the same text.  Its rows are passed over and do not count among the lines that are tried.  Its titles
    may hold "=" too (`h = 0.02 s`, `w1 = 13.08`): there an equation is what names a sought velocity and something it depends on,
    and lines that cannot be read are told only where others can.
    """
    most = most_lines(expected)
    lines = list(islice(_written(text) if beside is None else _beside(text, _SIGNS.get(beside.separator)), _MOST_LINES))
    own = _definitions(lines, expected) if beside is None else {}
    found, answers = Lines(), dict[str, AnswerLine]()
    tried = characters = 0
    for number, line in lines:
        tried, characters = tried + 1, characters + min(len(line), MAX_CHARACTERS)
        if tried > _TRIED * most or characters > _CHARACTERS or len(found.equations) > most:
            found.unread += "=" in line
        elif answer := _answer(line, name, number, expected):
            answers.setdefault(answer.name, answer)
        elif beside is None and _defines(line, own):
            continue
        elif beside is None and ("=" in line or is_equation_without_sign(line, expected)):
            found.equations += [read_line(part, name, number, expected, own) for part in parts_of(line)]
        elif beside is not None and relates(read := read_line(line, name, number, expected), expected):
            found.equations.append(read)
    if beside is not None and all(line.left is None for line in found.equations):
        found.equations = []
    found.answers = [*answers.values()]
    return found


def _written(text: str) -> Iterator[tuple[int, str]]:
    """Give the lines that are neither blank nor remarks with their numbers."""
    for number, line in logical_lines(text):
        bare = line.partition("#")[0].strip()
        if bare:
            yield number, bare


def parts_of(line: str) -> list[str]:
    """Return the equations of one line, parted by semicolons, or by commas that stand between two of them.

    >>> parts_of("w3 = 0,5*w1, w4 = atan2(1, w3)")
    ['w3 = 0,5*w1', 'w4 = atan2(1, w3)']
    """
    if line.count("=") < 2:
        return [line]
    depth, cuts = 0, [-1]
    for place, sign in enumerate(line):
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(sign, 0)
        is_decimal = sign == "," and line[place - 1 : place].isdigit() and line[place + 1 : place + 2].isdigit()
        if sign in ",;" and depth == 0 and not is_decimal and "=" in line[cuts[-1] + 1 : place]:
            cuts.append(place)
    pieces = [line[start + 1 : end].strip() for start, end in pairwise([*cuts, len(line)])]
    return pieces if all("=" in piece for piece in pieces) else [line]


def _beside(text: str, sign: str | None) -> Iterator[tuple[int, str]]:
    """Give the lines that may be an equation or an answer, with a name and "=", and no rows of a table separated by `sign`."""
    for number, line in _written(text):
        bare = line.strip(_EDGES)
        if "=" in bare and not (sign and sign in bare) and _WORD.search(bare):
            yield number, bare


def _answer(line: str, name: str, number: int, expected: Expected) -> AnswerLine | None:
    return read_answer(line[:500], name, number, expected.answers) if expected.answers else None


def _definitions(lines: Sequence[tuple[int, str]], expected: Expected) -> dict[str, Formula]:
    """Return the student's own names that other lines use, with their formulas; a later one may use those before it."""
    own: dict[str, Formula] = {}
    words = Counter(key(word) for _, line in lines for word in {*_WORD.findall(line)})
    for _, line in lines[:_MOST_DEFINITIONS]:
        if _own_name(line) and (found := definition(line, expected, own)) and words[found[0]] > 1:
            own.setdefault(*found)
    return own


def _own_name(line: str) -> str:
    """Return the one word on the left of a line, "" where more stands there."""
    left = without_labels(line).partition("=")[0].strip(" :$")
    return left if "=" in line and _WORD.fullmatch(left) else ""


def _defines(line: str, own: Mapping[str, Formula]) -> bool:
    return bool(own) and key(_own_name(line)) in own


def relates(read: EquationLine, expected: Expected) -> bool:
    """Return whether a line names a sought velocity and something it depends on."""
    named, sought = _names(read, spellings_for(expected)), {*expected.variant.sought}
    return bool(named & sought and named - sought - {"t"})


def _names(read: EquationLine, spellings: Spellings) -> set[str]:
    """Return the declared names in a line, of one that cannot be read those that stand by themselves."""
    if read.left is not None and read.right is not None:
        return {node.name for node in (*read.left.walk(), *read.right.walk()) if node.op == "name"}
    return names_in(read.text, spellings)
