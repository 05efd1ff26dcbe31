"""Names of a variant file -> symbols as a textbook sets them: "w3" -> ω₃, "VMx" -> V with subscript Mx.

Enters: a name (letters, digits, "_", one "." of a point's column), or "∂r/∂phi1".  Leaves: `Symbol`, in text or Typst math.
Only names pass through here, never text of a student; anything else is refused.
Used by `report/` and `assigning/`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

from coursework.drawing.paper.symbols import LOWERED
from coursework.system.frozen import frozen
from coursework.variant.formula.alphabet import LETTERS

GREEK = {**LETTERS, "epsilon": "ε", "lambda": "λ", "omega": "ω", "Lambda": "Λ"}
_NAME = re.compile(r"\w+(\.\w+)?")
_GREEK_HEAD = re.compile(rf"({'|'.join(sorted(GREEK, key=len, reverse=True))})(?=$|[\dA-Z_])_?(\w*)")
# "phij", "wb", "wpsi": the angle of side j, the angular velocity of b, that of psi.  Names that begin words are left out.
_NAMED_AFTER = re.compile(r"(alpha|beta|gamma|delta|theta|phi|psi|omega|w)([a-z]|(?:alpha|beta|gamma|delta|theta|phi|psi)\d*)")
# "si", "rj": lengths at the ends i and j of a group; "xa", "yb": coordinates of points a and b; "us": velocity along s.
_LETTER_HEAD = re.compile(r"([^\W\d_])(?:_(\w+)|(\d\w*)|([A-Z]\w*|[xyij]|(?<=[xyuv])[a-z]))")
_WORD_HEAD = re.compile(r"([^\W\d_]{2,})(?:_(\w+)|(\d\w*))")
_GREEK_SUBSCRIPT = re.compile(rf"({'|'.join(sorted((n for n in GREEK if len(n) > 2), key=len, reverse=True))})(\d*)")
_DERIVATIVE = re.compile(r"(\w*?[^\W_])(?<!_d)_?dot(\d*)")  # x1_dot, phi_dot2, wdot
_DOT_ABOVE = "\u0307"
_DOTTED_OMEGA, _DOTTED_U = "ω" + _DOT_ABOVE, "u" + _DOT_ABOVE
LINEAR = frozenset("uvV")  # letters of linear velocities


@frozen
class Symbol:
    """One symbol: a letter (or an upright word), its subscript, a dot above for a time derivative."""

    letter: str
    subscript: str = ""
    dotted: bool = False

    @property
    def is_word(self) -> bool:
        """Return whether the letter is a whole word, set upright."""
        return len(self.letter) > 1 and not (self.letter.isalpha() and self.letter.isupper())

    @property
    def head(self) -> str:
        """Return the letter with its dot."""
        return self.letter[:1] + _DOT_ABOVE + self.letter[1:] if self.dotted else self.letter

    @property
    def text(self) -> str:
        """Return plain text: "ω₃", "V_Mx", "ω̇₁"."""
        if self.subscript.isdigit():
            return self.head + self.subscript.translate(LOWERED)
        return f"{self.head}_{self.subscript}" if self.subscript else self.head

    @property
    def run(self) -> dict[str, str]:
        """Return the symbol as a run: a letter with its index, or a word."""
        return {"t": self.head} if self.is_word and not self.subscript else {"v": self.head, "s": self.subscript}

    @property
    def typst(self) -> str:
        """Return Typst math source."""
        head = f'"{self.letter}"' if self.is_word else " ".join(self.letter)
        if self.dotted:
            head = f"dot({head})"
        elif len(self.letter) > 1 and not self.is_word:
            head = f"({head})" if self.subscript else head
        return f"{head}_{_lowered(self.subscript)}" if self.subscript else head


@frozen
class Rates:
    """Names of velocities before which "d" means the time derivative, and the language's letters for that of ω and of u."""

    names: frozenset[str] = frozenset()
    angular: str = _DOTTED_OMEGA
    linear: str = _DOTTED_U


NO_RATES = Rates()


def _lowered(subscript: str) -> str:
    if len(subscript) == 1 or subscript.isdigit():
        return subscript
    if re.search(r"[a-z]{2}|_", subscript):
        return f'"{subscript.replace("_", " ")}"'
    return f"({' '.join(re.findall(r'[0-9]+|.', subscript))})"


def _greek(subscript: str) -> str:
    """Return a subscript; the name of a Greek letter, also before digits, becomes the letter: "phi1" -> "φ1"."""
    match = _GREEK_SUBSCRIPT.fullmatch(subscript)
    return GREEK[match[1]] + match[2] if match else subscript


def is_named_after(name: str) -> bool:
    """Return whether a name is a Greek letter with a subscript of letters: "phij", "wpsi"; "we" counts as a word."""
    return name != "we" and _NAMED_AFTER.fullmatch(name) is not None


def parts_of_derivative(name: str) -> tuple[str, ...]:
    """Return ("r", "phi1") for "∂r/∂phi1", the name of a derivative of a law; empty for any other name."""
    law, _, by = name.removeprefix("∂").rpartition("/∂")
    return (law, by) if law else ()


@lru_cache(maxsize=4096)
def symbol(name: str, rates: Rates = NO_RATES) -> Symbol:
    """Return the symbol of a name; "d" before one of `rates` becomes the dot of a derivative.

    If a language has letters for accelerations, "dw1" is ε₁ and "du3" is a₃.  Raises `ValueError` for text that is no name.
    """
    if parts := parts_of_derivative(name):
        return Symbol("/".join(f"∂{symbol(part).text}" for part in parts))
    if not _NAME.fullmatch(name):
        raise ValueError(f"{name!r} is no name")
    if "." in name:
        point, _, part = name.partition(".")
        return Symbol(part[0], point + part[1:]) if len(part) > 1 else Symbol(part, point)
    if name.startswith("d") and name[1:] in rates.names:
        inner = symbol(name[1:])
        if inner.letter == "ω" and rates.angular != _DOTTED_OMEGA:
            return Symbol(rates.angular, inner.subscript)
        if inner.letter in LINEAR and rates.linear != _DOTTED_U:
            return Symbol(rates.linear, inner.subscript)
        return Symbol(inner.letter, inner.subscript, dotted=True)
    if match := _DERIVATIVE.fullmatch(name):
        inner = symbol(match[1] + match[2])
        if not (inner.is_word or inner.dotted):
            return Symbol(inner.letter, inner.subscript, dotted=True)
    if match := _GREEK_HEAD.fullmatch(name) or _NAMED_AFTER.fullmatch(name):
        return Symbol(GREEK[match[1]], _greek(match[2]))
    if name.isalpha() and name.isupper():
        return Symbol(name)  # AB, BM: the segment between two points
    for pattern in (_LETTER_HEAD, _WORD_HEAD):
        if match := pattern.fullmatch(name):
            return Symbol(match[1], _greek(next(part for part in match.groups()[1:] if part)))
    return Symbol(name)


def with_symbols(text: str, names: Iterable[str]) -> str:
    """Return a text in which `names` are replaced by their symbols, as on the pages: φ₁ and ω₁.

    >>> with_symbols("phi1 = 2*w1, phi12", ["phi1", "w1"])
    'φ₁ = 2*ω₁, phi12'
    """
    written = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    return re.sub(rf"(?<![\w.])(?:{written})(?![\w.]*\w)", lambda name: symbol(name[0]).text, text) if written else text
