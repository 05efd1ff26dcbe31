"""The step that would be fine enough: it is run before it is advised.

Enters: `Evidence` and findings, some of them COARSE.  Leaves: the same findings with a step, and a sentence of advice.
Used by `check.py`, which supplies the judge of a motion.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.motion.integration.finer import finer
from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import SCHEMES, title_of
from coursework.results.checks.close_to_motion.rows import parts_at_breaks
from coursework.results.checks.close_to_motion.stiffness import Stiff, stiff
from coursework.results.checks.computed_right.divided import divisions
from coursework.results.checks.evidence import LIMIT, Evidence
from coursework.results.checks.result import Finding, percent
from coursework.system.frozen import frozen
from coursework.variant.record.variant import MAX_ROWS, whole_steps
from coursework.variant.record.vocabulary import EXACT, scheme_names
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

Judge = Callable[[Evidence], Sequence[Finding]]
# Share aimed at with the next step: a coarse table is further off than its order says, and each trial costs a march.
AIM = 0.8 * LIMIT
# Largest number of steps tried; the first is enough in nine cases of ten.
_TRIES = 12
# An error of this many scales or more follows no order.
_WILD = 10.0
# Largest N of a step 2h/N.
_LARGEST_PART = 999
# An error this many times smaller than the order predicts may be luck.
_LUCK = 4.0
# Largest work of an advised step, in slopes made of formulas: some three seconds.
_MOST_WORK = 3e6


@frozen
class Advice:
    """What to take instead of a coarse step.

    `option` and `step` (s) are for --step, "" and None if no step was found.  `scheme` is a scheme that is accurate enough at the
    run's own step, `share` the error of its table.  `jumped` is a finer step that was tried and is worse, with its share.
    """

    option: str
    step: float | None
    scheme: str
    share: float
    jumped: tuple[str, float] | None = None

    @property
    def sentence(self) -> Sentence:
        """Return the advice in words."""
        better = ""
        if self.scheme:
            title = title_of(SCHEMES[self.scheme])
            better = say("advice.scheme", scheme=self.scheme, title=title, share=percent(self.share))
        if self.step is None:
            return say("advice.take", what=better)
        key = "advice.step_seconds" if "h" in self.option else "advice.step"
        finer = say(key, option=self.option, step=self.step)
        take = say("advice.take", what=joined([finer, better], "advice.or"))
        if self.jumped is None:
            return take
        option, share = self.jumped
        return joined([take, say("advice.jumps", option=option, share=percent(share))])


def with_advice(evidence: Evidence, found: Iterable[Finding], judge: Judge) -> list[Finding]:
    """Return the findings; those a finer step cures get that step as advice, after a trial run judged by `judge`."""
    listed = list(found)
    if not any(map(_curable, listed)) or evidence.restricted or evidence.stop is not None:
        return listed
    if any(one.is_own for one in divisions(evidence)):  # a table leaves the motion there with any step
        return listed
    found_stiff = stiff(evidence)
    advice = _advice(evidence, [one for one in listed if _curable(one)], judge, found_stiff)
    if found_stiff is not None:
        place = next(place for place, one in enumerate(listed) if _curable(one))
        told = joined([listed[place].sentence, found_stiff.sentence])
        listed[place] = replace(listed[place], sentence=told, headline=found_stiff.sentence)
    if advice is None:
        return listed
    option = f"--step {advice.option}" if advice.option else f"--scheme {advice.scheme}"
    taken: dict[str, Any] = {"step": advice.step, "option": option, "scheme": advice.scheme, "advised": advice.sentence}
    return [replace(one, sentence=joined([one.sentence, advice.sentence]), **taken) if _curable(one) else one for one in listed]


def _curable(finding: Finding) -> bool:
    return finding.verdict == "COARSE" and finding.cured and (finding.group == "motion" or finding.code == "STOP")


def _advice(evidence: Evidence, coarse: list[Finding], judge: Judge, found: Stiff | None) -> Advice | None:
    own = evidence.motion.scheme
    if evidence.rerun is None or not len(evidence.exact.t) or own not in scheme_names():
        return None
    scheme, share = _better_scheme(evidence, own, judge)
    parts, jumped = _step(evidence, own, coarse, judge, found.parts(evidence.motion.step) if found else 1)
    if not parts:
        return Advice("", None, scheme, share) if scheme else None
    option, step = _spelled(evidence, parts)
    return Advice(option, step, scheme, share, jumped)


def _better_scheme(evidence: Evidence, own: str, judge: Judge) -> tuple[str, float]:
    """Return the scheme of highest order and its error, if it is accurate enough at the run's own step; "" and 0 if not."""
    assert evidence.rerun is not None
    best = max(SCHEMES, key=lambda name: SCHEMES[name].order)
    if own == EXACT or SCHEMES[best].order <= SCHEMES[own].order:
        return "", 0.0
    if (tried := _tried(evidence, best, 1, evidence.rerun(best, evidence.motion.step))) is None:
        return "", 0.0
    findings = judge(tried)
    closeness = next((one.value for one in findings if one.code == "ACCURACY"), None)
    return (best, closeness) if closeness is not None and not any(map(_curable, findings)) else ("", 0.0)


def _step(evidence: Evidence, own: str, coarse: list[Finding], judge: Judge, fewest: int) -> tuple[int, tuple[str, float] | None]:
    """Return the parts of the step, `fewest` or more, with which every motion check passes; 0 if that takes too many rows.

    A step that does better than the order of the scheme predicts may do so by chance: then finer ones must pass too.  If one does
    not, the search goes on from there, and that step is returned with its share.
    """
    assert evidence.rerun is not None
    order = SCHEMES[own].order if own in SCHEMES else 1  # exact rows have no error: what they lack comes with more rows
    parts, jumped = 1, None
    known = next((one.value for one in coarse if one.code == "ACCURACY" and one.value), 0.0)
    for _ in range(_TRIES):
        needed = max(parts + 1, fewest, math.ceil(parts * max(_growth(one, order) for one in coarse)))
        before, parts = parts, needed if own == EXACT else parts_at_breaks(evidence, needed) or needed
        if not _affordable(evidence, parts, order):
            return 0, None
        motion = None if own == EXACT else evidence.rerun(own, _spelled(evidence, parts)[1])
        expected = known * (before / parts) ** order
        if motion is None and own != EXACT:  # this step is still so large that its rows end early
            known, coarse = expected, [Finding("COARSE", "")]
            continue
        known = share = _glanced(evidence, motion, parts) if motion is not None else 0.0
        if share > LIMIT:
            coarse = [Finding("COARSE", "", share, LIMIT)]
            continue
        tried = _tried(evidence, own, parts, motion)
        if tried is None:
            return 0, None  # there is no exact motion to judge it against, and more rows would not help
        coarse = [one for one in judge(tried) if _curable(one)]
        if coarse:
            continue
        worse = None if motion is None or share > expected / _LUCK else _worse(evidence, own, parts, order)
        if worse is None:
            return parts, jumped
        parts, known = worse
        jumped, coarse = (_spelled(evidence, parts)[0], known), [Finding("COARSE", "", known, LIMIT)]
    return 0, None


def _worse(evidence: Evidence, own: str, parts: int, order: int) -> tuple[int, float] | None:
    """Return a finer step (in parts of the run's own) that fails although `parts` pass, and its share; None if none does."""
    assert evidence.rerun is not None
    for more in (2 * parts, 3 * parts):
        if not _affordable(evidence, more, order):
            return None
        motion = evidence.rerun(own, _spelled(evidence, more)[1])
        share = _glanced(evidence, motion, more) if motion is not None else 0.0
        if share > LIMIT:
            return more, share
    return None


def _affordable(evidence: Evidence, parts: int, order: int) -> bool:
    rows = evidence.variant.time.end / evidence.motion.step * parts
    return rows <= MAX_ROWS and rows * order * evidence.rates.weight <= _MOST_WORK


def _glanced(evidence: Evidence, motion: Motion, parts: int) -> float:
    """Return the largest error (share) of a finer table in the rows that the exact motion already has."""
    count = evidence.compared
    common = replace(
        motion, t=motion.t[::parts][:count], coordinates=motion.coordinates[::parts][:count],
        velocities=motion.velocities[::parts][:count],
    )  # fmt: skip
    return float(np.max(np.abs(replace(evidence, motion=common).errors), initial=0.0))


def _growth(finding: Finding, order: int) -> float:
    """Return the factor by which the step must be refined for a check to pass; 2 if its number does not say."""
    value, limit = finding.value, finding.limit
    if not value or not limit:
        return 2.0
    if finding.code == "STEP":
        return limit / value
    if finding.code == "PEAK":
        return value / limit
    # For a table that is off by more than the whole range of its column, the error does not tell by how much to refine.
    return float((min(value, _WILD) / AIM) ** (1 / order)) if limit == LIMIT else 2.0


def _tried(evidence: Evidence, scheme: str, parts: int, motion: Motion | None) -> Evidence | None:
    """Return the evidence about a `motion` with another scheme or a part of the step; None if that run failed.

    Exact rows are not made by a scheme: they are what a scheme would be judged against.
    """
    if motion is None and scheme != EXACT:
        return None
    step = evidence.motion.step if parts == 1 else _spelled(evidence, parts)[1]
    rows = whole_steps(step, evidence.variant.time.end) + 1
    exact = finer(evidence.exact, evidence.rates, parts, rows) if parts > 1 else evidence.exact
    motion = motion or exact
    if motion is None or exact is None:
        return None
    return replace(evidence, motion=motion, exact=exact, extended_precision=None, replay=None, rerun=None, is_trial=True)


def _spelled(evidence: Evidence, parts: int) -> tuple[str, float]:
    """Return a part of the run's step as --step takes it, and in seconds: h/N or, if that is shorter, 2h/N of the file's step."""
    step, own = evidence.motion.step / parts, evidence.variant.time.own_step or evidence.variant.time.step
    whole = round(own / step)
    if whole > 1 and abs(own / step / whole - 1) < 1e-12:
        return f"h/{whole}", own / whole
    from fractions import Fraction  # imported here, as few runs have such a step

    share = Fraction(step / own).limit_denominator(_LARGEST_PART)
    exact = own * share.numerator / share.denominator
    named = f"{share.numerator}h/{share.denominator}" if share.denominator > 1 else repr(exact)
    return (named, exact) if abs(exact / step - 1) < 1e-12 and len(named) < len(repr(step)) else (repr(step), step)
