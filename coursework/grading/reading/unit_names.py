"""The names of units as people write them, in any of the languages and with letters that look alike -> the unit.

Enters: a text.  Leaves: the unit's name, "" where it is none; the form in which texts are compared.
Used by `numbers.py`, `headers.py`, `layout.py`, `answers.py`, `labels.py`, `lines.py`, `line_kinds.py`, `columns.py` and
`names_in_text.py`.
"""

from __future__ import annotations

import re
import tomllib
import unicodedata
from pathlib import Path
from typing import Any

from coursework.variant.formula.alphabet import spell

# Letters of the Cyrillic alphabet that a keyboard leaves in place of Latin ones, after casefold().
_LATIN = str.maketrans("асеорхуіјѕвкмнт", "aceopxyijsbkmht")
# What people write in tables, in all languages.
WORDS: dict[str, Any] = tomllib.loads(Path(__file__).with_name("words.toml").read_text(encoding="utf-8"))


def fold(text: str) -> str:
    """Return a text as heads are compared: one form of each letter, Latin for its look-alikes, Greek written out."""
    plain = unicodedata.normalize("NFKC", text.replace("°", "º")).replace("º", "°").casefold()
    return spell(plain.replace("−", "-").translate(_LATIN))


_PER_SECOND = re.compile(r"(?<=.)(?:[·*]?(?:s|c)\^?-1|/(?:s|c)e[gcku]n?d?o?)$")  # rad·s⁻¹, м·с⁻¹, m/seg
_FOLDED_UNITS: dict[str, str] = {fold(spelling): unit for unit, spellings in WORDS["units"].items() for spelling in spellings}


def unit_of(text: str) -> str:
    """Return the unit that a text is, "" where it is none."""
    plain = re.sub(r"\s+", "", fold(text)).strip("[](){},;")
    return _FOLDED_UNITS.get(plain) or _FOLDED_UNITS.get(_PER_SECOND.sub("/s", plain), "")
