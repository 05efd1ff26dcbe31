"""Patterns of text in which Chinese may stand: its signs are letters to Python, but no part of a name or a word beside them.

Enters: a pattern with `HAN_HERE` where its signs stand, and the text it is for.  Leaves: the compiled pattern.
Used by `templates.py`, `line_ends.py` and `report/text/text_runs.py`.

A class with 29 000 signs takes a millisecond to make, ten of them as long as the checks of a table: without a Chinese sign in
the text the same pattern without them says the same.
"""

from __future__ import annotations

import re
from functools import cache

HAN = "\u2e80-\u9fff\uff00-\uffef"  # no spaces between them, and a line may break at any of them
HAN_HERE = "\ue011"


def is_chinese(text: str) -> bool:
    """Return whether a sign of Chinese stands in a text."""
    return max(text, default="") >= HAN[0] and _sign().search(text) is not None


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
