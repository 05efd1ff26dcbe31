"""What every page starts from: the templates of `reports/`, and text cleaned of what would spoil a page.

Enters: the name of a template; text of a student or a file.  Leaves: a template that escapes; plain text.
Used by the report and by the pages of grading.
"""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from coursework.data import folder
from coursework.line_ends import HAN, line_groups

if TYPE_CHECKING:
    from jinja2 import Template

LONGEST = 2000  # characters of one text: a word of 1 MB would take Typst half a minute
_LINE_END = re.compile(rf"(?<=[{HAN}])[ \t]*\n\s*(?=[{HAN}])")
_UNBROKEN = re.compile(rf"[^\s{HAN}]{{25,}}")
_SHORT = 24  # characters, below which no word needs a place to break
_PIECE = re.compile(r"\S{1,12}")
_INVISIBLE = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def template(name: str) -> Template:
    """Return a template of `reports/`; what is filled in is escaped, and a gap that nothing fills is an error."""
    return _template(folder("reports"), name)


@lru_cache
def _template(place: Path, name: str) -> Template:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    looks = Environment(
        loader=FileSystemLoader(place, encoding="utf-8"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    looks.filters["line_groups"] = line_groups
    return looks.get_template(name)


def clean(text: str, longest: int = LONGEST) -> str:
    """Return text without control, direction and unassigned characters, NFC, at most `longest` characters.

    Words beyond 24 letters get places to break (U+200B), so that none runs off the page.
    """
    if len(text) < _SHORT and text.isascii() and text.isprintable() and "  " not in text:
        return text.strip()[:longest]  # nearly every cell of a table
    joined = _LINE_END.sub("", unicodedata.normalize("NFC", text[: 4 * longest]))
    spaced = re.sub(r"[^\S\u00a0\u202f]+", " ", joined)
    plain = "".join(letter for letter in spaced if unicodedata.category(letter) not in _INVISIBLE).strip()
    if len(plain) > longest:
        plain = plain[: longest - 1].rstrip() + "…"
    return _UNBROKEN.sub(lambda word: "\u200b".join(_PIECE.findall(word[0])), plain)
