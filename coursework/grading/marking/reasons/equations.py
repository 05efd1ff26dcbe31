"""Why equations and answers have the points they have: lines that are not right or could not be read, and the sum.

Enters: marks, the points.  Leaves: `Reason`s, in order.  Used by `reasons.py`, and line by line by the page.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.grading.marking.answers import AnswerMarks
from coursework.grading.marking.equations.marks import COUNTED, EquationMark, EquationMarks
from coursework.grading.marking.reasons.reason import Reason, quoted
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

MOST_LINES = 6


def why_of_line(mark: EquationMark, *, asked: bool = False) -> Sentence:
    """Return the verdict on a line and its reason; with `asked`, a line that could not be read is a question to the teacher."""
    verdict = "asked" if asked and mark.verdict == "unreadable" and mark.line.relates else mark.verdict
    return joined([say(f"feedback.equation.{verdict}"), mark.lack, _hint(mark)])


def _hint(mark: EquationMark) -> Sentence | str:
    if mark.hint is None or not (mark.hint.text or mark.hint.kind != "reader"):
        return ""
    text = mark.hint.text if isinstance(mark.hint.text, Sentence) else quoted(mark.hint.text)
    return say(f"feedback.hint.{mark.hint.kind}", text=text, column=mark.hint.column, term=quoted(mark.hint.term))


def equation_reasons(marked: EquationMarks, points: float | None, most: float) -> Iterator[Reason]:
    """Yield why equations have less than all points; no sum if `points` is None or lines wait for a person."""
    troubled = [mark for mark in marked.marks if mark.verdict == "wrong" or (mark.verdict in COUNTED and mark.lack)]
    for mark in (*troubled, *marked.questions)[:MOST_LINES]:
        yield Reason("equations", "finding", _line(mark))
    if (more := len(troubled) + len(marked.questions) - MOST_LINES) > 0:
        yield Reason("equations", "finding", say("feedback.more_lines", number=more))
    if points is None:
        return
    wrong = marked.different
    known = {"independent": marked.independent, "needed": marked.needed, "wrong": wrong, "points": points, "most": most}
    among = max(marked.needed, marked.independent + wrong)
    yield Reason("equations", "rule", say("feedback.earned.equations", **known, among=among))


def _line(mark: EquationMark) -> Sentence:
    key = {"wrong": "wrong", "unreadable": "unread"}.get(mark.verdict, "adds_nothing")
    hint = _hint(mark) if mark.verdict not in COUNTED else ""
    kind = "place" if mark.line.place else "line"
    return joined([say(f"feedback.{kind}_{key}", line=mark.line.line, place=mark.line.where), mark.lack, hint])


def answer_reasons(marked: AnswerMarks, points: float, most: float) -> Iterator[Reason]:
    """Yield why measured answers have less than all points."""
    for mark in marked.marks:
        if mark.verdict != "right":
            verdict = say(f"feedback.answer.{mark.verdict}")
            yield Reason("answers", "finding", say("feedback.answer_of", name=quoted(mark.name), verdict=verdict))
    known = {"right": marked.share * len(marked.marks), "all": len(marked.marks), "points": points, "most": most}
    yield Reason("answers", "rule", say("feedback.earned.answers", **known))
