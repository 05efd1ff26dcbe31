"""The one way to pandoc, a program of its own that is called, not linked.

Enters: text or a tree, and options.  Leaves: bytes.  Raises `OutputError` where it refuses.
Used by `formulas.py` and `writer.py`.
"""

from __future__ import annotations

import os
import subprocess
from functools import cache

from coursework.words.errors import OutputError
from coursework.words.sentences import say

SECONDS = 60.0
LONGEST = 500  # characters of what it says
ITS_OWN = "CallStack"  # from here on it tells of itself


@cache
def _program() -> str:
    import pypandoc

    found: str = pypandoc.get_pandoc_path()
    return found


def called(options: list[str], content: bytes) -> bytes:
    """Return what pandoc makes of its input.  It reads no file but those that the options name, and fetches nothing."""
    command = [_program(), *options]
    environment = os.environ | {"SOURCE_DATE_EPOCH": "315532800"}  # the hour of no run: the same bytes each time
    try:
        done = subprocess.run(command, input=content, capture_output=True, timeout=SECONDS, env=environment, check=False)
        if not done.returncode:
            return done.stdout
        told = done.stderr.decode("utf-8", "replace")
    except (OSError, subprocess.TimeoutExpired) as error:
        told = str(error)
    raise OutputError(say("fault.W043", refused=" ".join(told.partition(ITS_OWN)[0].split())[:LONGEST]))
