"""The determinant-scaled flow: the motion with the smallest determinant as its clock in place of time.

Enters: the linear system and its blocks.  Leaves: `Flow`.  Used by `search.py`, `change_point.py`, the rows' determinants.

Near a dead point the velocities grow without bound, so time is the wrong parameter.  With dt/ds = D (the determinant of one
block, dimensionless) and dq/ds = D u = adj(A) b, nothing is divided by D.  Source: numerics.md 3.1.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import field
from functools import partial

import numpy as np

from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Program, compile_function
from coursework.equations.codegen.tabulated import OutsideTable
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.statements import clock_statements
from coursework.equations.reduction.symbolic import constants
from coursework.equations.reduction.system import LinearSystem, compile_system, scene_program
from coursework.motion.integration.order_eight import SLOPES, dormand_prince_8
from coursework.system.arrays import Array
from coursework.system.frozen import changing, frozen
from coursework.variant.record.held import largest_length
from coursework.variant.record.variant import Variant

# Number of positions and times at which a determinant of unknown largest value is evaluated; a rough scale is enough.
_LOOKS = 16


@frozen
class BlockColumns:
    """The places of one block in the values of the linear system.

    `entries` are those of its matrix, row by row; -1, the zero after all values, stands for no entry.  `rights` are those of its
    right side.  `earlier` lists for each row the terms (entry, unknown) with velocities found before; it is empty if there are
    none.  `unknowns` are the columns the block determines.  `factors` bring the largest coefficient of every row near 1, so that
    lengths, teeth and equations multiplied by any number weigh alike; they are powers of 2, which round nothing.
    """

    entries: tuple[int, ...]
    rights: tuple[int, ...]
    earlier: tuple[tuple[tuple[int, int], ...], ...]
    unknowns: tuple[int, ...]
    factors: tuple[float, ...]


@changing
class Flow:
    """The determinant-scaled flow of one scene.

    `largest` scales the determinant of each block.  `rates` says for each coordinate whether its rate is driven, and its index
    among the driven or the unknown rates.  `compile_clock(block)` gives (pace, *q, t) -> the flow whose clock is the determinant
    of a block times a pace.  `units` (m,) of the coordinates are 1 rad for angles, for lengths the size of the mechanism; they
    and `unknown_units` (k,) measure steps, in micrometres as in kilometres.  `noise` is the share of itself by which round-off
    changes the flow: large where equations nearly depend on each other everywhere.  `evaluations` counts right-hand sides; the
    flow was made from `equations` and `begin` (m,).
    """

    equations: VelocityEquations
    system: LinearSystem
    places: tuple[BlockColumns, ...]
    largest: tuple[float, ...]
    rates: tuple[tuple[bool, int], ...]
    compile_clock: Callable[[int], Callable[..., tuple[float, ...]]]
    units: Array
    unknown_units: Array
    noise: float
    begin: Sequence[float]
    clocks: dict[int, Callable[..., tuple[float, ...]]] = field(default_factory=dict)
    evaluations: int = field(default=0)

    def _values(self, t: float, q: Sequence[float]) -> tuple[float, ...]:
        return (*self.system.scalar(t, *q), 0.0)

    def scaled(self, t: float, q: Sequence[float]) -> list[float]:
        """Return the dimensionless determinants of all blocks at one time (s) and position."""
        values = self._values(t, q)
        return [_determinant(values, place) / size for place, size in zip(self.places, self.largest, strict=True)]

    def relative(self, determinants: Array, blocks: Sequence[int]) -> Array:
        """Return the determinants (n, k) of some blocks relative to their largest values."""
        return np.asarray(determinants / np.array([self.largest[block] for block in blocks]))

    def slopes(self, t: float, q: Sequence[float], block: int) -> tuple[float, ...]:
        """Return dq/ds, with dt/ds last, for the clock of `block`.  Raises `ArithmeticError` if another block is singular."""
        self.evaluations += 1
        return self._field(block, 1)(*q, t)

    def clock(self, block: int, sign: int) -> Clock:
        """Return the flow with the clock of `block`; a `sign` of -1 reverses it."""
        return Clock(self, self._field(block, sign))

    def _field(self, block: int, sign: int) -> Callable[..., tuple[float, ...]]:
        if block not in self.clocks:
            self.clocks[block] = self.compile_clock(block)
        return partial(self.clocks[block], sign / self.largest[block])

    def part(self, t: float, q: Sequence[float], block: int) -> tuple[Array, Array, Array]:
        """Return A (k, k) and b (k,) of one block, with earlier velocities moved to b, and the rates (m,) known so far.

        The rows of A and b are multiplied by the block's `factors`.
        """
        values = self._values(t, q)
        u = [0.0] * len(self.system.unknowns)
        for place in self.places[:block]:
            for column, value in zip(place.unknowns, _solve(values, place, _rest(values, place, u)), strict=True):
                u[column] = value
        place = self.places[block]
        known = values[len(self.system.entries) + len(self.system.names) : -1]
        velocities = np.array([known[index] if driven else u[index] for driven, index in self.rates])
        factors = np.array(place.factors)
        return factors[:, None] * _matrix(values, place), factors * _rest(values, place, u), velocities

    def velocities(self, t: float, q: Sequence[float], block: int, chosen: Sequence[float]) -> list[float | None]:
        """Return every unknown velocity if those of `block` are `chosen`; None from a later singular block on."""
        values = self._values(t, q)
        u: list[float | None] = [0.0] * len(self.system.unknowns)
        for index, place in enumerate(self.places):
            involved = [u[column] for row in place.earlier for _, column in row]
            found: Sequence[float | None] = chosen
            if index != block:
                known = [value or 0.0 for value in u]
                solvable = None not in involved and abs(_determinant(values, place)) > 1e-6 * self.largest[index]
                found = _solve(values, place, _rest(values, place, known)) if solvable else [None] * len(place.unknowns)
            for column, value in zip(place.unknowns, found, strict=True):
                u[column] = value
        return u

    def demand(self, t: float, q: Sequence[float], block: int) -> float:
        """Return the part of the drive's demand that a singular block cannot meet (in the units of the equations)."""
        matrix, right, _ = self.part(t, q, block)
        factors = np.array(self.places[block].factors)
        matrix, right = matrix / factors[:, None], right / factors
        left = np.linalg.svd(matrix)[0][:, -1]
        return float(abs(left @ right))


@frozen
class Clock:
    """The flow with one clock: `field`(*state) -> d(state)/ds, where a state is a position followed by t."""

    flow: Flow
    field: Callable[..., tuple[float, ...]]

    def slope(self, state: Array) -> Array:
        """Return d(state)/ds.  Raises `ArithmeticError` if a block other than that of the clock is singular."""
        self.flow.evaluations += 1
        return np.array(self.field(*state.tolist()))

    def step(self, state: Array, slope: Array, length: float) -> tuple[Array, list[float]]:
        """Return the state after a `length` of the clock (s), starting with the known `slope`, and its estimated error."""
        self.flow.evaluations += SLOPES
        return dormand_prince_8(self.field, state, slope, length)


def compile_flow(equations: VelocityEquations, reduction: Reduction, start: Sequence[float] | None) -> Flow:
    """Return the flow of a scene; `start` (by default that of the file) scales determinants whose largest value is unknown."""
    used = [equation for equation in equations.equations if equation.name in reduction.used]
    system = compile_system(equations, used)
    names = list(system.names)
    entry_at = {place: entry for entry, place in enumerate(system.entries)}
    count = len(system.entries)
    begin = list(start) if start is not None else [c.start_or_guess or 0.0 for c in equations.variant.coordinates]
    variant = equations.variant
    size = _length_unit(variant)
    units = np.array([1.0 if one.unit == "rad" else size for one in variant.coordinates])
    own = np.array([size if variant.unit_of(name).startswith("m") else 1.0 for name in system.unknowns])
    seen = _seen(system, begin, units, equations.variant.time.end)
    places = []
    for block in reduction.blocks:
        rows = [names.index(name) for name in block.equations]
        columns = [system.unknowns.index(unknown) for unknown in block.unknowns]
        entries = tuple(entry_at.get((row, column), -1) for row in rows for column in columns)
        earlier = tuple(
            tuple((entry, column) for (other, column), entry in entry_at.items() if other == row and column not in columns)
            for row in rows
        )
        rights, earlier = tuple(count + row for row in rows), earlier if any(earlier) else ()
        places.append(BlockColumns(entries, rights, earlier, tuple(columns), _factors(seen, entries, len(columns))))
    rates = tuple(
        (rate in system.known, (system.known if rate in system.known else system.unknowns).index(rate))
        for rate in equations.variant.rates
    )
    largest = tuple(block.largest or _largest_seen(seen, place) for block, place in zip(reduction.blocks, places, strict=True))
    noise = max([0.0, *(_noise(seen, place, size) for place, size in zip(places, largest, strict=True))])
    return Flow(
        equations, system, tuple(places), largest, rates, lambda block: _compile_clock(equations, reduction, block), units, own,
        noise, begin,
    )  # fmt: skip


def _length_unit(variant: Variant) -> float:
    """Return the size of a mechanism as a unit of length: the power of 2 (m) next to its largest length, which rounds nothing."""
    return float(2.0 ** round(math.log2(largest_length(variant))))


def _compile_clock(equations: VelocityEquations, reduction: Reduction, clock: int) -> Callable[..., tuple[float, ...]]:
    """Return (pace, *q, t) -> pace D dq/dt and pace D, where D is the determinant of block `clock`; nothing is divided by D."""
    variant = equations.variant
    results = [f"_out{place}" for place in range(len(variant.rates) + 1)]

    def written() -> Program:
        return scene_program(equations, clock_statements(reduction.blocks, clock, variant.rates, results))

    body = equations.once(("clock", clock, reduction.names), written).bind(constants(variant))
    arguments = ["_pace", *(private(name) for name in (*(c.name for c in variant.coordinates), "t"))]
    return compile_function("clock", arguments, body, [f"_pace * {result}" for result in results])


def _seen(system: LinearSystem, begin: Sequence[float], units: Array, end: float) -> list[tuple[float, ...]]:
    """Return the values of the system at the start and at some positions and times around it, where it has any."""
    found = []
    for look in range(_LOOKS):
        # Any fixed irrational shifts will do; the first point is the start itself.
        shares = [0.5 * look * (0.618 * (i + 1) % 1.0) / _LOOKS for i in range(len(begin))]
        q = [value + share * unit for value, share, unit in zip(begin, shares, units.tolist(), strict=True)]
        try:
            found.append((*system.scalar(look / _LOOKS * end, *q), 0.0))
        except (ArithmeticError, ValueError, OutsideTable):
            continue
    return found


def _largest_seen(seen: Sequence[Sequence[float]], place: BlockColumns) -> float:
    """Return the largest |determinant| in values of the system; 1 if none is found."""
    found = max([0.0, *(abs(_determinant(values, place)) for values in seen)])
    return found if 0.0 < found < float("inf") else 1.0


def _noise(seen: Sequence[Sequence[float]], place: BlockColumns, largest: float) -> float:
    """Return the round-off of a determinant as a share of its `largest` value.

    It is Hadamard's bound for rows and columns that were brought to the same size, so that no unit and no factor counts.
    """
    if len(place.unknowns) == 1 or not seen:
        return 0.0
    size = len(place.unknowns)
    matrices = np.abs(np.array(seen)[:, place.entries]).reshape(-1, size, size)
    bounds = np.full(len(seen), float(np.finfo(float).eps) / largest)
    for axis in (2, 1):
        sizes = matrices.max(axis=axis, keepdims=True)
        matrices, bounds = matrices / np.where(sizes > 0, sizes, 1.0), bounds * sizes.prod(axis=(1, 2))
    bounds = bounds * np.sqrt((matrices**2).sum(axis=2)).prod(axis=1)
    return float(bounds[np.isfinite(bounds)].max(initial=0.0))


def _factors(seen: Sequence[Sequence[float]], entries: Sequence[int], size: int) -> tuple[float, ...]:
    """Return for each row of a block the power of 2 that brings its largest coefficient between a half and 1; 1 for one alone."""
    if size == 1 or not seen:
        return (1.0,) * size
    largest = np.fmax.reduce(np.abs(np.array(seen)[:, entries])).reshape(size, size).max(axis=1)
    return tuple((0.5 ** np.frexp(np.where(np.isfinite(largest), largest, 1.0))[1].clip(-1000, 1000)).tolist())


def _rest(values: Sequence[float], place: BlockColumns, u: Sequence[float]) -> list[float]:
    if not place.earlier:
        return [values[right] for right in place.rights]
    return [
        values[right] - sum([values[entry] * u[column] for entry, column in earlier])
        for right, earlier in zip(place.rights, place.earlier, strict=True)
    ]


def _determinant(values: Sequence[float], place: BlockColumns) -> float:
    entries = [values[entry] for entry in place.entries]
    match len(place.unknowns):  # the walk asks at every step, so small ones are written out
        case 1:
            return entries[0]
        case 2:
            a, b, c, d = entries
            return a * d - b * c
        case 3:
            a, b, c, d, e, f, g, h, i = entries
            return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
    return float(np.linalg.det(_matrix(values, place)))


def _matrix(values: Sequence[float], place: BlockColumns) -> Array:
    size = len(place.unknowns)
    return np.array([values[entry] for entry in place.entries]).reshape(size, size)


def _solve(values: Sequence[float], place: BlockColumns, rest: Sequence[float]) -> list[float]:
    """Return the unknowns of a block.  Raises `ZeroDivisionError` if it is singular."""
    try:
        found: list[float] = np.linalg.solve(_matrix(values, place), np.array(rest)).tolist()
    except np.linalg.LinAlgError as error:
        raise ZeroDivisionError("a block is singular") from error
    return found
