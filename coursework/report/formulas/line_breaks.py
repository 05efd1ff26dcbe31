"""The places where a person would break a displayed formula: before "=" or before a sign of its outer sum.

Enters: Typst math of one line.  Leaves: its pieces, of which a browser puts as many on a line as fit.
Used by `svg.py`.
"""

from __future__ import annotations

import re

LONG = 56  # characters of Typst math; a shorter formula fits the screen of a phone
TOGETHER = 44  # characters of neighbouring pieces that fit on one line of a phone beside the formula's number, so they are joined
_SET_ALREADY = re.compile(r"^& | \\ & quad(?= )")  # line breaks already set in a formula that is too long for a line on paper
_SIGNS = (" = ", " + ", " - ")
_AFTER = " "  # stands before a sign that begins a piece, so that `equation.typ` sets the sign as one between two terms


def pieces(source: str) -> list[str]:
    """Return the pieces of a formula; a short formula, or one without a place to break, stays one piece.

    >>> pieces("x = a + b")
    ['x = a + b']
    >>> pieces("V_(D y) = ω_4 frac(r_3, 2) cos(π slash 2) + ω_3 r_3 cos(φ_3 + 3 π slash 2) = 0")
    ['V_(D y) = ω_4 frac(r_3, 2) cos(π slash 2)', ' + ω_3 r_3 cos(φ_3 + 3 π slash 2) = 0']
    """
    if len(source) < LONG or "cases(" in source:
        return [source]
    parted = _parted(_SET_ALREADY.sub("", source))
    return _gathered([piece for long in parted for piece in _opened(long)])


def _gathered(found: list[str]) -> list[str]:
    """Return the pieces with short neighbours joined, and with a final "= 0" joined to the piece before it."""
    kept = found[:1]
    for piece in found[1:]:
        if len(kept[-1]) + len(piece) <= TOGETHER or piece == f"{_AFTER}= 0":
            kept[-1] += piece
        else:
            kept.append(piece)
    return kept


def _parted(source: str) -> list[str]:
    """Return the formula split before "=", "+" and "-" outside all parentheses; all pieces but the first begin with the sign."""
    places, depth, is_text = [0], 0, False
    for place, sign in enumerate(source):
        if sign == '"':
            is_text = not is_text
        elif not is_text:
            depth += (sign == "(") - (sign == ")")
            if depth == 0 and place and source.startswith(_SIGNS, place):
                places.append(place)
    ends = [*places[1:], len(source)]
    found = [source[begin:end].strip() for begin, end in zip(places, ends, strict=True)]
    return [found[0], *(_AFTER + piece for piece in found[1:])]


def _opened(piece: str) -> list[str]:
    """Return a long product that ends in a sum, "g (a - b + c)", split at the terms of that sum; another piece whole."""
    begin = piece.find(" (")
    if len(piece) < LONG or begin < 0 or not piece.endswith(")") or "(" in piece[:begin].replace("_(", ""):
        return [piece]
    inside = _parted(piece[begin + 2 : -1])
    depth = 0
    for sign in piece[begin + 2 : -1]:
        depth += (sign == "(") - (sign == ")")
        if depth < 0:  # the last parenthesis does not close the first one
            return [piece]
    return [f"{piece[:begin]} \\({inside[0]}", *inside[1:-1], f"{inside[-1]}\\)"] if len(inside) > 1 else [piece]
