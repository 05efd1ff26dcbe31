"""The spelling of names: Greek letters written out, subscripts as digits, letters of other alphabets found.

Enters: a name as an author wrote it.  Leaves: its spelling in the tool.  Used while files and formulas are read.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from functools import lru_cache

from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "eps", "ζ": "zeta", "η": "eta", "θ": "theta",
    "ϑ": "theta", "λ": "lam", "μ": "mu", "ν": "nu", "ξ": "xi", "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau",
    "φ": "phi", "ϕ": "phi", "χ": "chi", "ψ": "psi", "ω": "w", "Δ": "Delta", "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega",
    "Θ": "Theta", "Γ": "Gamma", "κ": "kappa", "ϵ": "eps", "ϱ": "rho", "µ": "mu", "Λ": "Lam", "Ξ": "Xi", "Π": "Pi", "Σ": "Sigma",
}  # fmt: skip
LETTERS = {word: letter for letter, word in reversed(_GREEK.items())}
# Letters typed on a keyboard with another alphabet that look exactly like Latin ones.
LOOK_ALIKE = dict(zip("асеорхуіјѕАВЕКМНОРСТХІЅοιυΑΒΕΖΗΙΚΜΝΟΡΤΥΧ", "aceopxyijsABEKMHOPCTXISoiuABEZHIKMNOPTYX", strict=True))
# Letters of a word in two alphabets, by their look or by their sound.
_IN_ONE = (
    str.maketrans("асеорхкмтНМ", "aceopxkmtHM"), str.maketrans("асеоркмтдгинНМПТ", "aseorkmtdginNMPT"),
    str.maketrans("aceopxkmtrdgsinHNM", "асеорхкмтрдгсинННМ"),
)  # fmt: skip
# Functions as they are typed on a Cyrillic keyboard.
CYRILLIC_FUNCTIONS = {"син": "sin", "сін": "sin", "кос": "cos", "тан": "tan", "тг": "tan", "корень": "sqrt", "корінь": "sqrt"}
SCRIPTS = ("cyrillic", "greek")  # alphabets for which the words files have a word
_SUBSCRIPTS = {ord("₀") + digit: str(digit) for digit in range(10)}


@lru_cache(maxsize=10_000)
def spell(name: str) -> str:
    """Return a name in the tool's spelling: Greek letters written out, subscripts as digits."""
    plain = "".join(_GREEK.get(letter, letter) for letter in unicodedata.normalize("NFC", name))
    return plain.translate(_SUBSCRIPTS)


def spell_path(path: Iterable[str | int]) -> tuple[str | int, ...]:
    """Return the path of a key with each name in the tool's spelling."""
    return tuple(spell(part) if isinstance(part, str) else part for part in path)


def greek(word: str) -> str:
    """Return the Greek letter that a word spells ("phi": φ); any other word unchanged."""
    return LETTERS.get(word, word)


def in_one_alphabet(word: str) -> tuple[str, ...]:
    """Return what a word with Latin and other letters may be in one alphabet, by look or sound; nothing for any other word.

    >>> in_one_alphabet("сm")[::2], in_one_alphabet("cm")
    (('cm', 'см'), ())
    """
    mixes = not word.isascii() and any(letter.isascii() for letter in word)
    return tuple(word.translate(table) for table in _IN_ONE) if mixes else ()


def foreign_letter(name: str) -> tuple[int, Sentence] | None:
    """Return the position (from 0) and description of the first letter from another alphabet, None if there is none."""
    for position, letter in enumerate(name):
        if letter.isalpha() and not letter.isascii() and letter not in _GREEK:
            name = unicodedata.name(letter, "unknown letter").capitalize()
            script = name.partition(" ")[0].lower()
            called = say(f"fault.letter.{script}" if script in SCRIPTS else "fault.letter.other", name=name, letter=letter)
            if letter in LOOK_ALIKE:
                return position, say("fault.letter.look_alike", letter=called, latin=LOOK_ALIKE[letter])
            return position, called
    return None


def letter_hint(name: str) -> str:
    """Return ' Letter 1 is …' for a name with a letter from another alphabet, an empty text for any other name."""
    strange = foreign_letter(name)
    return say("hint.letter", number=strange[0] + 1, strange=strange[1]) if strange else ""
