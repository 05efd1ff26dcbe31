"""Lines of text, or a variant file -> the equations a student handed in, each a checked tree or a reason why not.

Enters: text with the names of the variant.  Leaves: `EquationLine`s.  The text is data: nothing in it is evaluated.
Used by `read_submission.py`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace

from coursework.grading.reading.equations.latex import without_latex
from coursework.grading.reading.equations.meanings import Meanings, key, meaning_of, put_in
from coursework.grading.reading.equations.names_in_text import BUILT_IN, Spellings, spellings_of
from coursework.grading.reading.equations.plain_text import without_labels
from coursework.grading.reading.equations.repair import repaired
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.student_work import EquationLine, EquationReading
from coursework.variant.formula import reader
from coursework.variant.formula.tree import Formula, FormulaFault, mapped
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

MORE_LINES = 20  # beyond twice the equations needed
_WORD = re.compile(r"[^\W\d]\w*")
_OWN_NAME = re.compile(r"[^\W\d][\w{}']{0,40}")


def most_lines(expected: Expected) -> int:
    """Return how many equations of a submission are read."""
    return 2 * len(expected.variant.sought) + MORE_LINES


def spellings_for(expected: Expected) -> Spellings:
    """Return the spellings of the names that equations may have."""
    return spellings_of(expected.variant, tuple((column.name, column.unit) for column in expected.grid.columns))


def read_line(text: str, file: str, line: int, expected: Expected, own: Meanings | None = None) -> EquationLine:
    """Return one line as an equation: as it stands where the strict reader takes it, else repaired, else with its fault.

    A line that can be meant in several ways has the others too: a label may be a number, a formula without a name the value of
    any velocity.  `own` are the definitions of the same text.
    """
    names = _Names(spellings_for(expected), expected, own or {})
    bare = without_labels(text)
    found: list[EquationReading] = []
    faults: list[Fault] = []
    for candidate in dict.fromkeys((bare, text)) if len(text) <= reader.MAX_CHARACTERS else (text,):
        read = _read(candidate, text, names)
        if isinstance(read, Fault):
            faults.append(replace(read, column=read.column + text.find(candidate)) if candidate != text else read)
        else:
            found.append(read)
    if found:
        first = found[0]
        return EquationLine(file, line, text, first.left, first.right, first.text, others=tuple(found[1:]))
    fault, others = faults[-1], _of_any_velocity(bare, names)
    if others:
        fault = Fault(say("fault.G063", example=f"{expected.variant.sought[0]} {bare.strip()}"[:80]), column=1)
    short = text[: reader.MAX_CHARACTERS]
    told = Fault(fault.message, file, line, fault.column)
    return EquationLine(
        file, line, short, None, None, fault=told, others=others, relates=len(names_in(short, names.spellings)) > 1
    )


def names_in(text: str, spellings: Spellings) -> set[str]:
    """Return the declared names that stand in a text by themselves, in any spelling; t and pi are no names here."""
    words = _WORD.findall(without_latex(text))
    return {known for word in words if (known := spellings.canonical(word)) is not None} - {*BUILT_IN}


def _read(text: str, whole: str, names: _Names) -> EquationReading | Fault:
    """Return a text as an equation, repaired where it must be; `whole` is the line as handed in."""
    strict = _strict(text, names)
    if not isinstance(strict, Fault):
        return EquationReading(*strict, "" if text == whole else text)
    if len(text) > reader.MAX_CHARACTERS:
        return strict
    better = repaired(text, names.spellings)
    read = _strict(better, names)
    if not isinstance(read, Fault):
        return EquationReading(*read, better)
    # Every sign was understood, a name was not: that is the fault to tell.
    return Fault(read.message, column=_column_of(read.place, text)) if read.place else strict


def _of_any_velocity(text: str, names: _Names) -> tuple[EquationReading, ...]:
    """Return what a formula of a spreadsheet may be, "=V1*SIN(…)": the value of any velocity that is sought."""
    if not text.lstrip().startswith("=") or len(text) > reader.MAX_CHARACTERS:
        return ()
    formula = text.lstrip(" =")
    found = (_read(f"{velocity} = {formula}", text, names) for velocity in names.expected.variant.sought)
    return tuple(reading for reading in found if not isinstance(reading, Fault))


def definition(text: str, expected: Expected, own: Meanings) -> tuple[str, Formula] | None:
    """Return the name and the formula of a line that defines a name of the student's own, None for any other line."""
    bare = without_labels(text)
    name, sign, formula = bare.partition("=")
    name = name.strip(" :$")
    spellings = spellings_for(expected)
    if (
        not sign
        or not formula.strip()
        or "=" in formula
        or not _OWN_NAME.fullmatch(name)
        or spellings.canonical(name) is not None
    ):
        return None
    read = _read(f"0 = {formula}", text, _Names(spellings, expected, own))
    return None if isinstance(read, Fault) else (key(name), read.right)


def is_equation_without_sign(text: str, expected: Expected) -> bool:
    """Return whether a line without "=" is the left side of an equation and not a line of prose."""
    if "=" in text or len(text) > reader.MAX_CHARACTERS or not any(sign in text for sign in "+-−*·"):
        return False
    spellings = spellings_for(expected)
    return not isinstance(_strict(repaired(without_labels(text), spellings), _Names(spellings, expected)), Fault)


def read_constraints(source: Source, file: str, expected: Expected) -> list[EquationLine]:
    """Return the equations of a variant file; files are strict, nothing in them is repaired."""
    entries = source.data.get("constraint")
    names = _Names(spellings_for(expected), expected)
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
        read = _strict(text, names)
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


@dataclass(frozen=True, slots=True)
class _Names:
    """What names in a line may be: those of the variant in any spelling, and what others mean."""

    spellings: Spellings
    expected: Expected
    own: Meanings = field(default_factory=dict)


def _strict(text: str, names: _Names) -> tuple[Formula, Formula] | Fault:
    """Return both sides with declared names, or the fault; its `place` is the name nobody declared."""
    try:
        sides = reader.parse_equation(text)
    except FormulaFault as fault:
        return Fault(fault.message, column=fault.column)
    meant: dict[str, Formula] = {}
    for node in (*sides[0].walk(), *sides[1].walk()):
        if node.op != "name" or names.spellings.canonical(node.name) is not None:
            continue
        meaning = meaning_of(node.name, names.expected, names.own)
        if meaning is None:
            advice = closest(node.name, sorted(names.spellings.known))
            return Fault(say("fault.G061", name=node.name[:40], hint=advice), column=node.column, place=node.name)
        meant[node.name] = meaning
    whole = put_in(Formula("-", sides), meant) if meant else Formula("-", sides)
    if whole is None:
        return Fault(say("fault.G064"), column=1)
    left, right = whole.args
    return _renamed(left, names.spellings), _renamed(right, names.spellings)


def _renamed(tree: Formula, spellings: Spellings) -> Formula:
    if tree.op == "name":
        return replace(tree, name=spellings.canonical(tree.name) or tree.name)
    return mapped(tree, lambda arg: _renamed(arg, spellings))


def _column_of(name: str, text: str) -> int:
    """Return where a name stands in the line as handed in, 1 where its spelling was another."""
    return max(text.find(name), 0) + 1
