"""DRIFT: how far the position equations of the table's rows are open, as a share of the shortest length.

DRIFT-PER-PERIOD: what a scheme loses period after period; a table that repeats itself need not be the true motion.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from coursework.equations.reduction.system import compile_values
from coursework.motion.geometry.closure import Closure
from coursework.motion.geometry.gaps import gaps
from coursework.results.checks.evidence import LIMIT, Evidence
from coursework.results.checks.result import Finding, Verdict, percent, skipped
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula, evaluate, spelled
from coursework.variant.record.held import POWERS, followed
from coursework.variant.record.places import lengths_of
from coursework.words.sentences import joined

# A length below this share of the longest counts as zero: it belongs to a point that coincides with another.
_NO_LENGTH = 1e-9
# An equation open by less than this share of the shortest length is open by round-off only.
ROUND_OFF = 1e-12
# Share of a step in which a velocity shows whether it keeps an equation: then it opens less than this share of it in a step.
_NUDGE, _KEPT = 1e-6, 1e-4


def drift(evidence: Evidence) -> Finding:
    """The position equations stay satisfied to 5 % of the shortest length."""
    closure = evidence.closure
    assert closure is not None
    motion = evidence.motion
    residual = gaps(closure, motion.t, motion.coordinates, closure.targets(motion.t)[0])
    shortest = evidence.once("shortest length", lambda: shortest_length(evidence))
    angles = np.array([position.unit == "rad" for position in evidence.equations.positions])
    shares = np.abs(residual) / np.where(angles, 1.0, shortest)
    row, equation = (int(i) for i in np.unravel_index(int(np.argmax(shares)), shares.shape))
    value, name = float(shares[row, equation]), closure.names[equation]
    called = [
        evidence.say("check.DRIFT.as_length", name=one.told) if one.unit in POWERS.values() else one.told
        for one in evidence.equations.positions
    ]
    unit = "rad" if angles[equation] else "m"
    lines = tuple(
        (evidence.say("check.largest", name=name), float(size), "rad" if angle else "m")
        for name, size, angle in zip(called, np.max(np.abs(residual), axis=0), angles, strict=True)
    )
    size = float(abs(residual[row, equation]))
    if (jump := evidence.once("opened", lambda: _jump(evidence, closure, np.where(angles, 1.0, shortest)))) is not None:
        at, which, kind = jump
        told = {"name": called[which], "time": float(motion.t[at])}
        told |= {"row": at, "next": at + 1} if kind == "jump" else {"row": at + 1}
        sentence = evidence.say(f"check.DRIFT.{kind}", **told)
        return Finding(
            "FAIL", sentence, value, LIMIT, evidence.say("unit.of_the_shortest"), closure.names[which], at + 1, rows=lines
        )
    share = percent(value, LIMIT)
    found = {"name": called[equation], "row": row + 1, "size": size, "unit": unit, "share": share, "shortest": shortest}
    verdict: Verdict = "PASS" if value <= LIMIT else "COARSE" if float(np.max(shares[0])) <= LIMIT else "FAIL"
    if value < ROUND_OFF:
        sentence = evidence.say("check.DRIFT.same")
    else:
        kind, point = verdict.lower(), ""
        if verdict == "COARSE":
            kind, point = ("angle", "") if angles[equation] else _leaves(evidence, equation)
        sentence = evidence.say(f"check.DRIFT.{kind}", **found, point=point)
    shown = evidence.say("unit.relative" if angles[equation] else "unit.of_the_shortest")
    return Finding(verdict, sentence, value, LIMIT, shown, name, row + 1, rows=lines)


def _leaves(evidence: Evidence, equation: int) -> tuple[str, str]:
    """Return with which sentence an open position equation is told, and the point that leaves its path, guide or pivot."""
    variant, positions = evidence.variant, evidence.equations.positions
    driven = followed(variant).get(positions[equation].target)
    if driven:
        return "coarse_driven", driven[0]
    held = variant.holds[place] if (place := equation - len(positions) + len(variant.holds)) >= 0 else None
    names = set(held.names()) if held else set()
    points = names.intersection(name for name, _ in variant.points)
    if len(points) != 1 or names.intersection(one.name for one in variant.coordinates):
        return "coarse", ""  # with a coordinate beside the point it is a length, a loop or a wheel that rolls
    (point,) = points
    return "coarse_pivot" if point in variant.frame.hinges else "coarse_guided", point


def _jump(evidence: Evidence, closure: Closure, scales: Array) -> tuple[int, int, str] | None:
    """Return which equation the exact motion leaves open after a closed start: the row (from 0), the equation, how; else None.

    "jump": open from this row on, while the velocities of the row before it keep the equation.  "opened": they do not keep it.
    """
    exact = evidence.exact
    if not len(exact.t):
        return None
    residual = gaps(closure, exact.t, exact.coordinates, closure.targets(exact.t)[0])
    open_rows = np.abs(residual) / scales > LIMIT
    if open_rows[0].any() or not open_rows.any():
        return None
    row = int(np.argmax(open_rows.any(axis=1)))
    which, before = int(np.argmax(open_rows[row])), row - 1
    size, nudge = exact.coordinates.shape[1], _NUDGE * exact.step
    later = exact.coordinates[before] + nudge * exact.velocities[before, :size]
    times, moved = np.append(exact.t[:row], exact.t[before] + nudge), np.vstack([exact.coordinates[:row], later])
    after = gaps(closure, times, moved, closure.targets(times)[0])[-1, which]
    opens = abs(after - residual[before, which]) / (_NUDGE * scales[which])
    return (before, which, "opened") if opens > _KEPT else (row, which, "jump")


def shortest_length(evidence: Evidence) -> float:
    """Return the shortest length (m) of a vector or group, over all rows if it changes; without any, of data that are factors."""
    variant, motion = evidence.variant, evidence.motion
    trees = {*lengths_of(variant)}
    sliding = {coordinate.name for coordinate in variant.coordinates if coordinate.unit == "m"}
    fixed = {*variant.values, "pi"}
    sizes = [abs(evaluate(tree, variant.values)) for tree in trees if set(tree.names()) <= fixed]
    changing = [tree for tree in trees if not (set(tree.names()) <= fixed or sliding & set(tree.names()))]
    if changing:
        scalars = [evidence.equations.symbols.scalar(tree) for tree in sorted(changing, key=spelled)]
        values = compile_values(evidence.equations, scalars)[1](motion.t, *motion.coordinates.T)
        sizes += [float(np.min(np.abs(value))) for value in values]
    data = {given.name: abs(given.value) for given in variant.given if given.si == "m"}
    turned = {name for path, formula in variant.formulas() if path[-1] != "equation" for name in _factors(formula, fixed)}
    return _shortest(sizes) or _shortest([data[name] for name in turned & {*data}]) or _shortest([*data.values()]) or 1.0


def _factors(formula: Formula, fixed: set[str]) -> Iterator[str]:
    """Yield the names that multiply something that moves: links, where an offset stands alone."""
    for node in formula.walk():
        if node.op == "*":
            for arm, other in (node.args, node.args[::-1]):
                if not fixed.issuperset(other.names()):
                    yield from arm.names()


def _shortest(sizes: list[float]) -> float:
    longest = max(sizes, default=0.0)
    return min((size for size in sizes if size > _NO_LENGTH * longest), default=0.0)


# The table repeats itself if the last period changes it by less than this share of its error.
REPEATS = 0.01
_SHOWN = (1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)


def per_period(evidence: Evidence) -> Finding:
    """After many periods every coordinate is still where the true motion is."""
    motion, period = evidence.motion, evidence.period
    whole = int((motion.t[-1] + motion.step / 2) / period)
    if whole < 2 or motion.stop is not None:
        return skipped(evidence.say("check.DRIFT-PER-PERIOD.short"))
    if evidence.compared < len(motion.t):
        return skipped(evidence.say("check.unknown"))
    names = motion.coordinate_names
    listed = [k for k in _SHOWN if k < whole - 1] + [whole - 1, whole]
    ends = np.minimum(np.rint(np.array(listed) * period / motion.step).astype(int), len(motion.t) - 1)
    gaps = evidence.errors[ends][:, [evidence.names.index(name) for name in names]]
    worst = int(np.argmax(np.abs(gaps[-1])))
    name = names[worst]
    unit, scale = evidence.unit(name), evidence.scale[name]
    value, last = float(abs(gaps[-1, worst])), float(gaps[-1, worst] * scale)
    rows = tuple(
        (evidence.say("check.DRIFT-PER-PERIOD.after", number=k, name=name), float(gap * scale), unit)
        for k, gap in zip(listed, gaps[:, worst].tolist(), strict=True)
    )
    found = {"name": name, "unit": unit, "first": rows[0][1], "last": last, "periods": whole, "each": last / whole}
    told = [evidence.say("check.DRIFT-PER-PERIOD.found", **found)]
    scales = np.array([evidence.scale[name] for name in names])
    if value > LIMIT and float(np.max(np.abs(gaps[-1] - gaps[-2]) * scales)) < REPEATS * abs(last):
        told.append(evidence.say("check.DRIFT-PER-PERIOD.repeats"))
    verdict: Verdict = "PASS" if value <= LIMIT else "COARSE"
    return Finding(verdict, joined(told), value, LIMIT, evidence.say("unit.of_the_scale"), name, int(ends[-1]) + 1, rows=rows)
