"""The data of a task sheet that a reader may move, and how far.

Enters: a `SceneRun`.  Leaves: for each such datum the ends of its slider (SI), and the unit in which it was given; whether the
page can follow the motion that far.
Used by `page.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from coursework.motion.geometry.drive import resolved
from coursework.scene.scene_run import SceneRun
from coursework.variant.formula.units import UNITS

# Places of a slider at which the drive is looked at, and what may stay open of its way in one step (rad or m): a fold leaves so
# much, a pulse far more.
_PLACES, _POINTS, _OPEN = 5, 2, 1e-4
_ROUNDING = 1e-12


def sliders_of(run: SceneRun, unit: Callable[[str], str]) -> dict[str, dict[str, Any]]:
    """Return the data that may be moved: an angle through its whole turn, anything else from half to one and a half of itself.

    A value is told in the `unit` of the file, which is `size` times that of SI.

    A datum that is zero has no such range, and one that moves the times at which a law changes would need another law.
    """
    variant = run.variant
    formulas = [formula for path, formula in variant.times.items() if path[0] != "time"]
    timed = {name for formula in formulas for name in formula.names()}
    found = {}
    for given in variant.given:
        if given.name in timed or not (given.value or given.si == "rad"):
            continue
        low, high = sorted((0.5 * given.value, 1.5 * given.value))
        if given.si == "rad":
            low = math.tau * math.floor(given.value / math.tau)
            high = low + math.tau
        size, si = UNITS.get(given.unit, (1, given.si))
        written = given.unit if si == given.si else given.si
        found[given.name] = {"low": low, "high": high, "unit": unit(written), "size": float(size) if si == given.si else 1.0}
    return found


def followed(run: SceneRun, sliders: dict[str, dict[str, Any]], step: float) -> bool:
    """Return whether steps of this length (s) see all that the drive does, wherever a slider stands."""
    variant = run.variant
    driving = {name for law in (*variant.drive, *variant.functions) for formula in law.formulas for name in formula.names()}
    ends = {name: (slider["low"], slider["high"]) for name, slider in sliders.items() if name in driving}
    moved = [(name, place) for name in ends for place in np.linspace(*ends[name], _PLACES)]
    data = {name: np.full(1 + len(moved), value) for name, value in variant.values.items()}
    for index, (name, place) in enumerate(moved, start=1):
        data[name][index] = place
    times = np.arange(int(run.end / step * (1 + _ROUNDING)) + 1).astype(np.float64) * step
    return bool(np.all(resolved(run.scene.equations, data, times, _POINTS, _OPEN)))
