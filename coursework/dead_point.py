"""Whether the whole motion is possible, and where it ends if not.

Enters: the determinant-scaled flow, the start.  Leaves: None or an `Event`, located without regard to any scheme or step.

The flow is smooth through a fold, and a dead point is the maximum of t(s): a determinant changes its sign.  Two changes
inside one step leave no trace at its ends, so a step in whose middle a determinant is smallest is looked into.  A change
point is where the flow comes to rest; it is searched for as soon as the flow comes near (`change_point.py`).
Source: numerics.md 3.1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from coursework.adaptive import Step, dormand_prince, next_length
from coursework.change_point import nearest_change_point
from coursework.errors import InputError
from coursework.scaled_flow import Flow
from coursework.tabulated import OutsideTable

Array = NDArray[np.float64]
# The event time is wanted to 1e-8 s; the local tolerance leaves three digits for the sum of all steps.
TOLERANCE = 1e-12
# A start whose determinant is this small leaves fewer than six digits of any velocity.
SINGULAR = 1e-10
# A motion that is off by TOLERANCE a step passes a change point at the square root of that sum: nearer than this it is searched.
NEAR = 1e-4
# The part of a length by which a motion may miss a change point and still be called at it: nobody cuts a link to 1e-9.
MISSED = 1e-9
# The flow has stalled in a dead point that time alone approaches (the determinant depends on t only).
STALLED = 1e-10
# Determinants below this are looked at for a minimum inside a step; at a minimum as flat as the second it is zero.
DIP, TOUCH = 0.1, 1e-12
# Part of the run before a break of the drive at which the old formula is left.
BEFORE_BREAK = 1e-12
NEAR_END = 1e-9
MAX_STEPS = 20_000
# Runge-Kutta halvings of a step to the smallest determinant inside it.
_HALVINGS = 40


@dataclass(frozen=True, slots=True)
class Event:
    """Where D of block number `block` vanishes: `time` (s), `position`; `demanded` is what b asks beyond the range of A.

    `together`: all blocks that become singular there, the first of them is `block`.
    """

    kind: str
    block: int
    time: float
    position: Array
    demanded: float
    together: tuple[int, ...] = ()


def find_event(
    scene: Flow, start: Sequence[float], end: float, *, tolerance: float = TOLERANCE, breaks: Sequence[float] = ()
) -> Event | None:
    """Follow the true motion from `start` at t = 0 until `end` (s); return the first dead or change point, if any.

    `breaks` are the times at which the drive changes its formula.  Raises `InputError` where the motion cannot be followed.
    """
    walk = _Walk(scene, np.array([*start, 0.0], dtype=float), end, tolerance)
    if float(np.min(np.abs(walk.scaled))) < SINGULAR:
        return walk.at_start()
    for goal in [*(b for b in breaks if 0 < b < end), end]:
        event = walk.until(goal)
        if event is not None:
            return event
    scene.fastest = tuple(zip(walk.fastest.tolist(), walk.when.tolist(), strict=True))
    return None


@dataclass
class _Walk:
    """The walk along the flow: `state` (position, then t), `scaled` determinants there, the step `length` in s."""

    scene: Flow
    state: Array
    end: float
    tolerance: float
    length: float = 0.0
    usual: float = 0.0
    tried: float = np.inf
    scaled: Array = field(init=False)
    fastest: Array = field(init=False)
    when: Array = field(init=False)

    def __post_init__(self) -> None:
        self.scaled = self.scene.scaled(float(self.state[-1]), self.state[:-1].tolist())
        self.fastest = np.zeros(len(self.state) - 1)
        self.when = np.zeros(len(self.state) - 1)

    def until(self, goal: float) -> Event | None:
        """Walk to time `goal` exactly; return the event on the way, if any."""
        block = -1
        for _ in range(MAX_STEPS):
            nearest = int(np.argmin(np.abs(self.scaled)))
            sign = 1.0 if self.scaled[nearest] > 0 else -1.0
            if nearest != block or self.length == 0.0:
                self.length = self.length or goal / 200 / abs(self.scaled[nearest])
                block = nearest
            rule = self._field(nearest, sign)
            step = self._step(rule, nearest)
            if step is None:
                return None
            after = self.scene.scaled(float(step.state[-1]), step.state[:-1].tolist())
            reach = self.length
            crossed = set(np.flatnonzero(after * self.scaled < 0).tolist())
            if not crossed and (dip := self._dip(rule, step, after)):
                crossed, reach, after = dip
            if crossed - {nearest} and not (nearest in crossed and self._together(crossed, after)):
                self.length /= 4
                continue
            found = self._locate(rule, reach, nearest, sign) if crossed else None
            if found is not None and found[0][-1] >= goal:
                reach = found[1]
            if found is None or found[0][-1] >= goal:
                if (found is not None or step.state[-1] >= goal) and self._arrive(rule, reach, goal):
                    return None
                if found is not None:
                    continue
                shrinking = abs(after[nearest]) < abs(self.scaled[nearest])
                self.state, self.scaled = step.state, after
                if shrinking and (event := self._rest(nearest, goal)):
                    return event
                continue
            return self._event(found[0], nearest)
        raise InputError(f"the motion could not be followed beyond t = {self.state[-1]:.6g} s; nothing is known about it there.")

    def at_start(self) -> Event:
        """Return the event of a start that is singular itself."""
        block = self._first(float(np.min(np.abs(self.scaled))))
        position = self.state[:-1]
        matrix, right, _ = self.scene.part(0.0, position.tolist(), block)
        demanded = self.scene.demand(0.0, position.tolist(), block)
        size = float(np.linalg.norm(right)) or float(np.linalg.norm(matrix))
        kind = "change point" if demanded <= 1e-8 * size else "dead point"
        return Event(kind, block, 0.0, position, demanded, self._singular(position, 0.0, block))

    def _field(self, block: int, sign: float) -> Callable[[float, Array], Array]:
        slopes = self.scene.slopes

        def rule(_s: float, y: Array) -> Array:
            *q, t = y.tolist()
            return sign * np.array(slopes(t, q, block)[0])

        return rule

    def _step(self, rule: Callable[[float, Array], Array], block: int) -> Step | None:
        """Return the next step that is accurate enough; None at the end of what the equations are defined for."""
        *q, t = self.state.tolist()
        slope, demanded = self.scene.slopes(t, q, block)
        self.usual = max(self.usual, demanded)
        rates = np.abs(np.array(slope[:-1]) / slope[-1])
        self.when[rates > self.fastest] = t
        self.fastest = np.maximum(self.fastest, rates)
        first = np.sign(slope[-1]) * np.array(slope)
        sizes = 1.0 + np.abs(self.state)
        sizes[-1] = self.end
        while True:
            try:
                step = dormand_prince(rule, 0.0, self.state, first, self.length)
            except (OutsideTable, ArithmeticError, ValueError) as error:
                # A law need not exist beyond the end of the run: come closer to the end in shorter steps.
                self.length /= 4
                if self.length * abs(slope[-1]) < NEAR_END * self.end:
                    if self.end - t < 100 * NEAR_END * self.end:
                        return None
                    raise InputError(f"the equations cannot be computed beyond t = {t:.6g} s: {error}") from error
                continue
            ratio = float(np.max(np.abs(step.error) / (self.tolerance * sizes)))
            taken = self.length
            if ratio <= 1.0:
                self.following = next_length(taken, ratio)
                return step
            self.length = next_length(taken, ratio if np.isfinite(ratio) else 1e10)
