"""What one run may cost: numbers in its table, periods, and a period of less than a step.

Enters: a `Variant`.  Leaves: what is too much; raises `InputError`.
Used where a file is read, and before a motion is marched, because step and end may come from the command line.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.variant.record.variant import MAX_NUMBERS, MOST_PERIODS, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_CLOSE = 1e-9


def exceeded(variant: Variant) -> Iterator[tuple[str, Sentence]]:
    """Yield the key of [time] and a sentence for everything that is too much."""
    time = variant.time
    rows, columns = time.steps + 1, len(variant.columns)
    if rows * columns > MAX_NUMBERS:
        yield "step", say("fault.V016", rows=rows, columns=columns, most=MAX_NUMBERS)
    if time.period is not None and time.period < time.step * (1 - _CLOSE):
        yield "period", say("fault.V017", period=time.period, step=time.step)
    elif time.period is not None and time.end / time.period > MOST_PERIODS * (1 + _CLOSE):
        yield "end", say("fault.V018", periods=time.end / time.period, most=MOST_PERIODS)


def refuse_unbounded(variant: Variant) -> None:
    """Raise `InputError` where a run would cost too much."""
    faults = [Fault(text, variant.file, variant.nearest_line("time", key), 0, f"time.{key}") for key, text in exceeded(variant)]
    if faults:
        raise InputError(faults)
