"""The distance of a table from the exact motion, in numbers that several places of a page quote.

Enters: a `PageContext` whose run asks for checks.  Leaves: `Split`, `LargestError`, `LocalError`.
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
from coursework.results.checks.evidence import Evidence
from coursework.system.frozen import frozen

SEEN = 1e-9  # parts of the scale of a column: a smaller error is not mentioned
ALIKE = 1e-4  # parts of the largest error: errors that differ by less are equal in the digits shown
ON_THE_CURVE = 1e-12  # limit of `share` for one step: a smaller gap is only round-off


@frozen
class LargestError:
    """The largest error of the coordinates of one unit: `value` (SI) of `column` in `row` (from 1), made by `scheme`."""

    scheme: str
    column: str
    unit: str
    value: float
    row: int

    def told(self, context: PageContext) -> dict[str, str]:
        """Return the words of the error that fill the gaps of a sentence."""
        amount = context.with_unit(context.numbers.scalar(self.value, 3), self.unit)
        if self.unit == "rad":
            degrees = context.with_unit(context.numbers.scalar(math.degrees(self.value), 2), "°")
            amount = context.words("result.angle", amount=amount, degrees=degrees)
        symbol = context.lettering(self.column)
        return {"amount": amount, "symbol": symbol, "row": str(self.row)}


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


def largest_errors(context: PageContext) -> list[LargestError]:
    """Return for each unit the largest error of its coordinates, without errors below `SEEN`.

    If several errors are equal in the digits shown, the first coordinate and its first row are named, as in the laboratory.
    """
    found = evidence(context)
    if not found.compared or found.exact is None or len(found.motion.t) > found.compared:
        return []
    scheme = SCHEMES.get(found.motion.scheme)
    title = context.told(_title(context, scheme is None or context.run.tableau is not None))
    sizes = np.abs(found.errors) * found.scales
    seen = [
        place
        for place, name in enumerate(found.names)
        if name in found.motion.coordinate_names and np.max(sizes[:, place]) > SEEN * found.scales[place]
    ]
    told = []
    for unit in dict.fromkeys(found.unit(found.names[place]) for place in seen):
        places = [place for place in seen if found.unit(found.names[place]) == unit]
        largest = float(np.max(sizes[:, places]))
        alike = sizes[:, places] >= (1 - ALIKE) * largest
        first = int(np.argmax(alike.any(axis=0)))
        told.append(LargestError(title, found.names[places[first]], unit, largest, int(np.argmax(alike[:, first])) + 1))
    return told


def largest_error_sentence(context: PageContext) -> str:
    """Return the sentence on the scheme's largest error for each unit, angles also in degrees; "" if there is none to report."""
    errors, say = largest_errors(context), context.words
    if not errors:
        return ""
    listed = say("join.semicolon").join(say("result.where", **error.told(context)) for error in errors)
    is_beside = context.run.tableau is None  # the table is exact: no scheme has made its rows
    return say("result.error_beside" if is_beside else "result.error", scheme=errors[0].scheme, errors=listed)


def _title(context: PageContext, own: bool) -> str:
    return context.run.scheme_title if own else title_of(DEFAULT_SCHEME)


def largest_step_error(context: PageContext) -> LocalError | None:
    """Return the Euler step that leaves the exact curve most; None if that curve has fewer than two rows or no step leaves it.

    Steps in which the drive changes its formula do not count: their error comes from the old formula, not from the bend.
    """
    exact = evidence(context).exact
    if exact is None or len(exact.t) < 2:
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
