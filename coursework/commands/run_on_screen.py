"""What a run prints: in brief on a terminal, in full with `--verbose` and to a file or a program.

Enters: a `Run`, the folder and the names of its files.  Leaves: lines on standard output.  Used by `run.py` and `check.py`.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from coursework.commands.line.screen import in_language, speaks_english, tell, tell_wrapped, title_of
from coursework.commands.mobility import of_pairs_left_out
from coursework.report.text.numbers import said_step
from coursework.results.checks.result import GROUPS, OF_THE_SCALE, Finding, beside, digits_apart, never_more
from coursework.run import Run
from coursework.scene.quantities import CHECKS
from coursework.variant.record.entries import guide_number
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

LEFT_OF_ZERO = 1e-12  # share of a column's largest entry; a smaller value is round-off and printed as 0
INDENT = "    "
_OF_EQUATIONS = {"START", "INITIAL", "RESIDUAL", "DRIFT", "DRIFT-PER-PERIOD"}  # checks in which `column` names an equation


def tell_remarks(run: Run, *, coded: bool = True) -> None:
    """Print the remarks on values in the file that look like slips; `coded`: with the code of each."""
    for remark in run.variant.plausibility:
        told = remark.told
        has_code = coded and speaks_english()
        tell(say("screen.check", code=remark.code, sentence=told) if has_code else say("screen.note", sentence=told))


def tell_run(run: Run, folder: Path, written: list[str]) -> None:
    """Print the whole result, the summary first, with every check."""
    if run.summary:
        tell(run.summary if speaks_english() else run.named_summary)
    tell(f"{title_of(run.variant)}  ({run.variant.name})")
    tell(*_set_values(run), _how_computed(run), *_about_rows(run), *_first_and_last(run), *_why_stopped(run))
    tell_remarks(run)
    tell(*of_pairs_left_out(run))
    if run.asks(CHECKS):
        tell_checks(run)
    tell(say("screen.written_to", out=folder, files=", ".join(written)))


def tell_run_briefly(run: Run, folder: Path, written: list[str]) -> None:
    """Print in brief what was computed, whether it is right and accurate, two rows, the checks not passed, and the files.

    Checks have names here instead of codes, and advice that several of them share is printed once.
    """
    title, name = title_of(run.variant), run.variant.name
    key = "screen.computed_own" if title == name else "screen.computed"  # what `new` writes is called as its file is
    tell_wrapped(say(key, title=title, name=name, how=_how_computed(run)))
    findings = run.checks if run.asks(CHECKS) else ()
    if findings:
        tell_wrapped(run.named_summary)
    tell_wrapped(*_set_values(run), *_about_rows(run))
    tell_wrapped(*_first_and_last(run), hanging=INDENT)
    tell_wrapped(*_why_stopped(run))
    tell_remarks(run, coded=False)
    tell_wrapped(*of_pairs_left_out(run))
    advice: dict[str, None] = {}  # in the order of the checks, without repetition
    for finding in findings:
        if finding.says_more:
            fact, *further = _parted(finding)
            advice |= dict.fromkeys(further)
            mark = say(f"checks.mark.{finding.verdict}")
            tell_wrapped(say("screen.not_passed", mark=mark, title=finding.title, sentence=fact), hanging=INDENT)
    tell_wrapped(*advice)
    tell_wrapped(say("screen.written_to", out=folder, files=", ".join(by_folder(written))))
    if findings:
        tell_wrapped(say("screen.more_with_verbose"))


def by_folder(names: Iterable[str]) -> tuple[str, ...]:
    """Return names of files, those of a folder as one: before a person forty drawings are "figures/"."""
    return tuple(dict.fromkeys(name[: name.find("/") + 1] or name for name in names))


def _parted(finding: Finding) -> list[str]:
    """Return the finding of a check as a list, with its advice as further parts if it gives some."""
    sentence = finding.sentence
    parts = sentence.values.get("parts") if isinstance(sentence, Sentence) and finding.option else None
    return list(parts) if isinstance(parts, tuple) else [sentence]


def _how_computed(run: Run) -> Sentence:
    return say("screen.scheme_step_rows", scheme=run.scheme_title, step=said_step(run.motion.step), count=len(run.motion.t))


def _set_values(run: Run) -> list[str]:
    changed = run.variant.set_values
    told = say("run.set", listed=tuple(_set_value(name, value) for name, value in changed.items())) if changed else None
    return [line for line in (told, run.scene.closed_anew) if line is not None]


def _set_value(name: str, value: str) -> Sentence:
    """Return the sentence for a value that was set; a law or a whole number has no unit."""
    if name == "check_row" and (guide := guide_number(int(value))) >= 1:
        return say("remark.set_row", name=name, row=int(value), guide=guide)
    number, _, unit = value.partition(" ")
    try:
        if unit:
            return say("remark.set", name=name, number=float(number), unit=unit)
    except ValueError:
        pass
    return say("remark.set_plain", name=name, value=value)


def _about_rows(run: Run) -> list[str]:
    """Return sentences on the distance to the exact rows and on the effect of Baumgarte's gain."""
    told: list[str] = []
    if run.distance_to_exact is not None:
        told.append(run.distance_to_exact.sentence)
    if gain := run.settings.gain:
        share = gain * run.motion.step
        told.append(say("screen.gain", gain=gain, share=share, kept=1 - share))
    return told


def _first_and_last(run: Run) -> list[str]:
    motion = run.motion
    if not len(motion.t):
        return []
    largest, units = abs(motion.rows).max(axis=0).tolist(), [run.variant.unit_of(name) for name in motion.names]
    sizes = [max(size for size, other in zip(largest, units, strict=True) if other == unit) for unit in units]
    told: list[str] = []
    for key, row in (("screen.first", 0), ("screen.last", -1)):
        shown = [
            value if abs(value) > LEFT_OF_ZERO * size else 0.0
            for value, size in zip(motion.rows[row].tolist(), sizes, strict=True)
        ]
        pairs = zip(motion.names, shown, strict=True)
        values = joined([say("screen.named", name=name, value=value) for name, value in pairs], "join.numbers")
        told.append(say(key, time=float(motion.t[row]), values=values))
    return told


def _why_stopped(run: Run) -> list[str]:
    if run.stop is None:
        return []
    told = [say("screen.stopped_by", kind=run.stop.name, sentence=run.stop.sentence)]
    return [*told, run.scene.phases] if run.scene.phases else list(told)


def tell_checks(run: Run) -> None:
    """Print the result of every check, group by group, then the sentences of those that say more than their line."""
    for group in GROUPS:
        found_of = [check for check in run.checks if check.group == group]
        if found_of:
            tell(say(f"checks.group.{group}"))
        for check in found_of:
            parts: list[str] = []
            if check.value is not None:
                value = never_more(check.value, check.unit, 3)
                value = float(f"{value:.{digits_apart(value, check.limit, 3, 'g')}g}")  # three digits are enough
                unit = beside(check.unit, value)
                has_unit = bool(unit and in_language(unit))  # a language may have no word for a bare number
                parts.append(say("screen.value_unit", value=value, unit=unit) if has_unit else say("screen.value", value=value))
            if check.limit is not None:
                parts.append(say("screen.least" if check.is_least else "screen.limit", limit=check.limit))
            if check.column:
                is_equation = check.code in _OF_EQUATIONS and "." not in check.column
                parts.append(say("screen.equation" if is_equation else "screen.column", column=check.column))
            parts += [say("screen.row", row=check.row)] if check.row else []
            mark, found = in_language(say(f"checks.mark.{check.verdict}")), in_language(joined(parts, "join.nothing"))
            why = in_language(check.sentence) if check.verdict == "SKIP" and not check.says_more else ""
            found = found.lstrip(" ,，") or why  # a row or column without a value before it; of what is not known, why
            found = f" {found}" if found else ""
            if speaks_english():
                tell(f"  {mark} {check.verdict:<6} {check.code:<16}{found}".rstrip())
            else:
                said = say("check.line", name=check.title, part=found.strip()) if found else check.title
                tell(f"  {mark} {in_language(said)}")
    if any(isinstance(check.unit, Sentence) and check.unit.key == OF_THE_SCALE for check in run.checks):
        tell_wrapped(say("screen.scale"))
    for check in run.checks:
        if check.says_more:
            tell(say("screen.check", code=check.code if speaks_english() else check.title, sentence=check.sentence))
