"""One sentence on why a grade is what it is.

Enters: nothing.  Leaves: `Reason`, the numbers as sentences say them.  Used by `reasons.py`, `table.py`, `equations.py`.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import Literal

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence

# Kinds of sentences: why there is no number, what a person decided, what was found, how the points are summed up.
Kind = Literal["state", "decided", "first", "cause", "finding", "note", "rule"]
LONGEST = 300  # characters of a text that came from a student


@frozen
class Reason:
    """`text` about a `part` of the grade: a part of the rubric, "total" or "late"; "" stands for the whole grade."""

    part: str
    kind: Kind
    text: Sentence | str

    def plain(self) -> dict[str, str]:
        """Return the record as the journal keeps it."""
        return asdict(self)


def in_sum(value: float) -> float:
    """Return a factor of a sum with enough digits that a student who works it out gets the points to two decimals."""
    return float(f"{value:.5g}")
