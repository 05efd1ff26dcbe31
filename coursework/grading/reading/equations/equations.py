"""Lines of text, or a variant file -> the equations a student handed in, each a checked tree or a reason why not.

Enters: text with the names of the variant.  Leaves: `EquationLine`s.  The text is data: nothing in it is evaluated.
Used by `read_submission.py`.
"""

from __future__ import annotations

from dataclasses import replace

from coursework.grading.reading.equations.names_in_text import Spellings, spellings_of
from coursework.grading.reading.equations.repair import repaired
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula import reader
from coursework.variant.formula.tree import Formula, FormulaFault, mapped
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

MORE_LINES = 20  # beyond twice the equations needed


def most_lines(expected: Expected) -> int:
    """Return how many equations of a submission are read."""
    return 2 * len(expected.variant.sought) + MORE_LINES


def spellings_for(expected: Expected) -> Spellings:
    """Return the spellings of the names that equations may have."""
    return spellings_of(expected.variant, tuple((column.name, column.unit) for column in expected.grid.columns))


def read_line(text: str, file: str, line: int, spellings: Spellings) -> EquationLine:
    """Return one line as an equation: as it stands where the strict reader takes it, else repaired, else with its fault."""
    strict = _strict(text, spellings)
    if not isinstance(strict, Fault):
        return EquationLine(file, line, text, *strict)
    if len(text) <= reader.MAX_CHARACTERS:
        better = repaired(text, spellings)
        read = _strict(better, spellings)
        if not isinstance(read, Fault):
            return EquationLine(file, line, text, *read, repaired=better)
        if read.place:  # every sign was understood, a name was not: that is the fault to tell
            strict = Fault(read.message, column=_column_of(read.place, text))
    return EquationLine(
        file, line, text[: reader.MAX_CHARACTERS], None, None, fault=Fault(strict.message, file, line, strict.column)
    )


def is_equation_without_sign(text: str, spellings: Spellings) -> bool:
    """Return whether a line without "=" is the left side of an equation and not a line of prose."""
    if "=" in text or len(text) > reader.MAX_CHARACTERS or not any(sign in text for sign in "+-−*·"):
        return False
    return not isinstance(_strict(repaired(text, spellings), spellings), Fault)


def read_constraints(source: Source, file: str, spellings: Spellings) -> list[EquationLine]:
    """Return the equations of a variant file; files are strict, nothing in them is repaired."""
    entries = source.data.get("constraint")
    lines: list[EquationLine] = []
    for place, entry in enumerate(entries if isinstance(entries, list) else []):
        if not isinstance(entry, dict):
            continue
        key = "equation" if "equation" in entry else "closure"
        text = entry.get(key)
        line = source.positions.find(("constraint", place, key))[0]
        if not isinstance(text, str):
            continue
        if key == "closure":
            fault = Fault(say("fault.G062"), file, line)
            lines.append(EquationLine(file, line, text[: reader.MAX_CHARACTERS], None, None, fault=fault))
            continue
        read = _strict(text, spellings)
        if isinstance(read, Fault):
            fault = Fault(read.message, file, line, read.column)
            lines.append(EquationLine(file, line, text[: reader.MAX_CHARACTERS], None, None, fault=fault))
        else:
            lines.append(EquationLine(file, line, text, *read))
    return lines


def faults_as_lines(error: InputError, file: str) -> list[EquationLine]:
    """Return what makes a variant file unreadable as one line that cannot be read."""
    fault = error.faults[0]
    return [EquationLine(file, fault.line, "", None, None, fault=fault)]


def _strict(text: str, spellings: Spellings) -> tuple[Formula, Formula] | Fault:
    """Return both sides with declared names, or the fault; its `place` is the name nobody declared."""
    try:
        left, right = reader.parse_equation(text)
    except FormulaFault as fault:
        return Fault(fault.message, column=fault.column)
    for node in (*left.walk(), *right.walk()):
        if node.op == "name" and spellings.canonical(node.name) is None:
            advice = closest(node.name, sorted(spellings.known))
            return Fault(say("fault.G061", name=node.name[:40], hint=advice), column=node.column, place=node.name)
    return _renamed(left, spellings), _renamed(right, spellings)


def _renamed(tree: Formula, spellings: Spellings) -> Formula:
    if tree.op == "name":
        return replace(tree, name=spellings.canonical(tree.name) or tree.name)
    return mapped(tree, lambda arg: _renamed(arg, spellings))


def _column_of(name: str, text: str) -> int:
    """Return where a name stands in the line as handed in, 1 where its spelling was another."""
    return max(text.find(name), 0) + 1
