"""The drive as numbers: its values, its integral from t = 0, its breaks and its fastest oscillation.

Enters: the drive of a variant.  Leaves: plain functions of time.
Used by `closure.py`, `chain.py`, the march, checks, `sets.py` and `report/live/page.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np

from coursework.equations.algebra.calculus import derivative, expand
from coursework.equations.algebra.expression import ZERO, Expression, multiply
from coursework.equations.codegen.tabulated import TableLaw
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import TIME, symbol
from coursework.equations.reduction.system import compile_values
from coursework.motion.geometry.drives.enclosures import Enclosure, Laws
from coursework.motion.geometry.drives.quadrature import NODES, POINTS, WANTED, WEIGHTS, Resolution, left_open, resolve
from coursework.system.arrays import Array, Flags, as_columns, distinct
from coursework.variant.record.held import largest_length, velocities_of_points
from coursework.variant.record.variant import MAX_ROWS, Law, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

_PIECES_PER_RUN = 240
_MANY_TURNS = 1e3  # rad; beyond it the sum is made in extended precision
_SAME_END = 1e-12  # relative: ends of the run that differ by less are the same, as row counts round differently
_MOST_CELLS = 1_000_000  # largest number of stretches, over all data sets, that are examined at once
# Cache for each living scene: end of the time span (s) -> its resolution.
_resolved: WeakKeyDictionary[VelocityEquations, dict[float, Resolution]] = WeakKeyDictionary()
# A drive grows beyond bounds at a time if, within `_NEAR` of the run's length, it exceeds `_BEYOND` times its usual size.
_NEAR, _BEYOND = 1e-6, 1e4
# A ripple turns by less than `_RIPPLE` of the whole motion; at most `_MOST_LOOKS` rows and stretches are examined.
_RIPPLE, _MOST_LOOKS = 0.02, 10_000
_OF_STRETCH = np.array([0.1, 0.3, 0.5, 0.7, 0.9])


def breaks(variant: Variant) -> tuple[float, ...]:
    """Return the times (s) at which a piecewise drive or function changes its formula."""
    return tuple(sorted({time for law in variant.laws for time, _ in law.pieces if time > 0}))


def drive_values(equations: VelocityEquations, names: Sequence[str], times: Array) -> Array:
    """Return the named drives at times (*shape) as columns (*shape, len(names)); undefined values are not finite."""
    return values_of_time(equations, [symbol(name) for name in names], times)


def values_of_time(equations: VelocityEquations, wanted: Sequence[Expression], times: Array) -> Array:
    """Return expressions of time alone at times (*shape) as columns (*shape, len(wanted)); undefined values are not finite."""
    _, rows = compile_values(equations, wanted)
    with np.errstate(all="ignore"):
        return as_columns(rows(times, *np.zeros(len(equations.variant.coordinates))), times.shape)


def integrals(equations: VelocityEquations, names: Sequence[str], times: Array) -> Array:
    """Return the integrals of the named drives from 0 to each time: (n, len(names)).

    `times` (n,) grow from 0.  The rule is composite Gauss-Legendre, split at the rows, at breaks, at the nodes of tables over t
    (between them a law is a polynomial) and wherever `resolution` needs shorter stretches.
    """
    if not names or not times[-1] > 0:
        return np.zeros((len(times), len(names)))
    finest = float(times[-1]) / _PIECES_PER_RUN
    inner = _joints(equations)
    edges = np.sort(np.concatenate([[0.0], times, inner[(inner > 0) & (inner < times[-1])]]))
    edges = edges[np.diff(edges, prepend=-1.0) > 0]
    counts = np.maximum(1, np.ceil(np.diff(edges) / finest).astype(int))
    inside = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    fine = np.append(np.repeat(edges[:-1], counts) + inside * np.repeat(np.diff(edges) / counts, counts), edges[-1])
    fine = _split(fine, resolution(equations, float(times[-1])).edges)
    middle, half = (fine[1:] + fine[:-1]) / 2, np.diff(fine) / 2
    at = middle[:, None] + half[:, None] * NODES
    values = drive_values(equations, names, at)
    if not np.all(np.isfinite(values)):
        place = np.argwhere(~np.isfinite(values))[0]
        name, variant = names[place[2]], equations.variant
        told = say("fault.V321", name=name, time=float(at[place[0], place[1]]))
        raise InputError([Fault(told, variant.file, variant.line_of("drive", name))])
    pieces = np.tensordot(values, WEIGHTS, axes=(1, 0)) * half[:, None]
    # After thousands of turns a sum of doubles would lose the last digits.
    kind = np.longdouble if np.abs(pieces).sum() > _MANY_TURNS else np.float64
    total = np.vstack([np.zeros(len(names)), np.cumsum(pieces.astype(kind), axis=0).astype(np.float64)])
    return np.asarray(total[np.searchsorted(fine, times)])


def _split(fine: Array, resolved: Array) -> Array:
    """Return the edges `fine` (s), with those edges of `resolved` added that bound shorter stretches."""
    around = np.clip(np.searchsorted(fine, resolved, side="right") - 1, 0, len(fine) - 2)
    shorter = np.minimum(np.diff(resolved, prepend=-np.inf), np.diff(resolved, append=np.inf)) < np.diff(fine)[around]
    return distinct(fine, resolved[shorter & (resolved < fine[-1])]) if shorter.any() else fine


def resolution(equations: VelocityEquations, end: float = 0.0) -> Resolution:
    """Return the stretches that resolve every drive up to the end of the run, or up to `end` (s) if that is later."""
    kept, own = _resolved.setdefault(equations, {}), equations.variant.time.end
    last = end if end > own * (1 + _SAME_END) else own
    if last not in kept:
        kept[last] = _resolution(equations, last)
    return kept[last]


def _resolution(equations: VelocityEquations, end: float) -> Resolution:
    laws, inner = _laws(equations, equations.variant.values), _joints(equations)
    moving = _moving(equations, laws)
    if (forces := equations.variant.forces) is not None and forces.motor is not None:  # then time-dependent forces count
        parts = [Law(f"acting {n}", one) for n, one in enumerate(forces.parts({"t", "pi", *laws.values, *moving}))]
        laws = replace(laws, laws=dict(laws.laws) | {law.name: law for law in parts})
        moving += [law.name for law in parts if _is_of_time(law, laws)]
    edges = distinct(np.array([0.0, end]), inner[(inner > 0) & (inner < end)])
    if not moving or end <= 0:
        return Resolution(edges, 0.0, True)
    units = _units(equations.variant)
    sizes = [units[name] if name in units else _least(laws.over(name, edges[:1], edges[-1:]), end) for name in moving]
    return resolve(lambda begin, end: [laws.over(name, begin, end) for name in moving], edges, sizes)


def _units(variant: Variant) -> dict[str, float]:
    """Return what counts as 1 of the integral of each drive: 1 rad, or the size of the mechanism (m)."""
    straight = {one.rate for one in variant.coordinates if one.unit == "m"} | velocities_of_points(variant).keys()
    return {law.name: largest_length(variant) if law.name in straight else 1.0 for law in variant.drive}


def _least(law: Enclosure, end: float) -> float:
    """Return what counts as 1 of the integral up to `end` (s) of a law of any unit: 1, or the most it can be if that is less."""
    most = float(law.size[0]) * end
    return most if 0 < most < 1 else 1.0


def resolved(
    equations: VelocityEquations, data: Mapping[str, Array], times: Array, points: int = POINTS, wanted: float = WANTED
) -> Flags:
    """Return for which data sets the quadrature rule sees all that the drives do between `times` (k,).

    `data` holds one column (n,) per name.  `wanted` is the largest error (rad or share of the largest length) allowed for a rule
    of `points` between two times.
    """
    variant = equations.variant
    units = _units(variant)
    seen = np.ones(max(map(len, data.values()), default=1), dtype=bool)
    moving = _moving(equations, _laws(equations, variant.values))
    allowed = {name: wanted * units.get(name, 1.0) for name in moving}
    inner = _joints(equations)
    edges = distinct(times, inner[(inner > times[0]) & (inner < times[-1])])
    for first in range(0, len(seen) if moving else 0, some := max(1, _MOST_CELLS // len(edges))):
        part = slice(first, first + some)
        columns = {name: column[part, None] if np.ptp(column[part]) else float(column[first]) for name, column in data.items()}
        laws = _laws(equations, columns)
        for name, most in allowed.items():
            open_ = left_open(laws.over(name, edges[:-1], edges[1:]), np.diff(edges) / 2, points)
            seen[part] &= np.all(open_ <= most, axis=-1)
    return seen


def _laws(equations: VelocityEquations, values: Mapping[str, float | Array]) -> Laws:
    variant = equations.variant
    return Laws(values, {law.name: law for law in variant.laws}, equations.tables)


def _moving(equations: VelocityEquations, laws: Laws) -> list[str]:
    """Return the drives and the functions of time alone whose values change with time."""
    drives = {law.name for law in equations.variant.drive}
    return [name for name, law in laws.laws.items() if (name in drives or law.of in {"", "t"}) and _is_of_time(law, laws)]


def _is_of_time(law: Law, laws: Laws) -> bool:
    """Return whether a law changes with time and depends on nothing else."""
    if law.table:
        return law.of == "t"
    used = {name for formula in law.formulas for name in formula.names()}
    inner = [laws.laws[name] for name in used & laws.laws.keys()]
    constant = {*laws.values, "pi", "t", *laws.laws}
    moves = "t" in used or len(law.pieces) > 1 or any(_is_of_time(one, laws) for one in inner)
    return moves and used <= constant


def _joints(equations: VelocityEquations) -> Array:
    """Return the times (s) between which every law is a single formula or polynomial."""
    return np.concatenate([breaks(equations.variant), *(law.nodes for law in _over_time(equations))])


def _over_time(equations: VelocityEquations) -> list[TableLaw]:
    """Return the laws that are tabulated over t."""
    variant = equations.variant
    return [equations.tables[law.name] for law in variant.laws if law.of == "t"]


def refuse_short_tables(equations: VelocityEquations) -> None:
    """Raise `InputError` for each law whose table over t does not cover the whole run."""
    variant, faults = equations.variant, []
    for law in _over_time(equations):
        if not all(law.covers(time) for time in (0.0, variant.time.end)):
            path = variant.path_of(law.name)
            told = say("fault.V322", first=law.first, last=law.last, end=variant.time.end)
            faults.append(Fault(told, variant.file, variant.line_of(*path), 0, ".".join(path)))
    if faults:
        raise InputError(faults)


def argument_slopes(equations: VelocityEquations) -> list[Expression]:
    """Return d argument/dt (rad/s) of every sine and cosine in the drives, except where it is zero."""
    definitions = [equations.symbols.definitions[symbol(law.name)] for law in equations.variant.drive]
    slopes = (
        derivative(one.args[0], TIME) for definition in definitions for one in definition.walk() if one.op in {"sin", "cos"}
    )
    return [slope for slope in slopes if slope is not ZERO]


def refuse_aliasing(equations: VelocityEquations, step: float, frequency: float) -> None:
    """Raise `InputError` if the step has under two rows a period of an oscillation (`frequency`, rad/s) that shapes the motion.

    A ripple on a larger motion is allowed: it changes the rows little, and they are judged as usual.
    """
    if frequency * step >= np.pi * (1 - 1e-12) and not _is_ripple(equations, step):
        variant = equations.variant
        own = variant.time.own_step in {None, step}
        line = variant.nearest_line("time", "step") if own else 0  # a step given on the command line has no line in the file
        most = float(np.pi / 10 / frequency)
        advice = (
            say("hint.step_at_most", most=most) if variant.time.end / most <= MAX_ROWS else say("hint.too_fast", most=MAX_ROWS)
        )
        told = say("fault.C021", step=step, turned=frequency * step, advice=advice)
        raise InputError([Fault(told, variant.file, line)])


def _is_ripple(equations: VelocityEquations, step: float) -> bool:
    """Return whether what a drive may turn back and forth between two rows is small compared with its motion in the run.

    An oscillation with less than two rows a period turns at most its height times step/pi.
    """
    end, names = equations.variant.time.end, [law.name for law in equations.variant.drive]
    count = min(round(end / step), _MOST_LOOKS)
    try:
        turned = np.ptp(integrals(equations, names, np.linspace(0.0, end, count + 1)), axis=0)
    except InputError:  # an undefined value is reported where the motion is followed
        return False
    edges = resolution(equations).edges
    edges = edges[:: len(edges) // _MOST_LOOKS + 1]
    looks = edges[:-1, None] + np.diff(edges)[:, None] * _OF_STRETCH  # one look a stretch could always meet the same phase
    height = np.ptp(drive_values(equations, names, looks.ravel()), axis=0)
    return bool(np.all(height * step / np.pi <= _RIPPLE * turned))


def refuse_endless(equations: VelocityEquations, time: float, *, goes_round: bool = False) -> None:
    """Raise `InputError` if a drive has no finite value near `time` (s), or turns a crank by whole turns in one step.

    `goes_round` allows the latter: the crank can turn right round, however fast.
    """
    variant = equations.variant
    names = [law.name for law in variant.drive]
    if not names:
        return
    near = _NEAR * variant.time.end
    times = np.concatenate([np.linspace(0.0, time / 2, 33), [time - near, time, time + near]])
    values = np.abs(drive_values(equations, names, times))
    usual, there = np.max(values[:-3], axis=0), np.max(values[-3:], axis=0)
    faults = []
    angles = {coordinate.rate for coordinate in variant.coordinates if coordinate.unit == "rad"}
    for name, before, now in zip(names, usual, there, strict=True):
        told = None
        if not now <= _BEYOND * before:  # also true for nan; false for a drive that is 0 throughout
            told = say("fault.V323", name=name, time=time)
        elif not goes_round and name in angles and now * variant.time.step > 2 * np.pi:
            told = say("fault.V324", name=name, turned=float(now * variant.time.step), most=float(0.1 / now))
        if told is not None:
            faults.append(Fault(told, variant.file, variant.line_of("drive", name)))
    if faults:
        raise InputError(faults)


def frequencies(equations: VelocityEquations) -> tuple[float, ...]:
    """Return the frequencies |d argument/dt| (rad/s) of the sines that make up the drives, slowest first.

    The result is empty unless every drive is zero or a sum of sines and cosines of t, each times a constant.
    """
    slopes = equations.once("slopes of sums", lambda: _slopes_of_sums(equations))
    values = compile_values(equations, slopes)[0](0.0, *np.zeros(len(equations.variant.coordinates))) if slopes else ()
    return tuple(sorted({abs(float(value)) for value in values}))


def _slopes_of_sums(equations: VelocityEquations) -> list[Expression]:
    """Return d argument/dt of the sines that make up the drives; empty if one of the drives is not such a sum."""
    laws = {symbol(law.name) for law in equations.variant.laws}
    slopes = set()
    for law in equations.variant.drive:
        definition = equations.symbols.definitions[symbol(law.name)]
        if definition.free_symbols & laws:
            return []
        for term in expand(definition).terms:
            rest = multiply(*[factor for factor in term.factors if factor.has(TIME)])
            if term is ZERO:
                continue
            if rest.op not in {"sin", "cos"} or (slope := derivative(rest.args[0], TIME)).has(TIME) or slope is ZERO:
                return []
            slopes.add(slope)
    return sorted(slopes)
