"""Where a sign or a name stands in a line as the student typed it, when it was found in the line as it was read.

Enters: both texts and a column of the second.  Leaves: a column of the first.  Used by `equations.py`.
"""

from __future__ import annotations

from difflib import SequenceMatcher

_MINUS = "-−–—‐‑－"
_ALIKE = str.maketrans(dict.fromkeys(_MINUS, "-") | {"·": "*", "⋅": "*", "×": "*", "＋": "+", "（": "(", "）": ")"})


def column_as_handed_in(typed: str, read: str, column: int, *, is_sign: bool = False) -> int:
    """Return the column (from 1) in the line as typed; of a term whose sign is meant, that of the sign, where it has one.

    >>> column_as_handed_in("(16) 2r3 ω3 − 0,5 r3 ω4 = 0", "2 * r3 * w3 - 0.5 * r3 * w4 = 0", 15, is_sign=True)
    13
    """
    if is_sign:
        column = _sign_before(read, column)
    if typed == read:
        return column
    whole, part = typed.translate(_ALIKE), read.translate(_ALIKE)
    place, best = column - 1, 0
    for block in SequenceMatcher(None, whole, part, autojunk=False).get_matching_blocks():
        if block.b <= place < block.b + block.size:
            return block.a + place - block.b + 1
        if block.size and block.b + block.size <= place:
            best = block.a + block.size
    return min(best + 1, max(len(typed), 1))


def _sign_before(text: str, column: int) -> int:
    """Return the column of the sign before a term, of the term itself where none stands there."""
    place = min(column - 2, len(text) - 1)
    while place >= 0 and (text[place].isspace() or text[place] == "("):
        place -= 1
    return place + 1 if place >= 0 and text[place] in f"+{_MINUS}" else column
