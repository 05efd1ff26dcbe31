"""Text from a submission made safe for others: no formula in a spreadsheet, no invisible or reversing characters.

Enters: any text.  Leaves: the text for a CSV cell or a page.  Used by all code that writes such files.
"""

from __future__ import annotations

import re
import unicodedata

from coursework.words.templates import INVISIBLE

_STARTS_FORMULA = tuple("=+-@＝＋－＠\t\r\n\0")
_PARTED = re.compile(
    r"([;\t\r\n][\s\"\u00a0]*)([=+\-@＝＋－＠](?=[\w(@\"'])(?!\d+(?:[.,]\d+)?(?:e[+-]?\d+)?(?:[\s;,.)]|$)))", re.IGNORECASE
)


def text_cell(text: str) -> str:
    r"""Return a text cell that no spreadsheet takes for a formula: a `'` is put before what might be one.

    This is also done after a semicolon, a tab or a line end, where a spreadsheet may split the cell, except for a plain number.

    >>> text_cell("=HYPERLINK(1)"), text_cell("Ann"), text_cell('a;=HYPERLINK("x")')
    ("'=HYPERLINK(1)", 'Ann', 'a;\'=HYPERLINK("x")')
    """
    start = len(text) - len(text.lstrip())
    text = text[:start] + _PARTED.sub(r"\1'\2", text[start:])
    first = text.lstrip(" \"'\u00a0")
    return f"'{text}" if text.startswith(_STARTS_FORMULA) or first.startswith(_STARTS_FORMULA) else text


def shown(text: str) -> str:
    """Return a text in which characters that do not print, or that reverse the direction of writing, appear as ⟨U+202E⟩.

    Line ends and tabs are kept; escaping for HTML is left to the caller.
    """
    return "".join(letter if _is_visible(letter) else f"⟨U+{ord(letter):04X}⟩" for letter in text)


def _is_visible(letter: str) -> bool:
    return letter in "\n\t" or unicodedata.category(letter) not in INVISIBLE
