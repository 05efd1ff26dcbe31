"""Names of a file as a drawing writes them: "r1" is r₁, "2*r3" is 2r₃, "phi1" is φ₁.

Enters: a name or a formula.  Leaves: short text.
Used by `naming.py`, `angles.py`, `dimensions.py`, `drawing/figures.py` and `plans/`.
"""

from __future__ import annotations

import re

from coursework.variant.formula.alphabet import greek
from coursework.variant.formula.tree import Formula, spelled
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

LONGEST_NAME = 12  # most letters of the name of a point or link
LONGEST_LENGTH = 14  # most letters of a length beside a link; a longer formula would help less than none
LONGEST_INDEX = 4  # most letters of an index
LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_POWER = re.compile(r"e([+-]\d+)")
_NAME = re.compile(r"(?<![^\W\d])(?<!\.)([^\W\d_]+?)(\d*)(?!\w)")
_INDEXED = re.compile(r"([^\W\d_])(?:_?(\d+)|_(\w+)|([ijxy])|(?<=[xy])([^\W\d_])|(?<=[a-z])([A-Z]\w{0,3}))")
_RATE = re.compile(r"(?:w|omega)_?(\w*)")


def short(name: str) -> str:
    """Return the name of a point or link, cut if it is too long to stand beside it."""
    return name if len(name) <= LONGEST_NAME else name[: LONGEST_NAME - 1] + "…"


def name_word(name: str) -> tuple[str, str, str]:
    """Return the name of a point or datum as (text, subscript, prime): "P1" is P with 1, "Ki" K with i, "lAB" l with AB.

    The point under another, "P1'", has its prime behind everything.
    """
    plain, prime = _without_prime(name)
    found = _INDEXED.fullmatch(plain)
    return (
        (found[1], next(part for part in found.groups()[1:] if part), prime) if found else (short(greek(plain)) + prime, "", "")
    )


def _without_prime(name: str) -> tuple[str, str]:
    plain = name.rstrip("'")
    return plain, "′" * (len(name) - len(plain))


def lettered(text: str) -> str:
    """Return a text with its names typeset: Greek letters, and digits after a name as subscripts."""
    return _NAME.sub(lambda match: greek(match[1]) + match[2].translate(LOWERED), text)


def rate_word(name: str) -> tuple[str, str, str]:
    """Return a given rate as (text, subscript, ""): "w1" is ω with 1, "wpsi" is ω with ψ."""
    found = _RATE.fullmatch(name)
    return ("ω", greek(found[1]), "") if found else (short(name), "", "")


def lowered_name(name: str) -> str:
    """Return the name of a point as it stands in a subscript: "P1" is P₁; "P1'", the point under it, is P₁′."""
    plain, prime = _without_prime(name)
    return (short(lettered(plain)) if _INDEXED.fullmatch(plain) else short(plain)) + prime


def image(name: str) -> str:
    """Return the letter of a point's image in a plan: the name in small letters, its digits as subscripts."""
    return lowered_name(name).lower()


def angle_word(name: str) -> tuple[str, str, str]:
    """Return the name of an angle as (text, subscript, ""): "phi1" is φ with 1, "phib" φ with b, "beta" β.

    >>> angle_word("phi1"), angle_word("psi"), angle_word("q2")
    (('φ', '1', ''), ('ψ', '', ''), ('q', '2', ''))
    """
    heads = (name[:end] for end in range(len(name), 1, -1))
    head = next((head for head in heads if greek(head) != head), "")
    low = name[len(head) :].removeprefix("_")
    return (greek(head), greek(low), "") if head and len(low) <= LONGEST_INDEX else name_word(name)


def length_text(length: Formula) -> str:
    """Return a length as it stands beside a link, "" if it is too long for that."""
    text = lettered(spelled(length).replace("*", "").replace(" ", "").replace("-", "−"))
    return text if len(text) <= LONGEST_LENGTH else ""


def length_word(length: Formula) -> tuple[str, str, str]:
    """Return a length as (text, subscript, prime): "xF" is x with F; the text is "" if it is too long."""
    named = length.op == "name" and not length.name[-1:].isdigit()
    if length.op == "name" and length.name == "l":
        return ("ℓ", "", "")  # a slanted l reads as a stroke
    return name_word(length.name) if named else (length_text(length), "", "")


def decimal(value: float) -> str:
    """Return a round number written without a power of ten, 0.0002, unless nobody would count its zeros: 2·10⁻⁸."""
    return say("drawing.round", value=float(value)) if 1e-5 <= value < 1e7 else powers(f"{value:.0e}")


def powers(text: str) -> str:
    """Return a text in which a number of a program, 1.56e-06, is written as on paper: 1.56·10⁻⁶."""
    return _POWER.sub(lambda found: f"·10{str(int(found[1])).translate(RAISED)}", text)


def ratio(scale: float) -> Sentence:
    """Return "1:10" for a scale of 10, "5:1" for an enlargement."""
    return say("drawing.reduced", value=float(scale)) if scale >= 1 else say("drawing.enlarged", value=float(f"{1 / scale:.6g}"))
