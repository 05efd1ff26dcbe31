"""A line whose equations are parted by slashes or dots, a = b / c = d -> the line with semicolons between them.

Enters: a line, `Names`.  Leaves: the line; a slash that divides is left.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.formulas.equations import Names, names_in, read_as_one
from coursework.grading.reading.equations.notation.signs import depths, relates_two_sides, relations
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.variant.record.places import has_one_dimension
from coursework.words.errors import Fault

# Slashes and dots between the equations of one line, a = b / c = d.
_TWO = re.compile(r"(?<=[^\s:;/{}])\s*//\s*(?=[^\s/])")
_MOST_SLASHES = 20  # slashes of a line
_ONE = re.compile(r"(?<=\S)\s+[/•·∙⋅●]\s+(?=\S)")


def parted_at_slashes(text: str, names: Names) -> str:
    """Return a line with semicolons for slashes and dots between its equations; what stands behind // is else a remark."""
    if len(text) > EQUATION_CHARACTERS:
        return text
    pieces = _TWO.split(text) if "//" in text else []
    if pieces and all(_is_one(piece, names) for piece in pieces):
        return "; ".join(pieces)
    return "; ".join(_at_slashes(text, names)) if _ONE.search(text) else text


def _is_one(text: str, names: Names) -> bool:
    """Return whether a text may be an equation by itself: it relates two sides and names a sought velocity and something else."""
    named = names_in(text, names.spellings) if relates_two_sides(text) else set[str]()
    return len(named) > 1 and not named.isdisjoint(names.expected.variant.sought)


def _at_slashes(text: str, names: Names) -> list[str]:
    """Return the equations of a line that slashes or dots part.

    In a = b / c = d the slash divides if a and b / c can have one unit, and parts two equations if only a and b can. If neither
    can, nothing is right in which it divides: it parts the two, if it is the only one and each may be an equation by itself.
    """
    inside, signs = depths(text), relations(text)
    pieces, start = list[str](), 0
    slashes = [found for found in _ONE.finditer(text) if inside[found.start()] == 0]
    for found in slashes if len(signs) > 1 and len(slashes) <= _MOST_SLASHES else ():
        before = max((sign for sign in signs if sign < found.start()), default=-1)
        behind = min((sign for sign in signs if sign > found.start()), default=-1)
        is_ended = any(sign in text[found.end() : max(behind, 0)] for sign in (";", ", "))  # a = b / c; d = e
        if before < start or behind < 0 or is_ended or not _is_one(text[found.end() :], names):
            continue
        alone = sum(before < other.start() < behind for other in slashes) == 1
        parts = text[start:before], text[before : found.start()], text[found.end() : behind]
        is_zero = "0" in {part.strip("= ") for part in parts}
        divides = not is_zero and _has_one_unit(text[start:behind], names)
        if not divides and (
            _has_one_unit(text[start : found.start()], names) or (alone and _is_one(text[start : found.start()], names))
        ):
            pieces.append(text[start : found.start()])
            start = found.end()
    return [*pieces, text[start:]]


def _has_one_unit(text: str, names: Names) -> bool:
    """Return whether a text can be read as an equation whose terms all have one unit."""
    read = read_as_one(text.rstrip(" :<"), names)
    return not isinstance(read, Fault) and has_one_dimension(read.tree, names.expected.variant, plainly=True)
