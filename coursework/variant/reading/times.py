"""The times of a file and the rows that it speaks of.

Enters: the checked sections [time] and [[quote]].  Leaves: `Time`, `Quote`; faults stay with the `Parts`.  Used by `reader.py`.
"""

from __future__ import annotations

import math

from coursework.variant.reading import schema
from coursework.variant.reading.parts import Parts
from coursework.variant.record.variant import MAX_ROWS, Quote, Time, whole_steps
from coursework.variant.record.vocabulary import OF_FORCES, scheme_names
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentences import closest, say


def read_time(entry: schema.Time, parts: Parts) -> Time:
    """Return step, end, period, row of the check and scheme."""
    step = parts.number(("time", "step"), entry.step, "s")
    end = parts.number(("time", "end"), entry.end, "s")
    period = None if entry.period is None else parts.number(("time", "period"), entry.period, "s")
    if step <= 0:
        parts.say(("time", "step"), say("fault.V063", step=step))
    elif end < step * (1 - 1e-9):
        parts.say(("time", "end"), say("fault.V071", end=end, step=step))
    elif MAX_ROWS < end / step < math.inf:  # what is not finite has a fault of its own
        parts.say(("time", "end"), say("fault.V076", number=end / step, max_rows=MAX_ROWS))
    elif parts.broken.isdisjoint({("time", "step"), ("time", "end")}) and math.isfinite(end / step):
        rows = whole_steps(step, end) + 1
        if entry.check_row is not None and entry.check_row > rows:
            parts.say(("time", "check_row"), say("fault.V077", check_row=entry.check_row, number=rows))
    if period is not None and period <= 0:
        parts.say(("time", "period"), say("fault.V064", period=period))
    return Time(step, end, period, entry.check_row, scheme=_scheme(entry.scheme, ("time", "scheme"), parts))


def _scheme(name: str | None, path: KeyPath, parts: Parts) -> str:
    """Return the name of a scheme, "" for none."""
    names = (*scheme_names(), *(OF_FORCES if "motor" in parts.source.data else ()))
    if name is not None and name not in names:
        parts.say(path, say("fault.V065", name=name, hint=closest(name, names), known=", ".join(names)))
    return name or ""


def read_quote(place: int, entry: schema.Quote, columns: list[str], time: Time, parts: Parts) -> Quote:
    """Return a number that a remark quotes."""
    if time.step > 0 and math.isfinite(time.end / time.step) and entry.row > time.steps + 1:
        parts.say(("quote", place, "row"), say("fault.V066", row=entry.row, number=time.steps + 1))
    column = parts.names.canonical(entry.column)
    if column not in columns:
        parts.undeclared(
            ("quote", place, "column"),
            {"coordinate", "rate", "unknown"},
            say("fault.V067", column=column, hint=closest(column, columns)),
        )
    return Quote(entry.row, column, entry.value.replace("−", "-"), _scheme(entry.scheme, ("quote", place, "scheme"), parts))
