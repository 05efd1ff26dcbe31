"""The letters of a PDF page -> its lines, words and rows of cells, by their positions.

Enters: letters with boxes, base lines and sizes, thin bars.  Leaves: `PageLine`s.  A raised letter becomes a power; the letters
above and below a short bar become one piece of text at the bar.  A rule of a table is not a fraction bar: an equation continues
beside the bar of a fraction, on a base line a little below the bar.
Used by `pdf.py`.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

from coursework.grading.reading.documents.signs import plain_signs
from coursework.grading.reading.numbers import looks_numeric

_SAME_LINE, _ATTACHED, _SMALLER = 0.12, 0.6, 0.88  # shares of the size: same base line, base line of an index, size of an index
_WORD_GAP, _WIDE_GAP = 0.17, 1.2  # shares of the size: gaps between words, equations
MOST_BARS = 3000
# Shares of the size of letters: distance of the parts' base lines from the bar, height of the bar above the equation's base line,
# excess of the bar's length over its parts, distance to the rest of the equation.
_FAR, _AXIS, _LONGER, _NEAR = 1.6, (0.05, 0.45), 0.9, 1.5


class Letter(NamedTuple):
    """One letter: its text, left and right edge, base line (measured upwards) and size, in points."""

    text: str
    left: float
    right: float
    base: float
    size: float


@dataclass(slots=True)
class Word:
    """Letters without a gap between them; `text` has powers as ^2."""

    text: str
    left: float
    right: float


@dataclass(slots=True)
class PageLine:
    """One line: its words from left to right."""

    words: list[Word]
    size: float

    @property
    def text(self) -> str:
        """Return the words with one blank between them, three blanks at a gap as wide as between two equations."""
        gaps = [word.left - before.right > _WIDE_GAP * self.size for before, word in pairwise(self.words)]
        return "".join(
            f"{word.text}{'   ' if wide else ' '}" for word, wide in zip(self.words, [*gaps, False], strict=True)
        ).rstrip()

    @property
    def is_numbers(self) -> bool:
        """Return whether the line is a row of a table: at least two numbers, and at least half of its words are numbers."""
        count = sum(looks_numeric(word.text) for word in self.words)
        return count >= 2 and 2 * count >= len(self.words)


@dataclass(slots=True)
class _Row:
    base: float
    size: float
    letters: list[Letter] = field(default_factory=list)


def lines_of(letters: Iterable[Letter]) -> list[PageLine]:
    """Return the lines of a page, from top to bottom."""
    rows: list[_Row] = []
    for letter in sorted(letters, key=lambda letter: (-letter.base, letter.left)):
        if not rows or rows[-1].base - letter.base > _SAME_LINE * max(letter.size, rows[-1].size):
            rows.append(_Row(letter.base, letter.size))
        rows[-1].letters.append(letter)
    for row in rows:
        sizes = Counter(round(letter.size, 1) for letter in row.letters)
        row.size = max(sizes, key=lambda size: (sizes[size], size))
    return [_line(row) for row in _attached(rows) if any(letter.text.strip() for letter in row.letters)]


def _attached(rows: list[_Row]) -> list[_Row]:
    """Return the rows, with rows of indices and powers merged into the line beside them."""
    kept: list[_Row] = []
    given: list[list[Letter]] = [[] for _ in rows]
    for place, row in enumerate(rows):
        near = [other for other in (*range(max(place - 4, 0), place), *range(place + 1, min(place + 5, len(rows))))
                if row.size < _SMALLER * rows[other].size
                and abs(row.base - rows[other].base) < _ATTACHED * rows[other].size
                and _is_beside(row, rows[other])]  # fmt: skip
        if near:
            given[min(near, key=lambda other: abs(rows[other].base - row.base))] += row.letters
        else:
            kept.append(row)
    for place, row in enumerate(rows):
        row.letters = sorted([*row.letters, *given[place]], key=lambda letter: letter.left)
    return kept


def _is_beside(row: _Row, line: _Row) -> bool:
    """Return whether the first letter of a row follows a letter of the line closely."""
    first = min(letter.left for letter in row.letters)
    return any(-0.5 * line.size < first - letter.right < 0.7 * line.size for letter in line.letters)


def _line(row: _Row) -> PageLine:
    words: list[Word] = []
    before: Letter | None = None
    was = 0
    for letter in row.letters:
        if not letter.text.strip():
            before = None
            continue
        offset = (letter.base - row.base) / row.size
        place = 0 if letter.size > _SMALLER * row.size and abs(offset) < _SAME_LINE else (1 if offset > 0.1 else -1)
        text = letter.text
        if before is None or not words or letter.left - before.right > _WORD_GAP * row.size:
            words.append(Word(text, letter.left, letter.right))
        else:
            word = words[-1]
            if place == 1 and was != 1 and re.match(r"[\d−-]", text):
                text = f"^{text}"
            elif was == -1 and place == 0 and text.isalnum():
                text = f" {text}"
            word.text, word.right = word.text + text, max(word.right, letter.right)
        before, was = letter, place
    for word in words:
        word.text = plain_signs(word.text)
    return PageLine(words, row.size)


class Bar(NamedTuple):
    """A thin horizontal bar: left and right end, height above the bottom of the page, in points."""

    left: float
    right: float
    height: float


def with_fractions(letters: Sequence[Letter], bars: Sequence[Bar]) -> list[Letter]:
    """Return the letters of a page, with the letters of each fraction replaced by one text."""
    kept = sorted((letter for letter in letters if letter.text.strip()), key=lambda letter: letter.base)
    if not bars or len(bars) > MOST_BARS:
        return kept
    for bar in sorted(set(bars), key=lambda bar: bar.right - bar.left):  # inner fractions first
        kept = _put_together(kept, bar)
    return kept


def _put_together(letters: list[Letter], bar: Bar) -> list[Letter]:
    start = bisect_left(letters, bar.height - 60, key=lambda letter: letter.base)
    near = letters[start : bisect_right(letters, bar.height + 60, key=lambda letter: letter.base)]
    inside = [letter for letter in near if bar.left - 1.5 <= letter.left and letter.right <= bar.right + 1.5]
    beside = [letter for letter in near if _goes_on_at(letter, bar)]
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


def _goes_on_at(letter: Letter, bar: Bar) -> bool:
    """Return whether a letter continues the equation to the left or right of a bar."""
    low, high = (share * letter.size for share in _AXIS)
    gap = max(bar.left - letter.right, letter.left - bar.right)
    return low < bar.height - letter.base < high and -1.0 < gap < _NEAR * letter.size


def _text(letters: Sequence[Letter]) -> str:
    return " ".join(line.text for line in lines_of(letters))
