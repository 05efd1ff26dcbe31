"""A scene moved by forces: the rows of a scheme in the free coordinates, with the exact motion beside them.

Enters: a `Variant` with [motor] and `Settings`.  Leaves: `MotorScene`; everything that reads a `Scene` reads it too.
Used by `exact_scene.py`, for a file with a motor only.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from coursework.effects.dynamics.crossings import SINGLE, ended_at, first_crossing
from coursework.effects.dynamics.dynamics import TOLERANCE, Dynamics
from coursework.effects.dynamics.dynamics_checks import Evidence, check_dynamics
from coursework.effects.dynamics.dynamics_lesson import Moved, energy_of_rows, is_heavy, rates_of
from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.effects.dynamics.free_motion import FreeMotion, one_by_one
from coursework.effects.dynamics.known_rows import COARSER, LOOKS, UNDEFINED, known_rows, up_to_values
from coursework.effects.dynamics.motion_writer import MotionWriter
from coursework.effects.dynamics.regime import Regime, find_regime
from coursework.effects.dynamics.why_ended import CHANGE, LIMIT, laws_of_forces, too_steep
from coursework.effects.friction.held import Held
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.scheme import read_scheme
from coursework.motion.integration.integrate import TOO_LARGE
from coursework.motion.integration.motion import Motion, Stop
from coursework.motion.schemes import DEFAULT_SCHEME, Scheme, scheme_named
from coursework.motion.singular.search import Search
from coursework.results.checks.result import Finding
from coursework.scene.motion_results import MotionResults
from coursework.scene.scene import Scene
from coursework.system.arrays import Array
from coursework.system.on_demand import computed
from coursework.variant.judging.bounds import refuse_unbounded
from coursework.variant.record.forces import Motor
from coursework.variant.record.vocabulary import EXACT
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import either, say

if TYPE_CHECKING:
    from coursework.results.accuracy.record import AccuracyStudy

_SAID = {
    "dead point": "dead", LIMIT: "limit", CHANGE: "crossing", SINGLE: "single", "not finite": "far", "too steep": "steep",
    TOO_LARGE: "wide", UNDEFINED: "undefined",
}  # fmt: skip
_LATE = 0.9  # share of its time: rows that go off the scale before lack a shorter step


@dataclass(frozen=True, eq=False, repr=False)
class MotorResults(MotionResults):
    """The results of a motion under forces, judged by energy and by the exact motion, not by velocity laws."""

    @computed("motion", "exact", "energy", "free_equations", "closure")
    def checks(self) -> tuple[Finding, ...]:
        """Return the checks of a motion under forces: energy, distance from the exact motion, stability of the step."""
        scene = self.scene
        assert isinstance(scene, MotorScene)
        return check_dynamics(self.evidence_of_forces, scene.finer)

    @property
    def evidence_of_forces(self) -> Evidence:
        """Return what the checks of a motion under forces look at."""
        scene = self.scene
        assert isinstance(scene, MotorScene)
        step, closure = scene.variant.time.step, scene.closure
        return Evidence(self.forces, scene.exact_analysis, scene.free_equations, scene.scheme, step, closure)


@dataclass(frozen=True, eq=False, repr=False)
class MotorScene(Scene):
    """A scene whose motion follows from forces; its velocities are part of the state."""

    follows_laws: ClassVar[bool] = False
    kind_of_results: ClassVar[type[MotionResults]] = MotorResults

    @property
    def _motor(self) -> Motor:
        motor = self.variant.motor
        assert motor is not None
        return motor

    @property
    def scheme(self) -> Scheme | None:
        """Return the scheme of the rows, None for exact rows."""
        return scheme_named(self.settings.scheme)

    @computed("mechanism", "equations", "reduction", "closure")
    def free_equations(self) -> EquationsOfMotion:
        """Return the equations of motion in the free coordinates, for masses as they are where the mechanism is closed."""
        writer = MotionWriter(self.equations, self.reduction, read_scheme(self.mechanism), tuple(self.closed_start))
        if writer.scheme.forces.friction:
            from coursework.effects.dynamics.rubbed_motion import rubbed_motion

            found = rubbed_motion(writer)
        else:
            found = writer.made()
        try:
            found.slope(0.0, *self.closed_start, *self._start_rates)
        except (ZeroDivisionError, ValueError, OverflowError):
            told = say("fault.V749") if is_heavy(found, self.closed_start) else say("fault.V744", names=self._motor.rates)
            raise InputError([Fault(told, self.variant.file, self.variant.nearest_line("motor", "rates"))]) from None
        except Held:  # it locks where it begins: the rows end there
            pass
        return found

    @property
    def unit_of_rates(self) -> str:
        """Return the unit of the free rates; "rad/s or m/s" if they differ."""
        return either(list(dict.fromkeys(map(self.variant.unit_of, self._motor.rates))))

    @cached_property
    def regime(self) -> Regime | None:
        """Return the steady motion of a crank turned by forces, None if the exact rows tend to none."""
        motion, rates = self.exact, self._motor.rates
        timed = any("t" in law.names() for law in laws_of_forces(self.variant))
        speed = float(motion.column(rates[0])[-1]) if len(motion.t) else 0.0
        is_crank = [self.variant.unit_of(rate) for rate in rates] == ["rad/s"]
        if not is_crank or timed or not speed or motion.stop is not None:
            return None
        return find_regime(self.free_equations, list(self.closed_start), speed)

    @computed("equations")
    def search(self) -> Search:
        """Return an empty search: singular positions are not known before the motion is."""
        return Search(None, None, self.variant.time.end)

    @cached_property
    def _begin(self) -> list[float]:
        return [*(self.closed_start[place] for place in self.free_equations.free), *self._start_rates]

    @property
    def _start_rates(self) -> list[float]:
        start = dict(self._motor.start)
        return [start.get(rate, 0.0) for rate in self._motor.rates]

    def energy_study(self, progress: Callable[[str], None] | None = None) -> AccuracyStudy:
        """Return the study of accuracy: the error of the energy against slopes."""
        from coursework.effects.dynamics.energy_study import energy_study

        return energy_study(self.moved, self.scheme or DEFAULT_SCHEME, self.unit_of_rates, progress)

    @property
    def moved(self) -> Moved:
        """Return the motion that schemes are tried on."""
        return Moved(self.free_equations, self.begin_of_forces, self.variant.time, self.exact)

    @property
    def begin_of_forces(self) -> tuple[list[float], list[float]]:
        """Return all coordinates at t = 0, and the free coordinates with their rates."""
        return list(self.closed_start), self._begin

    @cached_property
    def _true(self) -> FreeMotion:
        time, motion = self.variant.time, self.free_equations
        pace = max(1, time.steps // LOOKS)
        fine, coarser = (Dynamics(motion, list(self.closed_start), size) for size in (TOLERANCE, COARSER))
        found = up_to_values(self.variant, fine.exact(self._begin, time.step, time.steps), self._table)
        rough, rates = coarser.exact(self._begin, pace * time.step, time.steps // pace), motion.sizes_of_state[len(motion.free) :]
        known = known_rows(found, rough, pace, [*motion.sizes, *rates])
        if known.ended != CHANGE:
            return known
        exact, between = self._motion_of(known, EXACT), Dynamics(motion, []).between
        at, ended = ended_at(self.flow, exact, lambda times: self._motion_of(between(known, times), EXACT), known.at)
        return replace(known, at=at, ended=ended)

    @cached_property
    def _exact_rows(self) -> Motion:
        return replace(self._motion_of(self._true, EXACT, say("dynamics.exact"), self.stop), notes=self.passed)

    @cached_property
    def passed(self) -> tuple[str, ...]:
        """Return the sentence about a change point that the exact motion goes through."""
        return () if self._crossed_at is None else (say("dynamics.passed", time=self._crossed_at),)

    @cached_property
    def _crossed_at(self) -> float | None:
        """Return when (s) the exact motion first goes through a change point."""
        return first_crossing(self.flow, self._motion_of(self._true, EXACT), self.exact_at)

    @computed("free_equations")
    def stop(self) -> Stop | None:
        """Return why the exact motion ends early: links that would have to stretch, or a limit of its free coordinates."""
        return self._stop_of(self._true)

    def _stop_of(self, found: FreeMotion) -> Stop | None:
        if not found.ended:
            return None
        step, coordinates = self.variant.time.step, self.variant.coordinates
        last = dict(zip([c.name for c in coordinates], found.coordinates[-1].tolist(), strict=True)) if len(found.t) else {}
        key = "still" if found.ended == "held" and not found.at else _SAID.get(found.ended, found.ended)
        if key == "far" and self._true.ended == found.ended and found.at > _LATE * self._true.at:
            key = "runs_away"  # so does the exact motion
        means = "far" if key == "wide" else key  # a shorter step helps in both cases
        free = self.free_equations.free
        turned = tuple(coordinates[place].name for place in free)
        others = [one.rate for place, one in enumerate(coordinates) if place not in free]
        cause = (
            found.by
            if key == "undefined"
            else say(f"dynamics.{key}", time=found.at, at=found.by, names=turned, causes=either(list(too_steep(self.variant))))
        )
        return Stop(
            {LIMIT: "dead point", SINGLE: CHANGE}.get(found.ended, found.ended), found.at, found.at / step, (), last, cause,
            say(f"dynamics.{means}_means", row=len(found.t), names=either(others) if others else ""),
        )  # fmt: skip

    def _ended_as(self, found: FreeMotion) -> FreeMotion:
        """Return the rows of a scheme; if no position closes, the exact motion decides whether links or step are the cause."""
        if found.ended != "dead point":
            return found
        true, crossed = self._true, self._crossed_at
        if crossed is not None and len(found.t) and 0 <= crossed - found.t[-1] <= 1.001 * self.variant.time.step:
            return replace(found, ended=CHANGE, at=crossed)  # a slope was looked for just there
        return replace(found, ended={"": TOO_LARGE, LIMIT: LIMIT, CHANGE: CHANGE, SINGLE: SINGLE}.get(true.ended, found.ended))

    def _motion_of(self, found: FreeMotion, scheme: str, label: str = "", stop: Stop | None = None) -> Motion:
        variant, count = self.variant, len(found.t)
        names = tuple(c.name for c in variant.coordinates)
        values = self._table(found.t, found.coordinates, found.rates)
        size = len(variant.velocities)
        determinants = values[:, 2 * size + 2 :]
        largest = np.abs(determinants).max(axis=0, initial=1e-300)
        return Motion(
            found.t, found.coordinates, values[:, :size].copy(), determinants.copy(), determinants / largest, names,
            variant.velocities, scheme, variant.time.step, found.slopes, stop, label, residuals=np.zeros((count, 0)),
        )  # fmt: skip

    def _table(self, t: Array, q: Array, v: Array) -> Array:
        found = self.free_equations.table(t, *q.T, *v.T)
        return np.array([np.broadcast_to(value, t.shape) for value in found], dtype=float).T.reshape(len(t), len(found))

    @computed("free_equations", "stop", "start")
    def motion(self) -> Motion:
        """Return the rows of the scheme, or of the exact motion."""
        refuse_unbounded(self.variant)
        scheme, time = self.scheme, self.variant.time
        if scheme is None:
            return self._exact_rows
        rows = Dynamics(self.free_equations, list(self.closed_start)).rows(scheme, self._begin, time.step, time.steps)
        found = self._ended_as(up_to_values(self.variant, rows, self._table))
        notes = () if found.ended == CHANGE else self.passed
        return replace(self._motion_of(found, scheme.name, stop=self._stop_of(found)), notes=notes)

    @computed("free_equations", "stop", "start")
    def exact(self) -> Motion:
        """Return the motion without a scheme's error, on the same rows."""
        return self._exact_rows

    def exact_at(self, times: Array) -> Motion:
        """Return the exact motion at times (s) that grow from 0, as far as it goes."""
        found = Dynamics(self.free_equations, []).between(self._true, times) if len(self._true.t) else self._true
        return self._motion_of(found, EXACT, say("dynamics.exact"))

    def accelerations_of(self, motion: Motion) -> Array:
        """Return the accelerations (n, k) that the forces give the links in each row."""
        size = len(motion.velocity_names)
        return self._table(motion.t, motion.coordinates, rates_of(self.free_equations, motion))[:, size : 2 * size].copy()

    def energy_of(self, motion: Motion) -> Array:
        """Return the sum of kinetic and potential energy (n,) J."""
        return energy_of_rows(self.free_equations, motion.t, motion.coordinates, rates_of(self.free_equations, motion))[0]

    def stirred(self, motion: Motion) -> Motion:
        """Return the motion; if nothing moves where it is judged, the start with each free rate by itself: links show how."""
        rests = not motion.velocities[: None if motion.scheme == EXACT else 1].any()  # further rows of a scheme drift
        return self._motion_of(one_by_one(self.closed_start, len(self._motor.rates)), EXACT) if rests else motion

    @computed("exact")
    def exact_accelerations(self) -> Array:
        """Return the accelerations of the exact rows."""
        return self.accelerations_of(self.exact)

    @computed("exact")
    def extremes(self) -> dict[str, tuple[float, float]]:
        """Return the smallest and the largest value of every column in the rows of the exact motion."""
        exact = self.exact
        return {name: (float(exact.column(name).min()), float(exact.column(name).max())) for name in exact.names}

    @property
    def one_period(self) -> Motion:
        """Return the exact rows: a motion under forces has no period."""
        return self.exact

    def finer(self, parts: int) -> Evidence:
        """Return the evidence about the same motion with a step so many times shorter."""
        results = MotorScene(self.variant.timed(self.variant.time.step / parts), self.settings).results
        assert isinstance(results, MotorResults)
        return results.evidence_of_forces

    @cached_property
    def exact_analysis(self) -> ForceAnalysis:
        """Return the forces of the exact rows."""
        return self.over(self.exact).forces
