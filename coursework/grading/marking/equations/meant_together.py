"""Lines that are meant alike: a dash before all marks a list or is a minus; F(1) = … or cells =… are all residuals, or none.

Enters: lines, each with its possible readings, or their marks.  Leaves: the lines as they may be meant together, and files of
which not all can be meant.  Used by `equations.py`, `questions.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from coursework.grading.marking.equations.doubts import asked
from coursework.grading.reading.equations.formulas.labels import without_labels
from coursework.grading.reading.equations.text.list_marks import dash_apart
from coursework.grading.reading.student_work import EquationLine, EquationReading
from coursework.system.grouped import grouped
from coursework.words.sentences import say

_BEGINS = r"\s*(?:[(\[]?\d{1,3}[)\].:]{0,2}\s*)?(?=[-–—]"
# The second without a blank behind the dash; "- slider: v = …" has no minus.
_DASHED, _CLOSELY = re.compile(rf"{_BEGINS}\s(?![^\W\d_]{{3}}[^=:]*:\s))"), re.compile(rf"{_BEGINS})")
_SIGNS = re.compile(r"[\s\-–—−(]*")
_STEM = re.compile(r"\s*([^\d=]{1,20})\d{1,2}\s*+[)\]]?\s*+(?:\([\w\s,]*\))?\s*(?::?=|<-)")
_UNNAMED = "="


def as_lists_or_minus(
    lines: Sequence[EquationLine], is_right: Callable[[EquationLine], bool]
) -> Iterator[Sequence[EquationLine]]:
    """Yield the lines with their dashes as marks of a list, if all lines have one, and as minus signs; else as they are.

    A dash without a blank behind it may be a mark too where every line begins with a dash, though a minus is likelier. So may
    dashes before some lines only, if no other minus of the text is such a dash; any other before some lines is their minus, and
    a question where only the other meaning is right: the layout does not tell what it is, nor does that the equation is right.
    """
    read = [line for line in lines if line.tree is not None]
    dashed = [_DASHED.match(line.text) is not None for line in read]
    closely = len(read) > 1 and all(_CLOSELY.match(line.text) for line in read)
    is_list = len(read) > 1 and all(dashed)  # one line is none
    if not (closely or any(dashed)):
        yield lines
        return
    is_apart = dash_apart([line.text for line in read]) is not None
    for is_minus in (False, True) if is_list or is_apart else (True, False) if closely else (True,):
        dash = _CLOSELY if closely and not is_apart else _DASHED
        meant = [_meant(line, is_minus, dash) for line in lines]
        if any(dashed) and not is_list:
            others = [_meant(line, not is_minus, dash) for line in lines]
            asks = [one is not other and not is_right(one) and is_right(other) for one, other in zip(meant, others, strict=True)]
            columns = [len(one.text) - len(one.text.lstrip()) + 1 for one in meant]
            said = [asked(one, say("fault.G068"), column) for one, column in zip(meant, columns, strict=True)]
            meant = [question if is_asked else one for one, question, is_asked in zip(meant, said, asks, strict=True)]
        yield meant


def _meant(line: EquationLine, is_minus: bool, dash: re.Pattern[str]) -> EquationLine:
    """Return a line with those of its readings alone that keep its dash as a minus, or that leave it out; if any do."""
    begun = dash.match(line.text)
    if begun is None or line.tree is None:
        return line
    handed_in = _signs(line.text[begun.end() :])
    written = [(one, one.text or line.text) for one in (EquationReading(line.tree, line.repaired, line.guessed), *line.others)]
    kept = [
        one
        for one, text in written
        if (_signs(text) == handed_in) == is_minus and not ((found := dash.match(text)) and found[0].strip())
    ]
    if not kept:
        return line
    return line.read_as(kept[0], others=tuple(kept[1:]))


def _signs(text: str) -> int:
    """Return how many minus signs a formula begins with."""
    begun = _SIGNS.match(text)
    return sum(sign in "-–—−" for sign in begun[0]) if begun else 0


def as_others_of_their_kind(lines: Sequence[EquationLine], read: Sequence[tuple[EquationLine, bool]]) -> Iterator[EquationLine]:
    """Yield each line; one that is not right is read as "… = 0" if lines of its series are right in that reading.

    `read` has each line as it was read by itself, and whether it is right so.
    """
    pairs = [*zip(lines, read, strict=True)]
    vanishing = {_stem(line) for line, (one, is_right) in pairs if is_right and one.guessed and _vanishes(one.repaired)} - {""}
    for line, (one, is_right) in pairs:
        is_open = _stem(line) in vanishing and not _vanishes(one.repaired)
        meant = [other for other in line.others if is_open and _vanishes(other.text)]
        yield line.read_as(meant[0], others=(), fault=None, guessed=True) if meant and not is_right else line


def _stem(line: EquationLine) -> str:
    found = _STEM.match(line.text)
    if without_labels(line.text).lstrip().startswith(_UNNAMED):
        return _UNNAMED
    return found[1].strip() if found else ""


def _vanishes(text: str) -> bool:
    return text.endswith("= 0") or text.startswith("0 = ")


def contradicting(verdicts: Sequence[tuple[str, str]], needed: int) -> tuple[str, ...]:
    """Return the files that each hold as many lines as equations are needed, if only some of them are right throughout.

    `verdicts` has the file of each line and its verdict. Which of the files is meant, a person decides.
    """
    wrong = grouped((file, verdict == "wrong") for file, verdict in verdicts)
    whole = {file: any(lines) for file, lines in wrong.items() if len(lines) >= needed}
    return tuple(whole) if len({*whole.values()}) > 1 else ()
