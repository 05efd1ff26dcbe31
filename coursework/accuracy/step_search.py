"""The smallest number of steps that keeps the error under a wish, and what the better schemes would need.

Enters: a scene and a wished error (rad or m, maximum over the scheme's own rows).  Leaves: `StepChoice`.
Raises `InputError` where the search or the run would take minutes, and says how long.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.accuracy.timing import seconds
from coursework.errors import InputError
from coursework.march.loops import Loop, generate_loop
from coursework.march.rates import Rates
from coursework.schemes import SCHEMES

Array = NDArray[np.float64]
MOST_STEPS = 2_000_000
# Round-off of Runge-Kutta 4 in doubles grows to 1e-13; a wish must stay well above what can be told apart.
LEAST_ERROR = 1e-10


@dataclass(frozen=True, slots=True)
class Need:
    """What one scheme needs: `steps` of h = end/steps, `evaluations`, the `error` reached."""

    title: str
    steps: int
    evaluations: int
    error: float


@dataclass(frozen=True, slots=True)
class StepChoice:
    """`step` (s) of the scheme asked for, its `need`, and the `others`, cheapest first."""

    step: float
    need: Need
    others: tuple[Need, ...]

    @property
    def sentences(self) -> tuple[str, ...]:
        """Return the finding in words."""
        own = self.need
        told = [
            f"{own.title} needs {own.steps} steps of {self.step:.6g} s for an error of {own.error:.3g}: "
            f"{own.evaluations} evaluations."
        ]
        told += [
            f"{other.title} needs {other.steps} steps ({other.evaluations} evaluations, "
            f"{own.evaluations / other.evaluations:.2g} times fewer)."
            for other in self.others
            if other.evaluations < own.evaluations
        ]
        return tuple(told)


def choose_step(rates: Rates, scheme: str, start: Sequence[float], step: float, end: float, wish: float) -> StepChoice:
    """Return the largest step end/N whose error over its N + 1 rows stays under `wish`."""
    if not (np.isfinite(wish) and wish >= LEAST_ERROR):
        raise InputError(f"an error of {wish:g} cannot be asked for: from {LEAST_ERROR:g} down round-off decides. Ask for more.")
    own = _need(scheme, rates, start, step, end, wish)
    # Only a scheme of the same or a higher order can be cheaper.
    rivals = [name for name, rival in SCHEMES.items() if name != scheme and rival.order >= SCHEMES[scheme].order]
    others = sorted((_need(name, rates, start, step, end, wish) for name in rivals), key=lambda need: need.evaluations)
    return StepChoice(end / own.steps, own, tuple(others))


def _need(name: str, rates: Rates, start: Sequence[float], step: float, end: float, wish: float) -> Need:
    scheme = SCHEMES[name]
    loop, reference = generate_loop(scheme.step, rates), generate_loop(SCHEMES["rk4"].step, rates)

    def error(steps: int) -> float:
        # Runge-Kutta 4 with four times the steps is the reference: 256 times less error than itself, more than any other.
        gap = _rows(loop, rates, start, end, steps, 1) - _rows(reference, rates, start, end, steps, 4)
        return float(np.max(np.abs(gap)))

    first = max(1, round(end / step))
    found = error(first)
    guess = first * (found / wish) ** (1 / scheme.order) if found > wish else first
    if guess > MOST_STEPS:
        spent = guess * seconds(lambda: loop(0.0, 1000, end / 1000, *start), repeats=1) / 1000
        raise InputError(
            f"{scheme.title} would need about {guess:.2g} steps for an error of {wish:g}, about {_duration(spent)} "
            f"for the march alone (at most {MOST_STEPS} steps are searched). Take a scheme of higher order: --scheme rk4."
        )
    steps, reached = _smallest(error, first, found, int(guess), wish)
    return Need(scheme.title, steps, steps * scheme.slopes, reached)


def _smallest(error: Callable[[int], float], first: int, found: float, guess: int, wish: float) -> tuple[int, float]:
    """Return the smallest number of steps under the wish and its error: bracket it, then halve."""
    known = {first: found}

    def at(steps: int) -> float:
        if steps not in known:
            known[steps] = error(steps)
        return known[steps]

    high = max(guess, 1)
    while at(high) > wish:
        high = int(high * 1.3) + 1
        if high > 2 * MOST_STEPS:
            raise InputError(
                f"an error of {wish:g} is not reached with {MOST_STEPS} steps; ask for more, or take a better scheme."
            )
    low = high
    while low > 1 and at(low) <= wish:
        high, low = low, max(1, int(low / 1.3))
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if at(middle) <= wish else (middle, high)
    return high, at(high)


def _rows(loop: Loop, rates: Rates, start: Sequence[float], end: float, steps: int, inner: int) -> Array:
    h = end / steps
    q = tuple(start)
    rows = [q]
    for index in range(steps):
        try:
            length = min(h, rates.latest((index + 1) * h) - index * h)
            q = loop(index * h, inner, length / inner, *q)
        except (ArithmeticError, ValueError):
            return np.full((steps + 1, len(q)), np.inf if inner == 1 else 0.0)
        rows.append(q)
    return np.array(rows)


def _duration(value: float) -> str:
    return f"{value / 3600:.1f} h" if value > 5400 else f"{value / 60:.1f} min" if value > 90 else f"{value:.0f} s"
