"""The names of units as people write them, in any of the languages and with letters that look alike -> the unit.

Enters: a text.  Leaves: the unit's name, "" where it is none; the form in which texts are compared.
Used by `numbers.py`, `headers.py`, `layout.py`, `answers.py`, `labels.py`, `line_kinds.py` and `names_in_text.py`.
"""

from __future__ import annotations

import re
import unicodedata

from coursework.variant.formula.alphabet import spell

# Letters of the Cyrillic alphabet that a keyboard leaves in place of Latin ones, after casefold().
_LATIN = str.maketrans("асеорхуіјѕвкмнт", "aceopxyijsbkmht")
_UNITS = {
    "rad": "рад rad радиан радиани радиан. radian radians 弧度", "deg": "град град. ° deg degree degrees grad º 度 градусы",
    "1/s": "1/с 1/s 1/c рад/с rad/s rad/sec рад/сек с-1 s-1 с^-1 s^-1 1/сек 1/sec radian/second 弧度/秒 rad/秒 rad/с рад·с-1",
    "deg/s": "град/с deg/s °/s °/с град/сек grad/s 度/秒 º/s", "rpm": "об/мин rpm об/хв u/min min-1 мин-1 хв-1 rev/min r/min",
    "s": "с s c сек сек. sec 秒 seconds sekunden", "ms": "мс ms", "m": "м m", "mm": "мм mm", "cm": "см cm",
    "m/s": "м/с m/s м/сек m/sec 米/秒 metre/second meter/second", "mm/s": "мм/с mm/s", "cm/s": "см/с cm/s",
}  # fmt: skip


def fold(text: str) -> str:
    """Return a text as heads are compared: one form of each letter, Latin for its look-alikes, Greek written out."""
    plain = unicodedata.normalize("NFKC", text.replace("°", "º")).replace("º", "°").casefold()
    return spell(plain.replace("−", "-").translate(_LATIN))


_FOLDED_UNITS = {fold(spelling): unit for unit, spellings in _UNITS.items() for spelling in spellings.split()}


def unit_of(text: str) -> str:
    """Return the unit that a text is, "" where it is none."""
    return _FOLDED_UNITS.get(re.sub(r"\s+", "", fold(text)).strip("[](){},;"), "")
