"""Everything about a marked table: its cells, what they earn and why.

Enters: what the files of `table/` have found.  Leaves: `TableMarks`.
Used by `grade.py`, `feedback.py` and the reasons.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from coursework.grading.marking.table.causes.hypotheses import OTHER_STEP
from coursework.grading.marking.table.causes.misconceptions import Misconception
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.first_wrong import FirstWrong
from coursework.grading.marking.table.points import Earned, TablePoints
from coursework.grading.reading.student_work import Table
from coursework.words.sentence import Sentence

if TYPE_CHECKING:
    from coursework.grading.marking.force_columns import ForceColumns


# If this part of a column's shown cells is right, its numbers confirm that it was taken for the right column.
_SHOWS = 0.9


@dataclass(frozen=True)
class TableMarks:
    """Everything about a marked table; `earned` says what share of the points it gets and how.

    `hidden` are the misconceptions that its digits are too few to show, None if none was looked for. `own_line` is a wrong
    line of the student's own equations from which the wrong cells follow, "" if there is none. `cut_off` counts the cells that
    are right only because further digits may have been cut off instead of rounded.
    """

    table: Table
    cells: Cells
    points: TablePoints
    first: FirstWrong | None
    misconception: Misconception | None
    earned: Earned
    hidden: tuple[str, ...] | None = None
    forces: ForceColumns | None = None
    own_line: str = ""
    cut_off: int = 0

    @property
    def share(self) -> float:
        """Return the share of the table's points; columns of forces weigh as much as they have cells."""
        own = self.earned.share
        if self.forces is None:
            return own
        return (own * self.points.cells + self.forces.earned) / max(self.points.cells + self.forces.count, 1)

    def open_question(self, names: Sequence[str]) -> Sentence | None:
        """Return the question about columns whose heads name none of `names`, None if their numbers answer it."""
        asked = [names.index(column.name) for column in self.table.columns if column.by == "position"]
        shown, right = (cells[:, asked].sum(axis=0) for cells in (self.cells.judged, self.cells.right))
        return None if np.all(right >= _SHOWS * shown) else self.table.asked


def is_of_other_step(marks: TableMarks | None) -> bool:
    """Return whether the steps of a table are proved to have another length than the task's."""
    return marks is not None and marks.misconception is not None and marks.misconception.code == OTHER_STEP
