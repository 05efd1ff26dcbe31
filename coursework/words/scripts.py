"""Text in which Chinese may stand: its signs are letters to Python, but no part of a word beside them, and know few spaces.

Enters: a pattern with `HAN_HERE` where its signs stand, and the text it is for; a text.  Leaves: the compiled pattern; the text.
Used by `sentences.py`, `templates.py`, `line_ends.py`, `report/text/text_runs.py` and `variant/reading/reader.py`; what sets
columns, `commands/screen.py`, `commands/line/kinds.py`, `mechanism/drafts/text.py` and `takeaway/note/blocks.py`, for widths.

A class with 29 000 signs takes a millisecond to make, ten of them as long as the checks of a table: without a Chinese sign in
the text the same pattern without them says the same.
"""

from __future__ import annotations

import re
from functools import cache

HAN = "\u2e80-\u9fff\uff00-\uffef"  # no spaces between them, and a line may break at any of them
HAN_HERE = "\ue011"
# A space of our own beside a gap: Chinese sets one beside Latin letters and figures, none between its own signs or beside its
# full stops and parentheses; which of them a gap brings is known when it is filled.
OPEN_SPACE = "\ue00f"
_WIDE, _STOPS = "\u3000-\u303f\u3400-\u9fff\uff00-\uff65", "、。，；：！？（）"


def is_chinese(text: str) -> bool:
    """Return whether a sign of Chinese stands in a text: marks of our own lie above most of them, and wait for no pattern."""
    return max(text, default="") >= HAN[0] and any(HAN[0] <= sign <= HAN[2] or HAN[3] <= sign <= HAN[5] for sign in text)


def wide_letters(text: str) -> int:
    """Return how many letters of a text are as wide as two, as Unicode has it.

    >>> wide_letters("步 h"), wide_letters("step h")
    (1, 0)
    """
    from unicodedata import east_asian_width  # only what sets columns pays for it

    return sum(east_asian_width(letter) in "WF" for letter in text)


def without_chinese(text: str, sign: str) -> str:
    """Return a text with `sign` in the place of every sign of Chinese."""
    return _sign().sub(sign, text) if is_chinese(text) else text


def made_for(text: str, pattern: str) -> re.Pattern[str]:
    """Return a pattern, with the signs of Chinese where there are some in the text."""
    return _compiled(pattern, HAN if is_chinese(text) else "")


@cache
def _sign() -> re.Pattern[str]:
    return re.compile(f"[{HAN}]")


@cache
def _compiled(pattern: str, han: str) -> re.Pattern[str]:
    return re.compile(pattern.replace(HAN_HERE, han))


def unfolded(text: str) -> str:
    """Return a text without the ends of lines that would become spaces where Chinese sets none."""
    return closed_up(text.replace("\n", OPEN_SPACE), "\n") if max(text, default="") >= _WIDE[0] else text


def closed_up(text: str, space: str = " ") -> str:
    """Return a text with `space` for each open space that is one, and nothing for the others."""
    if OPEN_SPACE not in text:
        return text
    return (_no_space().sub("", text) if is_chinese(text) else text).replace(OPEN_SPACE, space)


@cache
def _no_space() -> re.Pattern[str]:
    """Return the places without a space; English has none, and does not wait for the pattern."""
    return re.compile(f"(?<=[{_WIDE}]){OPEN_SPACE}(?=[{_WIDE}])|(?<=[{_STOPS}]){OPEN_SPACE}|{OPEN_SPACE}(?=[{_STOPS}])")
