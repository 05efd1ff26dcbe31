"""A line that is wrong as it was read -> the question to a person whether it was read as it is meant.

Enters: a line, whether a single slip explains it, a test for right formulas.  Leaves: the line as a question, or None.
Used by `equations.py` and `meant_together.py`.
A slip of the pen is one edit, or leaves an equation between quantities of one dimension; what was misread seldom does.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from dataclasses import replace

from coursework.grading.reading.equations.formulas.names_in_text import plain_name
from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.alphabet import greek
from coursework.variant.formula.reader import FUNCTION_WORDS
from coursework.variant.formula.tree import Formula, constant, spelled, terms
from coursework.variant.record.places import has_one_dimension
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_NAME = re.compile(r"[^\W\d]\w*")
_SPEED = re.compile(r"\s*([vV]\w{0,12})\s*:?=")
_CONTINUES = re.compile(r"\s*[+*/·]")
_SHORT, _TWO_SIDES = 2, 1  # signs of equality in a line with two sides


def speed_given_by(line: EquationLine) -> str:
    """Return the name of a speed before "=" as it was typed, "" if the line gives none."""
    found = _SPEED.match(line.text)
    return plain_name(found[1]) if found else ""


def question_of(
    line: EquationLine, variant: Variant, tells: Callable[[Formula], bool], speeds: Collection[str], *, is_named: bool
) -> EquationLine | None:
    """Return a wrong line as a question to a person, None if it is an equation and wrong.

    It is right without a word or letter at its edge; or no single slip explains it (`is_named`) and it was completed, is a chain
    of which some sides were passed over, begins with a sign as if it continued another, was rewritten to be read, or gives a
    speed under another name, vx, where lines give other `speeds`, too: one may be that of another point.
    """
    if meant := next((other for other in line.others if other.asks and tells(other.tree)), None):
        return asked(line, say("fault.G069", text=meant.text))
    is_cut = line.guessed or line.text.count("=") > _TWO_SIDES or _CONTINUES.match(line.text) is not None
    is_cut |= len(speeds) > 1 and speed_given_by(line) not in {"", *line.difference.names()}
    if is_named or not (is_cut or _is_rewritten(line, variant)):
        return None
    return asked(line, say("fault.G071", text=line.repaired or " = ".join(map(spelled, line.difference.args))))


def asked(line: EquationLine, question: Sentence, column: int = 1) -> EquationLine:
    """Return a line as one that could not be read, with the question to a person as its fault."""
    fault = Fault(question, line.file, line.line, column)
    return replace(line, tree=None, repaired="", fault=fault, others=(), relates=True)


def _is_rewritten(line: EquationLine, variant: Variant) -> bool:
    """Return whether a line has not one name for each name of its formula, or others and no one dimension.

    So it has names of the student, glued ones, or words that were left out; "1- r*ω" has other names, and 1 is no r*ω.
    """
    typed = [word for word in _NAME.findall(line.text) if word.lower() not in FUNCTION_WORDS]
    read = [node.name for node in line.difference.walk() if node.op == "name"]
    words = (word for word in typed if len(word) > _SHORT and word.isascii() and word.isalpha() and greek(word) == word)
    if len(typed) != len(read) or any(word not in read for word in words):
        return True
    if {*typed} <= {*read}:
        return False
    has_number = any(constant(term) not in {None, 0} for side in line.difference.args for term in terms(side))
    return has_number or not has_one_dimension(line.difference, variant)
