"""The result of a study: its rows, orders, budget and words.

Leaves `study.py`; read by the report and the command line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

from coursework.system.frozen import frozen


@frozen
class StudyRow:
    """The result of one method with one setting; errors are in `unit` and `end_unit`.

    `seconds` is None if it was not timed; `failed` says why a run failed.  `time_ratio` is the time as a multiple of the time of
    Euler with the table's own step.  `size` and `end_size` are what counts as 1 of the errors.
    """

    method: str
    steps_or_tolerance: str
    evaluations: int
    max_error: float
    end_error: float
    seconds: float | None
    failed: str = ""
    unit: str = "rad"
    end_unit: str = "rad"
    time_ratio: float | None = None
    size: float = 1.0
    end_size: float = 1.0

    @property
    def share(self) -> float:
        """Return the largest error as a share of its size; those of a length and an angle can be compared."""
        return self.max_error / self.size


@frozen
class AccuracyStudy:
    """The rows of a study and what follows from them.

    `orders` are the measured orders by method; `own` is the coursework's point (method, evaluations, error, seconds); `floor` the
    round-off floor, in the unit of the first row; `overhead` lists (what, seconds); `machine` describes where it was timed;
    `left_out` says what was left out because the table is long.
    """

    rows: tuple[StudyRow, ...]
    orders: Mapping[str, float]
    own: tuple[str, int, float, float | None] | None
    floor: float
    reference_label: str
    sentences: Sequence[str]
    overhead: Sequence[tuple[str, float]]
    seconds_shown: bool
    machine: Mapping[str, str] = field(default_factory=dict)
    left_out: Sequence[str] = ()

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self.rows)} runs of {len({row.method for row in self.rows})} methods>"
