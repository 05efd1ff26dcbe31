"""Linear algebra in one thread: the matrices of a mechanism are small, and idle worker threads slow down the start.

Enters: nothing.  Leaves: environment variables that NumPy reads when it is loaded; those set by the user are kept.
Used by `pool.py` and `commands/line/program.py`.
"""

from __future__ import annotations

import os

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")


def keep_to_one_thread() -> None:
    """Make the libraries that this process loads from now on use one thread, unless the user has set a number."""
    for name, value in ONE_THREAD.items():
        os.environ.setdefault(name, value)
