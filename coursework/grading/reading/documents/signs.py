"""Letters that word processors write in place of plain ones: mathematical italics, the Symbol font, invisible signs.

Enters: text.  Leaves: the same text in plain letters.  Used by the readers of this room.
"""

from __future__ import annotations

import re
import unicodedata

_UNSEEN = {chr(code): None for code in (0x2061, 0x2063, 0x200B, 0x200C, 0x200D, 0x2060, 0xFEFF, 0xAD, 0xFE0E, 0xFE0F)}
_SIGNS = str.maketrans({
    **_UNSEEN, "\u2062": " ", "\u2064": "+", "∙": "*", "⋅": "*", "·": "*", "×": "*", "•": "*", "∗": "*", "÷": "/", "\u2215": "/",
    "\u2010": "-", "\u2011": "-", "\u2012": "-", "\u2013": "-", "\u2014": "-", "\u00a0": " ", "\u2028": " ", "\u2029": " ",
    "\u02d9": "\u0307", "\ufffc": " ", "\x0b": " ", "\x0c": " ", "\x00": " ",
})  # fmt: skip
# The Symbol font of Windows shows Greek letters for Latin ones.
_SYMBOL = dict(zip("abgdezhqiklmnxoprstufcyw", "αβγδεζηθικλμνξοπρστυφχψω", strict=True)) | {
    "j": "φ",
    "J": "θ",
    "W": "Ω",
    "F": "Φ",
}
_SYMBOL |= {"\xb4": "*", "\xd7": "*", "\xb0": "°", "\xa2": "'", "\xb8": "/", "\xd6": "√"}
_STYLED = re.compile("[\U0001d400-\U0001d7ff\uf020-\uf0ff\u2102-\u2134]+")


def plain_signs(text: str) -> str:
    """Return a text in plain letters.

    >>> plain_signs("\U0001d714\u2062\U0001d711 ⋅ \uf077")
    'ω φ * ω'
    """
    if text.isascii():
        return text
    return _STYLED.sub(lambda found: "".join(map(_plain, found[0])), text).translate(_SIGNS)


def _plain(letter: str) -> str:
    if "\uf020" <= letter <= "\uf0ff":
        return symbol_font(chr(ord(letter) - 0xF000))
    return unicodedata.normalize("NFKC", letter) if letter >= "\U0001d400" or letter in "ℎℊℓ" else letter


def symbol_font(letter: str) -> str:
    """Return the sign that the Symbol font shows for a letter."""
    return _SYMBOL.get(letter, letter)
