"""What a person must decide before a submission has a number: heads that name no column, few decimals, lines that were not read.

Enters: the marks of table and equations.  Leaves: `Sentence`s.  Used by `grade.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.equations.meant_together import contradicting
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.whole import only_coarse
from coursework.grading.marking.table_marks import TableMarks
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_SHOWN = 80  # characters of a line that could not be read


def questions(
    key: Key, weights: Mapping[str, float], table: TableMarks | None, equations: EquationMarks | None
) -> Iterator[Sentence]:
    """Yield the questions about parts that have a weight, the first of which is told."""
    if table and weights["table"]:
        if asked := table.open_question(key.names):
            yield asked
        if count := only_coarse(key, table.cells):
            yield say("reading.review.few_decimals", count=count, least=key.least_decimals)
    if equations and weights["equations"]:
        if unread := equations.unread:
            line, kind = unread.line, "unread_place" if unread.line.place else "unread_line"
            yield say(f"reading.review.{kind}", line=line.line, place=line.where, text=line.text[:_SHOWN])
        if files := contradicting([(mark.line.file, mark.verdict) for mark in equations.marks], equations.needed):
            yield say("reading.review.two_systems", names=files)
