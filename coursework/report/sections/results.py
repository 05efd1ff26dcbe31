"""The section of results: the table, its first row beside the last, and why they differ.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

from coursework.motion.schemes import SCHEMES, Scheme, title_of
from coursework.report.graphs.tangent import tangent_figure
from coursework.report.text.numbers import FEW_DIGITS, MOST_DECIMALS, deserved_decimals
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Column, Paragraph, Part, Table
from coursework.report.text.tables import motion_parts, pieces
from coursework.report.text.text_runs import begun, numeral, runs
from coursework.report.wording.closeness import (
    LocalError,
    evidence,
    largest_error_sentence,
    largest_step_error,
    rows_before_breaks,
    splits,
    turns_taken_off,
    unreturned,
)
from coursework.results.checks.close_to_motion.period import Split, is_a_period
from coursework.scene.quantities import CHECKS

ROWS = ("first", "last", "total")
CAUSES = ("scheme", "period")  # the two parts of a difference; exact rows have no part from a scheme, so none is shown
MOST_BESIDE_WORDS = 9  # columns beside a first column of words
SHORT = 2  # significant digits of a part that is too small for the decimals of its column
HARDLY = 1e-3  # parts of a difference: if the period causes less, its part is not mentioned
FINE = 1  # decimals of a difference beyond those of its column


def results(context: PageContext) -> list[Part]:
    """Return the table of the motion, thinned if long; then the first row beside the last, and why they differ."""
    parts = motion_parts(context)
    if not context.run.asks(CHECKS) or not len(context.run.motion.t):
        return parts
    found = [split for split in splits(context) if split.name not in context.run.variant.given_rates]
    parted = pieces([split.name for split in found], MOST_BESIDE_WORDS) if found else []
    for number, (first, last) in enumerate(parted, start=1):
        parts.append(_first_last(context, found[first:last], number, len(parted)))
    step = largest_step_error(context) if _scheme(context) is not None else None
    parts += _why(context, found, step)
    scheme = _scheme(context)
    bends = step is not None and not step.is_round_off
    if step and bends and scheme and scheme.slopes == 1 and (figure := tangent_figure(context, step)):
        parts.append(figure)
    return parts


def _scheme(context: PageContext) -> Scheme | None:
    return SCHEMES.get(evidence(context).motion.scheme)


def _first_last(context: PageContext, found: list[Split], number: int, many: int) -> Table:
    """Return table `number` of `many`: first row, last row, their difference and its parts, a column for each in `found`."""
    say, numbers, motion = context.words, context.numbers, context.run.motion
    row = context.run.results.evidence.period_row or 0
    heads = {
        "first": say("first_last.row", row=1, time=context.quantity(float(motion.t[0]), "s")),
        "last": say("first_last.row", row=row + 1, time=context.quantity(float(motion.t[row]), "s")),
        "total": say("first_last.total"),
        "scheme": say("first_last.scheme"),
        "period": say("first_last.period" if is_a_period(context.run.results.evidence) else "first_last.motion"),
    }
    parts = ROWS if context.run.tableau is None else ROWS + CAUSES
    decimals = {split.name: deserved_decimals(map(float, motion.column(split.name))) for split in found}
    rows: list[list[Cell]] = []
    for part in parts:
        cells: list[Cell] = [runs(heads[part])]
        for split in found:
            value = getattr(split, part) + (split.roundoff if part == "scheme" else 0.0)
            fine = 0 if part in {"first", "last"} else FINE
            shown = numbers.without_noise(value, split.first)
            few = decimals[split.name] > MOST_DECIMALS  # as in the table above
            text = numbers.scalar(shown, FEW_DIGITS) if few else numbers.fixed(shown, decimals[split.name] + fine, SHORT)
            cells.append(numeral(text))
        rows.append(cells)
    columns = [Column([], words=True)]
    columns += [Column(context.symbol_runs([split.name]), context.unit(split.unit)) for split in found]
    turned = turns_taken_off(context, found)
    which = say("table.part", part=number, parts=many) if many > 1 else ""
    of_row = "" if row == len(motion.t) - 1 else "_row"
    told = say(f"first_last.caption{of_row}" if parts != ROWS else f"first_last.caption_motion{of_row}", row=row + 1)
    caption = runs(say.sentences([told, which]))
    return Table(columns, rows, caption, strong=[2], note=runs(turned) if turned else [], id="first-last" if number == 1 else "")


def _why(context: PageContext, found: list[Split], step: LocalError | None) -> list[Part]:
    """Return the sentences on why the rows differ: exact rows, the tangent, half the step, the part of the period."""
    say, scheme = context.words, _scheme(context)
    told: list[str] = []
    if context.run.tableau is None and context.run.distance_to_exact is not None:
        told.append(say("why.exact", sentence=context.told(context.run.distance_to_exact.sentence)))
    if step is not None and step.is_round_off:
        told.append(say("why.straight"))
    elif step is not None and scheme is not None:
        gap = context.with_unit(context.numbers.scalar(abs(step.gap), 3), step.unit)
        values = {"symbol": context.lettering(step.column), "rate": context.lettering(step.rate_name), "gap": gap}
        values |= {"row": str(step.row), "next": str(step.row + 1)}
        title = context.told(title_of(scheme))
        if scheme.order == 1:
            told.append(begun(say("why.tangent", scheme=title, **values)))
            told += [say("why.broken")] if rows_before_breaks(evidence(context)) else []
            told += [] if context.run.settings.project else [say("why.half")]
        elif not context.run.settings.project:  # rows corrected by projection do not have the order of the scheme
            told.append(begun(say("why.order", scheme=title, order=scheme.order, less=2**scheme.order)))
    if context.run.tableau is not None and (largest := largest_error_sentence(context)):
        told.append(largest)
    told += _period(context, found)
    return [Paragraph(context.lettered(say.sentences(told)))] if told else []


def _period(context: PageContext, found: list[Split]) -> list[str]:
    """Return the sentence on a run that does not end exactly with its period, for the coordinate that moves most by that."""
    period, say = context.run.variant.time.period, context.words
    coordinates = [split for split in found if split.name in context.run.motion.coordinate_names]
    # A motion that returns only after several periods, or never, is a matter of the checks.
    if period is None or not coordinates or not is_a_period(context.run.results.evidence):
        return []
    row = context.run.results.evidence.period_row or 0
    end = float(context.run.motion.t[row])
    late = abs(end - round(end / period) * period)
    told: dict[str, object] = {"row": row + 1, "end": context.quantity(end, "s"), "period": context.quantity(period, "s")}
    most = max(coordinates, key=lambda split: abs(split.period))
    of_row = "" if row == len(context.run.motion.t) - 1 and round(end / period) == 1 else "_row"
    if context.run.tableau is None:
        key = "elsewhere" if unreturned(context) else "returns"
    elif late < 1e-9 * period:
        key = "period_met"
    elif all(abs(split.period) < HARDLY * abs(split.total) for split in coordinates):
        key, told["late"] = "period_near", context.with_unit(context.numbers.scalar(late, SHORT), context.unit("s"))
    else:
        key, whole = "period", context.numbers.scalar(most.total, 3)
        told |= {"part": context.numbers.scalar(most.period, 2), "whole": context.with_unit(whole, most.unit)}
        told["symbol"] = context.lettering(most.name)
    return [say(f"why.{key}{of_row}", **told)]
