"""Change points, where A u = b loses rank but stays solvable, so that two motions meet; and the velocities possible there.

Enters: the flow and a state near such a point.  Leaves: the point itself, or None; then its branches.  Used by
`search.py` and `scene.py`.

Near a change point the true motion is one arm of a crossing, and a motion that is off by 1e-12 m passes it at 1e-6 rad on
either side.  Waiting for a determinant to vanish would therefore fail: Newton's method goes to the crossing itself, and the
distance by which the motion misses it decides.  Source: hard cases H03, H04 (tangent cone of the loop closure), H06.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.equations.reduction.system import compile_system
from coursework.motion.singular.scaled_flow import Flow
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen

MAX_NEWTON = 12
_CLOSE = 1e-13  # rad or share of the largest length; size of Newton's last correction
_ZERO = 1e-9  # relative to their size: determinant and demand at the crossing
_STRAYED = 10.0  # multiple of the distance allowed: beyond it Newton would find another point, if any
_NUDGE = 1e-6  # rad or share of the largest length; step of the differences in Newton's matrix
_STEP = 1e-5  # rad or share of the largest length along the motion, and a share of the run; central difference, error about 1e-10
_SAME = 1e-6  # share of the fastest; velocities that differ by less are one motion
_PACES = 10.0  # velocities that differ by this factor from those they were looked for with are looked for again
_FLAT = 1e-6  # a coefficient of the quadratic below this share of the largest counts as zero
_DOUBLE = 1e-10  # and so does its discriminant below this share: differences are no more exact, and two roots would be noise
_TOLD = 1e3 * float(np.finfo(float).eps)  # relative to the matrix; smaller differences have fewer than three digits
_ALIKE = 1e-5  # sides that differ by less, for every velocity, are alike: differences over _STEP are no more exact
_BESIDE = 0.1  # rad, or share of the largest length; how far from a singular position coefficients have their usual size
_OPENS = 1e-5  # share of the fastest; a motion at which an equation that was not solved opens faster is none of the mechanism
# Two-point Gauss rule for the closure error between two positions; exact to the fourth order of their distance.
_GAUSS = (0.5 - 3**-0.5 / 2, 0.5 + 3**-0.5 / 2)


def nearest_change_point(
    flow: Flow, t: float, q: Array, block: int, rates: Array, within: float
) -> tuple[float, Array, float] | None:
    """Return the change point of `block` at most `within` (rad or share of the size) from (t, q), None if Newton finds none.

    The result is its time (s), its position, and by what share of its size the motion misses it.
    `rates` (m,) are those of the motion at (t, q).
    """
    near = _crossing_near(flow, t, q, block, rates)
    try:
        x = near.solved(_STRAYED * within)
        if x is None or np.max(np.abs(x)) > within:
            return None
        missed = near.missed(x)
    except (ArithmeticError, ValueError):
        return None
    time, position = near.moved(1.0, x, near.base_at(x))
    return float(time), np.array(position), missed


@frozen
class _Crossing:
    """The search for a change point near (t, q).

    The unknowns are the displacements of the block's own unknowns in their `units`, and the time multiplied by `pace`.  At the
    change point the determinant and the demand of the drive are zero; every equation of the block but the lost one is kept.
    `own` pairs coordinates with the unknowns that are their rates; `left` (k, k) holds the directions of the block's equations at
    (t, q), the lost one last; `earlier` (m,) flags the rates known before the block.
    """

    flow: Flow
    block: int
    t: float
    q: Array
    rates: Array
    own: tuple[tuple[int, int], ...]
    pace: float
    left: Array
    scale: float
    earlier: Flags
    units: Array

    def moved(self, part: float, x: Array, base: Array) -> tuple[float, list[float]]:
        """Return time and position after a `part` of the displacement x; what is known before the block moves at rates `base`."""
        shifted = self.q + part * x[-1] / self.pace * base
        for coordinate, unknown in self.own:
            shifted[coordinate] = self.q[coordinate] + part * x[unknown] * self.units[unknown]
        return self.t + part * x[-1] / self.pace, shifted.tolist()

    def base_at(self, x: Array) -> Array:
        return np.where(self.earlier, self._part(0.5, x, self.rates)[2], self.rates)

    def at(self, x: Array) -> tuple[Array, Array]:
        """Return the values that must become zero, and the direction of the lost equation."""
        middle, right, now = self._part(0.5, x, self.rates)
        matrix, end, _ = self._part(1.0, x, np.where(self.earlier, now, self.rates))
        lost = np.linalg.svd(matrix)[0][:, -1]
        lost = lost if lost @ self.left[:, -1] >= 0 else -lost
        kept = self.left[:, :-1].T @ (middle @ x[:-1] - right * x[-1] / self.pace)
        size = len(matrix)
        zero = (np.linalg.det(matrix) / self.scale**size, lost @ end / (self.scale * self.pace), *kept / self.scale)
        return np.array(zero), lost

    def solved(self, farthest: float) -> Array | None:
        """Return the displacement to the crossing, None if Newton leaves the neighbourhood or does not converge to one."""
        x = self._along_the_motion(farthest)
        nudges = _NUDGE * np.eye(len(x))
        for _ in range(MAX_NEWTON):
            jacobian = np.array([(self.at(x + d)[0] - self.at(x - d)[0]) / (2 * _NUDGE) for d in nudges]).T
            step = np.linalg.lstsq(jacobian, -self.at(x)[0], rcond=1e-9)[0]
            x = x + step
            if not np.max(np.abs(x)) <= farthest:
                return None
            if np.max(np.abs(step)) < _CLOSE:
                break
        else:
            if np.max(np.abs(step)) > 1e3 * _CLOSE:
                return None
        return x if np.max(np.abs(self.at(x)[0][:2])) <= _ZERO else None

    def _along_the_motion(self, farthest: float) -> Array:
        """Return the displacement after which the determinant would vanish if the motion went on evenly; none if that is far.

        Where a whole line of positions are change points, it leads to the one that the motion meets.
        """
        matrix, right, _ = self._part(0.0, np.zeros(len(self.left) + 1), self.rates)
        moving = np.append(np.linalg.lstsq(matrix, right, rcond=None)[0] / self.pace, 1.0)
        size = float(np.linalg.det(matrix))
        after, before = (float(np.linalg.det(self._part(1.0, side * _NUDGE * moving, self.rates)[0])) for side in (1, -1))
        length = -size * 2 * _NUDGE / (after - before) if after != before else 0.0
        return length * moving if np.max(np.abs(length * moving)) < farthest else 0.0 * moving

    def missed(self, x: Array) -> float:
        """Return the relative error by which the lost equation fails to lead to the crossing."""
        lost, base, gap = self.at(x)[1], self.base_at(x), 0.0
        for part in _GAUSS:
            matrix, right, _ = self._part(part, x, base)
            gap += float(lost @ (matrix @ x[:-1] - right * x[-1] / self.pace)) / 2
        return abs(gap) / self.scale

    def _part(self, part: float, x: Array, base: Array) -> tuple[Array, Array, Array]:
        matrix, right, velocities = self.flow.part(*self.moved(part, x, base), self.block)
        return matrix * self.units, right, velocities


def _crossing_near(flow: Flow, t: float, q: Array, block: int, rates: Array) -> _Crossing:
    first, _, velocities = flow.part(t, q.tolist(), block)
    units = _units(flow, block)
    left, sizes, _ = np.linalg.svd(first * units)
    scale = (float(sizes[0]) if len(sizes) > 1 else flow.largest[block] * float(units[0])) or 1.0
    pace = max(float(np.max(np.abs(rates / flow.units), initial=0.0)), 1e-9)
    return _Crossing(flow, block, t, q, rates, _own(flow, block), pace, left, scale, velocities != 0, units)


def _units(flow: Flow, block: int) -> Array:
    """Return what a displacement of 1 is for each unknown of a block: 1 rad, or the size of the mechanism."""
    return flow.unknown_units[list(flow.places[block].unknowns)]


def _own(flow: Flow, block: int) -> tuple[tuple[int, int], ...]:
    """Return pairs: a coordinate whose rate the block determines, and the index of that rate among the block's unknowns."""
    unknowns = flow.places[block].unknowns
    return tuple((i, unknowns.index(c)) for i, (driven, c) in enumerate(flow.rates) if not driven and c in unknowns)


def branches_at(
    flow: Flow, block: int, time: float, position: Sequence[float], end: float = 1.0
) -> tuple[dict[str, float], ...] | None:
    """Return the velocities possible at a change point; empty if they cannot be told apart, None if there are none.

    `end` (s) is that of the run.  What is known does not say how fast the unknown velocities are: they are looked for once more
    where they turn out to be far slower or faster.
    """
    start = np.array(position, dtype=float)
    known = float(np.max(np.abs(flow.part(time, start.tolist(), block)[2] / flow.units), initial=0.0))
    pace = max(1.0, 1.0 / end, known)
    found = _branches(flow, block, time, start, pace, min(1.0 / pace, end))
    fastest = max([known, *(abs(value) for one in found or () for value in one.values())])
    if found is not None and fastest and not 1 / _PACES < fastest / pace < _PACES:
        found = _branches(flow, block, time, start, fastest, min(1.0 / fastest, end)) or found
    if found is None:
        return None
    kept = _kept_closed(flow, time, start, found) if len(found) > 1 else found or _by_positions(flow, time, start)
    units = dict(zip(flow.system.unknowns, flow.unknown_units.tolist(), strict=True))
    return tuple({name: value * units[name] for name, value in one.items()} for one in kept)


def _by_positions(flow: Flow, time: float, start: Array) -> tuple[dict[str, float], ...]:
    """Return the one motion that position equations leave where those solved tell nothing, as with a double factor; else none."""
    equations, unknowns = flow.equations, flow.system.unknowns
    if not equations.from_closure:
        return ()
    try:
        matrix, right, _ = compile_system(equations, [*equations.equations, *equations.from_closure]).matrix(time, start.tolist())
    except (ArithmeticError, ValueError):
        return ()
    matrix = matrix * flow.unknown_units
    sizes = np.maximum(np.abs(matrix).max(axis=1, initial=0.0), 1e-300)
    u, _, rank, _ = np.linalg.lstsq(matrix / sizes[:, None], right / sizes, rcond=_OPENS)
    closes = np.abs(matrix @ u - right) <= _OPENS * sizes * float(np.max(np.abs(u), initial=0.0))
    return (dict(zip(unknowns, u.tolist(), strict=True)),) if rank == len(unknowns) and closes.all() else ()


def _kept_closed(flow: Flow, time: float, start: Array, found: tuple[dict[str, float], ...]) -> tuple[dict[str, float], ...]:
    """Return the motions that no equation beside those solved opens, such as one of [closure]; all if none is left."""
    equations, unknowns, units = flow.equations, flow.system.unknowns, flow.unknown_units
    beside = [one for one in (*equations.equations, *equations.from_closure) if one.name not in flow.system.names]
    if not beside:
        return found
    system, away = compile_system(equations, beside), _BESIDE * flow.units
    try:
        matrix, right, _ = system.matrix(time, start.tolist())
        # The equations of a singular position may be nothing but round-off there.
        around = [system.matrix(time, (start + off).tolist())[0] * units for off in (-away, away)]
    except (ArithmeticError, ValueError):
        return found
    matrix = matrix * units
    most = np.max(np.abs([matrix, *around]), axis=(0, 2), initial=0.0)

    def is_closed(branch: dict[str, float]) -> bool:
        u = np.array([branch.get(name, np.nan) for name in unknowns])  # beyond a later singular block nothing is known
        told = ~np.any((matrix != 0) & np.isnan(u), axis=1)
        fastest = max(map(abs, branch.values()))
        gaps = np.abs(matrix @ np.nan_to_num(u) - right)
        return bool(np.all(gaps[told] <= _OPENS * most[told] * fastest))

    return tuple(branch for branch in found if is_closed(branch)) or found


def _branches(flow: Flow, block: int, time: float, start: Array, pace: float, span: float) -> tuple[dict[str, float], ...] | None:
    """Return what `branches_at` does, in units of the flow: velocities of about a `pace` (1/s), by differences in a `span` (s).

    There A u = b has a line of solutions u + x v.  The second derivative of the closure selects those with
    w (dA/dt u - db/dt) = 0, where w A = 0: a quadratic equation in x.
    """
    step, units = _STEP * span, _units(flow, block)
    matrix, right, velocities = flow.part(time, start.tolist(), block)
    matrix = matrix * units
    left, sizes, directions = np.linalg.svd(matrix)
    scale = float(np.max(np.abs(matrix))) if len(sizes) > 1 else flow.largest[block] * float(units[0])  # it is nought here
    if len(sizes) > 1 and sizes[-2] < 1e-6 * sizes[0]:
        return ()
    w, v = left[:, -1], pace * directions[-1]
    particular = directions[:-1].T @ ((left[:, :-1].T @ right) / sizes[:-1])  # any other solution differs by a multiple of v

    def demand(u: Array) -> tuple[float, float]:
        motion = velocities.copy()
        for coordinate, unknown in _own(flow, block):
            motion[coordinate] = u[unknown] * units[unknown]
        after, before = (flow.part(time + side * step, (start + side * step * motion).tolist(), block)[:2] for side in (1, -1))
        left, right = w @ ((after[0] - before[0]) @ (u * units)) / (2 * step), w @ (after[1] - before[1]) / (2 * step)
        return float(left - right), float(max(abs(left), abs(right)))

    found_at = {x: demand(particular + x * v) for x in (-1.0, 0.0, 1.0)}
    at, sides = {x: gap for x, (gap, _) in found_at.items()}, max(side for _, side in found_at.values())
    square, slope, constant = (at[1.0] + at[-1.0]) / 2 - at[0.0], (at[1.0] - at[-1.0]) / 2, at[0.0]
    largest = max(abs(square), abs(slope), abs(constant), 1e-300)
    if largest < max(_TOLD * scale * pace / step, _ALIKE * sides):
        return ()  # lengths so different that the differences are round-off, or both sides alike whatever the velocity
    if abs(square) < _FLAT * largest:
        roots = [-constant / slope] if abs(slope) > _FLAT * largest else []
    else:
        inside = slope**2 - 4 * square * constant
        size = max(slope**2, abs(square * constant))
        if inside < -_FLAT * size:
            return None  # the mechanism closes here but nowhere nearby
        inside = inside if inside > _DOUBLE * size else 0.0
        roots = [(-slope + sign * np.sqrt(inside)) / (2 * square) for sign in (1, -1)]
    found = []
    for x in roots:
        every = zip(
            flow.system.unknowns,
            flow.velocities(time, start.tolist(), block, ((particular + x * v) * units).tolist()),
            flow.unknown_units.tolist(),
            strict=True,
        )
        found.append({name: float(value) / unit for name, value, unit in every if value is not None})
    return distinct(found, pace)


def distinct(found: Sequence[dict[str, float]], pace: float = 1.0) -> tuple[dict[str, float], ...]:
    """Return the distinct motions: two whose velocities agree to 1e-6 of a `pace` are one, and there is nothing to choose.

    >>> distinct([{"w": 1.0}, {"w": 1.0 + 5e-7}])
    ({'w': 1.0},)
    """
    kept: list[dict[str, float]] = []
    for branch in found:
        if all(any(abs(value - other.get(name, np.inf)) > _SAME * pace for name, value in branch.items()) for other in kept):
            kept.append(branch)
    return tuple(kept)
