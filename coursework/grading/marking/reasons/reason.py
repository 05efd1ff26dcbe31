"""One sentence on why a grade is what it is, or on what the code of a misconception means.

Enters: a code.  Leaves: `Reason`, a sentence, the numbers as sentences say them.
Used by `reasons.py`, `table.py`, `equations.py` and the class page.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import Literal

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import load_phrases, say
from coursework.words.templates import clean

# Kinds of sentences: why there is no number, what a person decided, what was found, how the points are summed up.
Kind = Literal["state", "decided", "first", "cause", "finding", "note", "rule"]
LONGEST = 300  # characters of a text that came from a student
# Codes that begin with one of these end in the name of a datum, velocity, column …
_NAMED = (
    "rounded_omega", "confusion", "equation", "variant", "origin", "start", "datum", "swap",
    "sign", "cosine", "row_above", "row_below", "column_slipped",
)  # fmt: skip
_WHOLE = ("sign_drive", "cosine_drive")


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


def quoted(text: str) -> str:
    """Return a text of a student or a file as sentences quote it; they enter tables too, where a place to break is in the way."""
    return clean(text, LONGEST, breaks=False)


def misconception_sentence(code: str, *, for_student: bool = False) -> Sentence | str:
    """Return what a code means, with the name it carries (datum, velocity, variant) filled in.

    With `for_student`, the sentence does not say whose variant the table belongs to; only the teacher is told that.
    """
    for stem in _NAMED:
        if code.startswith(f"{stem}_") and code not in _WHOLE:
            if stem == "variant" and for_student:
                return say("feedback.misconception.other_variant")
            name = code.removeprefix(f"{stem}_")
            name = quoted(", ".join(_two_names(name)) if stem == "swap" else name)
            return say(f"feedback.misconception.{stem}", name=name)
    key = f"feedback.misconception.{code}"
    return say(key) if load_phrases().has(key) else code


def _two_names(both: str) -> tuple[str, str]:
    """Return the two names joined in a code such as r1_r2 or l_1_l_2."""
    parts = both.split("_")
    middle = (len(parts) + 1) // 2
    return "_".join(parts[:middle]), "_".join(parts[middle:])
