"""What one run may cost: numbers in its table, periods, and a period of less than a step.

Enters: a `Variant`.  Leaves: what is too much; raises `InputError`.
Used where a file is read, and before a motion is marched, because step and end may come from the command line.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.errors import Fault, InputError
from coursework.variant.record import MAX_NUMBERS, MOST_PERIODS, Variant

_CLOSE = 1e-9


def exceeded(variant: Variant) -> Iterator[tuple[str, str]]:
    """Yield the key of [time] and a sentence for everything that is too much."""
    time = variant.time
    rows, columns = time.steps + 1, len(variant.columns)
    if rows * columns > MAX_NUMBERS:
        text = f"{rows} rows of {columns} columns are asked for; a table has at most {MAX_NUMBERS} numbers."
        yield "step", f"{text} Take a larger step."
    if time.period is not None and time.period < time.step * (1 - _CLOSE):
        yield "period", f"the period ({time.period:g} s) must be at least one step ({time.step:g} s)."
    elif time.period is not None and time.end / time.period > MOST_PERIODS * (1 + _CLOSE):
        text = f"the run lasts for {time.end / time.period:.3g} periods; at most {MOST_PERIODS} are computed."
        yield "end", f"{text} Take an earlier end."


def refuse_unbounded(variant: Variant) -> None:
    """Raise `InputError` where a run would cost too much."""
    file = str(variant.path or variant.name)
    faults = [Fault(text, file, variant.nearest_line("time", key), 0, f"time.{key}") for key, text in exceeded(variant)]
    if faults:
        raise InputError(faults)
