"""What is known about many data sets before any table: where they begin, and which of them are sure to move.

Enters: a `Model` and `Data`.  Leaves: `Sets`.  Used by `many.py` and `assigning/judge.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from coursework.motion.geometry.drives.drive import argument_slopes, resolved
from coursework.scene.model.data import Data
from coursework.scene.model.model import Columns, Model
from coursework.scene.model.start import close, of_rows, start_of
from coursework.scene.model.watch import fewest_steps, frequencies, stacked, sure_to_move
from coursework.system.arrays import Array, Flags

# Factor for the steps of a second look at sets that a first look leaves in doubt.
_CLOSER = 4
# Shares of the run at which unsolved equations are checked with the velocities found, and the relative tolerance.
_LOOKS, _FITS = (0.0, 0.02), 1e-8


@dataclass(frozen=True, slots=True, eq=False)
class Sets:
    """`numbers` for the model's programs; `begin` (m, n) of the rows; `sure` (n,) to move or not; drive `frequency` (n,)."""

    numbers: Columns
    begin: Array
    sure: Flags
    frequency: Array


def prepare(model: Model, data: Data, end: float) -> Sets:
    """Return the sets; `end` (s) is how far they must move.  Nothing is raised: a set with any fault is left in doubt."""
    with np.errstate(all="ignore"):
        numbers = model.numbers(data)
        start = start_of(model, data, numbers)
        frequency = frequencies(model, argument_slopes(model.equations), numbers, data.count, end)
        sure = ~start.doubtful & _sound(model, numbers, start.closed, end)
        if model.own_breaks(data.changed):
            sure[:] = False
        places = np.flatnonzero(sure)
        steps = 0
        for _ in range(2):
            if len(places):
                some = of_rows(numbers, places)
                at = start.closed[:, places]
                steps = max(_CLOSER * steps, fewest_steps(model, some, frequency[places], at, end))
                sure[places] = sure_to_move(model, some, at, end, steps)
                moved = {name: column[places] for name, column in data.given.items()}
                sure[places] &= resolved(model.equations, moved, np.linspace(0.0, end, steps + 1))
                places = places[~sure[places]]
    return Sets(numbers, start.begin, sure, frequency)


def _sound(model: Model, numbers: Columns, q: Array, end: float) -> Flags:
    """Return for which sets links have positive lengths, and unsolved equations fit the velocities found."""
    sound = np.ones(q.shape[1], dtype=bool)
    lengths = model.lengths
    if lengths:
        sound &= (stacked(model.compiled(lengths)(0.0, *q, *numbers), q[:1]) > 0.0).all(axis=0)
    unused = [e for e in model.equations.equations if e.name in model.reduction.unused]
    held = [*unused, *model.equations.from_closure]
    if not held:
        return sound
    parts = [[-e.right_side, *e.terms] for e in held]
    function = model.compiled(tuple(term for terms in parts for term in terms), model.variant.sought)
    first = np.cumsum([0, *map(len, parts[:-1])])
    sought = [model.velocities.index(name) for name in model.variant.sought]
    free = [place for place, c in enumerate(model.variant.coordinates) if c.rate not in model.variant.known_rates]
    closed = [position.expression for position in model.equations.positions if position.target == "zero"]
    told = np.zeros((len(held), q.shape[1]), dtype=bool)  # an equation of a mechanism at rest shows nothing
    at: Any = q
    for before, now in zip((0.0, *_LOOKS), _LOOKS, strict=False):
        t = now * end
        if now:
            # Any position near the motion that the geometry allows will do.
            at = at + (now - before) * end * stacked(model.program(before * end, *at, *numbers)[: len(at)], at)
            at, settled = close(model, t, at, numbers, free, closed) if closed else (at, sound)
            sound &= settled
        u = model.program(t, *at, *numbers)
        terms = stacked(function(t, *at, *(u[place] for place in sought), *numbers), at[:1])
        gap, size = np.abs(np.add.reduceat(terms, first)), np.add.reduceat(np.abs(terms), first)
        sound &= (gap <= _FITS * size).all(axis=0)
        told |= size > 0
    return sound & told.all(axis=0)
