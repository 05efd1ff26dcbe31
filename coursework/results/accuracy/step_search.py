"""The smallest number of steps that keeps the error under a wish, and the numbers that better schemes need.

Enters: a scene and a wished error (rad or m, maximum over the scheme's own rows).  Leaves: `StepChoice`.
Raises `InputError` if the search or the run would take minutes, and says how long.
Used by `api.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from coursework.motion.geometry.drives.drive import resolution
from coursework.motion.integration.exact_motion import refine
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import PRECISE, SCHEMES, Scheme, title_of
from coursework.results.accuracy.step_rules import StepRules
from coursework.results.accuracy.timing import seconds
from coursework.results.accuracy.trace import trace
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import MAX_ROWS
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

# If a number of steps fails, it is raised by this share of itself, then by twice this share, three times …
_FINER = 0.1
# The same limit as for the rows of a table.
MOST_STEPS = MAX_ROWS
# Number of trials in a search; number of steps in the trial that predicts their time.
_TRIALS, _SAMPLE = 8, 1000
# Up to this multiple of the coursework's own steps, a prediction of too many steps is tested once more.
_COARSE = 8
# From this many steps on the precise scheme is far better than one of lower order even with the same steps.
_FINE = 1000
# If the drive needs stretches shorter than 1/_SUDDEN of a step, equal steps are no reference.
_SUDDEN = 4
# Round-off of the precise scheme in doubles grows to 1e-13; a wished error must be well above what can be resolved.
LEAST_ERROR = 1e-10


@frozen
class Need:
    """What one scheme needs: `steps` of h = end/steps, `evaluations`, and the `error` reached.

    `ruled`: fewer steps would reach the wished error, but would break the rules of a table.
    """

    title: str
    steps: int
    evaluations: int
    error: float
    ruled: bool = False


@frozen
class StepChoice:
    """The chosen `step` (s) of the scheme asked for, its `need`, and the `others`, cheapest first."""

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
        for other in self.others:
            known = {"scheme": other.title, "steps": other.steps, "evaluations": other.evaluations}
            told.append(say("steps.other", **known, fewer=own.evaluations / other.evaluations))
        return tuple(told)


def choose_step(
    rates: Rates, scheme: str, start: Sequence[float], step: float, end: float, wish: float,
    rules: StepRules | None = None, runs: Callable[[str, float], bool] = lambda scheme, step: True,
) -> StepChoice:  # fmt: skip
    """Return the largest step end/N whose error over its N + 1 rows stays under `wish`, and that keeps the `rules`.

    `runs(scheme, step)` makes a run of the table with a step; a step whose run does not reach its end is not advised.
    """
    if not (np.isfinite(wish) and wish >= LEAST_ERROR):
        raise InputError(say("fault.C019", wish=wish, least_error=LEAST_ERROR))

    def search(name: str) -> _Search:
        return _Search(SCHEMES[name], rates, tuple(start), step, end, wish, rules or StepRules(), runs)

    own: Need | TooLong
    try:
        own = search(scheme).need(MOST_STEPS)
    except TooLong as refused:
        own = refused
    # Only a scheme of the same or a higher order can be cheaper, and only a cheaper one is worth a search.
    rivals = [rival for name, rival in SCHEMES.items() if name != scheme and rival.order >= SCHEMES[scheme].order]
    others = []
    for rival in rivals:
        with suppress(TooLong):
            most = MOST_STEPS if isinstance(own, TooLong) else (own.evaluations - 1) // rival.slopes
            others.append(search(rival.name).need(most))
    others.sort(key=lambda need: need.evaluations)
    if isinstance(own, TooLong):
        cheaper = [say("steps.enough", scheme=other.title, steps=other.steps) for other in others]
        advice = say("steps.take", cheaper=joined(cheaper, "join.semicolon")) if cheaper else say("steps.ask_more")
        raise InputError(say("fault.C020", refused=search(scheme).refused(own.steps), advice=advice))
    return StepChoice(end / own.steps, own, tuple(others))


class TooLong(Exception):
    """The wish needs so many `steps` that it would take minutes."""

    def __init__(self, steps: float) -> None:
        super().__init__(steps)
        self.steps = steps


@dataclass(frozen=True)
class _Search:
    """The search for one scheme's number of steps; `rules` and `runs` are further conditions besides the wish."""

    scheme: Scheme
    rates: Rates
    start: tuple[float, ...]
    step: float
    end: float
    wish: float
    rules: StepRules
    runs: Callable[[str, float], bool]
    found: dict[int, float] = field(default_factory=dict)  # number of steps tried -> its error

    def need(self, most: int) -> Need:
        """Return the fewest steps that keep the wish and the rules and whose run works.  Raises `TooLong` beyond `most` steps."""
        fewest = self.fewest()
        steps = self.rules.rounded(fewest)
        part = _FINER
        while steps <= most:
            if self.error(steps) <= self.wish and self.runs(self.scheme.name, self.end / steps):
                # Without a row at a break some fewer steps may do as well.
                ruled = steps > fewest or (self.rules.pace > 1 and self.error(steps - 1) <= self.wish)
                return Need(title_of(self.scheme), steps, steps * self.scheme.slopes, self.error(steps), ruled)
            steps = self.rules.rounded(steps + math.ceil(part * steps))
            part += _FINER
        raise TooLong(steps)

    def fewest(self) -> int:
        """Return the smallest number of steps whose error is under the wish, with a row at each break.  Raises `TooLong`."""
        pace, most = self.rules.pace, MOST_STEPS // self.rules.pace
        parts = first = min(max(1, round(self.end / self.step / pace)), most)
        low, high = 0, most + 1  # the error is above the wish at `low`, not at `high`; neither end is computed
        while high - low > 1:
            error = self.error(parts * pace)
            if not np.isfinite(error):
                guess = 2.0 * parts
            else:
                guess = parts * (error / self.wish) ** (1 / self.scheme.order) if error > 0 else 1.0
            if error <= self.wish:
                high = parts
                parts = min(high - 1, max(low + 1, math.floor(guess)))
            else:
                low = parts
                if guess > 1.3 * most:
                    if parts > _COARSE * first:
                        raise TooLong(guess * pace)
                    guess = min(_COARSE * 2 * first, most)  # coarse steps predict little: look once more
                parts = max(low + 1, min(high - 1, math.ceil(guess)))
        return high * pace

    def error(self, steps: int) -> float:
        """Return the largest error (rad or m) over all rows of a run with `steps` steps."""
        if steps not in self.found:
            self.found[steps] = self.measured(steps)
        return self.found[steps]

    def measured(self, steps: int) -> float:
        """Return the error, measured afresh."""
        rows = self.rows(self.scheme, steps, 1)
        if resolution(self.rates.equations, self.end).shorter(self.end / steps / _SUDDEN)[0].size:
            with suppress(ArithmeticError, ValueError):
                exact = refine(self.rates, self.start, np.arange(steps + 1).astype(np.float64) * (self.end / steps))[0]
                return float(np.max(np.abs(rows - exact)))
            return np.inf
        # The reference is the precise scheme with four times the steps: its error is 256 times smaller than with the same steps.
        parts = 1 if steps >= _FINE and self.scheme.order < PRECISE.order else 4
        return float(np.max(np.abs(rows - self.rows(PRECISE, steps, parts))))

    def rows(self, scheme: Scheme, steps: int, inner: int) -> Array:
        """Return the rows of `steps` steps, each made by `inner` steps of a scheme; without any, nothing is near them."""
        try:
            return trace(scheme, self.rates, self.start, self.end / steps, range(steps + 1), inner)
        except (ArithmeticError, ValueError):
            return np.full((steps + 1, len(self.start)), np.inf if inner == 1 else 0.0)

    def refused(self, steps: float) -> Sentence:
        """Return the sentence that `steps` are more than can be tried, and how long they would take."""
        spent = _TRIALS * steps / _SAMPLE * seconds(lambda: self.measured(_SAMPLE), repeats=1, shortest=0.0)
        return say(
            "steps.too_long", scheme=title_of(self.scheme), steps=float(steps), wish=self.wish, most=MOST_STEPS,
            duration=_duration(spent),
        )  # fmt: skip


def _duration(value: float) -> Sentence:
    if value > 5400:
        return say("steps.hours", value=value / 3600)
    return say("steps.minutes", value=value / 60) if value > 90 else say("steps.seconds", value=value)
