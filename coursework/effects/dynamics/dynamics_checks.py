"""The checks of a motion under forces: its energy, its distance from the exact motion, whether its step is stable.

Enters: `Evidence` of a run, and a way to that of a finer one.  Leaves: a `Finding` of each kind.
Used by `scene/motor_scene.py`.  Words stand under [check.CODE].
"""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import replace

import numpy as np

from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.effects.friction.held import Held
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import Scheme
from coursework.results.checks.close_to_motion.rows import ROWS_A_PERIOD
from coursework.results.checks.computed_right.beginning import start_of
from coursework.results.checks.evidence import STILL, scales_of, worst
from coursework.results.checks.result import Check, Finding, Verdict, percent, skipped
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.held import largest_length
from coursework.variant.record.variant import MAX_ROWS, Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

LIMIT = 0.05
_TRIALS, _MOST_TRIED = 4, 5000  # number of steps that are tried, each half the one before, and of rows of such a run
_TELLING = 0.5  # with a larger share the error no longer follows the order of the scheme
_TINY = 1e-6  # relative change of a rate or coordinate for difference quotients
_ROUNDED = 1e-9  # share of the fastest velocity of its unit: a slower one is at rest but for round-off
_ROUND_OFF = 1e-12  # share of the energy: a smaller exchange counts as none
_LOOKED_AT = 40  # number of rows examined
_NEAR = 0.3  # of a determinant: nearer to a limit position of the free coordinates, inertia alone makes every slope steep
# h w from which a swing grows without bound: Runge-Kutta 4 keeps it up to there, and so does the semi-implicit scheme; others of
# order one and two amplify every swing, and from there on more than twofold a step.
_RK4_SWINGS, _SWINGS = 2.8, 2.0


@frozen
class Evidence:
    """The input of the checks: both analyses, the equations of motion, the scheme (None for exact rows), the step (s).

    `closure` has the start values as the file writes them.
    """

    own: ForceAnalysis
    exact: ForceAnalysis
    dynamics: EquationsOfMotion
    scheme: Scheme | None
    step: float
    closure: Closure | None = None


def check_dynamics(e: Evidence, finer: Callable[[int], Evidence]) -> tuple[Finding, ...]:
    """Return the findings of all checks; `finer` gives the evidence of a run with a step so many times shorter."""
    return _advised(e, _judged(e), lambda parts: not any(map(_is_coarse, _judged(finer(parts)))))


def _is_coarse(finding: Finding) -> bool:
    return finding.verdict == "COARSE" and finding.code != "START"  # no step gives a start more digits


def _judged(e: Evidence) -> list[Finding]:
    found = [check.finding(e) for check in CHECKS]
    stop, notes = e.exact.rows.motion.stop, [*e.own.rows.motion.notes]
    if stop is not None and e.own.rows.count > e.exact.rows.count:  # the rows go on where the motion does not
        notes.append(stop.cause)
    if notes:
        found[-1] = replace(found[-1], headline=joined(notes))
    # A start alone shows no table to be right.
    return [one for one in found if one.code != "START" or one.verdict in {"FAIL", "COARSE"}]


def _advised(e: Evidence, findings: list[Finding], suffices: Callable[[int], bool]) -> tuple[Finding, ...]:
    """Return the findings, with advice on the step in the worst of them; if STABLE is coarse, it gives its own advice."""
    coarse = {one.value or 0.0: place for place, one in enumerate(findings) if _is_coarse(one)}
    if coarse and e.scheme is not None and findings[-1].verdict != "COARSE":
        share = max(coarse)
        found = findings[coarse[share]]
        findings[coarse[share]] = replace(found, sentence=joined([found.sentence, _step_for(share, e, suffices)]))
    return tuple(findings)


def _step_for(share: float, e: Evidence, suffices: Callable[[int], bool]) -> Sentence:
    """Return the step that makes an error of this share small.

    A higher order than one is lost where a force breaks between two rows, so there a step is run before it is advised.
    """
    assert e.scheme is not None
    parts, steps = math.ceil((share / (LIMIT / 2)) ** (1 / e.scheme.order)), e.exact.rows.count - 1
    if share <= _TELLING and e.scheme.order == 1 and parts * steps <= MAX_ROWS:
        return say("check.dynamics.step", step=e.step / parts)
    if share <= _TELLING and e.scheme.order > 1:
        for more in range(_TRIALS):
            if (tried := parts * 2**more) * steps <= _MOST_TRIED and suffices(tried):
                return say("check.dynamics.tried", step=e.step / tried)
    return say("check.dynamics.no_step")


def remainder(found: ForceAnalysis) -> tuple[Array, float]:
    """Return the unexplained energy (n,) J, which nothing gave to the motion, and the energy that was exchanged (J).

    The rows end before one that friction locks, because the work of friction is unknown there.
    """
    energy = found.energy
    power = energy.drive + energy.loads + energy.friction + energy.dampers
    count = int(np.argmin(np.append(np.isfinite(power), False)))
    if not count:
        return np.zeros(0), 0.0
    power, t = power[:count], found.rows.motion.t[:count]
    work = np.concatenate([[0.0], np.cumsum(_areas(power, t))])
    kinetic, potential = energy.kinetic[:count], energy.potential[:count]
    total = kinetic + potential
    exchanged = max(float(np.ptp(kinetic)), float(np.abs(np.diff(work)).sum()), float(np.ptp(potential)))
    return total - total[0] - work, exchanged


def _areas(values: Array, t: Array) -> Array:
    """Return the integral over each interval (n - 1,), by the cubic through four neighbours if there are four."""
    h = np.diff(t)
    if len(values) < 4:
        return np.asarray(h * (values[1:] + values[:-1]) / 2)
    inner = (13 * (values[1:-2] + values[2:-1]) - values[:-3] - values[3:]) / 24
    first = (9 * values[0] + 19 * values[1] - 5 * values[2] + values[3]) / 24
    last = (9 * values[-1] + 19 * values[-2] - 5 * values[-3] + values[-4]) / 24
    return np.asarray(h * np.concatenate([[first], inner, [last]]))


def _energy(e: Evidence) -> Finding:
    (left, exchanged), (unseen, given) = remainder(e.own), remainder(e.exact)
    if len(left) < 2:
        return skipped(say("check.ENERGY.open", row=len(left) + 1) if e.own.rows.count > len(left) else say("check.no_row"))
    moving, stored = (float(np.abs(energy).max()) for energy in (e.exact.energy.kinetic, e.exact.energy.potential))
    if max(exchanged, given) <= _ROUND_OFF * (moving + stored):
        return skipped(say("check.ENERGY.rest" if moving <= _ROUND_OFF * stored else "check.forces.none"))
    row = int(np.argmax(np.abs(left)))
    if given <= _ROUND_OFF * (moving + stored) < moving:  # nothing works, so what the motion has must stay
        share = float(abs(left[row]) / moving)
        told = {"energy": moving, "off": float(left[row]), "share": percent(share), "row": row + 1}
        return _graded("ENERGY", "free", share, row, **told)
    if np.abs(unseen).max(initial=0.0) > LIMIT * given:  # even the exact rows do not show the work
        return skipped(say("check.POWER.coarse", row=int(np.argmax(np.abs(unseen))) + 1))
    share = float(abs(left[row]) / exchanged) if exchanged else 0.0
    key = "pass" if share <= LIMIT else "coarse" if left[row] > 0 else "lost"
    energy = float(left[row] if key != "lost" else -left[row])
    return _graded("ENERGY", key, share, row, energy=energy, share=percent(share), row=row + 1, exchanged=exchanged)


def _graded(code: str, key: str, share: float, row: int, column: str | None = None, /, **told: object) -> Finding:
    """Return the finding for a share."""
    verdict: Verdict = "PASS" if share <= LIMIT else "COARSE"
    return Finding(verdict, say(f"check.{code}.{key}", **told), share, LIMIT, say("unit.relative"), column, row + 1)


def _accuracy(e: Evidence) -> Finding:
    if e.scheme is None:
        return skipped(say("check.STABLE.skip"))
    count = min(e.own.rows.count, e.exact.rows.count)
    if count < 2:
        return skipped(say("check.unknown" if e.own.rows.count > count else "check.no_row"))
    own, true = e.own.rows.motion, e.exact.rows.motion
    variant = e.own.equations.variant
    scales = _scales(true, variant, count)
    off = np.abs(own.rows[:count] - true.rows[:count])
    row, place = worst(off / scales)
    name, share = own.names[place], float(off[row, place] / scales[place])
    if share <= LIMIT and count < e.own.rows.count:
        return skipped(say("check.unknown"))
    told = {"name": name, "row": row + 1, "off": float(off[row, place]), "unit": variant.unit_of(name)}
    key = "pass" if share <= LIMIT else "coarse"
    return _graded("MOTION", key, share, row, name, **told, share=percent(share), scale=float(scales[place]))


def _scales(true: Motion, variant: Variant, count: int) -> Array:
    """Return the scale of each column: the range of a coordinate (of an angle at most a turn), the largest size of a velocity.

    A range is at least what the steps of one period may turn, because a shorter run does not show the whole range; a velocity
    that only rounds is measured by the fastest of its unit.
    """
    units = [variant.unit_of(name) for name in true.coordinate_names]
    sizes = np.abs(true.velocities[:count]).max(axis=0)
    ranges = np.maximum(np.ptp(true.coordinates[:count], axis=0), ROWS_A_PERIOD * true.step * sizes[: len(units)])
    spreads = np.minimum(ranges, np.where(np.array(units) == "rad", 2 * np.pi, np.inf)).tolist()
    still = [STILL * (1.0 if unit == "rad" else largest_length(variant)) for unit in units]
    rated = np.array([variant.unit_of(name) for name in true.velocity_names])
    fastest = np.array([sizes[rated == unit].max() for unit in rated])
    rates = np.where(sizes > _ROUNDED * fastest, sizes, np.where(fastest > 0, fastest, 1.0))
    return np.array([*scales_of(spreads, [0.0] * len(units), units, still), *rates])


def stiffness(e: Evidence) -> tuple[float, float]:
    """Return the largest rates (1/s) at which deviations decay and swing: from -da/dv and the root of -da/dq."""
    motion, dynamics = e.exact.rows.motion, e.dynamics
    motor = e.exact.equations.variant.forces
    assert motor is not None and motor.motor is not None
    damped, swinging = 0.0, 0.0
    for row in range(0, len(motion.t), max(1, len(motion.t) // _LOOKED_AT)):
        if motion.stop is not None and np.abs(motion.scaled[row]).min(initial=1.0) < _NEAR:
            continue
        t, q = float(motion.t[row]), motion.coordinates[row].tolist()
        v = [float(motion.column(rate)[row]) for rate in motor.motor.rates]
        try:
            with dynamics.rubbing.sliding_as(t, *q, *v) if dynamics.rubbing is not None else nullcontext():
                by_rates, by_places = _slopes(dynamics, t, q, v)
        except Held:  # it locks there
            continue
        damped = max(damped, float(-np.linalg.eigvals(by_rates).real.min()))
        swinging = max(swinging, float(-np.linalg.eigvals(by_places).real.min()))
    return damped, math.sqrt(swinging)


def _slopes(dynamics: EquationsOfMotion, t: float, q: list[float], v: list[float]) -> tuple[Array, Array]:
    """Return the derivatives (f, f) of the free accelerations by the free rates and by the free coordinates."""
    count = len(dynamics.free)

    def by_rate(k: int, off: float) -> Array:
        return np.array(dynamics.slope(t, *q, *[x + off * (k == i) for i, x in enumerate(v)])[:count])

    def by_place(k: int, off: float) -> Array:
        there = list(q)
        there[dynamics.free[k]] += off
        for _ in range(4 if dynamics.others else 0):
            for other, value in zip(dynamics.others, dynamics.newton(t, *there, *dynamics.kept), strict=True):
                there[other] += value
        return np.array(dynamics.slope(t, *there, *v)[:count])

    def slopes(of: Callable[[int, float], Array], at: list[float]) -> Array:
        moved = [_TINY * (1 + abs(x)) for x in at]
        return np.column_stack([(of(k, by) - of(k, -by)) / (2 * by) for k, by in enumerate(moved)])

    return slopes(by_rate, v), slopes(by_place, [q[place] for place in dynamics.free])


def _step(e: Evidence) -> Finding:
    """Return whether the step is too long for a steep motor or a stiff spring, so that deviations grow."""
    if e.scheme is None:
        return skipped(say("check.STABLE.skip"))
    damped, swinging = stiffness(e)
    product, limit = e.step * damped, e.scheme.damped
    told = {"rate": damped, "product": product, "limit": limit, "step": 0.9 * limit / damped if damped else e.step}
    if product >= limit:
        return Finding("COARSE", say("check.STABLE.steep", **told), product, limit, "", step=told["step"])
    most = _RK4_SWINGS if e.scheme.order > 2 else _SWINGS
    if e.step * swinging >= most:
        told |= {"rate": swinging, "product": e.step * swinging, "limit": most, "step": 0.9 * most / swinging}
        return Finding("COARSE", say("check.STABLE.stiff", **told), e.step * swinging, most, "", step=told["step"])
    if e.exact.rows.count < e.own.rows.count:  # unknown: it may become steeper where the motion could not be followed
        return skipped(say("check.STABLE.unknown", row=e.exact.rows.count))
    return Finding("PASS", say("check.STABLE.pass", **told, swing=e.step * swinging), product, limit)


CHECKS = (
    Check("START", "computation", lambda e: start_of(e.closure)),
    Check("ENERGY", "motion", _energy),
    Check("MOTION", "motion", _accuracy),
    Check("STABLE", "motion", _step),
)
