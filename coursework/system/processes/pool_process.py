"""A process of a pool: it reads jobs as lines of JSON and writes one answer line for each, until its input ends.

Enters: an `Opening`, then jobs, on standard input.  Leaves: one `Answered` per job on standard output, to which nothing else
is written.  Used by `pool.py`, which starts it.  A hostile file can harm this process only.
"""

from __future__ import annotations

import json
import os
import signal
from contextlib import suppress
from importlib import import_module
from typing import Any, BinaryIO

from coursework.system.frozen import frozen
from coursework.system.processes.budget import MIB, end_after, limit_memory, memory_held
from coursework.system.processes.plain_lines import line_of, plain_of, read_line


@frozen
class Opening:
    """The first line: the function of the trade as "module:function", its `setup`, and the limits, None for no limit.

    These are `memory` (MiB), and `processor` time of a job (s), of which the first may take `starting` seconds more.
    """

    trade: str
    setup: Any
    memory: int | None
    processor: float | None
    starting: float


@frozen
class Answered:
    """An answer, and the MiB by which the process has `grown` since its first one: a leak must not count as a student's fault."""

    grown: int
    answer: Any


def serve(lines: BinaryIO, answers: BinaryIO) -> None:
    """Answer the lines one by one until the input ends."""
    opening = read_line(Opening, lines.readline())
    module, _, name = opening.trade.partition(":")
    with getattr(import_module(module), name)(opening.setup) as work:
        if opening.memory:
            limit_memory(opening.memory)
        at_first, more = 0, opening.starting
        for line in lines:
            end_after(opening.processor and opening.processor + more)
            answer = work(json.loads(line))
            end_after(None)
            more = 0.0
            held = (memory_held() or 0) // MIB
            at_first = at_first or held
            answers.write(line_of(Answered(max(0, held - at_first), plain_of(answer))))
            answers.flush()


def main() -> None:
    """Serve on the standard streams; a library that prints or reads there gets the null device instead."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent process receives the interrupt too, and ends us
    lines, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nowhere = os.open(os.devnull, os.O_RDWR)
    os.dup2(nowhere, 0)
    os.dup2(nowhere, 1)
    with suppress(BrokenPipeError):  # the parent process is gone
        serve(lines, answers)
    os._exit(0)  # nothing is left to clean up, and an interpreter full of libraries is slow to exit
