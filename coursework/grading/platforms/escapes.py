"""Text from a submission as others may see it: no formula in a spreadsheet, no letter that hides another.

Enters: any text.  Leaves: the text for a CSV cell, or for a page.  Used by everything that writes.
"""

from __future__ import annotations

import re
import unicodedata

_STARTS_FORMULA = tuple("=+-@＝＋－＠\t\r\n\0")
_PARTED = re.compile(
    r"([;\t\r\n][\s\"\u00a0]*)([=+\-@＝＋－＠](?=[\w(@\"'])(?!\d+(?:[.,]\d+)?(?:e[+-]?\d+)?(?:[\s;,.)]|$)))", re.IGNORECASE
)


def text_cell(text: str) -> str:
    r"""Return a text cell that no spreadsheet takes for a formula: where it might be one, a `'` stands first.

    So it is, but for a plain number, behind a semicolon, a tab or the end of a line, where a spreadsheet may part the cell.

    >>> text_cell("=HYPERLINK(1)"), text_cell("Ann"), text_cell('a;=HYPERLINK("x")')
    ("'=HYPERLINK(1)", 'Ann', 'a;\'=HYPERLINK("x")')
    """
    start = len(text) - len(text.lstrip())
    text = text[:start] + _PARTED.sub(r"\1'\2", text[start:])
    first = text.lstrip(" \"'\u00a0")
    return f"'{text}" if text.startswith(_STARTS_FORMULA) or first.startswith(_STARTS_FORMULA) else text


def shown(text: str) -> str:
    """Return a text with each letter that does not print, or that turns the direction of writing, as ⟨U+202E⟩.

    Lines and tabs stay; escaping for HTML is left to whoever writes HTML.
    """
    return "".join(letter if _is_visible(letter) else f"⟨U+{ord(letter):04X}⟩" for letter in text)


def _is_visible(letter: str) -> bool:
    return letter in "\n\t" or unicodedata.category(letter) not in {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
