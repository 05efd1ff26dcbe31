"""What a process of `run A B C …` does here instead of running variants: it dies over each that is called "die".

Enters: items.  Leaves: outcomes.  Used by `test_several.py`.
"""

from __future__ import annotations

import os
import sys
from contextlib import contextmanager

from coursework.commands.several import Item, Outcome
from coursework.system.processes.plain_lines import record_of


@contextmanager
def opened(task):
    yield work


def work(plain):
    item = record_of(Item, plain)
    if item.variant == "die":
        print("dies", file=sys.stderr, flush=True)
        os._exit(7)
    return Outcome(item, 0)
