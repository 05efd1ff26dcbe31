"""A process of a pool: a line of JSON in, one out, until there are no more.

Enters: an `Opening`, then jobs, on standard input.  Leaves: an `Answered` a job on standard output, which nothing else reaches.
Used by `pool.py`, which starts it.  What a file does to this process it does to nobody else.
"""

from __future__ import annotations

import json
import os
import signal
from contextlib import suppress
from importlib import import_module
from typing import Any, BinaryIO

from coursework.system.budget import MIB, limit_memory, memory_held
from coursework.system.frozen import frozen
from coursework.system.plain_lines import line_of, plain_of, read_line


@frozen
class Opening:
    """The first line: the trade as "module:function", what the function is given, the most memory (MiB) or None."""

    trade: str
    setup: Any
    memory: int | None


@frozen
class Answered:
    """An answer, and the MiB that the process has grown by since its first one: a leak must not become a student's fault."""

    grown: int
    answer: Any


def serve(lines: BinaryIO, answers: BinaryIO) -> None:
    """Answer every line until there are none."""
    opening = read_line(Opening, lines.readline())
    module, _, name = opening.trade.partition(":")
    with getattr(import_module(module), name)(opening.setup) as work:
        if opening.memory:
            limit_memory(opening.memory)
        at_first = 0
        for line in lines:
            answer = work(json.loads(line))
            held = (memory_held() or 0) // MIB
            at_first = at_first or held
            answers.write(line_of(Answered(max(0, held - at_first), plain_of(answer))))
            answers.flush()


def main() -> None:
    """Serve on the standard streams; what a library prints there, or reads, goes nowhere and comes from nowhere."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever started us hears it too, and ends us
    lines, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nowhere = os.open(os.devnull, os.O_RDWR)
    os.dup2(nowhere, 0)
    os.dup2(nowhere, 1)
    with suppress(BrokenPipeError):  # whoever started us is gone
        serve(lines, answers)
    os._exit(0)  # everything is put away; an interpreter full of libraries takes its time to end
