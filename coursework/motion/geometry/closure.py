"""Position equations as numbers: residual, Newton correction, and how far the drive has moved by a given time.

Enters: `VelocityEquations` with positions.  Leaves: `Closure`.  Used by `integration` and the checks.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import field, replace
from functools import cached_property
from typing import Any

import numpy as np

from coursework.equations.algebra.calculus import derivative
from coursework.equations.algebra.expression import MINUS, ONE, Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.system import compile_values
from coursework.motion.geometry.closure_blocks import blocks_of
from coursework.motion.geometry.drives.drive import integrals
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags, as_columns
from coursework.system.frozen import caching
from coursework.variant.record.held import largest_length
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

MAX_NEWTON = 25
# Largest component of a Newton correction (rad or m, or share of a largest length above 1 m).  FARTHEST: Newton is lost.
# SETTLED: converged.  SHRINKING: small enough that round-off may stop its shrinking.  CLOSED: accepted when iterations run out.
FARTHEST, SETTLED, SHRINKING, CLOSED = 10.0, 1e-15, 1e-11, 1e-9
_REMEMBERED = 4  # grids of times kept in the cache: a table, its exact rows and its checks ask for the same grid
# Number of times at which a drive that waits is looked at, and the share of the largest length (or rad) that counts as waiting.
_LATER, WAITING = 201, 1e-3
CONFIGURATIONS = 5  # number of positions near the start at which equations and links are judged
_LOOSE = 1e-6  # a coordinate determined up to this share is determined


@caching
class Closure:
    """The position equations g(q, t) = target of one scene, with start position `start` (m,).

    `names` are the equations, `free` the indices of the coordinates they determine, `driven` those of the driven coordinates;
    `drives` names for each equation the drive it follows ("" for none); `origin` is its target at t = 0 (m or rad).
    `function(t, *q)` gives the values and their derivatives by the free coordinates, `rows` the same over arrays (n,).
    `blocks` are solved in turn: each is a matrix (r, k) that adds and subtracts equations so that only r free coordinates are
    left in them, the columns of these in the Jacobian, and their places among all coordinates.
    `turning` are the equations that give an angle by itself, q = atan2(...): they hold up to whole turns.
    `agreed` names the written velocity equations that the geometry confirms; `unjudged` those it cannot judge, each with its
    undetermined velocities; `unseen` those with terms whose signs have no effect; `asked` caches computed targets.
    """

    names: tuple[str, ...]
    free: tuple[int, ...]
    driven: tuple[int, ...]
    drives: tuple[str, ...]
    origin: Array
    start: Array
    function: Callable[..., Any]
    rows: Callable[..., Any]
    equations: VelocityEquations
    blocks: tuple[tuple[Array, list[int], list[int]], ...]
    turning: tuple[int, ...] = ()
    agreed: tuple[str, ...] = ()
    unjudged: tuple[tuple[str, tuple[str, ...]], ...] = ()
    unseen: tuple[tuple[str, tuple[str, ...]], ...] = ()
    asked: dict[bytes, tuple[Array, Array]] = field(default_factory=dict, repr=False, compare=False)

    @property
    def complete(self) -> bool:
        """Return whether the equations determine every coordinate that is not driven."""
        return len(self.names) >= len(self.free)

    @property
    def scale(self) -> float:
        """Return the largest length of the data (m), 1 if there is none; residuals are measured against it."""
        return largest_length(self.equations.variant)

    @cached_property
    def _sizes(self) -> Array:
        """Return for each coordinate what a correction is measured against: 1 rad, or the largest length if it is above 1 m."""
        return np.array([1.0 if one.unit == "rad" else max(1.0, self.scale) for one in self.equations.variant.coordinates])

    @cached_property
    def configurations(self) -> tuple[Array, Array]:
        """Return times and closed positions near the start, with the drive moved on; only the start if Newton finds none.

        A drive that waits moves nothing: then the first times at which something has moved are taken.
        """
        end = self.equations.variant.time.end
        times = np.linspace(0.0, end / 50, CONFIGURATIONS)
        if not self._moved(times).any():
            later = np.linspace(0.0, end, _LATER)
            with suppress(InputError):  # a drive without a value later on is told where it is followed
                first = max(1, int(np.argmax(self._moved(later))))
                times = np.array([0.0, *np.linspace(later[first - 1], later[first], CONFIGURATIONS)[1:]])
        kept, known = self.targets(times)
        guess = np.tile(self.start, (len(times), 1))
        guess[:, list(self.driven)] = known
        try:
            q, closed = self.newton_rows(times, guess, kept)
        except np.linalg.LinAlgError:
            closed = np.zeros(len(times), dtype=bool)
        count = int(np.argmin(closed)) if not closed.all() else len(times)
        return (times[:count], q[:count]) if count else (times[:1], self.start[None])

    @cached_property
    def loose(self) -> frozenset[str]:
        """Return the coordinates that the equations leave undetermined, though others of them may be determined."""
        times, positions = self.configurations
        slopes = self.residual(times, positions, self.targets(times)[0])[1]
        known = np.diagonal(np.linalg.pinv(slopes) @ slopes, axis1=1, axis2=2).max(axis=0)  # 1 where a column is determined
        names = self.equations.variant.coordinates
        return frozenset(names[place].name for place, share in zip(self.free, known.tolist(), strict=True) if share < 1 - _LOOSE)

    def _moved(self, times: Array) -> Flags:
        """Return at which times (n,) the drives have moved something away from the start."""
        kept, known = self.targets(times)
        every, variant = np.concatenate([kept, known], axis=1), self.equations.variant
        turns = {one.rate for one in variant.coordinates if one.unit == "rad"}
        drives = [*self.drives, *(variant.rates[place] for place in self.driven)]
        sizes = np.array([1.0 if name in turns else self.scale for name in drives])
        return np.asarray(np.max(np.abs(every - every[0]) / sizes, axis=1, initial=0.0) > WAITING)

    def at_zero(self, zero: Sequence[bool]) -> Closure:
        """Return the closure with target 0 for the equations flagged in `zero`; the others keep the value the start gives."""
        return replace(self, origin=np.where(zero, 0.0, self.origin), asked={})

    def targets(self, times: Array) -> tuple[Array, Array]:
        """Return the target values (n, equations) and the driven coordinates (n, driven) at times growing from 0."""
        key = times.tobytes()
        if key not in self.asked:
            if len(self.asked) == _REMEMBERED:
                del self.asked[next(iter(self.asked))]
            self.asked[key] = self._targets(times)
        return self.asked[key]

    def _targets(self, times: Array) -> tuple[Array, Array]:
        rates = self.equations.variant.rates
        drives = sorted({name for name in self.drives if name} | {rates[place] for place in self.driven})
        moved = dict(zip(drives, integrals(self.equations, drives, times).T, strict=True))
        zero = np.zeros(len(times))
        kept = np.array([value + moved.get(name, zero) for name, value in zip(self.drives, self.origin, strict=True)])
        known = np.array([self.start[place] + moved[rates[place]] for place in self.driven])
        return kept.T.reshape(len(times), len(self.names)), known.T.reshape(len(times), len(self.driven))

    def residual(self, t: float | Array, q: Array, target: Array) -> tuple[Array, Array]:
        """Return g - target (k,) and its Jacobian by the free coordinates (k, f); for times (n,) and q (n, m), n of each."""
        if isinstance(t, np.ndarray):
            values = as_columns(self.rows(t, *q.T), t.shape)
        else:
            values = np.array(self.function(t, *q.tolist()), dtype=float)
        count = len(self.names)
        open_by = values[..., :count] - target
        for place in self.turning:
            open_by[..., place] -= whole_turns(open_by[..., place])
        return open_by, values[..., count:].reshape(*values.shape[:-1], count, len(self.free))

    def correction(self, t: float | Array, q: Array, target: Array) -> Array:
        """Return one Newton correction of the coordinates (m,), block after block; (n, m) for n rows."""
        if not self.blocks:
            return self.linear(t, q, target)
        moved = q.copy()
        for mixed, columns, places in self.blocks:
            residual, jacobian = self.residual(t, moved, target)
            moved[..., places] -= np.linalg.solve((mixed @ jacobian)[..., columns], (residual @ mixed.T)[..., None])[..., 0]
        return moved - q

    def linear(self, t: float | Array, q: Array, target: Array) -> Array:
        """Return the correction (m,) from all equations at once; it is linear in the residual, as Baumgarte's gain needs."""
        residual, jacobian = self.residual(t, q, target)
        step = np.zeros_like(q)
        step[..., list(self.free)] = -(np.linalg.pinv(jacobian) @ residual[..., None])[..., 0]
        return step

    def newton(self, t: float, guess: Array, target: Array) -> Array | None:
        """Return the position that closes the mechanism near `guess`, None if Newton's method does not converge."""
        q = guess.copy()
        last = np.inf
        for _ in range(MAX_NEWTON):
            try:
                step = self.correction(t, q, target)
            except (np.linalg.LinAlgError, ArithmeticError, ValueError):  # a root may have no value on the way
                return None
            size = float(np.max(np.abs(step) / self._sizes, initial=0.0))
            if not size <= FARTHEST:
                return None
            q = q + step
            # Quadratic convergence ends in round-off: stop when the correction no longer shrinks.
            if size < SETTLED or (size < SHRINKING and size >= last / 2):
                return q
            last = size
        return q if last < CLOSED else None

    def newton_rows(self, times: Array, guess: Array, targets: Array) -> tuple[Array, Flags]:
        """Return n positions (n, m), found by Newton's method on all rows at once, and which of them are closed (n,).

        Each row follows the rules of `newton`; converged rows are left alone.  Raises `LinAlgError` if any row is singular.
        """
        q = guess.copy()
        last = np.full(len(q), np.inf)
        lost = np.zeros(len(q), dtype=bool)
        moving = np.arange(len(q))
        for _ in range(MAX_NEWTON):
            step = self.correction(times[moving], q[moving], targets[moving])
            size = np.max(np.abs(step) / self._sizes, axis=1, initial=0.0)
            near = size <= FARTHEST  # false for nan
            lost[moving[~near]] = True
            q[moving[near]] += step[near]
            settled = (size < SETTLED) | ((size < SHRINKING) & (size >= last[moving] / 2))
            last[moving] = size
            moving = moving[near & ~settled]
            if not len(moving):
                break
        return q, ~lost & (last < CLOSED)


def compile_closure(equations: VelocityEquations, start: Sequence[float]) -> Closure | None:
    """Return the closure of a scene, None if the file gives no position equation and the drives leave coordinates free."""
    positions = equations.positions
    variant = equations.variant
    known = set(variant.known_rates)
    free = tuple(i for i, c in enumerate(variant.coordinates) if c.rate not in known)
    if not positions and (free or not equations.equations):  # a single crank is placed by its group
        return None
    driven = tuple(i for i, c in enumerate(variant.coordinates) if c.rate in known)
    names = [symbol(variant.coordinates[place].name) for place in free]
    wanted = [position.expression for position in positions]
    wanted += [equations.symbols.partial(position.expression, name) for position in positions for name in names]
    function, rows = compile_values(equations, wanted)
    try:
        values = np.array(function(0.0, *start), dtype=float)[: len(positions)]
    except (ArithmeticError, ValueError) as error:
        told = say("fault.V311", names=", ".join(_without_value(equations, wanted, start)))
        raise InputError([Fault(told, variant.file, variant.nearest_line("closure"))]) from error
    origin = np.where([position.target == "zero" for position in positions], 0.0, values)
    followed = tuple("" if position.target in {"zero", "start"} else position.target for position in positions)
    blocks = equations.once("closure blocks", lambda: blocks_of([p.expression for p in positions], names, equations, free))
    return Closure(
        tuple(p.name for p in positions), free, driven, followed, origin, np.array(start, dtype=float), function, rows, equations,
        blocks, equations.once("turning", lambda: _turning(equations)),
    )  # fmt: skip


def _turning(equations: VelocityEquations) -> tuple[int, ...]:
    """Return the places of position equations in rad in which an angle stands alone, with one sign or the other."""
    angles = [symbol(one.name) for one in equations.variant.coordinates if one.unit == "rad"]
    rows = ([derivative(one.expression, angle) for angle in angles if one.unit == "rad"] for one in equations.positions)
    return tuple(place for place, slopes in enumerate(rows) if ONE in slopes or MINUS in slopes)


def _without_value(equations: VelocityEquations, wanted: list[Expression], start: Sequence[float]) -> list[str]:
    """Return the names of the position equations whose value or derivatives cannot be computed at the start."""
    positions = equations.positions
    columns = len(wanted) // len(positions) - 1
    found = []
    for place, position in enumerate(positions):
        first = len(positions) + place * columns
        try:
            compile_values(equations, [wanted[place], *wanted[first : first + columns]])[0](0.0, *start)
        except (ArithmeticError, ValueError):
            found.append(position.name)
    return found
