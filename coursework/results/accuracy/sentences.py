"""What a study says to a student, in sentences computed from its rows.

Enters: rows and orders.  Leaves: sentences.  Used by `study.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE, SCHEMES, title_of
from coursework.results.accuracy.methods import projected_title
from coursework.results.accuracy.record import StudyRow
from coursework.results.accuracy.trace import SETTLED, are_odd, local_slopes
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# A better scheme has at most this share of Euler's error.
_BETTER = 0.95
# Round-off of one step (rad or sizes of the mechanism); in many steps it grows as the square root of their number (N. J. Higham,
# Accuracy and Stability of Numerical Algorithms, section 2.8).
_UNIT = 2.0**-53
# The smallest measurable error, in round-offs of one step.
ROUNDINGS = 64
_HUNDRED = math.radians(99.5)


def sentences_of(
    rows: Sequence[StudyRow], orders: Mapping[str, float], end_orders: Mapping[str, float], own: StudyRow, floor: float,
    *, is_own: bool = True,
) -> tuple[str, ...]:  # fmt: skip
    """Return the findings: the own step, the better scheme at the same step, the cost of equal accuracy, the end-row trap.

    `is_own` is False for a table with corrected drift that no trial matches; `own` is then its scheme without the correction.
    The last row says nothing about errors below the round-off `floor` (a share).
    """
    best = _first(rows, title_of(PRECISE))
    usual = _first(rows, title_of(DEFAULT_SCHEME))
    first = {"steps": own.steps_or_tolerance, "method": own.method, "size": _size(own.max_error, own.unit)}
    told = [_told("study.own", _time(own), **first) if is_own else say("study.uncorrected", **first)]
    told += _of_best(rows, best, usual)
    for row in _finished(rows, projected_title(1))[:1]:
        found = {"steps": row.steps_or_tolerance, "size": _size(row.max_error, row.unit)}
        if row.share <= math.sqrt(row.evaluations) * _UNIT and row.share < usual.share:
            told.append(say("study.projected_exactly", **found))
        elif row.share < usual.share:
            told.append(say("study.with_projection", **found, less=_times_less(row, usual)))
    for row in _finished(rows, say("study.closed")):
        cost = {"evaluations": row.evaluations, "more": _round(row.evaluations / best.evaluations)}
        size = _size(row.max_error, row.unit)
        told.append(_told("study.by_closure", _ratio(row, best), **_reached(best), **cost, size=size))
    understated = usual.max_error / max(usual.end_error, 1e-300)
    if understated >= 1.1 and usual.share > floor and usual.end_unit == usual.unit:  # an angle is no multiple of a length
        told.append(say("study.end_row", size=_size(usual.end_error, usual.end_unit), less=_round(understated)))
    titles = [title_of(scheme) for scheme in SCHEMES.values()]
    seeming = {name: end_orders[name] for name, order in orders.items() if end_orders.get(name, order) - order > 0.5}
    methods = tuple(
        say("study.seeming", method=name, seeming=high, order=orders[name]) for name, high in seeming.items() if name in titles
    )
    if methods:
        told.append(say("study.end_order", methods=methods))
    return tuple(told)


def _of_best(rows: Sequence[StudyRow], best: StudyRow, usual: StudyRow) -> list[Sentence]:
    """Return how much better than Euler the better scheme is with the same steps, and what its accuracy would cost Euler."""
    reached, size = _reached(best), _size(best.max_error, best.unit)
    if not best.share < _BETTER * usual.share:  # also for nan
        return [say("study.no_better", **reached, size=size)]
    gain = {"less": _times_less(best, usual), "more": best.evaluations / usual.evaluations}
    told = [_told("study.best", _ratio(best, usual), **reached, **gain, size=size)]
    if reaching := _steps_for(rows, best.share):
        steps, within = reaching
        needed = _round(steps)
        if within:
            needed = say("study.between", needed=needed, low=_whole(within[0]), high=_whole(within[1]))
        if math.sqrt(steps) * _UNIT > best.share:
            told.append(say("study.never", **reached, needed=needed))
        else:
            more, time = _round(steps / best.evaluations), _predicted(rows, steps, best)
            told.append(_told("study.equal", time, **reached, needed=needed, more=more))
    return told


def _reached(best: StudyRow) -> dict[str, str]:
    return {"steps": best.steps_or_tolerance, "method": best.method}


def unsettled(rows: Sequence[StudyRow], floor: float, *, broken: bool = False) -> tuple[str, ...]:
    """Return the finding that schemes show no order: their local slopes differ, or no errors are small enough.

    `broken`: the drive changes its formula inside a step of every run, which spoils the order of a scheme.
    """
    told = []
    for scheme in SCHEMES.values():
        own = _finished(rows, title_of(scheme))
        if own and own[-1].share <= own[-1].evaluations * floor / ROUNDINGS:
            continue  # the round-off of the steps grows with their number
        local = local_slopes([row.evaluations for row in own], [row.share for row in own], floor)
        is_odd = are_odd(local, scheme.order)
        if len(local) > 1 and (is_odd or abs(local[-1] - local[-2]) > SETTLED):
            told.append(say("study.slopes", method=title_of(scheme), first=local[-2], last=local[-1]))
        elif is_odd:
            told.append(say("study.one_slope", method=title_of(scheme), slope=local[0]))
        elif not local and len(own) > 1 and own[-1].share > 10 * floor:
            told.append(say("study.no_slope", method=title_of(scheme)))
    return (say("study.broken" if broken else "study.unsettled", methods=tuple(told)),) if told else ()


def _first(rows: Sequence[StudyRow], method: str) -> StudyRow:
    return next(row for row in rows if row.method == method)


def _finished(rows: Sequence[StudyRow], method: str) -> list[StudyRow]:
    return [row for row in rows if row.method == method and not row.failed]


def _steps_for(rows: Sequence[StudyRow], share: float) -> tuple[float, tuple[int, int] | None] | None:
    """Return the Euler steps that reach an error of `share`, interpolated on logarithms, and the two runs between which they lie.

    Beyond the finest run the error is assumed to fall as 1/steps; there the second value is None.  None if no run reaches
    it.
    """
    usual = _finished(rows, title_of(DEFAULT_SCHEME))
    last = usual[-1]
    if 0 < share < last.share:
        return last.evaluations * last.share / share, None
    place = next((place for place, row in enumerate(usual) if row.share <= share), None)
    if place is None:
        return None
    fine, coarse = usual[place], usual[place - 1]
    if not place or not 0 < fine.share < coarse.share:
        return float(fine.evaluations), None
    part = math.log(coarse.share / share) / math.log(coarse.share / fine.share)
    steps = coarse.evaluations * (fine.evaluations / coarse.evaluations) ** part
    return steps, (coarse.evaluations, fine.evaluations)


def _times_less(row: StudyRow, other: StudyRow) -> str:
    """Return how many times smaller the error of `row` is than that of `other`."""
    return _round(other.share / row.share if row.share else math.inf)


def _told(key: str, time: dict[str, object], **values: object) -> Sentence:
    """Return a finding, with the time if it was measured."""
    return say(f"{key}.timed", **values, **time) if time else say(f"{key}.plain", **values)


def _size(value: float, unit: str) -> Sentence:
    if unit == "rad" and 1e-3 <= value < _HUNDRED:  # two digits of degrees
        return say("amount.angle", value=value, degrees=math.degrees(value))
    return say("amount.three", value=value, unit=unit)


def _round(value: float) -> str:
    """Return a number with two significant digits and narrow no-break spaces between thousands."""
    if not math.isfinite(value) or value <= 0:
        return say("amount.many")
    digits = max(0, math.floor(math.log10(value)) - 1)
    return _whole(round(value / 10**digits) * 10**digits) if value >= 10 else say("amount.bare", value=value)


def _whole(count: int) -> str:
    return f"{count:,}".replace(",", "\u202f")


def _time(row: StudyRow) -> dict[str, object]:
    return {"time": _clock(row.seconds)} if row.seconds is not None else {}


def _ratio(row: StudyRow, other: StudyRow) -> dict[str, object]:
    return {"longer": row.seconds / other.seconds} if row.seconds and other.seconds else {}


def _predicted(rows: Sequence[StudyRow], steps: float, best: StudyRow) -> dict[str, object]:
    finest = [row for row in rows if row.method == title_of(DEFAULT_SCHEME) and row.seconds][-1:]
    if not finest or not best.seconds or not finest[0].seconds:
        return {}
    spent = steps * finest[0].seconds / finest[0].evaluations
    return {"time": _clock(spent), "longer": _round(spent / best.seconds)}


def _clock(value: float) -> Sentence:
    for scale, unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= scale:
            return say("amount.whole" if value >= 10 * scale else "amount.two", value=value / scale, unit=unit)
    return say("amount.two", value=value / 1e-9, unit="ns")
