"""Rows of a motion as pandas frames: the table, its points, and the exact motion at any time.

Enters: a `Scene` and a `Motion` of it.  Leaves: frames, `ExactRows`.  Raises `InputError`.
Used by `run.py`; it imports pandas, which the files of a run do not need.
"""

from __future__ import annotations

from dataclasses import field, fields
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coursework.motion.integration.motion import Motion
from coursework.scene.scene import Scene
from coursework.system.arrays import Array
from coursework.system.frozen import caching
from coursework.variant.judging.bounds import number_of_seconds, seconds
from coursework.words.errors import InputError
from coursework.words.sentences import say

if TYPE_CHECKING:
    import pandas as pd

_LEVELS = {"": "position", "v": "velocity", "a": "acceleration"}
_SHORTEST = 1e-9  # relative to the last time: a time so little beyond it means the last row


def time_index(t: Array) -> pd.Index[float]:
    """Return times (s) rounded to 12 digits, as they are printed: 0.35, not 0.35000000000000003."""
    import pandas as pd

    return pd.Index([float(f"{time:.12g}") for time in t.tolist()], name="t")


def point_frame(scene: Scene, motion: Motion) -> pd.DataFrame:
    """Return positions (m), velocities (m/s) and accelerations (m/s²) of the points: columns (point, quantity, axis)."""
    import pandas as pd

    from coursework.takeaway.points import PointFrame

    names, rows = scene.over(motion).point_accelerations
    columns = [(point, _LEVELS[key[:-1]], key[-1]) for point, _, key in (name.partition(".") for name in names)]
    levels = pd.MultiIndex.from_tuples(columns, names=["point", "quantity", "axis"])
    return PointFrame(rows, index=time_index(motion.t), columns=levels)


@caching
class ExactRows(Motion):
    """Rows of the exact motion: a `Motion` that also has its points, and rows at any time between.

    >>> import coursework
    >>> exact = coursework.solve("31").exact
    >>> between = exact.at([0.05, 0.051])  # s
    >>> between.column("w3").round(4).tolist(), between.points["B"].velocity.shape
    ([4.7354, 4.7051], (2, 2))
    """

    scene: Scene | None = field(default=None, repr=False, compare=False)

    __eq__, __hash__, __repr__ = Motion.__eq__, Motion.__hash__, Motion.__repr__

    @property
    def points(self) -> pd.DataFrame:
        """Return the points as the frame of `point_frame`."""
        assert self.scene is not None
        return point_frame(self.scene, self)

    def at(self, t: ArrayLike) -> ExactRows:
        """Return the rows at one or several times, in s or as text with a unit ("50 ms"), in the order given.

        Raises `InputError` for a time outside the motion, and for text that is no time.
        """
        assert self.scene is not None
        asked = np.atleast_1d(np.asarray(t)).ravel().tolist()
        times = np.array([number_of_seconds(seconds(one), "time") for one in asked], dtype=float)
        last = self.scene.last_time
        outside = times[~((times >= 0) & (times <= last * (1 + _SHORTEST)))].tolist()
        grid, places = np.unique(np.append(np.clip(times, 0.0, last), 0.0), return_inverse=True)
        found = self.scene.exact_at(grid)
        if outside or len(found.t) < len(grid):
            raise InputError(say("fault.D026", time=[*outside, float(grid[-1])][0], last=last))
        return exact_rows(self.scene, found, places.ravel()[:-1])


def exact_rows(scene: Scene, motion: Motion, places: NDArray[np.intp] | None = None) -> ExactRows:
    """Return the rows of an exact motion, or only those at `places`."""
    values = {one.name: getattr(motion, one.name) for one in fields(Motion)}
    if places is not None:
        arrays = (name for name, value in values.items() if isinstance(value, np.ndarray) and len(value) == len(motion.t))
        values |= {name: values[name][places] for name in arrays}
    return ExactRows(**values, scene=scene)
