"""Whether a line is a value, reason or check of some row, as "w3 = 6.12", and so none of the equations needed.

Enters: a line as it was read, `Names`.  Leaves: the answer.  Used by `lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.formulas.equations import Names, names_in, names_of
from coursework.grading.reading.equations.notation.signs import VANISHED
from coursework.grading.reading.student_work import EquationLine
from coursework.grading.reading.unit_names import unit_of

_MEASURED, _CHECKED = re.compile(r"\d[.,]\d\d"), re.compile(r"[=≈]\s*[-+−]?\d+[.,]\d\d+(?:\s+[^\s\d]\S{0,7})?[.,;]?\s*$")
_AT_ONE_TIME = re.compile(r"[^=]{0,20}\bt\s*=\s*\d[\d.,]*\D")  # for t = 0: ω2 = -2.1
_UNIT_BEHIND = re.compile(r"\d\s+(\S{1,8}?)[.,;]?\s*$")
_ANALOG = re.compile(r"(?<![^\W\d_])d\s*[^\W\d]\w*\s*\)?\s*/\s*\(?\s*d\s*(?!t\b)[^\W\d]")
_STANDS = re.compile(
    r"(?:[^\W\d_]{2,12}[\s:,]+){0,5}[vV]_?\{?[A-Z]?[xy]?\}?\s*=\s*0\s*[.,;]?\s*"
)  # V_C = 0: why an equation holds


def is_of_one_row(read: EquationLine, names: Names) -> bool:
    """Return whether a line relates only sought velocities and numbers, as "w3 = 6.12": a value, reason or check of some row."""
    named = names_of(read, names) if read.tree is not None else set[str]()
    variant = names.expected.variant
    if len(named) == 1 and _STANDS.fullmatch(read.text.strip()):
        return True
    if (found := _UNIT_BEHIND.search(read.text)) and unit_of(found[1]):
        named -= names_in(found[1], names.spellings)  # w2 = 2.03 1/s, although s is a length of the task
    if _ANALOG.search(read.text):  # d(theta2)/d(theta1) = -2.93/10 is a ratio of velocities
        named -= {one.rate for one in variant.coordinates} - {*variant.sought}
    is_checked = _CHECKED.search(read.text) and not VANISHED.search(read.text)  # r1*w1 = 1.08
    return (
        bool(named)
        and bool(is_checked or named <= {*variant.sought})
        and (_MEASURED.search(read.text) is not None or (len(named) == 1 and _AT_ONE_TIME.match(read.text) is not None))
    )
