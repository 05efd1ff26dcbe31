"""Why a grade is what it is: the sentences, in order, for the page, grades.csv and every platform.

Enters: a `Grade`; a grade as grades.json writes it, with what was decided.  Leaves: `Reason`s; sentences.
Used by `workshop.py`, `work.py`, `decisions.py`, `written.py`, `autograder.py`, `feedback.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from coursework.grading.marking.grade import GRADED, Grade
from coursework.grading.marking.reasons.equations import answer_reasons, equation_reasons
from coursework.grading.marking.reasons.reason import Reason, quoted
from coursework.grading.marking.reasons.table import follows_euler, table_reasons
from coursework.words.sentence import Sentence
from coursework.words.sentences import Phrases, say

# Sentences that name another person are for the teacher; for these codes the student gets another sentence.
_FOR_STUDENTS = ("same_id",)
# Notes about cells that are not there, which cost their points.
_COSTS = ("rows_missing", "too_coarse", "date_cell", "error_cell")


def reasons(grade: Grade) -> list[Reason]:
    """Return why a submission has less than all points: why it has no number, then part by part; empty if it has all."""
    found = []
    if grade.status not in GRADED and grade.reason:
        found.append(state_reason(grade.reason))
    for part in grade.parts:
        points, most = grade.part(part)
        if points is None or points < most:
            found += _of_part(grade, part, points, most)
    return found


def state_reason(reason: Sentence | str) -> Reason:
    """Return why there is no number, as the student is told."""
    key = reason.key.removeprefix("reading.review.") if isinstance(reason, Sentence) else ""
    return Reason("", "state", say(f"feedback.review.{key}") if key in _FOR_STUDENTS else reason)


def _of_part(grade: Grade, part: str, points: float | None, most: float) -> Iterator[Reason]:
    if part == "table" and grade.table and points is not None:
        yield from (Reason("table", "note", note.text) for note in grade.notes if note.code in _COSTS)
        yield from table_reasons(grade.key, grade.table, grade.rubric, points, most, grade.equations)
    elif part == "equations" and grade.equations:
        yield from equation_reasons(grade.equations, points, most)
    elif part == "answers" and grade.answers and points is not None:
        yield from answer_reasons(grade.answers, points, most)
    if points is not None and getattr(grade.work, part) in (None, ()):  # the part was not handed in
        yield Reason(part, "rule", say("reading.note.no_part", part=say(f"feedback.part.{part}")))


def decided(check: str, points: float, most: float, told: str) -> Reason:
    """Return what the instructor decided about a part, and what the student is `told`; it replaces all that was found there."""
    key = "feedback.override_why" if told else "feedback.override"
    part, reason = say(f"feedback.part.{check}"), _closed(quoted(told))
    return Reason(check, "decided", say(key, check=part, points=points, most=most, reason=reason))


def _closed(text: str) -> str:
    """Return what a person typed with a full stop, as another sentence may follow it in a platform's comment."""
    return f"{text}." if text[-1:].isalnum() else text


def lost_by_time(minutes: int | None, lost: float, most: float) -> Reason:
    """Return what a submission loses for being late; by how much it is late is told if `minutes` is known."""
    if minutes is None:
        return Reason("late", "rule", say("feedback.late_by_platform", lost=lost, most=most))
    hours, rest = divmod(minutes, 60)
    days, hours = divmod(hours, 24)
    return Reason("late", "rule", say("feedback.late", days=days, hours=hours, minutes=rest, lost=lost, most=most))


def after_decision(found: list[dict[str, str]], decision: Reason) -> list[dict[str, str]]:
    """Return the reasons of a grade after a decision; a decision about the total replaces them all."""
    part = decision.part
    if part == "total":
        return [decision.plain()]
    place = next((place for place, entry in enumerate(found) if entry["part"] == part), len(found))
    kept = [entry for entry in found if entry["part"] != part]
    return [*kept[:place], decision.plain(), *kept[place:]]


def summary(grade: Grade) -> list[Sentence | str]:
    """Return what is right about a submission, and what the steps of its table show."""
    found: list[Sentence | str] = []
    if grade.verdicts.equations == "right":
        found.append(say("marking.verdict.equations.right"))
    if grade.table:
        found.append(follows_euler(grade.key, grade.table))
        of_forces = grade.table.forces.columns if grade.table.forces else ()
        if not grade.table.cells.wrong.any() and all(one.right + one.missing == one.count for one in of_forces):
            absent = grade.table.cells.missing.any() or any(one.missing for one in of_forces)
            found.append(say(f"marking.verdict.arithmetic.{'present' if absent else 'right'}"))
    return [sentence for sentence in found if sentence]


def told(grade: Mapping[str, Any], words: Phrases, part: str | None = None) -> str:
    """Return the reasons of a grade after all decisions as one text, for one `part` or for all."""
    found = [entry["text"] for entry in grade["reasons"] if part is None or entry["part"] == part]
    return words.template("join.sentences").join(found)
