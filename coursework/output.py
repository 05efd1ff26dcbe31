"""A `Run` -> `table.csv` and `run.json`: every digit, the same bytes on every run.

Enters: a `Run`.  Leaves: files.  Raises `OutputError`.  Needs no pandas, no matplotlib, no typst.
"""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from coursework.files import write_bytes
from coursework.run import Run


def table_csv(run: Run) -> str:
    """Return the results table as CSV: header t, then the columns; SI; shortest text that reads back to the same number."""
    names, rows = run.columns()
    return _csv(["t", *names], ([t, *row] for t, row in zip(run.motion.t.tolist(), rows.tolist(), strict=True)))


def _csv(head: Iterable[str], rows: Iterable[Iterable[float]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(map(repr, row) for row in rows)
    return text.getvalue()


def record(run: Run) -> dict[str, Any]:
    """Return what `run.json` holds: versions, scheme, stop, checks."""
    motion = run.motion
    checks = run.checks if "checks" in run.asked else ()
    return {
        "variant": run.variant.name,
        "title": run.variant.title,
        "versions": run.versions,
        "scheme": run.settings.scheme,
        "step": motion.step,
        "end": run.variant.time.end,
        "rows": len(motion.t),
        "evaluations": motion.evaluations,
        "quantities": list(run.asked),
        "stop": _stop(run),
        "remarks": [
            {"code": remark.code, "line": remark.line, "sentence": str(remark.sentence)} for remark in run.variant.plausibility
        ],
        "checks": [
            {
                "code": check.code,
                "verdict": check.verdict,
                "value": _finite(check.value),
                "limit": _finite(check.limit),
                "unit": check.unit,
                "sentence": check.sentence,
            }
            for check in checks
        ],
    }


def _stop(run: Run) -> dict[str, Any] | None:
    stop = run.stop
    if stop is None:
        return None
    return {
        "kind": stop.kind,
        "time": stop.time,
        "row": stop.row,
        "block": list(stop.block),
        "coordinates": stop.coordinates,
        "cause": stop.cause,
        "meaning": stop.meaning,
        "branches": list(stop.branches),
    }


def _finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def write_tables(run: Run, folder: Path) -> list[str]:
    """Write `table.csv` and, where asked for, `analogs.csv` and `invariants.csv`, whose rows are others; return their names."""
    texts = {"table.csv": table_csv(run)}
    texts |= {f"{name}.csv": _csv(table.names, table.rows.tolist()) for name, table in run.own_tables.items()}
    for name, text in texts.items():
        write_bytes(folder / name, text.encode("utf-8"))
    return [*texts]


def write_table(run: Run, path: Path) -> None:
    """Write `table.csv`."""
    write_bytes(path, table_csv(run).encode("utf-8"))


def write_record(run: Run, path: Path) -> None:
    """Write `run.json`."""
    write_bytes(path, (json.dumps(record(run), indent=1, ensure_ascii=False) + "\n").encode("utf-8"))
