"""The results of a run -> CSV text with all digits, the same bytes on every run.

Enters: a `SceneRun`.  Leaves: text by file name.  Used by `results.py` and `key.py`; needs no pandas, no matplotlib, no typst.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array
from coursework.system.files.csv_text import csv_text

if TYPE_CHECKING:
    from coursework.results.accuracy.record import AccuracyStudy

POLYGON_HEAD = ("row", "t", "motion", "plan", "kind", "from", "to", "x", "y", "unit")
STUDY_HEAD = (
    "method", "steps_or_tolerance", "evaluations", "max_error", "unit", "end_error", "end_unit", "seconds",
    "time_ratio", "failed",
)  # fmt: skip


def run_tables(run: SceneRun) -> Iterator[tuple[str, str]]:
    """Yield (name, text): `table.csv`, the scheme's rows if that table is exact, and the other tables asked for."""
    yield "table.csv", table_csv(run)
    if (lesson := run.scene.scheme_rows) is not None:
        yield f"table-{lesson.scheme}.csv", timed_csv(lesson.names, lesson.t, lesson.rows)
    for name, table in (run.own_tables | run.section_tables).items():
        rows = table.rows.tolist()
        blank = [[None if value != value else value for value in row] for row in rows] if table.blanks else rows
        yield f"{name}.csv", csv_text(table.names, blank)
    if lines := run.lines_of_drawings:
        yield "polygons.csv", csv_text(POLYGON_HEAD, chain.from_iterable(lines))


def table_csv(run: SceneRun) -> str:
    """Return the results table as CSV in SI, t first; each number is the shortest text that reads back to the same number."""
    names, rows = run.columns()
    return timed_csv(names, run.motion.t, rows)


def timed_csv(names: Sequence[str], t: Array, rows: Array) -> str:
    """Return `rows` (n, len(names)) at the times `t` (n,) as CSV, the time first."""
    return csv_text(["t", *names], ([time, *row] for time, row in zip(t.tolist(), rows.tolist(), strict=True)))


def study_csv(study: AccuracyStudy) -> str:
    """Return a study of accuracy as CSV: one line per method and setting; an error without a value gives an empty cell."""
    cells = ([getattr(row, name) for name in STUDY_HEAD] for row in study.rows)
    return csv_text(STUDY_HEAD, ([None if value != value else value for value in row] for row in cells))
