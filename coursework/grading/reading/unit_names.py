"""The spellings of units, in several languages and with look-alike letters -> the unit.

Enters: a text.  Leaves: the unit's name, "" if it is none; the folded form in which texts are compared.
Used by `numbers.py`, `headers.py`, `layout.py`, `answers.py`, `labels.py`, `row_values.py`, `line_kinds.py`, `columns.py` and
`names_in_text.py`.
"""

from __future__ import annotations

import re
import tomllib
import unicodedata
from pathlib import Path
from typing import Any

from coursework.variant.formula.alphabet import spell

# Cyrillic letters that are typed in place of Latin look-alikes, after casefold().
_LATIN = str.maketrans("асеорхуіјѕвкмнт", "aceopxyijsbkmht")
# The words and spellings found in tables, in all languages.
WORDS: dict[str, Any] = tomllib.loads(Path(__file__).with_name("words.toml").read_text(encoding="utf-8"))


def fold(text: str) -> str:
    """Return the form in which headers are compared: NFKC, casefolded, Latin look-alikes, Greek letters spelled out."""
    plain = unicodedata.normalize("NFKC", text.replace("°", "º")).replace("º", "°").casefold()
    return spell(plain.replace("−", "-").translate(_LATIN))


_PER_SECOND = re.compile(r"(?<=.)(?:[·*]?(?:s|c)\^?-1|/(?:s|c)e[gcku]n?d?o?)$")  # rad·s⁻¹, м·с⁻¹, m/seg
_FOLDED_UNITS: dict[str, str] = {fold(spelling): unit for unit, spellings in WORDS["units"].items() for spelling in spellings}


def unit_of(text: str) -> str:
    """Return the unit that a text names, "" if it names none."""
    plain = re.sub(r"\s+", "", fold(text)).strip("[](){},;")
    return _FOLDED_UNITS.get(plain) or _FOLDED_UNITS.get(_PER_SECOND.sub("/s", plain), "")
