"""Limits of the cost of one run (numbers in its table, periods, a period shorter than a step), and other times for it.

Enters: a `Variant`, a step and an end.  Leaves: the limits exceeded, the variant with these times; raises `InputError`.
Used where a file is read, and before a motion is integrated, because step and end may come from the command line.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress

from coursework.variant.formula.units import UnitFault, read
from coursework.variant.record.variant import MAX_NUMBERS, MAX_ROWS, MOST_PERIODS, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_CLOSE = 1e-9


def exceeded(variant: Variant) -> Iterator[tuple[str, Sentence]]:
    """Yield the key of [time] and a sentence for every limit that is exceeded."""
    time = variant.time
    rows, columns = time.steps + 1, len(variant.columns)
    if rows * columns > MAX_NUMBERS:
        yield "step", say("fault.V016", rows=rows, columns=columns, most=MAX_NUMBERS)
    if time.period is not None and time.period < time.step * (1 - _CLOSE):
        yield "period", say("fault.V017", period=time.period, step=time.step)
    elif time.period is not None and time.end / time.period > MOST_PERIODS * (1 + _CLOSE):
        yield "end", say("fault.V018", periods=time.end / time.period, most=MOST_PERIODS)


def refuse_unbounded(variant: Variant) -> None:
    """Raise `InputError` if a run would cost too much."""
    faults = [Fault(text, variant.file, variant.nearest_line("time", key), 0, f"time.{key}") for key, text in exceeded(variant)]
    if faults:
        raise InputError(faults)


def timed(variant: Variant, step: float | None, end: float | str | None) -> Variant:
    """Return the variant with another step and end (s).  Raises `InputError` for times that give no table."""
    h = number_of_seconds(step, "step") if step is not None else variant.time.step
    last = number_of_seconds(end, "end") if end is not None else variant.time.end
    if not (math.isfinite(h) and h > 0):
        raise InputError(say("fault.C008", h=h))
    if not math.isfinite(last):
        raise InputError(say("fault.C009", last=last))
    if last < h * (1 - 1e-9):
        raise InputError(say("fault.C010", last=last, h=h))
    if last / h > MAX_ROWS:
        raise InputError(say("fault.C011", number=last / h, max_rows=MAX_ROWS))
    return variant.timed(h, last)


def seconds(time: float | str | None) -> float | str | None:
    """Return a time in seconds; text that is no time is returned unchanged, so that the function that uses it reports it."""
    if not isinstance(time, str):
        return time
    with suppress(UnitFault):
        found = read(time, "s")
        return found.value if found.si in {"s", ""} else time
    with suppress(ValueError):  # nan and infinity become numbers, so that they are reported as such
        return float(time)
    return time


def number_of_seconds(value: object, name: str) -> float:
    """Return a number of seconds.  Raises `InputError` for any other value."""
    with suppress(TypeError, ValueError):
        if not isinstance(value, bool):
            return float(value)  # type: ignore[arg-type]
    raise InputError(say("fault.C012", name=name, value=value, hint=say("hint.point") if "," in str(value) else ""))
