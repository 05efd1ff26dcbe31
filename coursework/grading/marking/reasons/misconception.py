"""What the code of a misconception means, in a sentence for the student or for the class.

Enters: a code.  Leaves: a sentence.  Used by `table.py` and the class page.
"""

from __future__ import annotations

from coursework.grading.marking.reasons.reason import LONGEST
from coursework.words.sentence import Sentence
from coursework.words.sentences import load_phrases, say
from coursework.words.templates import clean

# Codes that begin with one of these end in the name of a datum, velocity, column …
_NAMED = ("rounded_omega", "confusion", "equation", "variant", "origin", "start", "datum", "swap", "sign", "row_above")
_WHOLE = ("sign_drive",)


def misconception_sentence(code: str, *, for_student: bool = False) -> Sentence | str:
    """Return what a code means, with the name it carries (datum, velocity, variant) filled in.

    With `for_student`, the sentence does not say whose variant the table belongs to; only the teacher is told that.
    """
    for stem in _NAMED:
        if code.startswith(f"{stem}_") and code not in _WHOLE:
            if stem == "variant" and for_student:
                return say("feedback.misconception.other_variant")
            name = code.removeprefix(f"{stem}_")
            name = clean(", ".join(_two_names(name)) if stem == "swap" else name, LONGEST)
            return say(f"feedback.misconception.{stem}", name=name)
    key = f"feedback.misconception.{code}"
    return say(key) if load_phrases().has(key) else code


def _two_names(both: str) -> tuple[str, str]:
    """Return the two names joined in a code such as r1_r2 or l_1_l_2."""
    parts = both.split("_")
    middle = (len(parts) + 1) // 2
    return "_".join(parts[:middle]), "_".join(parts[middle:])
