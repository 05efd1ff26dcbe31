"""Where a path leads once its symbolic links are followed.

Enters: a path.  Leaves: an absolute path without links.
Used by `tables.py`, `inside.py`, `several.py` and `grade.py`.
"""

from __future__ import annotations

import os
from pathlib import Path


def led_to(path: Path) -> Path:
    """Return where a path leads; a link that leads to itself stays, and opening it is refused by the system.

    `Path.resolve` raises a `RuntimeError` for such a link in Python before 3.13.
    """
    return Path(os.path.realpath(path))
