"""The verdicts about closeness found another way: the motion by DOP853 of scipy, scales and shares by hand from its columns.

Shares with the package: the right-hand side, the start, and the text of the position equations; nothing of `checks/`.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

LIMIT, RETURNS = 0.05, 0.03


@dataclass(frozen=True)
class Judge:
    """The true rows of a run at its own times (n, m + k), the row after the stated period, and the scales of the columns."""

    run: Any
    rows: np.ndarray
    after: np.ndarray | None
    scale: np.ndarray

    @property
    def columns(self) -> list[int]:
        """Return the columns that are judged: all but driven rates."""
        known = set(self.run.variant.known_rates)
        return [place for place, name in enumerate(self.run.motion.names) if name not in known]

    @property
    def shares(self) -> np.ndarray:
        """Return |table - truth| as shares (n, k)."""
        gap = np.abs(self.run.motion.rows - self.rows)
        return (np.where(gap < 1e-10, 0.0, gap) / self.scale)[:, self.columns]

    def accuracy(self) -> float:
        return float(np.max(self.shares))

    def continuity(self) -> float:
        gap = (self.run.motion.rows - self.rows)[:, self.columns]
        return float(np.max(np.abs(np.diff(gap, axis=0)) / self.scale[self.columns]))

    def period(self, velocities: bool) -> float | str:
        """Return the share by which the last row of whole periods misses the first, or why that is not judged."""
        motion, time = self.run.motion, self.run.variant.time
        period = time.period or time.end
        whole = int((motion.t[-1] + max(motion.step / 2, 0.01 * period)) / period)
        if not whole:
            return "SKIP"
        row = min(round(whole * period / motion.step), len(motion.t) - 1)
        places = [p for p in self.columns if (motion.names[p] in motion.velocity_names) == velocities]
        if time.period is None:
            if float(np.max(self._missed(self.rows[row])[self.columns])) > RETURNS:
                return "SKIP"
        elif self.after is not None and float(np.max(self._missed(self.after)[self.columns])) > RETURNS:
            if self._is_drive_back(self.after):
                return self._later(places)
            if float(np.max(self._missed(self.after)[places])) > RETURNS:
                return "FAIL"
        gap = motion.rows[row] - motion.rows[0]
        return float(np.max(self._share(gap)[places]))

    def _is_drive_back(self, row: np.ndarray) -> bool:
        variant = self.run.variant
        driven = [c for c in variant.coordinates if c.rate in variant.known_rates]
        names = [name for c in driven for name in (c.name, c.rate)]
        missed = self._missed(row)
        return bool(names) and all(missed[self.run.motion.names.index(name)] <= RETURNS for name in names)

    def _later(self, places: list[int]) -> float | str:
        """Return the share after the first of a hundred periods in which every column is back to 0.001 of its scale."""
        motion, period = self.run.motion, self.run.variant.time.period
        rows = follow(self.run, period * np.arange(101))
        back = [k for k in range(1, 101) if float(np.max(self._missed(rows[k]))) <= 1e-3]
        whole = int((motion.t[-1] + motion.step / 2) / (back[0] * period)) if back else 0
        if not whole:
            return "SKIP"
        row = min(round(whole * back[0] * period / motion.step), len(motion.t) - 1)
        return float(np.max(self._share(motion.rows[row] - motion.rows[0])[places]))

    def _missed(self, row: np.ndarray) -> np.ndarray:
        return self._share(row - self.rows[0])

    def _share(self, gap: np.ndarray) -> np.ndarray:
        angles = [self.run.variant.unit_of(name) == "rad" for name in self.run.motion.names]
        gap = np.abs(np.where(angles, np.angle(np.exp(1j * gap)), gap))
        return np.where(gap < 1e-10, 0.0, gap) / self.scale

    def drift(self) -> float | None:
        """Return the largest residual over the shortest length that stands before an @ or in a group, None without closure."""
        closure = self.run.scene.closure
        if closure is None:
            return None
        kept, _ = closure.targets(self.run.motion.t)
        rows = zip(self.run.motion.t.tolist(), self.run.motion.coordinates, kept, strict=True)
        residuals = np.array([closure.residual(t, q, target)[0] for t, q, target in rows])
        units = [position.unit for position in self.run.scene.equations.positions]
        sizes = np.where([unit == "rad" for unit in units], 1.0, shortest(self.run))
        return float(np.max(np.abs(residuals) / sizes))


def verdict(share: float | str | None) -> str:
    """Return PASS, COARSE, or what stands instead of a share."""
    if share is None or isinstance(share, str):
        return share or "SKIP"
    return "PASS" if share <= LIMIT else "COARSE"


def judge(run: Any) -> Judge:
    """Return the truth about a run that reaches its end."""
    time = run.variant.time
    times = run.motion.t
    beyond = [time.period] if time.period is not None and time.period > times[-1] else []
    rows = follow(run, np.concatenate([times, beyond]))
    after = None
    if time.period is not None:
        after = rows[-1] if beyond else follow(run, np.array([0.0, time.period]))[-1]
    rows = rows[: len(times)]
    window = rows if time.period is None else rows[: max(2, round(time.period / run.motion.step) + 1)]
    spans = np.ptp(window, axis=0)
    units = [run.variant.unit_of(name) for name in run.motion.names]
    spans = np.array([min(s, 2 * math.pi) if unit == "rad" else s for s, unit in zip(spans, units, strict=True)])
    sizes = np.where([name in run.motion.velocity_names for name in run.motion.names], np.max(np.abs(window), axis=0), 0.0)
    widest = np.array([max(s for s, other in zip(spans, units, strict=True) if other == unit) for unit in units])
    scale = np.maximum(np.maximum(spans, 0.1 * sizes), np.maximum(0.05 * widest, 1e-9))
    return Judge(run, rows, after, scale)


def follow(run: Any, times: np.ndarray) -> np.ndarray:
    """Return all columns at `times` (growing from 0), integrated piece by piece where the drive changes its formula."""
    rates = run.scene.rates
    size = len(rates.coordinates)
    q = np.array(run.motion.coordinates[0])
    edges = [0.0, *(b for b in rates.breaks if b < times[-1]), float(times[-1])]
    found = {0.0: q}
    for begin, end in itertools.pairwise(edges):
        inside = times[(times > begin) & (times < end)]
        last = end * (1 - 1e-13) if end in rates.breaks else end

        def slope(t: float, y: np.ndarray, last: float = last) -> np.ndarray:
            return np.array(rates.evaluate(min(t, last), *y.tolist())[:size])

        done = solve_ivp(slope, (begin, end), q, "DOP853", rtol=1e-11, atol=1e-12, t_eval=[*inside, end])
        assert done.success, done.message
        found |= dict(zip(done.t.tolist(), done.y.T, strict=True))
        q = done.y[:, -1]
    positions = np.array([found[min(found, key=lambda key: abs(key - t))] for t in times.tolist()])
    velocities = [rates.evaluate(t, *y.tolist())[: len(rates.velocities)] for t, y in zip(times.tolist(), positions, strict=True)]
    return np.hstack([positions, np.array(velocities)])


def shortest(run: Any) -> float:
    """Return the shortest length of the geometry (m), read off the texts of the file's formulas."""
    variant = run.variant
    values = dict(variant.values)
    functions = {law.name: law for law in variant.functions}
    trees = [f for _, f in variant.points] + [*variant.holds]
    trees += [side for c in variant.constraints if c.is_closure for side in (c.left, c.right)]
    lengths = [node.args[0] for tree in trees for node in tree.walk() if node.op == "@"]
    lengths += [length for group in variant.groups for length in group.lengths]
    sliding = {c.name for c in variant.coordinates if c.unit == "m"}
    sizes = [size for tree in lengths if not sliding & set(tree.names()) for size in _sizes(tree, values, functions, run)]
    sizes = [size for size in sizes if size > 1e-9 * max(sizes)]
    return min(sizes or [abs(g.value) for g in variant.given if g.si == "m" and g.value] or [1.0])


def _sizes(tree: Any, values: dict[str, float], functions: dict[str, Any], run: Any) -> list[float]:
    """Return |L| with the data, and in every row where L follows the motion."""
    moving = [name for name in tree.names() if name not in values and name != "pi"]
    rows = range(len(run.motion.t)) if moving else range(1)
    found = []
    for row in rows:
        at = {**values, "t": float(run.motion.t[row]), **{n: float(run.motion.column(n)[row]) for n in run.motion.names}}
        for name, law in functions.items():  # a function may use those before it
            at[name] = _law(law, at)
        found.append(abs(_value(tree, at)))
    return found


def _law(law: Any, at: dict[str, float]) -> float:
    if law.table:
        nodes, values = zip(*law.table, strict=True)
        return float(np.interp(at[law.of], nodes, values))
    formula = law.formula if law.formula is not None else [f for begin, f in law.pieces if begin <= at["t"]][-1]
    return _value(formula, at)


def _value(tree: Any, at: dict[str, float]) -> float:
    if tree.op in {"number", "name"}:
        return float(tree.name) if tree.op == "number" else {"pi": math.pi, **at}[tree.name]
    args = [_value(arg, at) for arg in tree.args]
    if tree.op == "neg":
        return -args[0]
    if tree.op == "call":
        return abs(args[0]) if tree.name == "abs" else getattr(math, tree.name)(*args)
    first, second = args
    made = {"+": first + second, "-": first - second, "*": first * second}
    return made[tree.op] if tree.op in made else first / second if tree.op == "/" else first**second
