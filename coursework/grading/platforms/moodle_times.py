"""When a submission was last changed, as Moodle writes it in the language of the teacher.

Enters: a cell of the worksheet.  Leaves: a time without a zone, as the teacher's clock shows it.  Used by `worksheet.py`.
"""

from __future__ import annotations

import re
import unicodedata
from datetime import datetime

# By the first letters of the names of the months, of all languages, that tell them apart.
_MONTHS = (
    "jan,янв,січ,ene", "feb,fév,фев,лют", "mar,mär,мар,бер", "apr,avr,abr,апр,кві", "may,mai,мая,май,тра",
    "jun,juin,июн,чер", "jul,juil,июл,лип", "aug,aoû,ago,авг,сер", "sep,сен,вер", "oct,okt,окт,жов",
    "nov,ноя,лис", "dec,dez,déc,dic,дек,гру",
)  # fmt: skip
_CLOCK = re.compile(r"(?<![0-9])([0-9]{1,2})[:.]([0-9]{2})(?::([0-9]{2}))?(?![0-9])")
_CHINESE = re.compile(r"([0-9]{4}) ?年 ?([0-9]{1,2}) ?月 ?([0-9]{1,2}) ?日")
_ISO = re.compile(r"([0-9]{4})-([0-9]{1,2})-([0-9]{1,2})")
_DAY_MONTH = re.compile(r"(?<![0-9])([0-9]{1,2})\.?\s+(?:de\s+)?([^\W\d_]{3,})\.?,?\s+(?:de\s+)?([0-9]{4})(?![0-9])")
# Behind or before a clock of 12 hours.
_AFTERNOON = re.compile(r"[0-9] ?p\.? ?m\b|下午|晚上|[0-9] ?пп\b")
_MORNING = re.compile(r"[0-9] ?a\.? ?m\b|上午|凌晨|早上|[0-9] ?дп\b")


def moodle_time(text: str) -> datetime | None:
    """Return the time that a cell tells, None where it tells none.

    >>> moodle_time("Tuesday, 1 December 2026, 11:59 PM").isoformat()
    '2026-12-01T23:59:00'
    """
    plain = " ".join(unicodedata.normalize("NFKC", text).casefold().split())
    clocks = _CLOCK.findall(plain)
    date = _date(plain)
    if len(clocks) != 1 or date is None:
        return None
    hour, minute, second = (int(number or 0) for number in clocks[0])
    after = bool(_AFTERNOON.search(plain))
    if (after or _MORNING.search(plain)) and 1 <= hour <= 12:
        hour = hour % 12 + 12 * after
    try:
        return datetime(*date, hour, minute, second)
    except ValueError:
        return None


def _date(plain: str) -> tuple[int, int, int] | None:
    if found := _CHINESE.search(plain) or _ISO.search(plain):
        return int(found[1]), int(found[2]), int(found[3])
    found = _DAY_MONTH.search(plain)
    if not found:
        return None
    months = [
        number for number, names in enumerate(_MONTHS, start=1) if any(found[2].startswith(name) for name in names.split(","))
    ]
    return (int(found[3]), months[0], int(found[1])) if len(months) == 1 else None
