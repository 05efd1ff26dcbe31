"""The positions of all drawn points, row by row, for a page that does not compute them itself.

Enters: a `SceneRun` and its drawing.  Leaves: plain data for JSON, in a limited number of bytes.  Used by `page.py`.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import Motion
from coursework.report.live.drawn import Drawn
from coursework.scene.scene_run import SceneRun

# A number takes at least two bytes, a digit and a comma.  Rows twice as far apart take about half the room: the stride is raised
# a little less than that suggests, so that it is not larger than needed.
_LEAST, _NEARLY = 2, 0.9
_DIGITS = 5  # significant digits of the mechanism's size: finer than the eye can see by a factor of 100


def frames_of(run: SceneRun, drawn: Drawn, room: int) -> dict[str, Any]:
    """Return the data of the page: `frames` holds every n-th row of the true motion and of the table in at most `room` bytes.

    Two rows are kept even if they need more.
    """
    scene = run.scene
    table = scene.scheme_rows or run.motion
    truth, rows = _places(run, drawn, scene.exact), _places(run, drawn, table)
    size = float(np.max(np.abs(truth), initial=0.0)) or 1.0
    decimals = _DIGITS - 1 - int(np.floor(np.log10(size)))
    stride = 1 + (truth.size + rows.size) * _LEAST // room
    while True:
        kept = [np.round(each[::stride], decimals).tolist() for each in (truth, rows)]
        frames = {"truth": kept[0], "rows": kept[1], "step": run.step * stride, "finest": 10.0**-decimals}
        needed = len(json.dumps(frames, separators=(",", ":")))
        if needed <= room or len(kept[0]) <= 2:
            break
        stride = max(stride + 1, int(_NEARLY * stride * needed / room))
    return {
        "frames": frames, "step": run.step, "scheme": table.scheme, "stop": None if scene.stop is None else scene.stop.time,
        "coordinates": list(table.coordinate_names), "velocities": list(table.velocity_names), "start": scene.start,
        "rows": len(run.motion.t), "given": run.variant.values, "end": run.variant.time.end,
    }  # fmt: skip


def _places(run: SceneRun, drawn: Drawn, motion: Motion) -> Any:
    """Return the places of all drawn points in the n rows of a motion, (n, 2 * number of points) in m."""
    places = compile_rows(run.scene.equations, drawn.places, 0)
    return places(motion.t, motion.coordinates) if drawn.places else np.zeros((len(motion.t), 0))
