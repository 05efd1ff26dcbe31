"""Everything about a marked table: its cells, what they earn and why.

Enters: what the files of `table/` have found.  Leaves: `TableMarks`.
Used by `grade.py`, `feedback.py` and the reasons.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.first_wrong import FirstWrong
from coursework.grading.marking.table.misconceptions import Misconception
from coursework.grading.marking.table.points import Earned, TablePoints
from coursework.grading.reading.student_work import Table

if TYPE_CHECKING:
    from coursework.grading.marking.force_columns import ForceColumns


@dataclass(frozen=True)
class TableMarks:
    """Everything about a marked table; `earned` says which share of its points it has and how they came about.

    `hidden` are the misconceptions that its digits cannot tell, None where none was looked for.
    """

    table: Table
    cells: Cells
    points: TablePoints
    first: FirstWrong | None
    misconception: Misconception | None
    earned: Earned
    hidden: tuple[str, ...] | None = None
    forces: ForceColumns | None = None

    @property
    def share(self) -> float:
        """Return the share of the table's points; columns of forces count by their cells."""
        own = self.earned.share
        if self.forces is None:
            return own
        return (own * self.points.cells + self.forces.earned) / max(self.points.cells + self.forces.count, 1)
