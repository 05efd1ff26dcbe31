"""The distance of a table from the exact motion, in numbers that several places of a page quote.

Enters: a `PageContext` whose run asks for checks.  Leaves: `Split`, `LocalError`, sentences.
Used by `answer.py`, `results.py`, `conclusion.py`, `structure.py`, `tangent.py`.
For an exact table, the scheme's rows that stand beside it are judged.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from coursework.motion.schemes import DEFAULT_SCHEME, SCHEMES, title_of
from coursework.report.text.page_context import PageContext
from coursework.results.checks.close_to_motion.period import Split, mismatch
from coursework.results.checks.close_to_motion.rows import off_row
from coursework.results.checks.evidence import LIMIT, Evidence, worst
from coursework.results.checks.result import percent
from coursework.system.frozen import frozen

SEEN = 1e-9  # parts of the scale of a column: a smaller error is not mentioned
ON_THE_CURVE = 1e-12  # limit of `share` for one step: a smaller gap is only round-off


@frozen
class LocalError:
    """The Euler step that leaves the exact curve most: it begins in `row` (from 1) and misses `column` by `gap` (SI).

    `rate_name` is the rate of `column`; `share` is the gap in rad, or in parts of the column's scale for a length.
    """

    column: str
    rate_name: str
    unit: str
    row: int
    gap: float
    share: float

    @property
    def is_round_off(self) -> bool:
        """Return whether the gap is only round-off, because the curve does not bend and every step ends on it."""
        return self.share < ON_THE_CURVE


def evidence(context: PageContext) -> Evidence:
    """Return the rows of a scheme together with the exact ones."""
    return context.run.results.by_scheme.evidence


def rows_before_breaks(judged: Evidence) -> list[int]:
    """Return the rows (from 0) after which the drive changes its formula before the next row."""
    return [int(time / judged.motion.step) for time in off_row(judged.variant, judged.motion.step)]


def splits(context: PageContext) -> tuple[Split, ...]:
    """Return last minus first row for every column of the table itself; empty if the run reaches no full period."""
    return mismatch(context.run.results.evidence) or ()


def turns_taken_off(context: PageContext, found: Iterable[Split]) -> str:
    """Return the sentence that names the whole turns not counted as a difference, by column; "" if there are none."""
    say, numbers = context.words, context.numbers
    turned = [say("first_last.turns", symbol=context.lettering(s.name), turns=numbers.signed(s.turns)) for s in found if s.turns]
    return say("first_last.taken_off", turned=say("join.semicolon").join(turned)) if turned else ""


def unreturned(context: PageContext) -> list[Split]:
    """Return the columns, including driven ones, whose last row differs from the first by more than round-off."""
    return [split for split in splits(context) if context.numbers.without_noise(split.total, split.first)]


def largest_error_sentence(context: PageContext) -> str:
    """Return the sentence on the scheme's largest error, measured as the verdict measures it; "" if there is none to report."""
    found, say, numbers = evidence(context), context.words, context.numbers
    if not found.compared or len(found.motion.t) > found.compared or not found.names:
        return ""
    share, name, row, off = _largest(context, found)
    if share <= SEEN:
        return ""
    unit = found.unit(name)
    amount = context.with_unit(numbers.scalar(off, 3), unit)
    if unit == "rad":
        degrees = context.with_unit(numbers.scalar(math.degrees(off), 2), "°")
        amount = say("result.angle", amount=amount, degrees=degrees)
    is_beside = context.run.tableau is None  # the table is exact: no scheme has made its rows
    is_own = SCHEMES.get(found.motion.scheme) is None or not is_beside
    title = context.told(context.run.scheme_title if is_own else title_of(DEFAULT_SCHEME))
    part = context.told(percent(share, LIMIT))
    where = say("result.where", amount=amount, symbol=context.lettering(name), row=row + 1, share=part)
    return say("result.error_beside" if is_beside else "result.error", scheme=title, errors=where)


def _largest(context: PageContext, found: Evidence) -> tuple[float, str, int, float]:
    """Return the largest error as a share of its scale, its column and row (from 0), and the error itself (SI)."""
    judged = (one for one in context.run.results.checks if one.code == "MOTION" and one.column and one.value is not None)
    if (own := next(judged, None)) is not None and own.row is not None:  # under forces a velocity is measured by its largest size
        name, row = own.column or "", own.row - 1
        return own.value or 0.0, name, row, abs(float(found.motion.column(name)[row] - found.exact.column(name)[row]))
    shares = np.abs(found.errors)
    row, place = worst(shares)
    share, name = float(shares[row, place]), found.names[place]
    return share, name, row, share * found.scale[name]


def largest_step_error(context: PageContext) -> LocalError | None:
    """Return the Euler step that leaves the exact curve most; None if that curve has fewer than two rows or no step leaves it.

    Steps in which the drive changes its formula do not count: their error comes from the old formula, not from the bend.
    """
    exact = evidence(context).exact
    if len(exact.t) < 2:
        return None
    worst: LocalError | None = None
    steps = np.diff(exact.t)
    judged = evidence(context)
    whole = np.isin(np.arange(len(steps)), rows_before_breaks(judged), invert=True)
    best = 0.0
    for coordinate in context.run.variant.coordinates:
        if coordinate.name not in exact.names or coordinate.rate not in exact.names or coordinate.name not in judged.scale:
            continue
        if coordinate.name not in context.stepped or coordinate.rate in context.run.variant.given_rates:
            continue
        q, rate = exact.column(coordinate.name), exact.column(coordinate.rate)
        gaps = np.where(whole, np.diff(q) - steps * rate[:-1], 0.0)
        row = int(np.argmax(np.abs(gaps)))
        share = abs(float(gaps[row])) / (1.0 if coordinate.unit == "rad" else judged.scale[coordinate.name])
        if share > best:
            best = share
            worst = LocalError(coordinate.name, coordinate.rate, coordinate.unit, row + 1, float(gaps[row]), share)
    return worst
