"""One submission -> its grade: all parts marked, one state, and a number or none.

Enters: `StudentWork`, a `Key`, the rubric.  Leaves: `Grade`.  Used by the children that grade a batch, and by `precheck`'s tests.
Only "graded" and "graded-with-notes" carry a number: a format error is not a wrong answer, and a fault of ours is not a zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.grading.marking.answers import AnswerMarks, mark_answers
from coursework.grading.marking.blank import empty_table
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.questions import questions
from coursework.grading.marking.rubric import Rubric, rounded_points
from coursework.grading.marking.student_table import is_the_key, student_of, with_given
from coursework.grading.marking.table.by_rows import marked, points_of
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.causes.clockwise import turned
from coursework.grading.marking.table.causes.hypotheses import claims
from coursework.grading.marking.table.causes.indistinct import indistinct
from coursework.grading.marking.table.causes.misconceptions import Found, explanations, looked_for
from coursework.grading.marking.table.causes.printed_otherwise import COLUMN_SLIPPED, EACH_SLIPPED, SLIPPED
from coursework.grading.marking.table.causes.whole import as_made, fewer_decimals, untold_points
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.cut_off import with_the_rest
from coursework.grading.marking.table.earning import best_rule
from coursework.grading.marking.table.first_wrong import first_wrong
from coursework.grading.marking.table.ways import StudentTable
from coursework.grading.marking.table_marks import TableMarks, is_of_other_step
from coursework.grading.marking.verdicts import Verdicts, verdicts
from coursework.grading.reading.student_work import StudentWork, Table
from coursework.grading.reading.submission import Note, note
from coursework.system.arrays import Array
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.grading.marking.force_columns import ForceColumns

# With this share of the points, or so many times the right cells, no other order of a table's rows is marked.
_BY_FAR, _FEW = 0.9, 0.5
GRADED = ("graded", "graded-with-notes")


@dataclass(frozen=True)
class Grade:
    """What one submission earns, and why; `reason` says why there is no number, None if there is one."""

    status: str
    parts: Mapping[str, float | None]
    rubric: Rubric
    key: Key
    work: StudentWork
    table: TableMarks | None
    equations: EquationMarks | None
    answers: AnswerMarks | None
    verdicts: Verdicts
    notes: tuple[Note, ...]
    reason: Sentence | None = None

    @property
    def total(self) -> float:
        """Return the sum of the points of all parts; a part that is missing counts 0."""
        return rounded_points(sum(self.rubric.most(part) * (share or 0.0) for part, share in self.parts.items()))

    def plain(self) -> dict[str, Any]:
        """Return the submission as grades.json writes it, without what only the batch knows (id, name, overrides, page)."""
        graded = self.status in GRADED
        proposed = self.total if self.status == "needs-review" and any(s is not None for s in self.parts.values()) else None
        return {
            "status": self.status,
            "score": self.total if graded else None,
            "max": self.rubric.points,
            "proposed": proposed,
            "reason": self.reason or "",
            "files": [entry.plain() for entry in self.work.files],
            "reading": self.table.table.reading.plain() if self.table else None,
            "table": self._table(),
            "first_wrong": asdict(self.table.first) if self.table and self.table.first else None,
            "equations": self._equations(),
            "answers": self._answers(),
            "misconception": self.table.misconception.plain() if self.table and self.table.misconception else None,
            "verdicts": asdict(self.verdicts),
            "notes": [entry.plain() for entry in self.notes],
        }

    @property
    def waits(self) -> bool:
        """Return whether the marks for equations wait until a person has looked at a line that could not be read."""
        return self.equations is not None and self.equations.unread is not None and bool(self.rubric.weights["equations"])

    def part(self, name: str) -> tuple[float | None, float]:
        """Return the points of a part (None if it cannot be marked) and the most it can earn."""
        share = None if name == "equations" and self.waits else self.parts.get(name)
        return (None if share is None else rounded_points(self.rubric.most(name) * share)), rounded_points(self.rubric.most(name))

    def _table(self) -> dict[str, Any]:
        score, most = self.part("table")
        trouble = self.work.trouble
        empty = empty_table(most) | {
            "state": "marked" if self.table else "missing" if trouble is None or trouble.state == "missing" else "unreadable",
            "score": score, "rows_needed": len(self.key.table), "least_decimals": self.key.least_decimals,
        }  # fmt: skip
        if self.table is None:
            return empty
        cells, first = self.table.cells, self.table.first
        return empty | {
            "rows": sum(self.table.table.rows_present),
            "first_wrong": f"row {first.row} {first.column}" if first else None,
            "wrong_cells": int(cells.wrong.sum()), "missing_cells": int((cells.missing & cells.counted).sum()),
            "carried_cells": int(cells.carried.sum()),
            "decimals": {column.name: column.decimals for column in self.table.table.columns},
            "computed_to": cells.computed_to,
            **({"forces": self.table.forces.plain()} if self.table.forces else {}),
        }  # fmt: skip

    def _equations(self) -> dict[str, Any] | None:
        if self.equations is None:
            return None
        score, most = self.part("equations")
        items = [mark.plain() for mark in self.equations.marks]
        counts = {"independent": self.equations.independent, "needed": self.equations.needed}
        return {"score": score, "max": most, **counts, "items": items}

    def _answers(self) -> dict[str, Any] | None:
        if self.answers is None:
            return None
        score, most = self.part("answers")
        return {"score": score, "max": most, "items": [mark.plain() for mark in self.answers.marks]}


@dataclass
class Marker:
    """Marks all submissions of one variant; keeps what does not depend on a submission."""

    key: Key
    rubric: Rubric
    others: Mapping[str, Array] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.by_forces = self.key.free is not None
        if self.by_forces:  # a person marks the equations of motion
            self.rubric = replace(self.rubric, weights={**self.rubric.weights, "equations": 0.0})
        self.judge = Judge(self.key)
        self.confusions = self.rubric.confused(self.key.variant)
        self._kept: dict[bytes, tuple[str, ...]] = {}

    def grade(self, work: StudentWork) -> Grade:
        """Return the grade of one submission; a table whose times are not the task's may count in order, if it earns more so.

        Of the two orders that with more right cells is marked first, the other one only if that leaves much open. Rows that
        were made with the step of their own times are not marked in order.
        """
        student = student_of(self.key, work.table) if work.table else None
        if not work.table or student is None or not (in_order := work.table.in_order):
            return self._grade(work, student)
        notes = (*in_order.notes, *(one for one in work.notes if one not in work.table.notes))
        tried = [(work, student), (replace(work, table=in_order, notes=notes), student_of(self.key, in_order))]
        right = [int(marked(self.key, one).right.sum()) for _, one in tried]
        if right[1] > right[0]:
            tried, right = tried[::-1], right[::-1]
        first = self._grade(*tried[0])
        is_open = first.work.table is in_order and is_of_other_step(first.table)
        if not is_open and ((first.parts["table"] or 0.0) >= _BY_FAR or right[1] < _FEW * right[0]):
            return first
        found = [first, self._grade(*tried[1])]
        proved = (one for one in found if one.work.table is not in_order and is_of_other_step(one.table))
        return next(proved, max(found, key=lambda grade: grade.parts["table"] or 0.0))

    def _grade(self, work: StudentWork, student: StudentTable | None) -> Grade:
        back = turned(self.key, student) if student and not self.by_forces and self.rubric.clockwise == "accept" else None
        equations = self._equations(work, turning=self.rubric.clockwise == "accept" and student is None)
        answers = mark_answers(self.key, self.rubric.answers, work.answers) if self.rubric.answers else None
        table = self._table(work.table, with_given(self.key, student), equations) if work.table and student else None
        if work.table and table and back:  # the table is marked with both senses of rotation, and the better marks count
            other = self._equations(work, turning=True, is_told=True)
            counted = self._table(work.table, with_given(self.key, back), other)
            table, equations, back = (counted, other, back) if counted.share > table.share else (table, equations, None)
        # The rubric may ask for answers of which none has a value: if other work was handed in, the answers are not missing.
        is_answered = work.answers or ((table or equations) and answers and not answers.marks)
        shares: dict[str, float | None] = {
            "table": table.share if table else None,
            "equations": equations.share if equations else None,
            "answers": answers.share if answers and is_answered else None,
        }
        judged = verdicts(self.key, table, equations)
        status, reason, notes = self._status(work, shares)
        if status == "graded" and (asked := next(questions(self.key, self.rubric.weights, table, equations), None)):
            status, reason = "needs-review", asked
        clockwise = (note("clockwise"),) if back or (equations and equations.turned) else ()
        named = table.misconception if table else None
        slipped = named is not None and named.code.startswith((SLIPPED, EACH_SLIPPED, COLUMN_SLIPPED))
        read = [one for one in work.notes if not slipped or one.code != "turns"]  # numbers ten times too large are no turns
        notes = (*read, *clockwise, *(equations.notes if equations else ()), *self._notes(table), *notes)
        if status == "graded" and notes:
            status = "graded-with-notes"
        return Grade(status, shares, self.rubric, self.key, work, table, equations, answers, judged, notes, reason)

    def _equations(self, work: StudentWork, *, turning: bool, is_told: bool = False) -> EquationMarks | None:
        if work.equations is None or self.by_forces:
            return None
        marks = self.judge.mark(work.equations, turning=turning, is_told=is_told)
        return marks if marks and marks.marks else None

    def _table(self, table: Table, student: StudentTable, equations: EquationMarks | None) -> TableMarks:
        """Return the marks of a table; digits that were cut off are put back, unless that earns less."""
        cells = marked(self.key, student)
        if (whole := with_the_rest(self.key, cells)) is None:
            return self._marks(table, cells, equations)
        first = first_wrong(self.key, replace(cells, marks=whole.marks), table)  # told with the numbers as printed
        count = int((cells.wrong & ~whole.wrong).sum())
        found = replace(self._marks(table, whole, equations), first=first, cut_off=count)
        others = [] if found.share >= _BY_FAR else [self._marks(table, cells, equations)]
        return max([found, *others], key=lambda marks: marks.share)

    def _marks(self, table: Table, cells: Cells, equations: EquationMarks | None) -> TableMarks:
        told = cache(partial(self._claims, equations))
        points = points_of(self.key, cells, self.rubric.carried)
        made = None if self.by_forces else as_made(self.key, cells, told)
        judged = marked(self.key, made.student) if made else cells
        found, hidden = Found(), None
        if not self.by_forces and looked_for(self.key, judged, points.cells):
            hidden = self._hidden(judged.student)
            again = made.claims(self.key, cells.missing) if made and made.named else told(judged.student)
            found = explanations(self.key, judged, again, hidden, equations)
            points = points_of(self.key, judged, self.rubric.carried, found.untold)
        points = untold_points(cells, points, judged, self.rubric.carried) if made else points
        earned = best_rule(self.key, self.rubric, judged, points, found, self.others)
        first = first_wrong(self.key, cells, table)
        named = made.named if made else found.named
        if made and not named:
            named = explanations(self.key, cells, told(cells.student), self._hidden(cells.student), equations).named
        return TableMarks(table, cells, points, first, named, earned, hidden, self._forces(table), found.own_line)

    def _claims(self, equations: EquationMarks | None, student: StudentTable) -> list[Claim]:
        return [*claims(TableUnderTest(self.key, student), self.confusions, self.others, equations)]

    def _forces(self, table: Table) -> ForceColumns | None:
        if not self.rubric.forces:
            return None
        from coursework.grading.marking.force_columns import mark_forces

        return mark_forces(self.key, table, self.rubric.forces, self.rubric.misconception_floor)

    def _hidden(self, student: StudentTable) -> tuple[str, ...]:
        """Return the misconceptions that columns with these digits cannot show; kept, as few sorts of digits occur in a class."""
        units = np.fmax.reduce(student.units)
        digits = units.tobytes()
        if digits not in self._kept:
            self._kept[digits] = indistinct(self.key, units, self.confusions)
        return self._kept[digits]

    def _status(self, work: StudentWork, shares: dict[str, float | None]) -> tuple[str, Sentence | None, tuple[Note, ...]]:
        """Return the state, why there is no number, and notes on missing parts, whose `shares` the rubric may set to 0."""
        if work.review is not None:
            return "needs-review", work.review, ()
        trouble = work.trouble
        nothing = all(share is None for share in shares.values())
        if trouble is not None and (trouble.state != "missing" or nothing) and self.rubric.weights["table"]:
            return trouble.state, trouble.text, ()
        absent = [part for part, share in shares.items() if share is None and self.rubric.weights[part]]
        if not absent:
            return "graded", None, ()
        if work.unopened is not None:
            return "needs-review", work.unopened, ()
        notes = tuple(note("empty_part", "no_part", part=say(f"feedback.part.{part}")) for part in absent)
        if self.rubric.missing_part == "zero":
            shares.update(dict.fromkeys(absent, 0.0))
            return "graded", None, notes
        return "needs-review", work.pictured or notes[0].text, notes

    def _notes(self, table: TableMarks | None) -> Iterator[Note]:
        if table is not None:
            cells = table.cells
            if count := int((cells.too_coarse & cells.counted).sum()):
                yield note("too_coarse", count=count, least=self.key.least_decimals)
            if count := fewer_decimals(self.key, cells):
                yield note("fewer_decimals", count=count, least=self.key.least_decimals)
            if table.cut_off:
                yield note("coarse_work", "digits_cut", count=table.cut_off)
            if cells.computed_to is not None:
                yield note("coarse_work", decimals=cells.computed_to)
            yield from table.forces.notes() if table.forces else ()
            if is_the_key(self.key, cells.student):
                yield note("bit_identical")
        if self.key.stopped:
            yield note("dead_point", reason=self.key.stopped)
