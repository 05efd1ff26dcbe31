"""One thread for linear algebra and Typst: matrices are small, pages few, and idle worker threads cost more than they save.

Enters: nothing.  Leaves: environment variables that NumPy and Typst read when they are loaded; those set by the user are kept.
Used by `pool.py` and `commands/line/program.py`.
"""

from __future__ import annotations

import os

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS"), "1")


def keep_to_one_thread() -> None:
    """Make the libraries that this process loads from now on use one thread, unless the user has set a number."""
    for name, value in ONE_THREAD.items():
        os.environ.setdefault(name, value)
