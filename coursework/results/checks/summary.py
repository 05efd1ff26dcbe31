"""The findings in two or three sentences: computed right or not, close to the motion or not, and what to take.

Enters: findings.  Leaves: a `Sentence`.  Used by the page, run.json and the command line, whose first line it is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import attrgetter

from coursework.motion.schemes import SCHEMES, title_of
from coursework.results.checks.result import Finding, percent
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


def summary(
    findings: Sequence[Finding], *, is_motion: bool = False, named: Callable[[Finding], str] = attrgetter("code")
) -> Sentence:
    """Return the summary of a run; `is_motion`: its rows are exact; `named` gives the name of a check, by default its code."""
    told = list(dict.fromkeys(finding.headline for finding in findings if finding.headline))
    by_code = {finding.code: finding for finding in findings}
    stop = by_code.get("STOP")
    if stop is not None and stop.verdict != "PASS" and stop.value is not None:
        told.append(say("summary.steps_out" if stop.verdict == "COARSE" else "summary.stops", time=stop.value))
    computation = [finding for finding in findings if finding.group == "computation"]
    motion = [finding for finding in findings if finding.group == "motion"]
    if not computation:  # motion under forces is judged by its energy and by the motion alone
        shown = [one for one in motion if one.verdict != "PASS"] or motion[:1]
        return joined([*told, *dict.fromkeys(one.sentence for one in shown)])
    computed = _computed(computation, named)
    told.append(computed)
    if computed != say("summary.no_rows"):
        told += _close(by_code.get("ACCURACY") or by_code.get("MOTION"), motion, named, is_motion=is_motion)
    if errors := tuple(named(finding) for finding in findings if finding.verdict == "ERROR"):
        told.append(say("summary.error", codes=errors))
    return joined(told)


def _instead(coarse: list[Finding]) -> str:
    """Return the advised step or scheme in plain words."""
    advised = next(finding for finding in coarse if finding.option)
    if advised.step is not None:
        return say("advice.finer", step=advised.step)
    named = advised.option.rpartition(" ")[2]
    return title_of(SCHEMES[named]) if named in SCHEMES else named


def _computed(findings: list[Finding], named: Callable[[Finding], str]) -> Sentence:
    judged = [finding for finding in findings if finding.verdict != "SKIP"]
    count = {"passed": sum(finding.verdict == "PASS" for finding in judged), "all": len(judged)}
    equations_first = sorted(findings, key=lambda finding: finding.code != "AGREEMENT")
    unjudged = [finding.unjudged for finding in equations_first if finding.unjudged]
    failed = tuple(named(finding) for finding in judged if finding.verdict == "FAIL" and finding.code != "STOP")
    if failed:
        return say("summary.wrong", codes=failed, **count)
    if coarse := tuple(named(finding) for finding in judged if finding.verdict == "COARSE" and finding.code != "STOP"):
        rounded = say("summary.rounded", codes=coarse, **count)
        return joined([rounded, *(say("summary.besides", unjudged=one) for one in unjudged)])
    beside = joined(unjudged, "join.semicolon")
    if any(finding.unjudged and finding.code == "AGREEMENT" for finding in findings):
        return say("summary.right_but", unjudged=beside)
    if any(finding.code == "STOP" and finding.verdict != "PASS" for finding in judged):
        reached = {"passed": count["passed"], "all": count["all"] - 1}  # its stop has been reported before
        return say("summary.right_to_stop", **reached) if reached["all"] else say("summary.no_rows")
    return say("summary.right_beside", unjudged=beside, **count) if unjudged else say("summary.right", **count)


def _scale(sentence: object) -> dict[str, object]:
    """Return the scale (SI) and its unit from a sentence about closeness; empty if it has none."""
    if not isinstance(sentence, Sentence):
        return {}
    values = sentence.values
    within = [values.get("found"), *(parts if isinstance(parts := values.get("parts"), tuple) else ())]
    own = {key: values[key] for key in ("scale", "unit") if key in values}
    return own if len(own) == 2 else next((found for part in within if (found := _scale(part))), {})


def _close(accuracy: Finding | None, findings: list[Finding], named: Callable[[Finding], str], *, is_motion: bool) -> list[str]:
    coarse = [finding for finding in findings if finding.verdict == "COARSE"]
    option = next((finding.option for finding in coarse if finding.option), "")
    take = say("summary.take", option=option, what=_instead(coarse)) if option else ""
    told: list[str] = []
    if accuracy is not None and accuracy.code == "MOTION":  # under forces: its sentence says as much, with the step to take
        told.append(accuracy.sentence)
    elif accuracy is None or accuracy.verdict == "SKIP":
        if accuracy is None or not accuracy.headline or accuracy.headline != accuracy.sentence:
            told.append(say("summary.unknown"))
    elif accuracy.verdict == "FAIL":
        told.append(accuracy.sentence)
    elif is_motion and accuracy.value == 0:
        told.append(say("summary.same"))
    elif accuracy.value == 0:
        told.append(say("summary.no_error"))
    elif accuracy.value is not None:
        known = _scale(accuracy.sentence)
        scale = say("summary.scale", **known) if known else ""
        found = {"share": percent(accuracy.value, accuracy.limit), "name": accuracy.column, "row": accuracy.row, "scale": scale}
        is_far = accuracy.verdict == "COARSE"
        told.append(say("summary.far", take=take, **found) if is_far else say("summary.close", **found))
    if failed := tuple(named(finding) for finding in findings if finding.verdict == "FAIL" and finding is not accuracy):
        told.append(say("summary.failed", codes=failed))
    if coarse and (accuracy is None or accuracy.verdict != "COARSE"):
        told.append(say("summary.coarse", codes=tuple(named(finding) for finding in coarse), take=take))
    return told
