"""What a late submission loses according to the rubric.

Enters: the section `[late]` of the rubric, the time a submission was handed in.  Leaves: `Late`, minutes, shares.
Used by `rubric.py`, `class_list.py`, `decisions.py` and the command.
"""

from __future__ import annotations

import math
import re
from dataclasses import asdict
from datetime import datetime
from typing import Any

from coursework.system.frozen import frozen

DAY = 24 * 60 * 60
UNKNOWN, LATE = "unknown", "late"  # written instead of a time: it is not known, or the platform says only "late"
OF_FILE = "file "  # written before a time that no platform gives: that of the newest file
_SPAN = re.compile(r"([0-9]+(?:\.[0-9]+)?) ?(s|min|h|d)")
_SECONDS = {"s": 1, "min": 60, "h": 3600, "d": DAY}


@frozen
class Late:
    """The `deadline` (with its time zone), `grace` as written, the share of the points lost per day begun, and the most lost."""

    deadline: datetime
    grace: str = "0 min"
    lost_per_day: float = 0.1
    at_most: float = 1.0

    def share(self, handed_in: str) -> tuple[int | None, float] | None:
        """Return the minutes of delay (None if unknown) and the share lost; None if in time or if the time is not known.

        Days begin at the deadline; within `grace` after it nothing is lost.  A time without a zone has the deadline's.
        """
        if handed_in == LATE:
            return None, min(self.at_most, self.lost_per_day)
        if handed_in in ("", UNKNOWN):
            return None
        seconds = (self.time(handed_in) - self.deadline).total_seconds()
        if seconds <= max(0.0, span(self.grace) or 0.0):
            return None
        return math.ceil(seconds / 60), min(self.at_most, self.lost_per_day * math.ceil(seconds / DAY))

    def time(self, handed_in: str) -> datetime:
        """Return the time that is written, in the deadline's zone."""
        time = datetime.fromisoformat(handed_in.removeprefix(OF_FILE))
        return time.astimezone(self.deadline.tzinfo) if time.tzinfo else time.replace(tzinfo=self.deadline.tzinfo)

    def plain(self) -> dict[str, Any]:
        """Return the section as it was used, for grades.json."""
        return asdict(self) | {"deadline": self.deadline.isoformat()}


def span(text: str) -> float | None:
    """Return the seconds in a text such as "15 min", None if it is no such text.

    >>> span("15 min"), span("1.5 h"), span("soon")
    (900.0, 5400.0, None)
    """
    found = _SPAN.fullmatch(text.strip())
    return float(found[1]) * _SECONDS[found[2]] if found else None
