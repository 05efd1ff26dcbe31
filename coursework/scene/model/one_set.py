"""The template with the numbers of one data set, made without reading the file again.

Enters: a template, `Data`, the index of a set.  Leaves: a `Variant` with the numbers and times of that set.
Used by `many.py` and `assigning/judge.py`.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from coursework.scene.model.data import Data
from coursework.system.arrays import Array
from coursework.variant.formula.tree import FormulaFault, evaluate
from coursework.variant.record.variant import Variant


def horizons(template: Variant, data: Data) -> Array:
    """Return how long (n,) the motion of each set must last (s); nan if its data give no time."""
    if any({*formula.names()} & {*data.changed} for formula in template.times.values()):
        return np.array([with_numbers(template, data, index).time.whole for index in range(data.count)])
    return np.full(data.count, template.time.whole)


def with_numbers(template: Variant, data: Data, index: int) -> Variant:
    """Return the template with the numbers of one set and the times that follow from them; nothing else is read again."""
    values = {one.name: float(data.given[one.name][index]) for one in template.given}
    try:
        times = {str(path[1]): evaluate(formula, values) for path, formula in template.times.items() if path[0] == "time"}
    except FormulaFault:
        times = {"end": math.nan}  # data that give no time make no table
    starts = data.start[index].tolist()
    guesses = [None if math.isnan(start) else start for start in starts]
    coordinates = tuple(
        replace(c, start=guess if c.start is not None else None, start_guess=None if c.start is not None else guess)
        for c, guess in zip(template.coordinates, guesses, strict=True)
    )
    return replace(template.with_values(values), coordinates=coordinates, time=replace(template.time, **times))  # type: ignore[arg-type]
