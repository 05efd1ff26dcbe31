"""Lines with an equals sign that were passed over -> questions, in case the equations that were read are too few.

Enters: the lines, `Names`.  Leaves: `EquationLine`s that were not read.  Used by `lines.py`.
A comment, a statement of a program or a sentence may hold the very equation that is missing: a person must look at it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.grading.reading.equations.formulas.equations import TURNED, WORD, Names, names_in
from coursework.grading.reading.equations.notation.signs import plain_signs, relates_two_sides
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.grading.reading.student_work import EquationLine
from coursework.words.errors import Fault
from coursework.words.sentences import say

_MOST = 3
_PRODUCT = re.compile(r"[*·/]")


def as_questions(
    passed: Sequence[tuple[int, str]],
    named: Sequence[tuple[int, str]],
    file: str,
    names: Names,
    read: Sequence[EquationLine],
) -> list[EquationLine]:
    """Return the first lines that may be velocity equations: with a sine, a sought velocity and another name than velocities.

    Those `named` were taken for the definition of a name of the student, and asked about only if no equation has that name.
    """
    taken = {line.line for line in read}
    found = [
        EquationLine(
            file, number, line.strip(), fault=Fault(say("fault.G072"), file, number, 1),
            relates=True, passed_over=True, is_partial=lines is named,
        )
        for lines in (passed, named)
        for number, line in lines
        if number not in taken
        and not (lines is named and _is_used(line, read))
        and _may_be_one(line[:EQUATION_CHARACTERS], names)
    ]  # fmt: skip
    return found[:_MOST]


def _is_used(line: str, read: Sequence[EquationLine]) -> bool:
    """Return whether the name that a line defines stands in an equation, so that its formula is read there."""
    name = line.partition("=")[0].strip(" :$\\{}")
    return any(name in one.text for one in read)


def _may_be_one(text: str, names: Names) -> bool:
    """Return whether a text with a sine names a sought velocity and something else, or mostly what is unknown: $B$1*SIN(D8)."""
    if not relates_two_sides(text) or not TURNED.search(plain_signs(text)):
        return False
    named, variant = names_in(text, names.spellings), names.expected.variant
    words = WORD.findall(plain_signs(text))
    is_unknown = 2 * sum(map(names.is_name, words)) < len(words) and _PRODUCT.search(text) is not None
    return is_unknown or (bool(named & {*variant.sought}) and bool(named - {*variant.velocities, *variant.sought}))
