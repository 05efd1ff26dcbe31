"""What a run computed -> CSV text: every digit, the same bytes on every run.

Enters: a `SceneRun`.  Leaves: text by file name.  Used by `results.py`; needs no pandas, no matplotlib, no typst.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from coursework.scene.scene_run import SceneRun

if TYPE_CHECKING:
    from coursework.results.accuracy.record import AccuracyStudy

STUDY_HEAD = (
    "method", "steps_or_tolerance", "evaluations", "max_error", "unit", "end_error", "end_unit", "seconds",
    "time_ratio", "failed",
)  # fmt: skip


def run_tables(run: SceneRun) -> Iterator[tuple[str, str]]:
    """Yield `table.csv`, beside an exact one the rows of the coursework's scheme, and the tables asked for with other rows."""
    yield "table.csv", table_csv(run)
    if (lesson := run.scene.scheme_rows) is not None:
        rows = ([t, *row] for t, row in zip(lesson.t.tolist(), lesson.rows.tolist(), strict=True))
        yield f"table-{lesson.scheme}.csv", _csv(["t", *lesson.names], rows)
    for name, table in run.own_tables.items():
        yield f"{name}.csv", _csv(table.names, table.rows.tolist())
    for listing in run.listings:
        yield listing.file, _csv(listing.head, listing.rows)


def table_csv(run: SceneRun) -> str:
    """Return the results table as CSV: header t, then the columns; SI; shortest text that reads back to the same number."""
    names, rows = run.columns()
    return _csv(["t", *names], ([t, *row] for t, row in zip(run.motion.t.tolist(), rows.tolist(), strict=True)))


def study_csv(study: AccuracyStudy) -> str:
    """Return a study of accuracy as CSV: one line a method and setting; errors in the units named beside them."""
    rows = (
        (
            r.method,
            r.steps_or_tolerance,
            r.evaluations,
            r.max_error,
            r.unit,
            r.end_error,
            r.end_unit,
            r.seconds,
            r.time_ratio,
            r.failed,
        )
        for r in study.rows
    )
    return _csv(STUDY_HEAD, rows)


def _csv(head: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)  # the writer spells a float as `repr` does, and None as an empty cell
    return text.getvalue()
