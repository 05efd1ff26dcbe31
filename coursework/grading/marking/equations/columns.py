"""The column of a sign or name in a line as the student typed it, from its column in the line as it was read.

Enters: both texts and a column of the text as read.  Leaves: a column of the text as typed.  Used by `equations.py`.
"""

from __future__ import annotations

import re
from difflib import SequenceMatcher

_MINUS = "-−–—‐‑－"
_ALIKE = str.maketrans(dict.fromkeys(_MINUS, "-") | {"·": "*", "⋅": "*", "×": "*", "＋": "+", "（": "(", "）": ")"})
# Tokens that a typed line and its reading share one by one, in the same order: signs of terms, names and functions.
_SIGNS = re.compile(f"[{_MINUS}+＋]")
_SIGN_BEFORE = re.compile(rf"[{_MINUS}+][\s(]*\Z")
_WORDS = re.compile(r"\\?[^\W\d_][^\W_]*(?:_\{?\w+\}?)?")
_COMMANDS = {r"\frac", r"\dfrac", r"\tfrac", r"\cdot", r"\left", r"\right", r"\quad", r"\dot", r"\times", r"\mathrm", r"\text"}
_LEAST = 3  # characters by which a place is known
_LABEL = 2  # words that a line may have before its equation


def column_as_handed_in(typed: str, read: str, column: int, *, is_sign: bool = False) -> int:
    r"""Return the column (from 1) in the line as typed; with `is_sign`, that of the sign before the term, if it has one.

    >>> column_as_handed_in("(16) 2r3 ω3 − 0,5 r3 ω4 = 0", "2 * r3 * w3 - 0.5 * r3 * w4 = 0", 15, is_sign=True)
    13
    >>> column_as_handed_in(r"$r_3 \dot\varphi_3 + r_1 \omega_1 = 0$", "r3*w3 + r1*w1 = 0", 7, is_sign=True)
    20
    >>> [column_as_handed_in("r ω sin φ + 2 v = 0", "r*w*sin(phi) - 2*v = 0", column) for column in (1, 5, 18)]
    [1, 5, 15]
    >>> column_as_handed_in("v = a*2", "v = a*(c + 7)", 8)  # behind what both have
    7
    """
    if is_sign:
        column = _sign_before(read, column)
    if typed == read:
        return column
    for pattern in (_SIGNS, _WORDS):
        if place := _same_token(typed, read, column, pattern):
            return place
    whole, part = typed.translate(_ALIKE), read.translate(_ALIKE)
    place, best = column - 1, 0
    for block in SequenceMatcher(None, whole, part, autojunk=False).get_matching_blocks():
        if block.b <= place < block.b + block.size:
            return block.a + place - block.b + 1
        if block.size and block.b + block.size <= place:
            best = block.a + block.size
    return min(best + 1, max(len(typed), 1))


def column_in_source(source: str, typed: str, read: str, column: int, *, is_sign: bool = False) -> int:
    """Return the column in the line of the file of which `typed` is a part, or from which it was written out, row by row.

    >>> column_in_source("a = b; c - d = e", "c - d = e", "c - d = e", 5, is_sign=True)
    10
    >>> column_in_source("A = [c - d, 0; e, f]", "(c - d)*(w) + (0)*(u) = p", "(c - d)*(w) + (0)*(u) = p", 6, is_sign=True)
    8
    """
    if (begun := source.find(typed)) >= 0:
        return begun + column_as_handed_in(typed, read, column, is_sign=is_sign)
    around = _by_what_stands_around(source, typed, column_as_handed_in(typed, read, column))
    nearly = column_as_handed_in(source, read, column, is_sign=is_sign)
    if not around:
        return nearly
    # The line that has most of the text: of a matrix, the row with the other cells as well.
    lines = [source[source.rfind("\n", 0, place) + 1 :].partition("\n")[0] for place in around]
    likeness = {
        line: sum(block.size for block in SequenceMatcher(None, line, typed, autojunk=False).get_matching_blocks())
        for line in lines
    }
    found = min(zip(around, lines, strict=True), key=lambda one: (-likeness[one[1]], abs(one[0] - nearly)))[0]
    return _sign_before(source, found) if is_sign else found


def _by_what_stands_around(source: str, text: str, column: int) -> list[int]:
    """Return the columns of the longest part of a text around a place that stands in another text, [] if it is short."""
    begin, end = column - 1, column
    while end < len(text) and text[begin : end + 1] in source:
        end += 1
    while begin and text[begin - 1 : end] in source:
        begin -= 1
    part = text[begin:end]
    found = re.finditer(f"(?={re.escape(part)})", source) if len(part) >= _LEAST else ()
    return [one.start() + column - begin for one in found]


def has_sign(text: str, column: int) -> bool:
    """Return whether a plus or minus stands at a column or before the term that begins there.

    >>> has_sign("w = -2*r", 5)
    True
    >>> [has_sign(text, text.index("w") + 1) for text in ("r - w", "r - ( w)", "+w", "w - r", "(w)", "r*w")]
    [True, True, True, False, False, False]
    >>> has_sign("r -", 9), has_sign("r", 9)  # what stands behind the end of the text
    (True, False)
    """
    return _SIGNS.match(text, column - 1) is not None or _sign_before(text, column) != column


def _same_token(typed: str, read: str, column: int, pattern: re.Pattern[str]) -> int:
    """Return the typed column of the sign or word at a column of the reading, 0 if the tokens of the two lines do not match."""
    own = [found for found in pattern.finditer(typed) if found[0] not in _COMMANDS]
    others = list(pattern.finditer(read))
    at = next((place for place, found in enumerate(others) if found.start() + 1 == column), -1)
    before = len(own) - len(others)
    fits = 0 <= before <= (_LABEL if pattern is _WORDS else 0)
    return own[at + before].start() + 1 if at >= 0 and fits else 0


def _sign_before(text: str, column: int) -> int:
    """Return the column of the sign before a term, or the column of the term itself if it has none."""
    # The text as read may be shorter than the line as typed.
    found = _SIGN_BEFORE.search(text, 0, max(column - 1, 0))
    return found.start() + 1 if found else column
