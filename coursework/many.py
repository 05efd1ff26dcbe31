"""Many sets of data of one template solved together, with the certainty of solving them one by one.

Enters: a template and columns of data.  Leaves: `Solutions`, frozen arrays.  Raises `InputError`.
Used through `import coursework`.

What the sets share is computed for all at once.  Whatever leaves a doubt (a start that may not close, a determinant that comes
near zero, a step that is too wide, …) is solved alone, as `solve` does it, and has its sentences from there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.motion.integration.motion import Motion, Stop
from coursework.motion.schemes import SCHEMES
from coursework.motion.settings import Settings, scheme_for
from coursework.scene.exact_scene import scene_of
from coursework.scene.model.data import Data
from coursework.scene.model.model import Model, compile_model
from coursework.scene.model.one_set import horizons
from coursework.scene.model.rows import rows_of
from coursework.scene.model.sets import prepare
from coursework.scene.scene import Scene
from coursework.system.arrays import Array, Flags
from coursework.variant.catalogue import load
from coursework.variant.judging.bounds import timed
from coursework.variant.record.variant import Variant
from coursework.words.errors import CourseworkError, InputError
from coursework.words.sentences import joined, say

if TYPE_CHECKING:
    import pandas as pd

# Sets that are computed together: their columns stay in the processor's cache.
TOGETHER = 2048


@dataclass(frozen=True, slots=True, eq=False)
class Solutions:
    """The tables of n sets: `t` (rows,) in s, `values` (n, rows, columns), nan after a motion has stopped.

    `columns` as in `Run.table`; `stops` (n) says why a motion ended early, None where it did not.

    >>> import coursework
    >>> solutions = coursework.solve_many("31", {"p": [12.0, 13.08]})
    >>> solutions.values.shape, solutions.columns[:3], len(solutions.table(0))
    ((2, 25, 7), ('phi1', 'phi2', 'phi3'), 25)
    """

    t: Array
    columns: tuple[str, ...]
    values: Array
    stops: tuple[Stop | None, ...]

    def table(self, index: int) -> pd.DataFrame:
        """Return the table of one set (index t), as `solve` gives it: only the rows it has."""
        import pandas as pd

        rows = self.values[index]
        kept = ~np.isnan(rows).any(axis=1)
        return pd.DataFrame(rows[kept], index=pd.Index(self.t[kept], name="t"), columns=list(self.columns))


def solve_many(
    variant: Variant | Model | str | Path, data: Any, scheme: str | None = None, step: float | None = None,
    end: float | None = None,
) -> Solutions:  # fmt: skip
    """Return the tables of many sets of data; each is what `solve(variant.with_data(…))` gives, to 1e-12.

    `data`: a mapping or a frame; keys are given names and coordinates (their start), values numbers in SI, texts with a unit,
    or one for all sets.  `scheme` as in `solve`; `step` and `end` in s, the same for all sets; those of the file where None.
    Raises `InputError` for data that do not fit, and for a set that `solve` refuses, by its number.

    >>> import coursework
    >>> solved = coursework.solve_many("31", {"p": [12.0, 13.08], "r1": "953 mm"}, scheme="rk4")
    >>> solved.values.shape, solved.stops
    ((2, 25, 7), (None, None))
    """
    model = _model(variant)
    template = timed(model.variant, step, end)
    chosen = Settings(scheme_for(template, scheme)).checked(template.time.step).scheme
    sets = model.data(data)
    _refuse_own_times(model, sets, step, end)
    steps, h = template.time.steps, template.time.step
    times: Array = np.arange(steps + 1).astype(np.float64) * h
    names = (*model.coordinates, *model.velocities)
    values = np.full((sets.count, len(times), len(names)), np.nan)
    stops: list[Stop | None] = [None] * sets.count
    for part, chunk in _chunks(sets):
        prepared = prepare(model, chunk, template.time.end)
        doubtful = ~prepared.sure | (prepared.frequency * h >= np.pi * (1 - 1e-12))
        if chosen in SCHEMES:
            found, good = rows_of(model, prepared, SCHEMES[chosen], times)
            values[part] = found
            doubtful |= ~good
        else:
            doubtful[:] = True
        for place in np.flatnonzero(doubtful).tolist():
            index = part.start + place
            motion = _alone(template, sets, index, chosen)
            values[index] = np.nan
            values[index, : len(motion.t)] = motion.rows
            stops[index] = motion.stop
    for rows in (times, values):
        rows.flags.writeable = False
    return Solutions(times, names, values, tuple(stops))


def feasible(variant: Variant | str | Path) -> tuple[bool, str]:
    """Return whether the whole motion of a variant is possible, and if not why: through its table and through a period.

    >>> import coursework
    >>> coursework.feasible("31")
    (True, '')
    """
    chosen = load(variant) if isinstance(variant, (str, Path)) else variant
    scene = Scene(chosen.timed(None, chosen.time.whole), Settings())
    try:
        return (True, "") if scene.stop is None else (False, scene.stop.sentence)
    except CourseworkError as error:
        return False, str(error)


def feasible_many(variant: Variant | Model | str | Path, data: Any) -> tuple[Flags, tuple[str, ...]]:
    """Return for which sets of data (n,) the whole motion is possible, and for each of the others why it is not.

    >>> import coursework
    >>> coursework.feasible_many("31", {"alpha": [4.35, 0.02]})[0].tolist()
    [True, False]
    """
    model = _model(variant)
    sets = model.data(data)
    possible = np.ones(sets.count, dtype=bool)
    reasons = [""] * sets.count
    for part, chunk in _chunks(sets):
        ends = horizons(model.variant, chunk)
        prepared = prepare(model, chunk, float(np.max(ends, initial=0.0, where=np.isfinite(ends))))
        for place in np.flatnonzero(~prepared.sure | ~np.isfinite(ends)).tolist():
            index = part.start + place
            try:
                possible[index], reasons[index] = feasible(_with(model.variant, sets, index))
            except CourseworkError as error:
                possible[index], reasons[index] = False, str(error)
    possible.flags.writeable = False
    return possible, tuple(reasons)


def _model(variant: Variant | Model | str | Path) -> Model:
    return variant if isinstance(variant, Model) else compile_model(variant)


def _chunks(sets: Data) -> Iterator[tuple[slice, Data]]:
    """Yield parts of the sets and where they stand."""
    for first in range(0, sets.count, TOGETHER):
        part = slice(first, min(first + TOGETHER, sets.count))
        yield part, sets.part(part)


def _with(template: Variant, sets: Data, index: int) -> Variant:
    given, start = sets.of(index, template)
    return template.with_data(given, start)


def _alone(template: Variant, sets: Data, index: int, scheme: str) -> Motion:
    """Return the motion of one set, as `solve` gives it."""
    try:
        alone = timed(_with(template, sets, index), template.time.step, template.time.end)
        return scene_of(alone, Settings(scheme).checked(alone.time.step)).motion
    except InputError as error:
        reason = joined([fault.message for fault in error.faults])
        raise InputError(say("fault.D021", number=index + 1, reason=reason)) from error


def _refuse_own_times(model: Model, sets: Data, step: float | None, end: float | None) -> None:
    """Raise `InputError` where every set would have rows at times of its own."""
    for key, value in (("step", step), ("end", end)):
        formula = model.variant.times.get(("time", key))
        names = [name for name in sets.changed if formula is not None and name in formula.names()]
        if value is None and names:
            raise InputError(say("fault.D022", key=key, variant=model.variant.name, names=tuple(names)))
