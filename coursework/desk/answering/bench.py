"""The function that each process of the desk runs: a job as plain data -> an answer, each under its own budget.

Enters: `Setup`, jobs.  Leaves: `Answer`s.  Every process of `serving/renderers.py` opens it by name; no module imports it.
"""

from __future__ import annotations

import gzip
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from coursework.desk.answering import completion, derived, drag, pieces, takeaway, variant_page
from coursework.desk.answering.contradicted import naming_terms
from coursework.desk.answering.typed import Desk, faults_of
from coursework.desk.job import FAULT, OK, Answer, Job, Setup, fault_entry, faulty, plain, tell_place, told
from coursework.system.processes.budget import limit_memory, watched
from coursework.system.processes.plain_lines import record_of
from coursework.words.errors import CourseworkError
from coursework.words.sentences import say

PACKED_FROM = 2000  # bytes; compressing a shorter answer costs more than it saves
KINDS: dict[str, Callable[[Desk], dict[str, Any] | Answer]] = {
    "page": naming_terms("page", variant_page.page),
    "check": naming_terms("check", variant_page.check),
    "take": takeaway.take,
    "table": takeaway.table,
    "catalogue": completion.catalogue,
    "keys": completion.keys,
    "equations": derived.equations,
    "drag": drag.drag,
    "pieces": pieces.pieces,
    "piece": pieces.piece,
    "warm": variant_page.warm,
}


@contextmanager
def opened(plain_setup: Any) -> Iterator[Callable[[Any], Answer]]:
    """Yield a function that answers one job after the other."""
    setup = record_of(Setup, plain_setup)
    with suppress(OSError), Path("/proc/self/statm").open(encoding="ascii") as file:
        held = int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")  # bytes that the process holds with all its libraries
        limit_memory(2 * setup.bounds.memory, held)  # stops growth between two looks of the watch
    yield lambda job: answer(record_of(Job, job), setup)


def answer(job: Job, setup: Setup) -> Answer:
    """Return the answer to a job; errors caused by its text become faults of the text."""
    desk = Desk(job.body, job.language, setup)
    try:
        with watched(setup.bounds, desk.name, lambda _fault: None):
            made = KINDS[job.kind](desk)
    except CourseworkError as error:
        return faulty(job.kind, faults_of(error, desk))
    except MemoryError:
        return faulty(job.kind, [fault_entry("E002", desk.words.written(say("screen.memory")))])
    except Exception as error:
        tell_place(error)
        return told(FAULT, job.language, "desk.our_fault")
    found = made if isinstance(made, Answer) else plain(OK, made)
    if not job.packed or found.name or len(found.body) < PACKED_FROM:
        return found
    return replace(found, body=gzip.compress(found.body, 4), packed=True)
