"""A text line by line -> the equations and answers in it, alone or beside a table.

Enters: decoded text, `Expected`.  Leaves: `EquationLine`s and `AnswerLine`s.
Used by `understand.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from coursework.grading.answers import read_answer
from coursework.grading.contents import AnswerLine, EquationLine, Reading
from coursework.grading.equations import is_equation_without_sign, most_lines, read_line, spellings_for
from coursework.grading.expected import Expected
from coursework.grading.names_in_text import Spellings

_SIGNS = {";": ";", "tab": "\t"}  # a comma may stand in an equation, a blank always does
_EDGES = " \t;,\"'"  # what a spreadsheet puts round a line that was typed into one cell
_WORD = re.compile(r"[^\W\d]\w*")
_TRIED = 10  # lines of a text that are tried for each equation that may be handed in


def read_lines(text: str, name: str, expected: Expected) -> tuple[list[EquationLine], list[AnswerLine]]:
    """Return the equations and answers in a text; `#` begins a remark, prose without "=" is passed over."""
    spellings = spellings_for(expected)
    most = most_lines(expected)
    equations: list[EquationLine] = []
    answers: dict[str, AnswerLine] = {}
    for number, line in islice(_written(text), _TRIED * most):
        if answer := _answer(line, name, number, expected):
            answers.setdefault(answer.name, answer)
        elif "=" in line or is_equation_without_sign(line, spellings):
            equations.append(read_line(line, name, number, spellings))
        if len(equations) > most:
            break
    return equations, list(answers.values())


def lines_beside_table(text: str, reading: Reading, expected: Expected) -> tuple[list[EquationLine], list[AnswerLine]]:
    """Return the equations and answers above or below a table in one text.

    Titles of tables hold "=" too (`h = 0.02 s`, `w1 = 13.08`), so an equation is what names a sought velocity and something it
    depends on; lines that cannot be read are told only where others can.  Rows of the table are passed over and do not count
    among the lines that are tried.
    """
    spellings = spellings_for(expected)
    most = most_lines(expected)
    sought = {*expected.variant.sought}
    sign = _SIGNS.get(reading.separator)
    equations: list[EquationLine] = []
    answers: dict[str, AnswerLine] = {}
    for number, bare in islice(_beside(text, sign), _TRIED * most):
        if answer := _answer(bare, reading.file, number, expected):
            answers.setdefault(answer.name, answer)
            continue
        read = read_line(bare, reading.file, number, spellings)
        named = _names(read, spellings)
        if named & sought and named - sought - {"t"}:
            equations.append(read)
        if len(equations) > most:
            break
    return (equations if any(line.left is not None for line in equations) else []), list(answers.values())


def _written(text: str) -> Iterator[tuple[int, str]]:
    """Give the lines that are neither blank nor remarks with their numbers."""
    for number, line in enumerate(text.split("\n"), start=1):
        bare = line.partition("#")[0].strip()
        if bare:
            yield number, bare


def _beside(text: str, sign: str | None) -> Iterator[tuple[int, str]]:
    """Give the lines that may be an equation or an answer, with a name and "=", and no rows of a table separated by `sign`."""
    for number, line in _written(text):
        bare = line.strip(_EDGES)
        if "=" in bare and not (sign and sign in bare) and _WORD.search(bare):
            yield number, bare


def _answer(line: str, name: str, number: int, expected: Expected) -> AnswerLine | None:
    return read_answer(line[:500], name, number, expected.answers) if expected.answers else None


def _names(read: EquationLine, spellings: Spellings) -> set[str]:
    """Return the declared names in a line, of one that cannot be read those that stand by themselves."""
    if read.left is not None and read.right is not None:
        return {node.name for node in (*read.left.walk(), *read.right.walk()) if node.op == "name"}
    return {known for word in _WORD.findall(read.text) if (known := spellings.canonical(word)) is not None}
