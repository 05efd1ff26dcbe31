"""How far a table is from the motion, as numbers that several places of a page say.

Enters: a `PageContext` whose run asks for checks.  Leaves: `Split`, `LargestError`, `LocalError`.
Used by `answer.py`, `results.py`, `conclusion.py`, `structure.py`, `tangent.py`.
Of an exact table it speaks of the scheme's rows that stand beside it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from coursework.motion.schemes import SCHEMES, title_of
from coursework.report.text.page_context import PageContext
from coursework.results.checks.close_to_motion.period import Split, mismatch
from coursework.results.checks.close_to_motion.rows import off_row
from coursework.results.checks.evidence import Evidence
from coursework.system.frozen import frozen

SEEN = 1e-9  # of the scale of a column: a smaller error is none to speak of
ALIKE = 1e-4  # of the largest error: one that is less beside it is as large, to the digits shown
ON_THE_CURVE = 1e-12  # the same for one step, which leaves no more than round-off


@frozen
class LargestError:
    """The largest error of the coordinates of one unit: `value` (SI) of `column` in `row` (from 1), made by `scheme`."""

    scheme: str
    column: str
    unit: str
    value: float
    row: int

    def told(self, context: PageContext) -> dict[str, str]:
        """Return the error as words for a sentence."""
        amount = context.with_unit(context.numbers.scalar(self.value, 3), self.unit)
        if self.unit == "rad":
            degrees = context.with_unit(context.numbers.scalar(math.degrees(self.value), 2), "°")
            amount = context.words("result.angle", amount=amount, degrees=degrees)
        symbol = context.lettering(self.column)
        return {"amount": amount, "symbol": symbol, "row": str(self.row)}


@frozen
class LocalError:
    """The one step of Euler that leaves the curve most: from `row` (from 1) of the exact motion, `gap` (SI) of `column`.

    `share` is the gap in rad or in parts of the scale of the column.
    """

    column: str
    rate_name: str
    unit: str
    row: int
    gap: float
    share: float

    @property
    def is_round_off(self) -> bool:
        """Return whether the curve does not bend: every step ends on it."""
        return self.share < ON_THE_CURVE


def evidence(context: PageContext) -> Evidence:
    """Return rows of a scheme beside the exact ones."""
    return context.run.results.by_scheme.evidence


def rows_before_breaks(judged: Evidence) -> list[int]:
    """Return the rows (from 0) behind which the drive changes its formula before the next."""
    return [int(time / judged.motion.step) for time in off_row(judged.variant, judged.motion.step)]


def splits(context: PageContext) -> tuple[Split, ...]:
    """Return last minus first row of every column of the table itself, nothing where the run reaches no period."""
    return mismatch(context.run.results.evidence) or ()


def turns_taken_off(context: PageContext, found: Iterable[Split]) -> str:
    """Return that whole turns are no difference, and how many of which column; "" where none of them made any."""
    say, numbers = context.words, context.numbers
    turned = [say("first_last.turns", symbol=context.lettering(s.name), turns=numbers.signed(s.turns)) for s in found if s.turns]
    return say("first_last.taken_off", turned=say("join.semicolon").join(turned)) if turned else ""


def unreturned(context: PageContext) -> list[Split]:
    """Return the columns, driven ones too, whose last row is not the first, by more than round-off."""
    return [split for split in splits(context) if context.numbers.without_noise(split.total, split.first)]


def largest_errors(context: PageContext) -> list[LargestError]:
    """Return the largest error of the coordinates of each unit, those below `SEEN` left out.

    Of those alike to the digits shown the first coordinate is named, and its first row, as in the laboratory.
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
    """Return the scheme's largest error for each unit, with degrees; "" where none is known or to be seen."""
    errors, say = largest_errors(context), context.words
    if not errors:
        return ""
    listed = say("join.semicolon").join(say("result.where", **error.told(context)) for error in errors)
    is_beside = context.run.tableau is None  # no scheme has made the rows of the table
    return say("result.error_beside" if is_beside else "result.error", scheme=errors[0].scheme, errors=listed)


def _title(context: PageContext, own: bool) -> str:
    from coursework.motion.schemes import DEFAULT_SCHEME

    return context.run.scheme_title if own else title_of(DEFAULT_SCHEME)


def largest_step_error(context: PageContext) -> LocalError | None:
    """Return the step of Euler that leaves the exact curve most; None where no such curve is known over two rows.

    A step inside which the drive changes its formula is none: it leaves the curve by the old formula, not by its bend.
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
