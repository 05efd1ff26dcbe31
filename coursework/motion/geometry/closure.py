"""Position equations as numbers: residual, Newton's correction, and what the drive has moved by a time.

Enters: `VelocityEquations` with positions.  Leaves: `Closure`.  Used by `integration` and the checks.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import Any

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.matching import blocks as block_order
from coursework.equations.reduction.matching import match
from coursework.equations.reduction.symbolic import expanded, symbol
from coursework.equations.reduction.system import compile_values
from coursework.motion.geometry.drive import integrals
from coursework.system.arrays import Array, Flags, as_columns
from coursework.system.frozen import caching
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

MAX_NEWTON = 25
# Sizes of a correction (rad or m): too far to be a correction at all; settled; small enough that round-off may stop its
# shrinking; closed where the corrections run out.
FARTHEST, SETTLED, SHRINKING, CLOSED = 10.0, 1e-15, 1e-11, 1e-9
_REMEMBERED = 4  # grids of times: a table, its exact rows and its checks ask for the same one
CONFIGURATIONS = 5  # near the start, by which equations and links are judged
MOST_COMBINED = 12  # equations; beyond it pairs are not tried


@caching
class Closure:
    """The position equations g(q, t) = kept value of one scene, started at `start` (m,).

    `names` of the equations, `free` the places of the coordinates they determine, `driven` the places of known ones;
    `drives` per equation the name of the drive it follows ("" for none); `origin` the value kept (m or rad).
    `function(t, *q)` gives the values and their derivatives by the free coordinates, `rows` the same over arrays (n,).
    `combination` (k, k) adds and subtracts equations so that they fall into `blocks` (rows, free columns), solved in turn.
    `agreed` names the written velocity equations that these positions confirm, `unjudged` those that they cannot, with the
    velocities that nothing gives, `unseen` those with terms whose signs do not show; `asked` are targets that were worked out.
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
    combination: Array
    blocks: tuple[tuple[list[int], list[int]], ...]
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
        """Return the largest length of the data (m), 1 without any: what a residual is measured against."""
        return largest_length(self.equations.variant)

    @cached_property
    def configurations(self) -> tuple[Array, Array]:
        """Return times and positions near the start that close with the drive moved on; the start alone if none is found."""
        times = np.linspace(0.0, self.equations.variant.time.end / 50, CONFIGURATIONS)
        kept, known = self.targets(times)
        guess = np.tile(self.start, (len(times), 1))
        guess[:, list(self.driven)] = known
        try:
            q, closed = self.newton_rows(times, guess, kept)
        except np.linalg.LinAlgError:
            closed = np.zeros(len(times), dtype=bool)
        count = int(np.argmin(closed)) if not closed.all() else len(times)
        return (times[:count], q[:count]) if count else (times[:1], self.start[None])

    def at_zero(self, zero: Sequence[bool]) -> Closure:
        """Return the closure that keeps these of its positions at zero, not at what the start gives."""
        return replace(self, origin=np.where(zero, 0.0, self.origin), asked={})

    def targets(self, times: Array) -> tuple[Array, Array]:
        """Return the kept values (n, equations) and the driven coordinates (n, driven) at times growing from 0."""
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
        """Return g - target (k,) and its Jacobian by the free coordinates (k, f); for times (n,) and q (n, m) n of each."""
        if isinstance(t, np.ndarray):
            values = as_columns(self.rows(t, *q.T), t.shape)
        else:
            values = np.array(self.function(t, *q.tolist()), dtype=float)
        count = len(self.names)
        return values[..., :count] - target, values[..., count:].reshape(*values.shape[:-1], count, len(self.free))

    def correction(self, t: float | Array, q: Array, target: Array) -> Array:
        """Return one Newton correction of the coordinates (m,), block after block; for n rows (n, m)."""
        if not self.blocks:
            return self.linear(t, q, target)
        moved = q.copy()
        for rows, columns in self.blocks:
            residual, jacobian = self.residual(t, moved, target)
            mixed = self.combination[rows]
            part = np.linalg.solve((mixed @ jacobian)[..., columns], -(residual @ mixed.T)[..., None])[..., 0]
            moved[..., [self.free[column] for column in columns]] += part
        return moved - q

    def linear(self, t: float | Array, q: Array, target: Array) -> Array:
        """Return the correction (m,) of all equations at once, linear in the residual: what Baumgarte's gain multiplies."""
        residual, jacobian = self.residual(t, q, target)
        step = np.zeros_like(q)
        step[..., list(self.free)] = -(np.linalg.pinv(jacobian) @ residual[..., None])[..., 0]
        return step

    def newton(self, t: float, guess: Array, target: Array) -> Array | None:
        """Return the position that closes the mechanism near `guess`, or None where Newton does not get there."""
        q = guess.copy()
        last = np.inf
        for _ in range(MAX_NEWTON):
            try:
                step = self.correction(t, q, target)
            except np.linalg.LinAlgError:
                return None
            size = float(np.max(np.abs(step), initial=0.0))
            if not size <= FARTHEST:
                return None
            q = q + step
            # Quadratic convergence ends in round-off: stop when the correction no longer shrinks.
            if size < SETTLED or (size < SHRINKING and size >= last / 2):
                return q
            last = size
        return q if last < CLOSED else None

    def newton_rows(self, times: Array, guess: Array, targets: Array) -> tuple[Array, Flags]:
        """Return n positions (n, m) by one Newton over all rows, and which of them close their mechanism (n,).

        The rules of `newton`, row by row; a row that has settled is left alone.  Raises `LinAlgError` where some row is singular.
        """
        q = guess.copy()
        last = np.full(len(q), np.inf)
        lost = np.zeros(len(q), dtype=bool)
        moving = np.arange(len(q))
        for _ in range(MAX_NEWTON):
            step = self.correction(times[moving], q[moving], targets[moving])
            size = np.max(np.abs(step), axis=1, initial=0.0)
            near = size <= FARTHEST  # false for what is no number
            lost[moving[~near]] = True
            q[moving[near]] += step[near]
            settled = (size < SETTLED) | ((size < SHRINKING) & (size >= last[moving] / 2))
            last[moving] = size
            moving = moving[near & ~settled]
            if not len(moving):
                break
        return q, ~lost & (last < CLOSED)


def largest_length(variant: Variant) -> float:
    """Return the largest length of the data (m), 1 without any: what is large or small in the mechanism."""
    return max((abs(given.value) for given in variant.given if given.si == "m"), default=1.0) or 1.0


def compile_closure(equations: VelocityEquations, start: Sequence[float]) -> Closure | None:
    """Return the closure of a scene, None where the file gives no position equation and the drives leave coordinates free."""
    positions = equations.positions
    variant = equations.variant
    known = set(variant.known_rates)
    free = tuple(i for i, c in enumerate(variant.coordinates) if c.rate not in known)
    if not positions and (free or not equations.equations):  # a crank alone has its group
        return None
    driven = tuple(i for i, c in enumerate(variant.coordinates) if c.rate in known)
    names = [symbol(variant.coordinates[place].name) for place in free]
    wanted = [position.expression for position in positions]
    wanted += [equations.symbols.partial(position.expression, name) for position in positions for name in names]
    function, rows = compile_values(equations, wanted)
    try:
        values = np.array(function(0.0, *start), dtype=float)[: len(positions)]
    except (ArithmeticError, ValueError) as error:
        listed = ", ".join(_without_value(equations, wanted, start))
        raise InputError(
            [
                Fault(
                    say("fault.V311", names=listed, error=str(error)),
                    variant.file,
                    variant.nearest_line("closure"),
                )
            ]
        ) from error
    origin = np.where([position.target == "zero" for position in positions], 0.0, values)
    followed = tuple("" if position.target in {"zero", "start"} else position.target for position in positions)
    combination, blocks = equations.once("closure blocks", lambda: _blocks([p.expression for p in positions], names, equations))
    return Closure(
        tuple(p.name for p in positions), free, driven, followed, origin, np.array(start, dtype=float), function, rows, equations,
        combination, blocks,
    )  # fmt: skip


def _without_value(equations: VelocityEquations, wanted: list[Expression], start: Sequence[float]) -> list[str]:
    """Return the names of the positions that cannot be computed, themselves or a derivative of theirs."""
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


def _blocks(
    expressions: list[Expression], names: list[Expression], equations: VelocityEquations
) -> tuple[Array, tuple[tuple[list[int], list[int]], ...]]:
    """Return sums and differences of the equations with fewer coordinates each, and the order to solve them in."""
    places = {name: i for i, name in enumerate(names)}
    definitions = equations.symbols.definitions

    def inside(expr: Expression) -> frozenset[int]:
        return frozenset(places[name] for name in definitions.behind(expr.free_symbols) if name in places)

    count = len(expressions)
    combination = np.eye(count)
    rows = [inside(expr) for expr in expressions]
    # Multiplied out once, sums and differences cancel by themselves.
    flat = [expanded(expr) for expr in expressions] if count <= MOST_COMBINED else []
    for i in range(len(flat)):
        for j in range(count):
            for sign in (-1, 1):
                if i == j or not rows[i] & rows[j]:
                    continue
                joined = flat[i] + sign * flat[j]
                fewer = inside(joined)
                if fewer < rows[i]:
                    flat[i], rows[i] = joined, fewer
                    combination[i] = combination[i] + sign * combination[j]
    owner = match(rows, len(names))
    if count != len(names) or -1 in owner:
        return combination, ()
    ordered = block_order(rows, owner)
    return combination, tuple(([owner[column] for column in columns], columns) for columns in ordered)
