"""The box on page 1: whether the rows are computed right and close to the motion, advice, and the results asked for.

Enters: a `PageContext`.  Leaves: a `Result`.  Used by `statement.py`.
"""

from __future__ import annotations

from dataclasses import replace

from coursework.report.sections.verdict.checks import amount, parted
from coursework.report.text.numbers import TIGHT, shown_column
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Result, Runs
from coursework.report.text.text_runs import runs
from coursework.report.wording.closeness import largest_error_sentence, splits, turns_taken_off, unreturned
from coursework.results.checks.summary import summary
from coursework.scene.quantities import CHECKS, TABLE

# Significant digits of a velocity in the box, and of a time in a sentence.
SHOWN_DIGITS, TIME_DIGITS = 5, 4


def answer(context: PageContext) -> Result:
    """Return the box: verdict, advice, velocities of the check row, last minus first row, for exact rows the scheme's error."""
    run, say = context.run, context.words
    told: list[Runs] = []
    verdict = _verdict(context)
    if run.asks(CHECKS) and not (verdict and _says_all(context)):
        # The stop has been described already.
        findings = [replace(one, option="", value=None if one.code == "STOP" else one.value) for one in run.checks]
        whole = context.rich(summary(findings, is_motion=run.tableau is None, named=lambda finding: finding.title))
        if verdict and run.stop is None:
            verdict = whole  # it says the same in more words
        else:
            told.append(whole)
    # Only here the advice is given.
    advice = next((advice for finding in run.checks if (advice := parted(finding.sentence)[1])), "") if run.asks(CHECKS) else ""
    told += [context.rich(advice)] if advice else []
    if run.asks(CHECKS):
        told += [context.rich(one.sentence) for one in run.checks if one.is_news]
    if run.asks(TABLE) and len(run.motion.t):
        told.append(runs(_checked(context)))
    if run.asks(CHECKS):
        told += _misses(context)
    if not told:
        told.append(runs(say("result.rows", rows=say.count("count.rows", len(run.motion.t)))))
    return Result(say("result.title"), verdict, told)


def _says_all(context: PageContext) -> bool:
    """Return whether the verdict already says all that the summary would: an ordinary run of a scheme."""
    checks = [one for one in context.run.checks if one.code != "STOP"]
    if context.run.tableau is None or any(one.headline or (one.unjudged and one.code != "START") for one in checks):
        return False
    odd = [one for one in checks if one.verdict not in {"PASS", "SKIP"}]
    is_coarse = all(one.group == "motion" and one.verdict == "COARSE" for one in odd)
    by_accuracy = is_coarse and any(one.code == "ACCURACY" for one in odd)
    known = any(one.code == "ACCURACY" and one.verdict != "SKIP" for one in checks)
    return known and (by_accuracy or not odd)


def _verdict(context: PageContext) -> Runs:
    """Return in a few words whether the rows are computed right and close to the motion; empty if that was not checked."""
    say, checks = context.words, context.run.checks if context.run.asks(CHECKS) else ()
    computed = [one.verdict for one in checks if one.group == "computation" and one.code != "STOP"]
    accuracy = next((one for one in checks if one.code == "ACCURACY"), None)
    if not computed or not len(context.run.motion.t):
        return []
    open_to = {one.code for one in checks if one.unjudged}
    whole = "result.right" if context.run.stop is None else "result.right_to_stop"
    right = whole if not open_to else "result.right_given" if open_to == {"START"} else "result.right_partly"
    told = [say("result.wrong" if {"FAIL", "ERROR"} & {*computed} else right)]
    if accuracy is not None and accuracy.verdict == "PASS":
        told.append(say("result.close"))
    elif accuracy is not None and accuracy.verdict in {"COARSE", "FAIL"} and accuracy.value is not None and accuracy.column:
        share = amount(context, accuracy.value, accuracy.unit, limit=accuracy.limit)
        size, unit = context.run.results.evidence.scale[accuracy.column], context.run.variant.unit_of(accuracy.column)
        off, scale = (context.with_unit(context.numbers.scalar(one, 2), unit) for one in (accuracy.value * size, size))
        symbol = context.lettering(accuracy.column)
        told.append(say("result.far", symbol=symbol, share=share, row=accuracy.row or 1, off=off, scale=scale))
    return context.lettered(say.sentences(told))


def _checked(context: PageContext) -> str:
    """Return the sentence on the velocities of the check row."""
    motion, variant = context.run.motion, context.run.variant
    row = min(variant.time.row_of_check, len(motion.t))
    sought = [name for name in motion.velocity_names if name not in variant.given_rates] or motion.velocity_names
    values = context.words("result.between").join(
        f"{context.lettering(name)}{TIGHT}={TIGHT}"
        + context.with_unit(
            context.numbers.scalar(float(shown_column(motion, name, variant)[row - 1]), SHOWN_DIGITS), variant.unit_of(name)
        )
        for name in sought
    )
    time = context.quantity(float(motion.t[row - 1]), "s", TIME_DIGITS)
    return context.words("result.row", row=row, time=time, values=values)


def _misses(context: PageContext) -> list[Runs]:
    """Return the sentences on how far coordinates are from their start after a period; for exact rows, the scheme's error."""
    say, numbers, told = context.words, context.numbers, []
    coordinates, left = context.run.motion.coordinate_names, unreturned(context)
    moved = [split for split in left if split.name in coordinates]
    row = (context.run.results.evidence.period_row or 0) + 1
    of_row = "" if row == len(context.run.motion.t) else "_row"  # the run goes on after a whole number of periods
    shown = [split for split in moved if split.name not in context.run.variant.given_coordinates] or moved
    gaps = [
        f"{context.lettering(split.name)}{TIGHT}{context.with_unit(numbers.scalar(split.total, 3), split.unit)}"
        for split in shown
    ]
    if gaps:
        misses = say(f"result.misses{of_row}", row=row, gaps=say("join.numbers").join(gaps))
        told.append(runs(say.sentences([misses, turns_taken_off(context, shown)])))
    elif any(split.name in coordinates for split in splits(context)):
        told.append(runs(say(f"result.repeats_positions{of_row}" if left else f"result.repeats{of_row}", row=row)))
    # For exact rows, only this sentence says how large the scheme's error is.
    if context.run.tableau is None and (sentence := largest_error_sentence(context)):
        told.append(runs(sentence))
    return told
