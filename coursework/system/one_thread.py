"""Linear algebra in one thread: matrices of a mechanism are small, and a thread that waits for larger ones costs start-up.

Enters: nothing.  Leaves: variables of the environment, which count until NumPy is loaded; those of the user stand.
Used by `pool.py` and `commands/program.py`.
"""

from __future__ import annotations

import os

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")


def keep_to_one_thread() -> None:
    """Let the libraries that this process loads from now on use one thread, unless the user has said how many."""
    for name, value in ONE_THREAD.items():
        os.environ.setdefault(name, value)
