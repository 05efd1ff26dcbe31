"""The smallest number of steps that keeps the error under a wish, and what the better schemes would need.

Enters: a scene and a wished error (rad or m, maximum over the scheme's own rows).  Leaves: `StepChoice`.
Raises `InputError` where the search or the run would take minutes, and says how long.
Used by `commands/run.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.accuracy.step_rules import StepRules
from coursework.accuracy.timing import seconds
from coursework.errors import InputError
from coursework.integration.loops import Loop, generate_loop
from coursework.integration.rates import Rates
from coursework.schemes import PRECISE, SCHEMES
from coursework.sentences import Sentence, joined, say, title_of
from coursework.variant.record import MAX_ROWS

Array = NDArray[np.float64]
# Where a number of steps does not do, so much of itself more is tried.
_FINER = 10
# As many as a table has rows.
MOST_STEPS = MAX_ROWS
# Trials of a search, and the steps of the one from which the time of all is foretold.
_TRIALS, _SAMPLE = 8, 1000
# So many times the coursework's own steps tell by their order how many a wish needs.
_COARSE = 8
# Round-off of the precise scheme in doubles grows to 1e-13; a wish must stay well above what can be told apart.
LEAST_ERROR = 1e-10


@dataclass(frozen=True, slots=True)
class Need:
    """What one scheme needs: `steps` of h = end/steps, `evaluations`, the `error` reached.

    `ruled`: fewer steps would have done for the wish, but not for the rules of a table.
    """

    title: str
    steps: int
    evaluations: int
    error: float
    ruled: bool = False


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
        told = [say("steps.own", scheme=own.title, steps=own.steps, step=self.step, error=own.error, evaluations=own.evaluations)]
        if own.ruled:
            told.append(say("steps.ruled"))
        told += [
            say(
                "steps.other",
                scheme=other.title,
                steps=other.steps,
                evaluations=other.evaluations,
                fewer=own.evaluations / other.evaluations,
            )
            for other in self.others
            if other.evaluations < own.evaluations
        ]
        return tuple(told)


def choose_step(
    rates: Rates, scheme: str, start: Sequence[float], step: float, end: float, wish: float,
    rules: StepRules | None = None, runs: Callable[[str, float], bool] = lambda scheme, step: True,
) -> StepChoice:  # fmt: skip
    """Return the largest step end/N whose error over its N + 1 rows stays under `wish`, and that keeps the `rules`.

    `runs(scheme, step)` tries a run of the table with a step: what does not reach its end is not advised.
    """
    if not (np.isfinite(wish) and wish >= LEAST_ERROR):
        raise InputError(say("fault.C019", wish=wish, least_error=LEAST_ERROR))
    trial = _Trial(rules or StepRules(), runs)
    # Only a scheme of the same or a higher order can be cheaper; those are asked first, because they take no time.
    rivals = [name for name, rival in SCHEMES.items() if name != scheme and rival.order >= SCHEMES[scheme].order]
    others = []
    for name in rivals:
        with suppress(TooLong):
            others.append(_need(name, rates, start, step, end, wish, trial))
    others.sort(key=lambda need: need.evaluations)
    try:
        own = _need(scheme, rates, start, step, end, wish, trial)
    except TooLong as refused:
        cheaper = [say("steps.enough", scheme=other.title, steps=other.steps) for other in others]
        advice = say("steps.take", cheaper=joined(cheaper, "join.semicolon")) if cheaper else say("steps.ask_more")
        raise InputError(say("fault.C020", refused=refused.message, advice=advice)) from None
    return StepChoice(end / own.steps, own, tuple(others))


@dataclass(frozen=True, slots=True)
class _Trial:
    """What a number of steps must keep besides the wish."""

    rules: StepRules
    runs: Callable[[str, float], bool]


class TooLong(Exception):
    """What was wished for would take minutes; the sentence says how long."""

    def __init__(self, message: Sentence) -> None:
        super().__init__(message)
        self.message = message


def _need(name: str, rates: Rates, start: Sequence[float], step: float, end: float, wish: float, trial: _Trial) -> Need:
    scheme = SCHEMES[name]
    loop, reference = generate_loop(scheme, rates), generate_loop(PRECISE, rates)

    def error(steps: int) -> float:
        # The precise scheme with four times the steps is the reference: 256 times less error than itself, more than any other.
        gap = _rows(loop, rates, start, end, steps, 1) - _rows(reference, rates, start, end, steps, 4)
        return float(np.max(np.abs(gap)))

    def too_long(steps: float) -> TooLong:
        spent = _TRIALS * steps / _SAMPLE * seconds(lambda: error(_SAMPLE), repeats=1)
        needed = {"scheme": title_of(scheme), "steps": float(steps), "wish": wish, "most": MOST_STEPS}
        return TooLong(say("steps.too_long", **needed, duration=_duration(spent)))

    first = min(max(1, round(end / step)), MOST_STEPS)
    low, high = 0, MOST_STEPS + 1  # errors at `low` are above the wish, at `high` not; neither end is computed
    steps = first
    found = {}
    while high - low > 1:
        found[steps] = error(steps)
        if not np.isfinite(found[steps]):
            guess = 2.0 * steps
        else:
            guess = steps * (found[steps] / wish) ** (1 / scheme.order) if found[steps] > 0 else 1.0
        if found[steps] <= wish:
            high = steps
            steps = min(high - 1, max(low + 1, math.floor(guess)))
        else:
            low = steps
            if guess > 1.3 * MOST_STEPS:
                if steps > _COARSE * first:
                    raise too_long(guess)
                guess = min(_COARSE * 2 * first, MOST_STEPS)  # coarse steps foretell little: look once more
            steps = max(low + 1, min(high - 1, math.ceil(guess)))
    steps = trial.rules.rounded(high)
    while steps <= MOST_STEPS:
        found[steps] = found[steps] if steps in found else error(steps)
        if found[steps] <= wish and trial.runs(name, end / steps):
            break
        steps = trial.rules.rounded(steps + math.ceil(steps / _FINER))
    else:
        raise too_long(steps)
    return Need(title_of(scheme), steps, steps * scheme.slopes, found[steps], ruled=steps > high)


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


def _duration(value: float) -> Sentence:
    if value > 5400:
        return say("steps.hours", value=value / 3600)
    return say("steps.minutes", value=value / 60) if value > 90 else say("steps.seconds", value=value)
