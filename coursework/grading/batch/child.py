"""The process that looks into submissions: one line of JSON in, one out, with limits of its own.  Each answer stands behind
the MiB that the process has grown by since its first one, so that it can be replaced before a leak becomes a student's fault.

    python -m coursework.grading.batch.child

Enters: a setup line, then task lines, on standard input.  Leaves: outcome lines on standard output; nothing else is written.
Started by `supervisor.py` only.  What a student hands in may kill this process; it never holds more than one submission.
"""

from __future__ import annotations

import json
import os
import sys
from typing import BinaryIO

# One submission is one thread's work; more threads of linear algebra only cost memory and start-up.
for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")


def limit_memory(mib: int) -> None:
    """Bound the address space of this process, where the platform can."""
    try:
        import resource
    except ImportError:  # Windows: the supervisor's limit of time is what remains
        return
    size = mib * 2**20
    resource.setrlimit(resource.RLIMIT_AS, (size, resource.getrlimit(resource.RLIMIT_AS)[1]))


def most_memory() -> int:
    """Return the most memory (MiB) this process has held at once; 0 where the platform does not say."""
    try:
        import resource
    except ImportError:
        return 0
    unit = 2**20 if sys.platform == "darwin" else 2**10  # macOS counts bytes, others KiB
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // unit


def serve(lines: BinaryIO, answers: BinaryIO) -> None:
    """Answer every line until there are none."""
    from coursework.grading.batch.work import setup_from
    from coursework.grading.batch.workshop import Workshop
    from coursework.words.custom_templates import templates_standing_in

    setup = setup_from(json.loads(lines.readline()))
    with templates_standing_in(setup.pieces):
        workshop = Workshop(setup)
        limit_memory(setup.memory_mib)
        at_first = 0
        for line in lines:
            answer = workshop.answer(line).line()
            used = most_memory()
            at_first = at_first or used
            answers.write(b"%d " % (used - at_first) + answer)
            answers.flush()


def main() -> None:
    """Serve on the standard streams; what a library prints goes to standard error."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    serve(sys.stdin.buffer, answers)


if __name__ == "__main__":
    main()
