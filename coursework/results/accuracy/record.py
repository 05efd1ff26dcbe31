"""What a study leaves behind: its rows, orders, budget and words.

Leaves `study.py`; read by the report and the command line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

from coursework.system.frozen import frozen


@frozen
class StudyRow:
    """One method at one setting; errors in `unit` and `end_unit`, `seconds` None where not timed, `failed` says why it did.

    `time_ratio` is that time as a multiple of the time of Euler with the table's own step.
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


@frozen
class AccuracyStudy:
    """`rows`; measured `orders` by method; the coursework's `own` point (method, evaluations, error, seconds); round-off
    `floor`; `reference_label`; `sentences`; `overhead` (what, seconds); `machine` where it was timed;
    `left_out`: what a long table leaves no work for.
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
