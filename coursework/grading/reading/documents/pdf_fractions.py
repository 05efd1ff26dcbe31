"""Fractions of a PDF's page: what stands above and below a short bar -> one piece of text where the bar is.

Enters: letters and thin bars.  Leaves: letters, those of each fraction put together.  The lines of a table are no fractions:
beside the bar of a fraction its equation goes on, on a base line a little below the bar.
Used by `pdf.py`.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from typing import NamedTuple

from coursework.grading.reading.documents.pdf_lines import Letter, lines_of

MOST_BARS = 3000
# Of the size of letters: how far base lines of the parts are from the bar, the equation's own below it, how much longer than
# its parts a bar is, how near the equation goes on.
_FAR, _AXIS, _LONGER, _NEAR = 1.6, (0.05, 0.45), 0.9, 1.5


class Bar(NamedTuple):
    """A thin horizontal bar: left and right end, height above the page's foot, in points."""

    left: float
    right: float
    height: float


def with_fractions(letters: Sequence[Letter], bars: Sequence[Bar]) -> list[Letter]:
    """Return the letters of a page with those above and below each bar of a fraction as one."""
    kept = sorted((letter for letter in letters if letter.text.strip()), key=lambda letter: letter.base)
    if not bars or len(bars) > MOST_BARS:
        return kept
    for bar in sorted(set(bars), key=lambda bar: bar.right - bar.left):  # a fraction inside another first
        kept = _put_together(kept, bar)
    return kept


def _put_together(letters: list[Letter], bar: Bar) -> list[Letter]:
    start = bisect_left(letters, bar.height - 60, key=lambda letter: letter.base)
    near = letters[start : bisect_right(letters, bar.height + 60, key=lambda letter: letter.base)]
    inside = [letter for letter in near if bar.left - 1.5 <= letter.left and letter.right <= bar.right + 1.5]
    beside = [letter for letter in near if _is_beside(letter, bar)]
    if not beside or not inside:
        return letters
    size = max(letter.size for letter in beside)
    above = [letter for letter in inside if 0 < letter.base - bar.height < _FAR * size]
    below = [letter for letter in inside if 0 < bar.height - letter.base < _FAR * size]
    if not above or not below:
        return letters
    longest = max(max(part, key=lambda letter: letter.right).right - min(part, key=lambda letter: letter.left).left
                  for part in (above, below))  # fmt: skip
    if bar.right - bar.left - longest > _LONGER * size:
        return letters
    base = max(beside, key=lambda letter: letter.size).base
    text = f" (({_text(above)})/({_text(below)})) "
    gone = {id(letter) for letter in (*above, *below)}
    rest = [letter for letter in letters if id(letter) not in gone]
    return sorted([*rest, Letter(text, bar.left, bar.right, base, size)], key=lambda letter: letter.base)


def _is_beside(letter: Letter, bar: Bar) -> bool:
    """Return whether a letter goes on the equation on the left or on the right of a bar."""
    low, high = (share * letter.size for share in _AXIS)
    gap = max(bar.left - letter.right, letter.left - bar.right)
    return low < bar.height - letter.base < high and -1.0 < gap < _NEAR * letter.size


def _text(letters: Sequence[Letter]) -> str:
    return " ".join(line.text for line in lines_of(letters))
