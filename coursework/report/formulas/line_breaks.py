"""Where a person would break a displayed formula: before a sign of its outer sum or before "=".

Enters: Typst math of one line.  Leaves: its pieces; a browser puts as many on a line as fit.
Used by `svg.py`.
"""

from __future__ import annotations

import re

LONG = 56  # signs of Typst math; a shorter formula fits the screen of a phone
TOGETHER = 44  # signs of pieces that stand on one line of it beside the number of the formula: no break is needed between them
_SET_ALREADY = re.compile(r"^& | \\ & quad(?= )")  # lines of a formula that is too long for paper
_SIGNS = (" = ", " + ", " - ")
_AFTER = " "  # before a sign that begins a piece: `equation.typ` sets it as one between two terms


def pieces(source: str) -> list[str]:
    """Return the pieces of a formula, which is one piece where it is short or has no place to break.

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
    """Return the pieces, short neighbours as one, "= 0" not alone at the end."""
    kept = found[:1]
    for piece in found[1:]:
        if len(kept[-1]) + len(piece) <= TOGETHER or piece == f"{_AFTER}= 0":
            kept[-1] += piece
        else:
            kept.append(piece)
    return kept


def _parted(source: str) -> list[str]:
    """Return the terms of the outer sums, each but the first with its sign in front."""
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
    """Return a long product with a sum at its end, "g (a - b + c)", in the terms of that sum."""
    begin = piece.find(" (")
    if len(piece) < LONG or begin < 0 or not piece.endswith(")") or "(" in piece[:begin].replace("_(", ""):
        return [piece]
    inside = _parted(piece[begin + 2 : -1])
    depth = 0
    for sign in piece[begin + 2 : -1]:
        depth += (sign == "(") - (sign == ")")
        if depth < 0:  # the parenthesis at the end is another one
            return [piece]
    return [f"{piece[:begin]} \\({inside[0]}", *inside[1:-1], f"{inside[-1]}\\)"] if len(inside) > 1 else [piece]
