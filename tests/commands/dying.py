"""A task whose process ends at once over every item that says so: alone in a file, as every process of it reads that file.

Enters: items.  Leaves: outcomes.  Used by `test_several.py`.
"""

from __future__ import annotations

import os


class Dying:
    """Answers an item in capitals; dies over "die"."""

    def ready(self):
        return self

    def __enter__(self):
        return self.work

    def __exit__(self, *_):
        return None

    def work(self, item):
        if item == "die":
            os._exit(7)
        return item.upper()

    def lost(self, item):
        return f"lost {item}"
