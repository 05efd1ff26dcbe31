"""Whether the whole motion is possible, and where it ends if not: the determinant-scaled flow.

Enters: the linear system, the blocks, the start.  Leaves: None or a `Stop`, located without regard to any scheme or step.

Near a dead point the velocities grow without bound, so time is the wrong parameter.  With dt/ds = D (the determinant of the
block that is nearest to zero) and dq/ds = D u = adj(A) b nothing is divided by D: the flow is smooth through the fold, and
the dead point is the maximum of t(s).  Where adj(A) b vanishes together with D the flow comes to rest: a change point, where
two motions meet.  Source: numerics.md 3.1.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from coursework.adaptive import dormand_prince, next_length
from coursework.equations import VelocityEquations
from coursework.errors import InputError
from coursework.reduction import Reduction
from coursework.system import LinearSystem, compile_system
from coursework.tabulated import OutsideTable

Array = NDArray[np.float64]
# The event time is wanted to 1e-8 s; with this local tolerance variant 31 at alpha = 0.02 is found to 3e-11 s.
TOLERANCE = 1e-10
# A determinant of this part of its largest value, reached with velocities that stay bounded, is a change point.
AT_REST = 1e-5
# The flow has stalled in a dead point that time alone approaches (the determinant depends on t only).
STALLED = 1e-10
# Part of the run below which a rest before its end is not looked at.
NEAR_END = 1e-9
MAX_STEPS = 20_000


@dataclass(frozen=True, slots=True)
class Event:
    """Where D of block number `block` vanishes: `time` (s), `position`; `demanded` is what b asks beyond the range of A."""

    kind: str
    block: int
    time: float
    position: Array
    demanded: float


@dataclass(slots=True)
class Flow:
    """The determinant-scaled flow of one scene; `evaluations` counts its right-hand sides."""

    system: LinearSystem
    places: list[tuple[list[int], list[int]]]
    largest: list[float]
    rates: list[tuple[bool, int]]
    evaluations: int = field(default=0)

    def scaled(self, t: float, q: Array) -> Array:
        """Return the dimensionless determinants of all blocks at one time and position."""
        matrix, _, _ = self.system.matrix(t, q.tolist())
        return np.array([self._scaled(matrix, block) for block in range(len(self.places))])

    def _scaled(self, matrix: Array, block: int) -> float:
        rows, columns = self.places[block]
        part = matrix[np.ix_(rows, columns)]
        if self.largest[block] > 0:
            return _determinant(part) / self.largest[block]
        # Hadamard: a determinant is at most the product of the lengths of its columns.
        bound = float(np.prod(np.linalg.norm(part, axis=0)))
        return _determinant(part) / bound if bound > 0 else 0.0

    def slopes(self, t: float, q: Array, block: int) -> tuple[Array, float, float]:
        """Return (dq/ds with dt/ds last), the scaled determinant of `block`, and |adj(A) b| of its unknowns."""
        self.evaluations += 1
        matrix, right, known = self.system.matrix(t, q.tolist())
        rows, columns = self.places[block]
        scale = self._scaled(matrix, block)
        unit = scale / _determinant(matrix[np.ix_(rows, columns)]) if scale else self._unit(matrix, block)
        u = np.zeros(len(self.system.unknowns))
        demanded = 0.0
        for index, (r, c) in enumerate(self.places):
            part = matrix[np.ix_(r, c)]
            if index == block:
                rest = right[r] - matrix[r] @ u
                u *= scale
                u[c] = unit * (_adjugate(part) @ rest)
                demanded = float(np.linalg.norm(u[c]))
            else:
                share = scale if index > block else 1.0
                u[c] = _solve(part, share * right[r] - matrix[r] @ u)
        motion = [known[place] * scale if driven else u[place] for driven, place in self.rates]
        return np.array([*motion, scale]), scale, demanded

    def demand(self, t: float, q: Array, block: int) -> float:
        """Return how much the drive asks of a singular block that its links cannot give (in the units of the equations)."""
        matrix, right, _ = self.system.matrix(t, q.tolist())
        u = np.zeros(len(self.system.unknowns))
        for r, c in self.places[:block]:
            u[c] = _solve(matrix[np.ix_(r, c)], right[r] - matrix[r] @ u)
        r, c = self.places[block]
        left = np.linalg.svd(matrix[np.ix_(r, c)])[0][:, -1]
        return float(abs(left @ (right[r] - matrix[r] @ u)))

    def _unit(self, matrix: Array, block: int) -> float:
        if self.largest[block] > 0:
            return 1.0 / self.largest[block]
        rows, columns = self.places[block]
        return float(1.0 / max(np.prod(np.linalg.norm(matrix[np.ix_(rows, columns)], axis=0)), 1e-300))


def flow(equations: VelocityEquations, reduction: Reduction, start: Sequence[float] | None = None) -> Flow:
    """Return the flow of a scene; `start` (that of the file if None) scales determinants whose largest value is unknown."""
    used = [equation for equation in equations.equations if equation.name in reduction.used]
    system = compile_system(equations, used)
    names = list(system.names)
    places = []
    for block in reduction.blocks:
        places.append(([names.index(name) for name in block.equations], [system.unknowns.index(u) for u in block.unknowns]))
    rates = [
        (rate in system.known, (system.known if rate in system.known else system.unknowns).index(rate))
        for rate in equations.variant.rates
    ]
    begin = list(start) if start is not None else [c.start or 0.0 for c in equations.variant.coordinates]
    matrix, _, _ = system.matrix(0.0, begin)
    largest = []
    for block, (rows, columns) in zip(reduction.blocks, places, strict=True):
        at_start = abs(_determinant(matrix[np.ix_(rows, columns)])) if block.size <= 2 else 0.0
        largest.append(block.largest or at_start)
    return Flow(system, places, largest, rates)


def find_event(scene: Flow, start: Sequence[float], end: float, begin: float = 0.0, tolerance: float = TOLERANCE) -> Event | None:
    """Follow the true motion from `start` at t = `begin` until `end` (s); return the first dead or change point, if any."""
    state = np.array([*start, begin], dtype=float)
    scaled = scene.scaled(begin, state[:-1])
    if np.min(np.abs(scaled)) < AT_REST:
        return _at(scene, state, int(np.argmin(np.abs(scaled))), 0.0, 0.0)
    length = 0.0
    usual = 0.0
    block = -1
    for _ in range(MAX_STEPS):
        nearest = int(np.argmin(np.abs(scaled)))
        sign = 1.0 if scaled[nearest] > 0 else -1.0

        def field_of(_s: float, y: Array, k: int = nearest, sign: float = sign) -> Array:
            return sign * scene.slopes(float(y[-1]), y[:-1], k)[0]

        slope, _, demanded = scene.slopes(float(state[-1]), state[:-1], nearest)
        slope = sign * slope
        usual = max(usual, demanded)
        if nearest != block or length == 0.0:
            length = max(end - begin, 1e-12) / 200 / abs(scaled[nearest]) if length == 0.0 else length
            block = nearest
        try:
            step = dormand_prince(field_of, 0.0, state, slope, length)
        except (OutsideTable, ArithmeticError, ValueError) as error:
            # A law need not exist beyond the end of the run: come closer to the end in shorter steps.
            length /= 4
            if length * abs(scaled[nearest]) < NEAR_END * end:
                if end - state[-1] < 100 * NEAR_END * end:
                    return None
                raise InputError(f"the equations cannot be computed beyond t = {state[-1]:.6g} s: {error}") from error
            continue
        ratio = float(np.max(np.abs(step.error) / (tolerance * _sizes(state, end))))
        if not np.isfinite(ratio) or ratio > 1.0:
            length = next_length(length, ratio if np.isfinite(ratio) else 1e10)
            continue
        after = scene.scaled(float(step.state[-1]), step.state[:-1])
        crossed = np.flatnonzero(after * scaled < 0)
        if len(crossed) and crossed.tolist() != [nearest]:
            length /= 4
            continue
        if len(crossed):
            return _locate(scene, field_of, state, slope, length, nearest, sign, end)
        before, state, scaled = scaled, step.state, after
        if state[-1] >= end:
            return None
        if _resting(scene, state, scaled, before, nearest, usual):
            return _at(scene, state, nearest, usual, abs(scaled[nearest]))
        length = next_length(length, ratio)
    return None


def _sizes(state: Array, end: float) -> Array:
    sizes = 1.0 + np.abs(state)
    sizes[-1] = end
    return sizes


def _resting(scene: Flow, state: Array, scaled: Array, before: Array, block: int, usual: float) -> bool:
    size = abs(scaled[block])
    if size > AT_REST or size >= abs(before[block]):
        return False
    demanded = scene.slopes(float(state[-1]), state[:-1], block)[2]
    return size < STALLED or demanded < 1e-3 * usual


def _at(scene: Flow, state: Array, block: int, usual: float, size: float) -> Event | None:
    """Return the event at (or just ahead of) a state whose determinant is as good as zero."""
    slope, scaled, demanded = scene.slopes(float(state[-1]), state[:-1], block)
    consistent = demanded <= 1e-3 * usual if usual else demanded <= 1e-9 * max(1.0, float(np.max(np.abs(slope))))
    position, time = state[:-1], float(state[-1])
    if size and scaled:
        # The determinant runs linearly into zero: one step of its own slope leads there.
        rate = (scene.scaled(time + 1e-7, position + 1e-7 * slope[:-1] / scaled)[block] - scaled) / 1e-7
        if rate:
            ahead = -scaled / rate
            position, time = position + ahead * slope[:-1] / scaled, time + ahead
    return Event("change point" if consistent else "dead point", block, time, position, scene.demand(time, position, block))


def _locate(
    scene: Flow, field_of: object, state: Array, slope: Array, length: float, block: int, sign: float, end: float
) -> Event | None:
    """Return the event inside one step: the part of the step at which the determinant is zero (regula falsi, Illinois)."""
    assert callable(field_of)

    def at(part: float) -> tuple[Array, float]:
        reached = dormand_prince(field_of, 0.0, state, slope, part).state
        return reached, sign * float(scene.scaled(float(reached[-1]), reached[:-1])[block])

    low, high = 0.0, length
    at_low, (best, at_high) = sign * float(scene.scaled(float(state[-1]), state[:-1])[block]), at(length)
    for _ in range(80):
        middle = (low * at_high - high * at_low) / (at_high - at_low)
        best, value = at(middle)
        if abs(value) < 1e-15 or high - low < 1e-15 * length:
            break
        if value > 0:
            low, at_low, at_high = middle, value, at_high / 2
        else:
            high, at_high, at_low = middle, value, at_low / 2
    if best[-1] >= end:
        return None
    time, position = float(best[-1]), best[:-1]
    return Event("dead point", block, time, position, scene.demand(time, position, block))


def _determinant(matrix: Array) -> float:
    if len(matrix) == 1:
        return float(matrix[0, 0])
    if len(matrix) == 2:
        return float(matrix[0, 0] * matrix[1, 1] - matrix[0, 1] * matrix[1, 0])
    return float(np.linalg.det(matrix))


def _adjugate(matrix: Array) -> Array:
    """Return adj(A), also where A is singular (by singular values)."""
    if len(matrix) == 1:
        return np.ones((1, 1))
    if len(matrix) == 2:
        (a, b), (c, d) = matrix
        return np.array([[d, -b], [-c, a]])
    u, sizes, v = np.linalg.svd(matrix)
    others = np.array([np.prod(np.delete(sizes, i)) for i in range(len(sizes))])
    return np.asarray(np.linalg.det(u) * np.linalg.det(v) * (v.T * others) @ u.T)


def _solve(matrix: Array, right: Array) -> Array:
    if len(matrix) == 1:
        return np.asarray(right / matrix[0, 0])
    determinant = _determinant(matrix)
    return np.asarray(_adjugate(matrix) @ right / determinant if len(matrix) == 2 else np.linalg.solve(matrix, right))
