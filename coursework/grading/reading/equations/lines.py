"""A text, line by line -> the equations and answers in it, whether it has a table beside them or not.

Enters: decoded text, `Expected`, how the table in the text was read (if any).  Leaves: `Lines`.
Used by `read_submission.py`.
"""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice, pairwise

from coursework.grading.reading.equations.answers import read_answer
from coursework.grading.reading.equations.formulas.denials import is_denied
from coursework.grading.reading.equations.formulas.edges import unwrapped
from coursework.grading.reading.equations.formulas.equations import (
    OWN_NAME,
    TURNED,
    WORD,
    Names,
    most_lines,
    names_for,
    names_in,
    names_of,
    read_as_one,
    read_line,
)
from coursework.grading.reading.equations.formulas.labels import without_labels, without_words
from coursework.grading.reading.equations.formulas.plain_text import plain
from coursework.grading.reading.equations.notation.signs import VANISHED, depths, plain_signs, relates_two_sides
from coursework.grading.reading.equations.systems.complex_factors import by_parts
from coursework.grading.reading.equations.systems.complex_lines import real_and_imaginary
from coursework.grading.reading.equations.systems.parts import parts_of
from coursework.grading.reading.equations.text.legends import with_each_index, with_legend
from coursework.grading.reading.equations.text.line_kinds import (
    definition,
    is_datum,
    is_equation_without_sign,
    is_law,
    is_question,
    is_row,
    is_step,
    is_vector_sum,
    only_names_a_term,
    own_name,
    says_nothing,
)
from coursework.grading.reading.equations.text.list_marks import sign_of_list
from coursework.grading.reading.equations.text.own_names import defines, definitions_of, may_vanish, says_more, sections_of
from coursework.grading.reading.equations.text.passed_over import as_questions
from coursework.grading.reading.equations.text.row_values import is_of_one_row
from coursework.grading.reading.equations.text.text_lines import text_lines
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.grading.reading.student_work import AnswerLine, EquationLine, Reading
from coursework.variant.formula.reader import MAX_CHARACTERS
from coursework.variant.formula.tree import constant
from coursework.words.errors import Fault

_SIGNS = {";": ";", "tab": "\t"}  # not the comma or the blank, which also occur in equations
# Of a table, with nothing but numbers.
_ROW = re.compile(r"^[-+−]?\d[^;\t ,\n]*+(?:[;\t ]|,[^,\n]*+,)[-+−\d.,eE;\t ]*+$", re.MULTILINE)
_ON_THE_RIGHT = re.compile(r"[vV]_?[A-Z]\w{0,2}|[^\W\d_]")  # the velocity of a point, or a letter
_EDGES = " \t;,\"'"  # signs that a spreadsheet puts around a line typed into one cell
_COMMENTED = re.compile(r"^[ \t]*(?:#+|//+|%+)[ \t]*(?=[^\s=])", re.MULTILINE)  # the sign of a line that is a comment
# Limits on time: per equation that may be handed in, so many lines of a text are tried; in all, so many characters. A
# line longer than a formula counts more than it has: its time grows with the square of its length.
_TRIED, _CHARACTERS = 10, 60_000
_MOST_TEXT = 1_000_000  # characters of a text that are looked through for such lines
_MOST_LINES, _MOST_SIDES, _MOST_JOINED = 20_000, 3, 20


@dataclass(slots=True)
class Lines:
    """The equations and answers of a text; `unread` counts the lines with "=" that were not tried, any of which may be one.

    `passed` are lines that are no equations, but may hold one that is missing.
    """

    equations: list[EquationLine] = field(default_factory=list)
    passed: list[EquationLine] = field(default_factory=list)
    answers: list[AnswerLine] = field(default_factory=list)
    unread: int = 0


_Kept = Callable[[EquationLine], EquationLine | None]


def read_lines(text: str, name: str, expected: Expected, beside: Reading | None = None, kept: _Kept = lambda line: line) -> Lines:
    """Return the equations and answers in a text; `#` begins a comment, prose without "=" is skipped.

    `beside` is the table in the same text, None if it has none.  Its rows are skipped and do not count as lines that were tried.
    Its titles may contain "=" too (`h = 0.02 s`, `w1 = 13.08`), so beside a table a line is an equation only if it names a sought
    velocity and something that this depends on; unreadable lines are kept only if others can be read.  `kept` filters the lines
    of a document, where "=" is frequent: it returns the line to keep, or None, and then the line does not count as an equation.
    If there is no equation outside comments, those in comments count as far as they are right.
    """
    found = _read_lines(text, name, expected, beside, kept)
    if beside is None and not found.equations and (said := _COMMENTED.sub("", text)) != text:
        again = _read_lines(said, name, expected, beside, kept)
        if any(line.tree is not None for line in again.equations):
            lines = (replace(line, may_be_datum=line.tree is not None) for line in again.equations)
            found.equations, found.passed = [line for line in lines if line.tree is not None or line.relates], again.passed
    if beside is None and found.equations:
        found.equations += filter(None, map(kept, found.passed))
    return found


def _read_lines(text: str, name: str, expected: Expected, beside: Reading | None, kept: _Kept) -> Lines:
    most = most_lines(expected)
    names = names_for(expected)
    passed = list[tuple[int, str]]()
    end = text.rfind("\n", 0, _MOST_TEXT) + 1 if len(text) > _MOST_TEXT else len(text)  # no part of a line is an equation
    beyond = sum("=" in line for line in text[end:].split("\n"))
    text = text[:end]
    pieces = _pieces(text, names, passed) if beside is None else _beside(text, names, _SIGNS.get(beside.separator))
    names, lines = with_legend(list(islice(pieces, _MOST_LINES)), names)
    lines = _names_first(lines, names) if beside is None else lines
    sections = sections_of(lines, names) if beside is None else [len(lines)]
    meanings = definitions_of(lines, names, sections) if beside is None else [{}]
    listed = sign_of_list([line for _, line in lines if relates_two_sides(line[:EQUATION_CHARACTERS])], names.spellings.canonical)
    reader = _Reader(name, text.split("\n"), sorted({number for number, _ in lines}), names, kept, passed)
    found, answers, tried, characters = Lines(unread=beyond), dict[str, AnswerLine](), 0, 0
    with_own, defined = names, set[str]()
    for place, (number, line) in enumerate(lines):
        if place in {0, *sections}:
            own, defined = meanings[bisect(sections, place)], set()
            with_own = replace(names, own=own, spellings=names.spellings.with_own(own), listed=listed)
        length = min(len(line), EQUATION_CHARACTERS)
        tried, characters = tried + 1, characters + max(length, length**2 // MAX_CHARACTERS)
        if tried > _TRIED * most or characters > _CHARACTERS or sum(line.may_be_one for line in found.equations) > most:
            found.unread += "=" in line
        elif expected.answers and (answer := read_answer(line[:500], expected.answers)):
            answers.setdefault(answer.name, answer)
        elif is_denied(line[:EQUATION_CHARACTERS], names.is_single):
            passed.append((number, line))
        elif beside is not None:
            read = reader.as_equation(number, line, names)
            found.equations += [read] if relates(read, names) else []
        else:
            found.equations += reader.equations_in(number, line, with_own, defined)
    if beside is not None and all(line.tree is None for line in found.equations):
        found.equations = []
    checks = [is_of_one_row(line, names) for line in found.equations]
    if not all(checks):  # some lines are true equations
        found.equations = [
            replace(line, may_be_datum=line.may_be_datum or one) for line, one in zip(found.equations, checks, strict=True)
        ]
    found.answers, found.passed = [*answers.values()], as_questions(passed, reader.named, name, names, found.equations)
    return found


@dataclass(slots=True)
class _Reader:
    """What each line of a text is: an equation, or one of those that are `passed` over or give a `named` formula.

    `names` are those of the task; `handed_in` has the lines of the `file` as they are, of which the numbers in `begun` begin one
    of those that were read.
    """

    file: str
    handed_in: Sequence[str]
    begun: Sequence[int]
    names: Names
    kept: _Kept
    passed: list[tuple[int, str]]
    named: list[tuple[int, str]] = field(default_factory=list)

    def as_equation(self, number: int, line: str, names: Names) -> EquationLine:
        """Return a line as an equation, with the line of the file that it is from."""
        following = next((other for other in self.begun[bisect(self.begun, number) :]), number + _MOST_JOINED)
        source = "\n".join(self.handed_in[number - 1 : min(following - 1, number + _MOST_JOINED)])
        is_other = source != line and len(source) <= EQUATION_CHARACTERS
        return replace(read_line(line, self.file, number, names), source=source if is_other else "")

    def equations_in(self, number: int, line: str, names: Names, defined: set[str]) -> list[EquationLine]:
        """Return the equation that a line is, [] if it is none; `names` has the student's own, of which some are `defined`."""
        is_named = defines(line, names, defined)
        is_chain = not is_named and line.count("=") > 1 and not VANISHED.search(line) and definition(line, names) is not None
        if is_named or (is_chain and not says_more(line, names)):
            self.named.append((number, line))
            return self._at_rest(number, line, names)
        bare = unwrapped(line)  # (t = 0)
        if any(is_other(bare, self.names) for is_other in (is_datum, is_step, is_question, is_law)) or is_row(bare):
            return self._at_rest(number, line, names)
        line = "=".join(line.split("=")[:2]) if is_chain else line  # i = (R + r)/r = 1 + R/r
        one = self.kept(self.as_equation(number, line, names)) if _is_equation(line, self.names) else None
        if one and is_vector_sum(line, self.names):  # of one axis, if its parts are defined so
            one = replace(one, may_be_datum=True) if one.tree else None
        is_aside = bare != line and one and one.tree is not None and constant(one.tree.args[1]) not in {None, 0}  # (w1 = 3)
        if one and one.tree is not None and (is_aside or only_names_a_term(line, one.tree, names)):
            one = replace(one, may_be_datum=True)
        if one and (one.tree is not None or not says_nothing(line, names)):
            return [one]
        self.passed.append((number, line))
        return self._at_rest(number, line, names)

    def _at_rest(self, number: int, line: str, names: Names) -> list[EquationLine]:
        """Return the line of a point's velocity, V_P = …, as it is if the point rests; it counts only if it is right so."""
        zero = may_vanish(line, names)
        one = self.kept(self.as_equation(number, line, names)) if zero else None
        return [one.read_as(zero, fault=None, others=(), guessed=True, may_be_datum=True)] if zero and one else []


def _pieces(text: str, names: Names, passed: list[tuple[int, str]]) -> Iterator[tuple[int, str]]:
    """Yield the equations and answers; one line may contain several.  What is none is added to `passed`."""
    for number, line in text_lines(text, names, passed):
        for part in (one for piece in parts_of(line) for one in with_each_index(piece, names)):
            yield from ((number, one) for one in _apart(part, names))


def _names_first(lines: Sequence[tuple[int, str]], names: Names) -> list[tuple[int, str]]:
    """Return the lines with "vA = r*w1" for "r*w1 = vA", where no line before or behind has the student's name on the left."""
    found = [*lines]
    bare = [without_words(without_labels(line[:EQUATION_CHARACTERS]), names.is_name) for _, line in lines]
    left = {line.partition("=")[0].strip() for line in bare}
    for place, ((number, _), line) in enumerate(zip(lines, bare, strict=True)):
        formula, _, right = (side.strip(" .;,") for side in line.partition("="))
        if _ON_THE_RIGHT.fullmatch(right) and right not in left and not OWN_NAME.fullmatch(formula) and -1 not in depths(formula):
            said = f"{right} = {formula}"
            if own_name(said, names.spellings)[0]:
                found[place] = number, said
                left.add(right)
    return found


def _apart(line: str, names: Names) -> list[str]:
    """Return the two parts of an equation of complex numbers; else vP = … = … as two equations, if they give one velocity by
    different others and so are no steps of one; else the line. The name may stand last.
    """
    if parts := real_and_imaginary(line) or by_parts(line, names.spellings):
        return parts
    sought = {*names.expected.variant.sought}
    name, *sides = line.split("=") if 2 <= line.count("=") <= _MOST_SIDES else [line]
    if is_behind := bool(sides) and OWN_NAME.fullmatch(sides[-1].strip(" .;,")) is not None and TURNED.search(plain_signs(name)):
        *sides, name = name, *sides
    found = [names_in(side, names.spellings) & sought for side in sides]
    if (
        len(found) < 2
        or not all(map(TURNED.search, map(plain_signs, sides)))
        or any(one <= other for one in found for other in found if one is not other)
        or any(isinstance(read := read_as_one(f"{side} = 0", names), Fault) and not read.place for side in sides)
    ):
        return [line]
    if not isinstance(read_as_one(f"0 = {name}", names), Fault) and TURNED.search(plain_signs(name)):
        own = names_in(name, names.spellings) & sought
        is_apart = own and not any(own <= other or other <= own for other in found)
        return [f"{one} = {other}" for one, other in pairwise([name, *sides])] if is_apart else [line]  # the law of sines
    called = WORD.findall(plain(name, names.spellings))
    is_sought = called and names.spellings.canonical(called[-1]) in sought
    return [f"{side} = {name}" if is_behind else f"{name} = {side}" for side in sides] if is_sought else [line]


def _beside(text: str, names: Names, sign: str | None) -> Iterator[tuple[int, str]]:
    """Yield the lines with a name and "=" that may be equations or answers; skip table rows, which contain `sign`."""
    for number, line in text_lines(_ROW.sub("", text), names):
        bare = line.strip(_EDGES)
        if relates_two_sides(bare) and not (sign and sign in bare) and WORD.search(bare):
            yield number, bare


def _is_equation(line: str, names: Names) -> bool:
    return "=" in line or relates_two_sides(line[:EQUATION_CHARACTERS]) or is_equation_without_sign(line, names)


def relates(read: EquationLine, names: Names) -> bool:
    """Return whether a line names a sought velocity and another name than a sought velocity or t."""
    named, sought = names_of(read, names), {*names.expected.variant.sought}
    return bool(named & sought and named - sought - {"t"})
