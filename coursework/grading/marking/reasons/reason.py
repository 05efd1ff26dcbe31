"""One sentence of why a grade is what it is.

Enters: nothing.  Leaves: `Reason`, the numbers as sentences say them.  Used by `reasons.py`, `table.py`, `equations.py`.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import Literal

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence

# What a sentence is about: why there is no number, what was decided, what was found, the sum that the points come from.
Kind = Literal["state", "decided", "first", "cause", "finding", "note", "rule"]
LONGEST = 300  # characters of a text that came from a student


@frozen
class Reason:
    """`text` about a `part` of the grade: one of the rubric's, "total", "late", "" about all of it."""

    part: str
    kind: Kind
    text: Sentence | str

    def plain(self) -> dict[str, str]:
        """Return the record as the journal keeps it."""
        return asdict(self)


def in_sum(value: float) -> float:
    """Return a factor of a sum so that a student who works it out finds the points to two decimals."""
    return float(f"{value:.5g}")
