"""Text that may contain Chinese: Python counts its signs as letters, but they form no words with others and have few spaces.

Enters: a pattern with `HAN_HERE` in place of its signs, and the text to match; a text.  Leaves: the compiled pattern; the text.
Used by `sentences.py`, `templates.py`, `line_ends.py`, `report/text/text_runs.py` and `variant/reading/reader.py`; for the widths
of columns by `commands/line/screen.py`, `commands/line/kinds.py`, `mechanism/drafts/text.py` and `takeaway/note/blocks.py`.

Compiling a character class of 29 000 signs takes a millisecond, and ten of them take as long as the checks of a table.  For a
text without Chinese, the pattern without them gives the same result.
"""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise

HAN = "\u2e80-\u9fff\uff00-\uffef"  # signs without spaces between them; a line may break after each
HAN_HERE = "\ue011"
# A mark for a space beside a gap: Chinese has a space beside Latin letters and digits, but not between its own signs or beside
# its full stops and parentheses; which of these the gap brings is known only when it is filled.
OPEN_SPACE = "\ue00f"
_WIDE, _STOPS = (("\u3000", "\u303f"), ("\u3400", "\u9fff"), ("\uff00", "\uff65")), frozenset("、。，；：！？（）")


def is_chinese(text: str) -> bool:
    """Return whether a text contains a Chinese sign; it is tested without a pattern, and first by the largest character."""
    return (
        not text.isascii() and max(text) >= HAN[0] and any(HAN[0] <= sign <= HAN[2] or HAN[3] <= sign <= HAN[5] for sign in text)
    )


def wide_letters(text: str) -> int:
    """Return how many characters of a text are twice as wide as others, according to Unicode.

    >>> wide_letters("步 h"), wide_letters("step h")
    (1, 0)
    """
    from unicodedata import east_asian_width  # imported here, as only columns need it

    return sum(east_asian_width(letter) in "WF" for letter in text)


def without_chinese(text: str, sign: str) -> str:
    """Return a text with every Chinese sign replaced by `sign`."""
    return _sign().sub(sign, text) if is_chinese(text) else text


def made_for(text: str, pattern: str) -> re.Pattern[str]:
    """Return the compiled pattern, with the Chinese signs only if the text contains some."""
    return _compiled(pattern, HAN if is_chinese(text) else "")


@cache
def _sign() -> re.Pattern[str]:
    return re.compile(f"[{HAN}]")


@cache
def _compiled(pattern: str, han: str) -> re.Pattern[str]:
    return re.compile(pattern.replace(HAN_HERE, han))


def unfolded(text: str) -> str:
    """Return a text without the line ends that would become spaces where Chinese has none."""
    return closed_up(text.replace("\n", OPEN_SPACE), "\n") if max(text, default="") >= _WIDE[0][0] else text


def closed_up(text: str, space: str = " ") -> str:
    """Return a text with `OPEN_SPACE` replaced by `space`, or removed where Chinese has no space."""
    if OPEN_SPACE not in text or not is_chinese(text):
        return text.replace(OPEN_SPACE, space)
    pieces = text.split(OPEN_SPACE)
    between = ("" if _has_no_space(*pair) else space for pair in pairwise(pieces))
    return "".join(map(str.__add__, ("", *between), pieces))


def _has_no_space(before: str, after: str) -> bool:
    """Return whether Chinese has no space between two pieces; told without a pattern, as those are slow to compile."""
    last, first = before[-1:], after[:1]
    return last in _STOPS or first in _STOPS or (_is_wide(last) and _is_wide(first))


def _is_wide(sign: str) -> bool:
    return any(first <= sign <= last for first, last in _WIDE)
