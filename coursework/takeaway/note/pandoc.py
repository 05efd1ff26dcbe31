"""The only way to pandoc, a separate program that is called, not linked.

Enters: text or a tree, and options.  Leaves: bytes.  Raises `OutputError` if pandoc fails.
Used by `formulas.py` and `writer.py`.
"""

from __future__ import annotations

import os
import subprocess
from functools import cache

from coursework.words.errors import OutputError
from coursework.words.sentences import say

SECONDS = 60.0
LONGEST = 500  # most characters of pandoc's error message
ITS_OWN = "CallStack"  # from this word on the message is about pandoc itself


@cache
def _program() -> str:
    import pypandoc

    found: str = pypandoc.get_pandoc_path()
    return found


def called(options: list[str], content: bytes) -> bytes:
    """Return the output of pandoc.  It reads only the files that the options name, and fetches nothing."""
    command = [_program(), *options]
    environment = os.environ | {"SOURCE_DATE_EPOCH": "315532800"}  # a fixed time, so that the bytes are always the same
    try:
        done = subprocess.run(command, input=content, capture_output=True, timeout=SECONDS, env=environment, check=False)
        if not done.returncode:
            return done.stdout
        told = done.stderr.decode("utf-8", "replace")
    except (OSError, subprocess.TimeoutExpired) as error:
        told = str(error)
    raise OutputError(say("fault.W043", refused=" ".join(told.partition(ITS_OWN)[0].split())[:LONGEST]))
