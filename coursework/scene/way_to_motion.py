"""One variant with its settings, and the way to its motion: every step a typed property, computed once, when it is first read.

Enters: a `Variant` and `Settings`.  Leaves: `WayToMotion`, the base of `Scene`, which adds the results of the motion.
Used by `motion_results.py` and `scene.py`.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import ClassVar

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.equations.reduction.blocks import Reduction, angles_in_determinants, reduce
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.structure import Structure, structure_of
from coursework.equations.reduction.textbook.solution import Solution
from coursework.equations.reduction.textbook.solution import solutions as solve_blocks
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.geometry.chain import chain_positions, is_chain
from coursework.motion.geometry.closed_start import require_start
from coursework.motion.geometry.closure import Closure, compile_closure
from coursework.motion.geometry.drives.drive import breaks, refuse_aliasing, refuse_endless, refuse_short_tables
from coursework.motion.geometry.drives.oscillation import fastest
from coursework.motion.geometry.judging.unseen_signs import judged
from coursework.motion.geometry.start import start_values
from coursework.motion.integration.exact_motion import NoVelocities, OutOfReach, exact_motion, no_rows, passing_motion
from coursework.motion.integration.following import NotReached
from coursework.motion.integration.integrate import Correction, March, left_by_scheme
from coursework.motion.integration.motion import Motion, Stop, rows_before
from coursework.motion.integration.passage import through
from coursework.motion.integration.rates import Rates, compile_rates
from coursework.motion.schemes import scheme_of
from coursework.motion.settings import Settings
from coursework.motion.singular.event import NotFollowed
from coursework.motion.singular.scaled_flow import Flow, compile_flow
from coursework.motion.singular.search import Search, search_event
from coursework.system.arrays import Array
from coursework.system.on_demand import Ledger, computed
from coursework.variant.judging.bounds import refuse_unbounded
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError

# A periodic motion of many periods is searched for dead points over this many periods only.
PERIODS_LOOKED_AT = 2.2
PLACES = 10  # number of intervals between two of the twelve positions of a period


@dataclass(frozen=True, eq=False, repr=False)
class WayToMotion:
    """A variant with the settings of its run, up to its motions; each property builds on those above it."""

    variant: Variant
    settings: Settings
    ledger: Ledger = field(default_factory=Ledger)
    follows_laws: ClassVar[bool] = True  # velocities follow from time and positions alone

    @cached_property
    def structure(self) -> Structure:
        """Return what the variant shares with all variants that differ only in their data."""
        return structure_of(self.variant)

    @computed()
    def mechanism(self) -> Mechanism:
        """Return the mechanism: points in order, chains written out, mobility."""
        return self.structure.mechanism(self.variant)

    @computed("mechanism")
    def equations(self) -> VelocityEquations:
        """Return the velocity equations A(q, t) u = b(q, t)."""
        return self.structure.equations(self.mechanism)

    @computed("equations")
    def start(self) -> list[float]:
        """Return the coordinates at t = 0 (rad, m)."""
        return start_values(self.equations)

    @computed("equations", "start")
    def closure(self) -> Closure | None:
        """Return the position equations, if the file has any, after checking them against start and written equations."""
        closure = compile_closure(self.equations, self.start)
        require_start(closure)
        return judged(self.equations, closure)

    @property
    def closed_start(self) -> list[float]:
        """Return the closed position of t = 0, even if the file rounds it; as written where positions are not closed."""
        closure = self.closure
        closed = closure.newton(0.0, closure.start, closure.origin) if closure is not None and closure.complete else None
        return self.start if closed is None else closed.tolist()

    @computed("equations", "start")
    def reduction(self) -> Reduction:
        """Return the blocks, their solutions and determinants."""
        return reduce(self.equations, self.start)

    @computed("equations", "reduction")
    def solutions(self) -> tuple[Solution, ...]:
        """Return the velocities of every block as a textbook writes them."""
        return solve_blocks(self.equations, self.reduction)

    @computed("equations", "reduction")
    def rates(self) -> Rates:
        """Return the right-hand side as a plain function, for the columns asked for."""
        return compile_rates(self.equations, self.reduction, self.settings.columns or None)

    @computed("equations", "reduction", "start")
    def flow(self) -> Flow:
        """Return the determinant-scaled flow that finds dead points."""
        return compile_flow(self.equations, self.reduction, self.start)

    @computed("closure", "flow", "start", "equations")
    def search(self) -> Search:
        """Return the true motion followed to its first dead or change point, from a closed start even if the file rounds it."""
        refuse_short_tables(self.equations)
        time, start = self.variant.time, self.closed_start
        horizon = min(time.end, PERIODS_LOOKED_AT * (time.period or np.inf))
        try:
            found = search_event(self.flow, start, horizon, breaks=breaks(self.variant))
            if found.passages and horizon < time.end:  # every passage must be known
                found = search_event(self.flow, start, time.end, breaks=breaks(self.variant))
            if (until := found.given_up) is not None:
                from coursework.motion.singular.round_about import goes_round

                found = replace(found, goes_round=goes_round(self.flow, start))
                refuse_endless(self.equations, until, goes_round=found.goes_round)
            return found
        except NotFollowed as error:
            refuse_endless(self.equations, error.time)
            fault = Fault(error.faults[0].message, self.variant.file, self.variant.nearest_line("time", "end"))
            raise self.charged(error) or InputError([fault]) from None

    @computed("search", "flow", "equations", "reduction")
    def stop(self) -> Stop | None:
        """Return where the motion ends and why, in words; None if it does not end early."""
        if (event := self.search.event) is None:
            return None
        from coursework.motion.singular.change_point import branches_at
        from coursework.motion.singular.explain import explain

        at = (event.block, event.time, event.position.tolist())
        branches = branches_at(self.flow, *at, self.variant.time.end) if event.kind == "change point" else ()
        return explain(event, self.equations, self.reduction, self.variant.time.step, branches)

    @computed("search", "equations", "reduction", "start")
    def phases(self) -> str:
        """Return, for a motion that stops, the sentence about the phases of the drive for which the whole motion is possible."""
        if self.search.event is None:
            return ""
        from coursework.motion.singular.phases import phase_sentence

        return phase_sentence(self.equations, self.reduction, self.start)

    def march(self, step: float, scheme: str) -> Motion:
        """Return rows of a scheme with a step (s), corrected as the settings say, up to the stop of the true motion."""
        rates, passages = self.passing(self.rates), self.search.passages
        angles = angles_in_determinants([self.reduction.blocks[index] for index in rates.blocks], self.equations)
        guarded = [index for index, name in enumerate(rates.coordinates) if name in angles]
        made = March(rates, scheme_of(scheme), step, self.correction, guarded, passages, self.search.goes_on)
        rows = made.until(self.begin, self.variant.time.end, self.stop)
        return replace(rows, scaled=self.flow.relative(rows.determinants, rates.blocks), notes=self.passed)

    def passing(self, rates: Rates) -> Rates:
        """Return rates that know the limits at the singular positions with only one continuation."""
        return through(rates, self.search.passages)

    @property
    def passed(self) -> tuple[str, ...]:
        """Return the sentences about the singular positions that the motion passes through."""
        if not self.search.passages:
            return ()
        from coursework.motion.singular.explain import explain_passage

        return tuple(explain_passage(passage, self.equations, self.reduction) for passage in self.search.passages)

    def rerun(self, scheme: str, step: float) -> Motion | None:
        """Return the rows for another scheme or step, None if they do not reach the end of the motion."""
        with suppress(ArithmeticError, ValueError, OutsideTable):
            return rows if (rows := self.march(step, scheme)).stop is self.stop else None
        return None

    @property
    def correction(self) -> Correction | None:
        """Return the correction that keeps positions closed, None if not asked for.  Raises `InputError` if it is impossible."""
        return self.settings.correction(self.closure)

    @property
    def begin(self) -> list[float]:
        """Return the start of the integrated coordinates."""
        pairs = zip(self.variant.coordinates, self.start, strict=True)
        return [value for coordinate, value in pairs if coordinate.name in self.rates.coordinates]

    @cached_property
    def fastest_wave(self) -> float:
        """Return the largest frequency (rad/s) in the formulas of the drives."""
        return fastest(self.equations)

    @computed("stop", "equations", "closure", "rates", "reduction", "start", "flow", "search")
    def motion(self) -> Motion:
        """Return the rows of the coursework."""
        _ = self.stop  # an open start is reported before a step that is too coarse
        refuse_aliasing(self.equations, self.variant.time.step, self.fastest_wave)
        refuse_unbounded(self.variant)
        motion = self.march(self.variant.time.step, self.settings.scheme)
        if motion.stop is not None and motion.stop.kind == "not finite":
            last = motion.coordinates[-1].tolist() if len(motion.t) else self.begin
            if told := self.charged(NoVelocities((motion.stop.time, motion.stop.time), last)):
                raise told
            known = np.inf if self.search.goes_round else self.search.given_up or np.inf
            if self.search.event is None and known > motion.stop.time:
                return left_by_scheme(motion)
        return motion

    @computed("stop", "equations", "reduction", "rates", "closure", "start", "search")
    def exact(self) -> Motion:
        """Return the motion without a scheme's error, on the same rows."""
        time, stop, last = self.variant.time, self.stop, self.variant.time.steps
        if stop is not None:
            last = min(last, rows_before(stop.time, time.step) - 1)
        if last < 0:
            return no_rows(self.every_rate)
        return self.exact_at(np.arange(last + 1).astype(np.float64) * time.step)

    @computed("equations", "reduction", "exact", "search")
    def exact_accelerations(self) -> Array:
        """Return the accelerations of the exact rows."""
        return self.accelerations_of(self.exact)

    @computed("exact", "equations", "reduction", "rates", "search")
    def extremes(self) -> dict[str, tuple[float, float]]:
        """Return the smallest and largest value of every column of the exact motion up to its last row, also between rows."""
        from coursework.motion.integration.turning import extremes

        return extremes(self.exact, self.every_rate, self.accelerations_of)

    def accelerations_of(self, motion: Motion) -> Array:
        """Return the accelerations (n, k) of any motion of the mechanism."""
        from coursework.results.kinematics.accelerations import accelerations

        return accelerations(self.equations, self.reduction, motion, self.search.passages)

    def stirred(self, motion: Motion) -> Motion:
        """Return a motion in which what can move does, to judge links by: laws make this one."""
        return motion

    @property
    def scheme_rows(self) -> Motion | None:
        """Return the rows of a scheme beside an exact table; None if the table itself was made by a scheme."""
        return None

    @computed("exact", "stop", "equations", "reduction", "rates", "closure", "start", "search")
    def one_period(self) -> Motion:
        """Return the exact motion at `12 * PLACES + 1` equal times over a period.

        They end at the last row if there is no period or the motion stops within it.
        """
        last, period = float(self.exact.t[-1]) if len(self.exact.t) else 0.0, self.variant.time.period
        end = last if period is None or (self.stop is not None and last < period) else period
        return self.exact_at(np.linspace(0.0, end, 12 * PLACES + 1)) if end > 0 else self.exact

    @property
    def every_rate(self) -> Rates:
        """Return the rates of all coordinates, whatever columns are asked for."""
        return self.passing(compile_rates(self.equations, self.reduction) if self.settings.columns else self.rates)

    def exact_at(self, times: Array) -> Motion:
        """Return the exact motion at times (s) that grow from 0; it has no rows if it cannot be computed."""
        equations, every = self.equations, self.every_rate
        positions = (lambda at: chain_positions(equations, at)) if is_chain(self.variant) else None
        with suppress(OutOfReach):
            if passages := self.search.passages:
                return passing_motion(every, self.start, times, passages, self.passed)
            with suppress(NotReached):
                return exact_motion(every, self.closure, self.start, times, positions)
            return exact_motion(every, None, self.start, times)
        return no_rows(every)

    def charged(self, error: Exception) -> InputError | None:
        """Return the fault of a formula that has no value somewhere on the way, None if every formula has one."""
        from coursework.scene.charged import formula_charged

        known = vars(self)
        return formula_charged(error, self.variant, known.get("start"), known.get("motion"))
