"""Many sets of data of one template solved together, as reliably as one by one.

Enters: a template and columns of data.  Leaves: `Solutions`, frozen arrays.  Raises `InputError`.
Used through `import coursework`.

The sets are computed all at once.  A doubtful set (its start may not close, a determinant comes near zero, the step is too wide,
…) is solved alone, as by `solve`, from which its messages come.
"""

from __future__ import annotations

import math
import operator
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

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
from coursework.system.arrays import Array, Flags
from coursework.variant.catalogue import variant_from
from coursework.variant.judging.bounds import timed
from coursework.variant.record.variant import Variant, no_column
from coursework.words.errors import CourseworkError, InputError, visible
from coursework.words.sentences import joined, say

if TYPE_CHECKING:
    import pandas as pd

Template = Variant | Model | str | Path | int
# Bytes of values that are kept in memory; more are kept in a temporary file of the system, which disappears with them.
MOST_KEPT = 2**28
# Sets that are computed together, so few that their columns stay in the processor's cache.
TOGETHER = 2048


class Feasibility(NamedTuple):
    """Whether a whole motion is possible, and `why` not; false if it is not, but it can also be unpacked into two values."""

    possible: bool
    why: str

    def __bool__(self) -> bool:
        return self.possible


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Solutions:
    """The tables of n sets: `t` (rows,) in s, `values` (n, rows, columns), nan after a motion has stopped.

    `columns` as in `Run.table`, in rad, m, rad/s and m/s; `stops` (n) says why a motion ended early, None if it did not;
    `name` of the template and its `sets` of data.  `len` counts the sets; `[i]` and a loop give their tables.

    >>> import coursework
    >>> solutions = coursework.solve_many("31", {"p": [12.0, 13.08]})
    >>> solutions
    <Solutions of 31: 2 sets of 25 rows, phi1, phi2, phi3, w1, w2, w3, w4>
    >>> solutions.data["p"].tolist(), len(solutions[0]), len(solutions.to_frame())
    ([12.0, 13.08], 25, 50)
    """

    t: Array
    columns: tuple[str, ...]
    values: Array
    stops: tuple[Stop | None, ...]
    name: str
    sets: Data

    def __len__(self) -> int:
        return len(self.stops)

    def __getitem__(self, index: int) -> pd.DataFrame:
        return self.table(index)

    def __iter__(self) -> Iterator[pd.DataFrame]:
        return map(self.table, range(len(self)))

    @property
    def data(self) -> pd.DataFrame:
        """Return the data of every set, one row each: given names in SI, then the changed start coordinates."""
        import pandas as pd

        return pd.DataFrame(dict(self.sets.given), index=pd.RangeIndex(len(self), name="set"))

    def table(self, index: int) -> pd.DataFrame:
        """Return the table of one set (index t), as from `solve`: only the rows it has.  Raises `IndexError`."""
        import pandas as pd

        from coursework.takeaway.frames import time_index

        rows = self.values[operator.index(index)]
        kept = ~np.isnan(rows).any(axis=1)
        return pd.DataFrame(rows[kept], index=time_index(self.t[kept]), columns=list(self.columns))

    def to_frame(self) -> pd.DataFrame:
        """Return all tables below each other, index (set, t)."""
        import pandas as pd

        return pd.concat(dict(enumerate(self)), names=["set"])

    def __repr__(self) -> str:
        return f"<Solutions of {visible(self.name)}: {len(self)} sets of {len(self.t)} rows, {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        return self.to_frame().to_html(max_rows=20)


def solve_many(
    variant: Template, data: Any, scheme: str | None = None, step: float | None = None, end: float | None = None, *,
    quantities: Iterable[str] | None = None,
) -> Solutions:  # fmt: skip
    """Return the tables of many sets of data; each is what `solve(variant.with_data(…))` gives, to 1e-12.

    `data`: a mapping or a frame; its keys are given names and coordinates (for their start), its values numbers in SI or texts
    with a unit, one per set or one for all sets.  `scheme` as in `solve`; `step` and `end` in s, the same for all sets, those
    of the file if None; `quantities`: the columns to keep, all if None.  Values of more than `MOST_KEPT` bytes are kept in a
    temporary file.  Raises `InputError` for data that do not fit, and, with its number, for a set that `solve` refuses.

    >>> import coursework
    >>> solved = coursework.solve_many("31", {"p": [12.0, 13.08], "r1": "953 mm"}, scheme="rk4")
    >>> solved.values.shape, solved.stops
    ((2, 25, 7), (None, None))
    """
    model = _model(variant)
    template = timed(model.variant, step, end)
    by_forces = template.motor is not None
    chosen = Settings(scheme_for(template, scheme)).checked(template.time.step, by_forces=by_forces).scheme
    sets = model.data(data)
    _refuse_own_times(model, sets, step, end)
    steps, h = template.time.steps, template.time.step
    times: Array = np.arange(steps + 1).astype(np.float64) * h
    names = (*model.coordinates, *model.velocities)
    kept = _kept(names, quantities)
    values = _room((sets.count, len(times), len(kept)))
    stops: list[Stop | None] = [None] * sets.count
    for part, chunk in _chunks(sets):
        prepared = prepare(model, chunk, template.time.end)
        doubtful = ~prepared.sure | (prepared.frequency * h >= np.pi * (1 - 1e-12))
        if chosen in SCHEMES and not by_forces:
            found, good = rows_of(model, prepared, SCHEMES[chosen], times)
            values[part] = found[..., kept]
            doubtful |= ~good
        else:
            doubtful[:] = True
        for place in np.flatnonzero(doubtful).tolist():
            index = part.start + place
            motion = _alone(template, sets, index, chosen)
            values[index] = np.nan
            values[index, : len(motion.t)] = motion.rows[:, kept]
            stops[index] = motion.stop
    for rows in (times, values):
        rows.flags.writeable = False
    return Solutions(times, tuple(names[place] for place in kept), values, tuple(stops), model.variant.name, sets)


def feasible(variant: Variant | str | Path | int) -> Feasibility:
    """Return whether the whole motion of a variant, through its table and a period, is possible, and if not, why.

    >>> import coursework
    >>> found = coursework.feasible(coursework.load("31").with_data({"alpha": 0.02}))
    >>> bool(found), found.why[:40]
    (False, 'At t = 0.116889 s, between rows 6 and 7,')
    """
    chosen = variant_from(variant)
    scene = scene_of(chosen.timed(None, chosen.time.whole), Settings())
    try:
        return Feasibility(True, "") if scene.stop is None else Feasibility(False, scene.stop.sentence)
    except CourseworkError as error:
        return Feasibility(False, str(error))


def feasible_many(variant: Template, data: Any) -> tuple[Flags, tuple[str, ...]]:
    """Return for n sets of data whether the whole motion is possible (n,), and the reasons why not ("" if it is possible).

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
        alone = ~prepared.sure | ~np.isfinite(ends) | (model.variant.motor is not None)
        for place in np.flatnonzero(alone).tolist():
            index = part.start + place
            try:
                possible[index], reasons[index] = feasible(_with(model.variant, sets, index))
            except CourseworkError as error:
                possible[index], reasons[index] = False, str(error)
    possible.flags.writeable = False
    return possible, tuple(reasons)


def _kept(names: tuple[str, ...], quantities: Iterable[str] | None) -> list[int]:
    """Return the indices of the columns to keep.  Raises `InputError` for a name that is no column."""
    wanted = list(names) if quantities is None else [quantities] if isinstance(quantities, str) else list(quantities)
    for name in wanted:
        if name not in names:
            raise no_column(name, names)
    return [names.index(name) for name in wanted]


def _room(shape: tuple[int, ...]) -> Array:
    """Return an array of nan for the values: in memory, or in a file if it takes more than `MOST_KEPT` bytes."""
    if 8 * math.prod(shape) <= MOST_KEPT:
        return np.full(shape, np.nan)
    with tempfile.TemporaryFile() as file:
        values: Array = np.memmap(file, dtype=float, shape=shape)
    for first in range(0, shape[0], TOGETHER):
        values[first : first + TOGETHER] = np.nan
    return values


def _model(variant: Template) -> Model:
    return variant if isinstance(variant, Model) else compile_model(variant)


def _chunks(sets: Data) -> Iterator[tuple[slice, Data]]:
    """Yield parts of the sets, each after the slice of its indices."""
    for first in range(0, sets.count, TOGETHER):
        part = slice(first, min(first + TOGETHER, sets.count))
        yield part, sets.part(part)


def _with(template: Variant, sets: Data, index: int) -> Variant:
    given, start = sets.of(index, template)
    return template.with_data(given, start)


def _alone(template: Variant, sets: Data, index: int, scheme: str) -> Motion:
    """Return the motion of one set, as from `solve`.  Raises `InputError` with the number of the set."""
    try:
        alone = timed(_with(template, sets, index), template.time.step, template.time.end)
        return scene_of(alone, Settings(scheme).checked(alone.time.step, by_forces=alone.motor is not None)).motion
    except InputError as error:
        reason = joined([fault.message for fault in error.faults])
        raise InputError(say("fault.D021", number=index + 1, reason=reason)) from error


def _refuse_own_times(model: Model, sets: Data, step: float | None, end: float | None) -> None:
    """Raise `InputError` if step or end depend on changed data, so that every set would have rows at its own times."""
    for key, value in (("step", step), ("end", end)):
        formula = model.variant.times.get(("time", key))
        names = [name for name in sets.changed if formula is not None and name in formula.names()]
        if value is None and names:
            raise InputError(say("fault.D022", key=key, variant=model.variant.name, names=tuple(names)))
