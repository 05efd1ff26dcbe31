"""The frame of the points: a point that is not there is told with those that are.

Enters: numbers and the columns (point, quantity, axis).  Leaves: `PointFrame`.  Used by `frames.py`.
"""

from __future__ import annotations

from typing import Any

import pandas as pd

from coursework.words.sentences import closest, say


class PointFrame(pd.DataFrame):
    """A frame with columns (point, quantity, axis)."""

    def __getitem__(self, key: Any) -> Any:
        """Return what pandas returns.  Raises `KeyError` with a sentence for the name of no point."""
        try:
            return super().__getitem__(key)
        except KeyError:
            known = tuple(dict.fromkeys(self.columns.get_level_values(0)))
            if not isinstance(key, str) or key in known:
                raise
            raise KeyError(str(say("fault.D038", name=key, hint=closest(key, known), known=known))) from None
