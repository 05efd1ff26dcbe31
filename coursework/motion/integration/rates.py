"""The reduction as plain functions for the march: every velocity and determinant at (t, q).

Enters: a `Reduction`.  Leaves: `Rates`.  Used by `integrate.py`, `exact_motion.py`, the accuracy study.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Bound, Program, compile_function, compile_later
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.equations.reduction.system import scene_program
from coursework.motion.geometry.drives.drive import breaks
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import Slopes
from coursework.system.arrays import Array, as_columns
from coursework.system.frozen import caching

_SOLVED = 25  # cost of a block solved numerically, in formulas
# Share of its time by which a step stays before a break of the drive: its last slope must still use the old formula.
_BEFORE_BREAK = 1e-13


@caching
class Rates:
    """The right-hand side of a scene.

    `evaluate(t, *q)` gives velocities, then determinants, as floats; `rows` the same over arrays (n,).  `coordinates` are those
    integrated, `velocities` those returned (rates of the coordinates first), `blocks` the indices of the blocks evaluated.
    `body` is the program behind them, `equations` its source; `breaks` are the times (s) at which the drive changes its formula.
    """

    coordinates: tuple[str, ...]
    velocities: tuple[str, ...]
    blocks: tuple[int, ...]
    evaluate: Callable[..., tuple[float, ...]]
    rows: Callable[..., Any]
    body: Bound
    equations: VelocityEquations
    breaks: tuple[float, ...] = ()

    @cached_property
    def loops(self) -> dict[tuple[Any, bool], Callable[..., Any]]:
        """Return the cache of compiled loops; a page follows hundreds of intervals with the same one."""
        return {}

    @cached_property
    def sizes(self) -> Array:
        """Return what counts as 1 of each coordinate (m,): 1 rad, or the size of the mechanism."""
        return self.equations.units(self.coordinates)

    def may_look_until(self, end: float) -> float:
        """Return the last time (s) at which a step ending at `end` may evaluate slopes: just before a break there, else any."""
        return may_look_until(self.breaks, end)

    def rows_at_breaks(self, step: float) -> list[int]:
        """Return the rows (from 0, `step` s apart) that lie at a break, first ones first."""
        near = {round(time / step) for time in self.breaks}
        return sorted(row for row in near if math.isfinite(self.may_look_until(row * step)))

    def slopes(self, end: float = math.inf) -> Slopes:
        """Return `f(t, q)`: the slopes (m,) for a step that ends at `end` (s), in the arithmetic of the march."""
        size, latest = len(self.coordinates), self.may_look_until(end)
        return lambda t, q: np.array(self.evaluate(min(t, latest), *q.tolist())[:size])

    def slopes_of_rows(self, ends: Array) -> Slopes:
        """Return `f(t, q)`: the slopes (n, m) for n steps at once, which end at the times `ends` (s)."""
        size = len(self.coordinates)
        latest = np.array([self.may_look_until(end) for end in ends.tolist()]) if self.breaks else np.inf
        return lambda t, q: self.table(np.minimum(t, latest), q)[0][:, :size]

    @property
    def weight(self) -> float:
        """Return the cost of a slope: 1 if all velocities are formulas; blocks solved numerically cost far more."""
        return float(sum(_SOLVED if "_solve(" in line.text else 0 for line in self.body.lines)) or 1.0

    def table(self, t: Array, q: Array) -> tuple[Array, Array]:
        """Return velocities (n, k) and determinants (n, blocks) for rows of coordinates (n, m)."""
        values = as_columns(self.rows(t, *q.T), np.shape(t))
        return values[:, : len(self.velocities)], values[:, len(self.velocities) :]

    def motion(
        self, t: Array, q: Array, scheme: str, step: float, evaluations: int = 0,
        known: tuple[Array, Array] | None = None, **told: Any,
    ) -> Motion:  # fmt: skip
        """Return the motion with rows at `t` (n,) s and `q` (n, m); `known` is the result of `table`, if it is known."""
        velocities, determinants = known or self.table(t, q)
        bare, names = np.zeros((len(t), 0)), (self.coordinates, self.velocities)
        return Motion(t, q, velocities, determinants, bare, *names, scheme, step, evaluations, **told)


def may_look_until(breaks: Sequence[float], end: float) -> float:
    """Return the last time (s) at which a step that ends at `end` may evaluate slopes: just before a break there, else any."""
    at_break = any(abs(end - time) <= _BEFORE_BREAK * time for time in breaks)
    return end * (1 - _BEFORE_BREAK) if at_break else math.inf


def compile_rates(equations: VelocityEquations, reduction: Reduction, wanted: Sequence[str] | None = None) -> Rates:
    """Return the right-hand side for all columns, or only for what the `wanted` columns need.

    The coordinates integrated are those wanted and those their velocities depend on.
    """
    key = ("rates", tuple(wanted or ()), reduction.names)
    coordinates, velocities, needed, results, written = equations.once(key, lambda: _parts(equations, reduction, wanted))
    body = written.bind(constants(equations.variant))
    arguments = [private(name) for name in ("t", *coordinates)]
    scalar = compile_function("rates", arguments, body, results)
    rows = compile_later("rates", arguments, body, results, numpy=True)
    return Rates(coordinates, velocities, needed, scalar, rows, body, equations, breaks(equations.variant))


_Parts = tuple[tuple[str, ...], tuple[str, ...], tuple[int, ...], tuple[str, ...], Program]


def _parts(equations: VelocityEquations, reduction: Reduction, wanted: Sequence[str] | None) -> _Parts:
    """Return the parts of `Rates` that do not depend on data, the names of its results and its program."""
    variant = equations.variant
    coordinates, velocities = _closure(equations, reduction, wanted) if wanted else (None, variant.velocities)
    kept = tuple(c.name for c in variant.coordinates if coordinates is None or c.name in coordinates)
    listed = tuple(name for name in variant.velocities if name in velocities)  # the rates of those kept, then others
    blocks = reduction.needed(listed)
    statements = [statement for index in blocks for statement in block_statements(reduction.blocks[index], index)]
    statements += [Assign(local(_result(name)), symbol(name)) for name in listed]
    results = (*map(_result, listed), *(f"_det{index}" for index in blocks))
    return kept, listed, blocks, results, scene_program(equations, statements)


def _result(velocity: str) -> str:
    return f"_{private(velocity)}"


def _closure(equations: VelocityEquations, reduction: Reduction, wanted: Sequence[str]) -> tuple[set[str], set[str]]:
    """Return the coordinates to integrate and the velocities to compute for the `wanted` columns."""
    variant = equations.variant
    rate_of = {c.name: c.rate for c in variant.coordinates}
    definitions = equations.symbols.definitions
    coordinates = {name for name in wanted if name in rate_of}
    coordinates |= {name for name, rate in rate_of.items() if rate in wanted}
    velocities = {name for name in wanted if name not in rate_of}
    while True:
        velocities |= {rate_of[name] for name in coordinates}
        blocks = reduction.needed(tuple(velocities))
        inside = definitions.behind(s for index in blocks for s in reduction.blocks[index].symbols)
        needed = {name for name in rate_of if symbol(name) in inside}
        if needed <= coordinates:
            return coordinates, velocities
        coordinates |= needed
