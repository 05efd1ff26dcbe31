"""The times and positions at which written equations, and rates of links, are compared with the geometry.

Enters: velocity equations and their closure.  Leaves: times and positions.  Used by `agreement.py`, `turning.py`,
`misfits.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from functools import partial
from itertools import pairwise

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import TIME
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.closure import WAITING, Closure
from coursework.motion.geometry.drives.drive import breaks, drive_values
from coursework.motion.schemes import PRECISE
from coursework.system.arrays import Array
from coursework.variant.record.variant import Variant
from coursework.words.errors import InputError

# Times at which drives are looked at, and the share of its largest value below which a drive is at rest.
_LOOKS, _AT_REST = 200, 1e-4
_STIRRED = 1e-2  # rad or m from one configuration to the next
# The same where only equations close a loop.  A hidden sign shows in the first power, a lost cosine in the second, sin x = x in
# the third; how far each leads astray on the way, so that right equations seem wrong too, shows in the next power only.
_REACHES = (3e-5, 2e-3, _STIRRED)
# Share of the terms of an equation: above the ranks' tolerance, so that nobody stops before what ranks cannot see yet.
_FITS = 1e-6
_HALVED = 40  # times, until a step is short enough: from a run to less than a billionth of it


def looked_at(equations: VelocityEquations, closure: Closure) -> tuple[Array, Array]:
    """Return times and closed positions at which velocities are compared; positions of no time only if none depends on it.

    A velocity that is zero hides its sign: times at which each drive moves are among them.  At a position all velocities are
    possible, so those of another time will do where nothing else depends on time; else the motion is followed to that time.
    """
    times, positions = closure.configurations
    depends = depends_on_time(equations)
    if not closure.complete and closure.loose:  # a loop without a position equation is closed at the start alone
        times, positions = times[:1], positions[:1]
        if depends:
            then, there = _moved(equations, positions[0], times[0], goes_on=True)
            return np.concatenate([times, then]), np.concatenate([positions, there])
        times = np.concatenate([times, with_drives_on(equations, times)])
        positions = np.concatenate([positions, _moved(equations, positions[0], times[-1], goes_on=False)[1]])
        return np.repeat(times, len(positions)), np.tile(positions, (len(times), 1))
    if not depends and len(closure.driven) + sum(map(bool, closure.drives)) > 1:
        times, positions = (np.concatenate(pair) for pair in zip((times, positions), _stirred(closure), strict=True))
    later = with_drives_on(equations, times)
    if not len(later):
        return times, positions
    if depends:
        then, there = _followed(closure, later)
    else:
        then, there = np.repeat(later, len(times)), np.tile(positions, (len(later), 1))
    return np.concatenate([times, then]), np.concatenate([positions, there])


def _moved(equations: VelocityEquations, start: Array, time: float, goes_on: bool) -> tuple[Array, Array]:
    """Return times (k,) and positions (k, m) ever further beyond the start by all equations together.

    At a start of zero a sine hides the sign before it.  Equations that have no common solution somewhere lead nowhere, and are
    told there.  Time stands still unless it `goes_on`; then it stays in the run, and before a formula changes.
    """
    variant = equations.variant
    laws = [law.name for law in variant.drive]
    system = compile_system(equations, [*equations.equations, *equations.from_closure, *equations.bound])

    def solved(later: float, q: Array) -> tuple[Array, bool]:
        at = np.array([later if goes_on else time])
        (matrix,), (right,), _rest = system.matrices(at, q[None])
        values = np.linalg.pinv(matrix) @ right
        terms = np.abs(matrix) @ np.abs(values) + np.abs(right)
        found = dict(zip(equations.unknowns, values, strict=True))
        found |= dict(zip(laws, drive_values(equations, laws, at)[0], strict=True))
        rates = np.array([found[one.rate] for one in variant.coordinates])
        return rates, bool(np.all(np.abs(matrix @ values - right) <= _FITS * terms))

    now, q, seen = time, start, list[tuple[float, Array]]()
    with suppress(np.linalg.LinAlgError, ArithmeticError, ValueError, KeyError):
        for reach in _REACHES:
            first, fits = solved(now, q)
            if goes_on and fits and not first.any():
                now = _at_last(now, variant, partial(solved, q=q))
                first, fits = solved(now, q)
            ends = [at for at in (*breaks(variant), variant.time.end) if at > now]
            fastest = float(np.max(np.abs(first)))
            step = reach / fastest if fastest else 0.0
            if goes_on:  # a drive that starts from rest has no speed yet
                step = min([step or np.inf, variant.time.end / _LOOKS, *((at - now) / 2 for at in ends)])
            for part in step / 2.0 ** np.arange(_HALVED if fits and step else 0):
                there = PRECISE.step(lambda later, at: solved(later, at)[0], now, q, part, first)
                if np.max(np.abs(there - q)) <= 2 * reach:
                    now, q = now + float(part), there
                    seen.append((now, q))
                    break
    return np.array([at for at, _ in seen]), np.array([there for _, there in seen]).reshape(-1, len(start))


def _at_last(now: float, variant: Variant, solved: Callable[[float], tuple[Array, bool]]) -> float:
    """Return the last time known before something moves, or a break at which it does."""
    moments = {*np.linspace(0.0, variant.time.end, _LOOKS + 1).tolist(), *breaks(variant)}
    ahead = sorted(float(at) for at in moments if now < at < variant.time.end)
    for before, at in pairwise([now, *ahead]):
        if solved(at)[0].any():
            return at if at in breaks(variant) else before
    return now


def _stirred(closure: Closure) -> tuple[Array, Array]:
    """Return the closure's configurations with drives that wait moved a little too: they close, but at no time of the run.

    Where such a drive leaves an angle at zero, its sine would hide the sign before it.
    """
    times, positions = closure.configurations
    kept, known = (part.copy() for part in closure.targets(times))
    for values, is_driven in (
        (kept, np.array([bool(name) for name in closure.drives], dtype=bool)),
        (known, np.ones(len(closure.driven), bool)),
    ):
        waits = is_driven & (np.ptp(values, axis=0) <= WAITING * closure.scale)
        values[:, waits] += _STIRRED * np.arange(len(times))[:, None]
    guess = positions.copy()
    guess[:, list(closure.driven)] = known
    with suppress(np.linalg.LinAlgError, ArithmeticError, ValueError):
        q, closed = closure.newton_rows(times, guess, kept)
        return times[closed], q[closed]
    return times[:0], positions[:0]


def depends_on_time(equations: VelocityEquations) -> bool:
    """Return whether written equations or positions depend on time otherwise than by a drive."""
    parts = [part for one in equations.equations if one.written for part in one.parts]
    timed = any(
        law.pieces or law.of == "t" or any("t" in one.names() for one in law.formulas) for law in equations.variant.functions
    )
    return timed or any(TIME in part.free_symbols for part in (*parts, *(one.expression for one in equations.positions)))


def with_drives_on(equations: VelocityEquations, times: Array) -> Array:
    """Return times of the run at which drives move that are at rest at all of `times`."""
    variant, laws = equations.variant, [law.name for law in equations.variant.drive]
    if not laws:
        return np.zeros(0)
    changes = np.array([0.0, *(time for time in breaks(variant) if time < variant.time.end), variant.time.end])
    looked = np.concatenate([np.linspace(0.0, variant.time.end, _LOOKS), (changes[1:] + changes[:-1]) / 2])
    sizes, here = (np.abs(np.nan_to_num(drive_values(equations, laws, at), posinf=0, neginf=0)) for at in (looked, times))
    most = np.max(sizes, axis=0)
    resting = (np.max(here, axis=0) <= _AT_REST * most) & (most > 0)
    return np.array(sorted({float(looked[place]) for place in np.argmax(sizes[:, resting], axis=0)}))


def _followed(closure: Closure, times: Array) -> tuple[Array, Array]:
    """Return those of some times (n,) to which Newton's method follows the motion in small steps, and the positions there."""
    grid = np.unique(np.concatenate([np.linspace(0.0, closure.equations.variant.time.end, _LOOKS), times]))
    try:
        kept, known = closure.targets(grid)
    except InputError:  # a drive without a value later on is told where it is followed
        return times[:0], closure.start[None][:0]
    q, found = closure.start, {}
    for time, target, driven in zip(grid.tolist(), kept, known, strict=True):
        guess = q.copy()
        guess[list(closure.driven)] = driven
        near = closure.newton(time, guess, target)
        if near is None:
            break
        q = found[time] = near
    reached = [time for time in times.tolist() if time in found]
    return np.array(reached), np.array([found[time] for time in reached]).reshape(len(reached), len(closure.start))
