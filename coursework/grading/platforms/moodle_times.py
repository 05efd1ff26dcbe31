"""When a submission was last changed, as Moodle writes it in the teacher's language; its words are in `moodle.toml`.

Enters: a cell of the worksheet.  Leaves: a time without a zone, by the teacher's clock.
Used by `worksheet.py` and `downloads.py`.
"""

from __future__ import annotations

import re
import tomllib
import unicodedata
from datetime import datetime
from pathlib import Path
from typing import Any

MOODLE: dict[str, Any] = tomllib.loads(Path(__file__).with_name("moodle.toml").read_text(encoding="utf-8"))
_CLOCK = re.compile(r"(?<![0-9])([0-9]{1,2})[:.]([0-9]{2})(?::([0-9]{2}))?(?![0-9])")
_CHINESE = re.compile(r"([0-9]{4}) ?年 ?([0-9]{1,2}) ?月 ?([0-9]{1,2}) ?日")
_ISO = re.compile(r"([0-9]{4})-([0-9]{1,2})-([0-9]{1,2})")
_DAY_MONTH = re.compile(r"(?<![0-9])([0-9]{1,2})\.?\s+(?:de\s+)?([^\W\d_]{3,})\.?,?\s+(?:de\s+)?([0-9]{4})(?![0-9])")
# Signs of a 12-hour clock, before or after the time.
_AFTERNOON = re.compile(r"[0-9] ?p\.? ?m\b|下午|晚上|[0-9] ?пп\b")
_MORNING = re.compile(r"[0-9] ?a\.? ?m\b|上午|凌晨|早上|[0-9] ?дп\b")


def moodle_time(text: str) -> datetime | None:
    """Return the time that a cell states, None if it states none.

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
    months = [number for number, names in enumerate(MOODLE["months"], start=1) if found[2].startswith(tuple(names))]
    return (int(found[3]), months[0], int(found[1])) if len(months) == 1 else None
