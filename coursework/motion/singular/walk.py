"""A walk along the true motion to its first dead or change point.

Enters: the determinant-scaled flow, a state.  Leaves: `Event`, passages on the way, the peaks of the rates.
Used by `search.py`.

The flow is smooth through a fold.  A dead point is the maximum of t(s), where a determinant changes its sign.  Two changes
inside one step leave no trace at its ends, so a step is examined if a determinant has a minimum inside it.  At a change
point the flow comes to rest; the point is searched for as soon as the flow comes near (`change_point.py`).  If there is only one
continuation, the walk goes on with it (`passing.py`).
Source: numerics.md 3.1.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Sequence
from itertools import groupby

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.integration.adaptive import next_length
from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.passage import Passage
from coursework.motion.singular.event import Event, GivenUp, NotFollowed, without_value
from coursework.motion.singular.peaks import Peaks, Piece
from coursework.motion.singular.scaled_flow import Clock, Flow
from coursework.motion.singular.stalled import ahead
from coursework.system.arrays import Array
from coursework.words.sentences import say

# With a start determinant this small, any velocity has fewer than six digits.
SINGULAR = 1e-10
# With a local tolerance e, a motion passes a change point at a distance of about sqrt(100 e): the search begins at 100 sqrt(e)
# and reaches as far as FAR (rad or share of the largest length).
NEAR, FAR = 100.0, 1e-2
# Share of a length by which a motion may miss a change point and still be at it: no link is made to 1e-9.
MISSED = 1e-9
# The flow has stalled before a dead point that comes whatever the block does: its determinant depends on time and earlier blocks.
STALLED = 1e-10
# A determinant below DIP is examined for a minimum inside a step; one below TOUCH is zero.
DIP, TOUCH = 0.1, 1e-12
# Shares of the run: how long before a break of the drive its old formula is left; how close to the end counts as the end.
BEFORE_BREAK, AT_END = 1e-12, 1e-9
# Blocks whose determinants are below this at an event are singular together.
TOGETHER = 1e-6
# Tolerance of roots, as a share of the first determinant or of the run; the time of a fold is right to its square.
ROOT = 1e-13
MAX_STEPS = 15_000
# A coordinate beyond this (rad or sizes of the mechanism) turns for ever or grows without end: a hundred million revolutions.
BOUNDLESS = 1e9
# A determinant this many times its usual size stands at a pole: an equation divides by zero there, and no rate need be large.
POLE = 1e9
# MANY steps together shorter than SHORT times the time so far mean an unbounded rate; no step is below NOTHING times the run.
MANY, SHORT, NOTHING = 100, 1e-11, 1e-20
_HALVINGS = 30
# Factor for a step that reaches too far: the pace of the clock changes on the way.
_SHORT = 0.9


class Walk:
    """A walk along the flow: `state` (position, then t), the `scaled` determinants there, the `length` of the next step in s."""

    def __init__(self, flow: Flow, state: Array, end: float, cells: Array, tolerance: float) -> None:
        self.flow, self.state, self.end, self.cells, self.tolerance = flow, state, end, cells.tolist(), tolerance
        self.scaled = self._determinants(state)
        self.slope = state
        self.length = 0.0
        self.near = NEAR * tolerance**0.5
        self.tried = np.inf  # the determinant at the last search for a change point
        self.peaks = Peaks.of(len(state) - 1)
        self.way, self.since = [state], 0.0  # states from which the walk can start again; the time of the last break of the drive
        self.passages: list[Passage] = []
        self.taken = 0

    def at_start(self) -> Event | None:
        """Return the event at the start of the run, or just after a break of the drive, if it is singular; else None."""
        singular = [block for block, size in enumerate(self.scaled) if abs(size) < SINGULAR]
        return self._event(self.state, singular[0]) if singular else None

    def until(self, goal: float) -> Event | None:
        """Walk to time `goal`, a break of the drive or the end; return the first event on the way, None if there is none."""
        with np.errstate(all="ignore"):  # a step that gives nan is too long
            event = self._until(goal)
        self.since = goal
        return event

    def _until(self, goal: float) -> Event | None:
        latest = goal * (1 + AT_END) if goal == self.end else goal
        while self.taken < MAX_STEPS:
            self.taken += 1
            sizes = [abs(size) for size in self.scaled]
            block = sizes.index(min(sizes))
            self.length = self.length or self.end / 200 / sizes[block]
            clock = self.flow.clock(block, 1 if self.scaled[block] > 0 else -1)
            taken = self._step(clock)
            if taken is None:
                return None
            state, reach, following = taken
            after = self._determinants(state)
            crossed = [k for k, (now, then) in enumerate(zip(after, self.scaled, strict=True)) if now * then <= 0]
            if crossed and not self._at_once(crossed, block, after):
                self.length = reach / 4
                continue
            event, part = self._inside(clock, reach, state, after, block, bool(crossed))
            if event is not None and event.time < latest:
                if self._pass(event, goal):
                    continue
                return event
            if part or state[-1] >= goal - BEFORE_BREAK * self.end:
                self._arrive(clock, part or reach, goal)
                return None
            # A growth that comes with a vanishing determinant ends at a dead point, which is the better message.
            stalls = len(self.way) > MANY and state[-1] - self.way[-MANY][-1] < SHORT * state[-1]
            if min(map(abs, after)) > TOGETHER and (stalls or np.max(np.abs(state[:-1]) / self.flow.units) > BOUNDLESS):
                raise self._boundless(state)
            nearer = abs(after[block]) < min(abs(self.scaled[block]), self.near)
            self.state, self.scaled, self.length = state, after, following
            self.way.append(self.state)
            if nearer and (event := self._at_rest(block)) is not None and not (event.time < latest and self._pass(event, goal)):
                return event if event.time < latest else None
        raise GivenUp(float(self.state[-1]))

    def _boundless(self, state: Array) -> NotFollowed:
        """Return the fault of a formula at its pole, of a coordinate gone too far, else of a rate that grows as time stands."""
        sizes = ((max(map(abs, self._determinants(one))), float(one[-1])) for one in self.way)
        if first := next((list(run) for beyond, run in groupby(sizes, lambda one: one[0] > POLE) if beyond), None):
            _, pole = max(first, key=lambda one: one[0])
            return without_value(pole, say("event.no_value"))
        variant, time, bound = self.flow.equations.variant, float(state[-1]), say("event.no_bound")
        name = variant.rates[int(np.argmax(np.abs(self.slope[:-1])))]
        if (far := np.abs(state[:-1]) / self.flow.units).max() > BOUNDLESS:
            place = int(np.argmax(far))
            coordinate, unit = variant.coordinates[place], float(self.flow.units[place])
            if far[place] > (begun := abs(float(self.state[place])) / unit):  # a fast one passes the bound early in the step
                time -= (time - float(self.state[-1])) * (float(far[place]) - BOUNDLESS) / (float(far[place]) - begun)
            name, bound = coordinate.name, say("amount.three", value=BOUNDLESS * unit, unit=coordinate.unit)
        return NotFollowed(say("fault.V526", name=name, bound=bound, time=time), time)

    def _pass(self, event: Event, goal: float) -> bool:
        """Go on after a change point if only one motion does; return whether this was possible."""
        from coursework.motion.singular.passing import passage_at

        # A law may change its formula at a break; after the end of the run it usually goes on.
        passage = passage_at(self.flow, event, self.way, self.end, (self.since, goal if goal < self.end else np.inf))
        if passage is None:
            return False
        self.passages.append(passage)
        self._begin(np.append(passage.flanks[2].position, passage.flanks[2].time))
        self.tried = np.inf
        return True

    def _begin(self, state: Array) -> None:
        self.state, self.scaled, self.length, self.way = state, self._determinants(state), 0.0, [state]

    def _determinants(self, state: Array) -> list[float]:
        *q, t = state.tolist()
        return self.flow.scaled(t, q)

    def _step(self, clock: Clock) -> tuple[Array, float, float] | None:
        """Return the next accurate state, the length to it and the next length; None at the end of a table."""
        t = float(self.state[-1])
        slope = self.slope = clock.slope(self.state)
        sizes = [*self.flow.units.tolist(), 0.0]
        allowed = [self.tolerance * (unit + abs(value)) for unit, value in zip(sizes, self.state.tolist(), strict=True)]
        allowed[-1] = self.tolerance * self.end
        # A step that misses a pulse between its points shows no error: so no step reaches beyond the next stretch.
        beyond = bisect_right(self.cells, t) + 1
        farthest = self.cells[beyond] - t if beyond < len(self.cells) else math.inf
        while self.length * slope[-1] > NOTHING * self.end:
            try:
                after, error = clock.step(self.state, slope, self.length)
            except (OutsideTable, ArithmeticError, ValueError) as fault:
                # A law need not exist beyond the end of the run.
                self.length /= 4
                if self.length * slope[-1] > AT_END * self.end:
                    continue
                if self.end - t < 100 * AT_END * self.end:
                    return None
                why = fault.faults[0].message if isinstance(fault, OutsideTable) else say("event.no_value")
                ahead = [(self.state + slope * self.length * 4.0**further).tolist() for further in range(1, 12)]
                raise without_value(t, why, ahead) from fault
            shares = [abs(off) / most for off, most in zip(error, allowed, strict=True)]
            ratio = math.inf if math.isnan(sum(shares)) else max(shares)
            if (far := float(after[-1]) - t) > farthest * (1 + AT_END):
                self.length *= farthest / far * _SHORT
            elif ratio <= 1.0:
                self.peaks.see(Piece(self.state, slope, clock, self.length))
                return after, self.length, next_length(self.length, ratio, 8)
            else:
                self.length = next_length(self.length, min(ratio, 1e10), 8)
        raise self._boundless(self.state)

    def _reached(self, clock: Clock, part: float) -> Array:
        return clock.step(self.state, self.slope, part)[0]

    def _at_once(self, crossed: list[int], block: int, after: Sequence[float]) -> bool:
        """Return whether only the clock's determinant changes its sign, or others so close to it that they change at once."""
        return crossed == [block] or (block in crossed and max(abs(after[k]) + abs(self.scaled[k]) for k in crossed) < 1e-9)

    def _inside(
        self, clock: Clock, reach: float, ahead: Array, after: Sequence[float], block: int, crossed: bool
    ) -> tuple[Event | None, float]:  # fmt: skip
        """Return the event inside a step and the length to it; (None, 0) if there is none.

        `ahead` is the state at the end of the step, `after` the determinants there.
        """
        if not crossed and min(abs(after[block]), abs(self.scaled[block])) > DIP:
            return None, 0.0

        def value(state: Array) -> float:
            return self._determinants(state)[block] / self.scaled[block]

        lowest = reach if crossed else self._lowest(clock, reach, ahead, block)
        if not lowest:
            return None, 0.0
        bottom = self._reached(clock, lowest)
        smallest = value(bottom) * abs(self.scaled[block])
        if smallest <= TOUCH:
            state, part = self._root(clock, lowest, value)
            if abs(value(state)) > 1.0:  # it changed its sign through infinity, as a tangent does
                raise without_value(float(state[-1]), say("event.no_value"))
            return self._event(state, block), part
        return (self._change_point(bottom, block) if smallest < self.near else None), 0.0

    def _lowest(self, clock: Clock, reach: float, ahead: Array, block: int) -> float:
        """Return the length within a step at which a determinant has its minimum; 0 if the minimum is at an end."""

        def falls(state: Array) -> bool:
            nudge = 1e-4 * reach * clock.slope(state)  # to both sides: one alone would look for the minimum half of it too early
            after, before = (self._determinants(state + side * nudge)[block] for side in (1, -1))
            return bool((after - before) * self.scaled[block] < 0)

        if not falls(self.state) or falls(ahead):
            return 0.0
        low, high = 0.0, reach
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if falls(self._reached(clock, middle)) else (low, middle)
        return (low + high) / 2

    def _root(self, clock: Clock, reach: float, value: Callable[[Array], float]) -> tuple[Array, float]:
        """Return the state inside a step at which `value`, positive at its start, is zero, and the length to it (Illinois)."""
        ends = value(self.state), value(self._reached(clock, reach))
        part = crossing(lambda part: value(self._reached(clock, part)), (0.0, reach), ends, ROOT) if ends[1] < 0 else reach
        part = reach if part is None else part
        return self._reached(clock, part), part

    def _arrive(self, clock: Clock, reach: float, goal: float) -> None:
        """Go to a break of the drive at time `goal`: with the flow until just before it, then in a straight line."""
        if goal == self.end:
            return
        wanted = goal - BEFORE_BREAK * self.end
        state, _ = self._root(clock, reach, lambda y: (wanted - float(y[-1])) / self.end)
        slope = clock.slope(state)
        self._begin(np.append(state[:-1] + (goal - state[-1]) / slope[-1] * slope[:-1], goal))

    def _at_rest(self, block: int) -> Event | None:
        """Return the change point at which the flow comes to rest, or the dead point that comes whatever the block does."""
        size = abs(self.scaled[block])
        if size < STALLED:
            event = self._event(ahead(self.flow, self.state, block, self.end, within=FAR), block)
            return event if event.kind == "change point" else self._event(ahead(self.flow, self.state, block, self.end), block)
        if size > self.tried / 2:
            return None
        self.tried = size
        return self._change_point(self.state, block)

    def _change_point(self, state: Array, block: int) -> Event | None:
        """Return the change point that the motion meets near a state, None if there is none."""
        from coursework.motion.singular.change_point import nearest_change_point

        *q, t = state.tolist()
        sizes = [abs(size) for size in self._determinants(state)]
        block = next(k for k, size in enumerate(sizes) if size <= 10 * sizes[block])
        slope = np.array(self.flow.slopes(t, q, block))
        rates = slope[:-1] / slope[-1] if abs(slope[-1]) > 1e-9 else self.flow.part(t, q, block)[2]
        found = nearest_change_point(self.flow, t, state[:-1], block, rates, max(FAR, self.near))
        if found is None:
            return None
        time, position, miss = found
        return None if miss > max(MISSED, 1e3 * self.tolerance) else self._named("change point", time, position, block)

    def _event(self, state: Array, block: int) -> Event:
        """Return the event at a state with a zero determinant: a change point if there is one, else a dead point."""
        try:
            event = self._change_point(state, block)
        except ArithmeticError:
            event = None
        return event or self._named("dead point", float(state[-1]), state[:-1], block)

    def _named(self, kind: str, time: float, position: Array, block: int) -> Event:
        sizes = self.flow.scaled(time, position.tolist())
        together = tuple(k for k, size in enumerate(sizes) if abs(size) < TOGETHER or k == block)
        demanded = self.flow.demand(time, position.tolist(), together[0])
        # An event at a singular start happens at time 0, whatever round-off the search has added.
        return Event(kind, together[0], time if time > ROOT * self.end else 0.0, position, demanded, together)
