"""The gate: every number of a run is seen here before anything is written.

Enters: a `Run`.  Leaves: nothing, or `InputError` that names quantity, rows, the line of the file and the reason.
Used by `results.py`, which whoever writes goes through.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.errors import Fault, InputError
from coursework.output.reason import Formulas, Reason
from coursework.quantities import CHECKS, PLOTS
from coursework.run import Run
from coursework.sentences import Sentence, say
from coursework.variant.record import Variant

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Block:
    """Numbers of one kind: `rows` (n, len(names)); `of` names the table where its rows are not those of the results table."""

    names: Sequence[str]
    rows: Array
    of: str = ""


def pass_gate(run: Run, pages: bool) -> None:
    """Look at every number that would be written; `pages`: those that only a page shows, too.

    Raises `InputError` for the first block with numbers that are not finite, a fault for each quantity in it.
    """
    for block in _blocks(run, pages):
        spoilt = ~np.isfinite(block.rows)
        if spoilt.any():
            raise InputError(list(_faults(run, block, spoilt)))
    for check in run.checks if run.asks(CHECKS) else ():
        numbers = [number for number in (check.value, check.limit) if number is not None]
        if not np.isfinite(numbers).all():
            raise InputError([_fault(run.variant, f"checks.{check.code}", 0, say("fault.V601"))])


def _blocks(run: Run, pages: bool) -> Iterator[Block]:
    """Yield what is written, the plainest first, so that a fault is told where it begins."""
    yield Block(run.motion.names, np.asarray(run.motion.rows))
    names, rows = run.columns()
    yield Block(names, np.asarray(rows))
    if pages and run.asks(PLOTS):
        yield Block(run.exact.names, np.asarray(run.exact.rows), say("gate.exact"))
    for name, table in run.own_tables.items():
        yield Block(table.names, np.asarray(table.rows), name)
    study = run.accuracy if pages or run.timed is not None else None
    if study is not None:
        rows = np.array([[row.max_error, row.end_error] for row in study.rows if not row.failed]).reshape(-1, 2)
        yield Block(("max_error", "end_error"), rows, "accuracy")
    if pages and run.graph is not None:
        yield Block(("measured", "table"), np.array([row[1:3] for row in run.graph.rows]).reshape(-1, 2), "graph_check")


def _faults(run: Run, block: Block, spoilt: NDArray[np.bool_]) -> Iterator[Fault]:
    """Yield a fault for each quantity of a block that is not finite; the two components of a point are one quantity."""
    variant, formulas = run.variant, Formulas(run.variant, run.motion)
    points = dict(variant.points)
    told: set[str] = set()
    for index in np.flatnonzero(spoilt.any(axis=0)).tolist():
        name = block.names[index]
        owner = name.partition(".")[0]
        is_point = "." in name and owner in points
        what = owner if is_point else name
        if what in told:
            continue
        told.add(what)
        rows = _rows(np.flatnonzero(spoilt[:, index]))
        if block.of:
            yield _fault(variant, f"{block.of}, {name}", 0, say("fault.V603", rows=rows))
            continue
        reason = formulas.of_point(owner) if is_point else formulas.of_motion()
        place = ("points", owner) if is_point else reason.place if reason else ("coordinates", name)
        why = say("fault.V602", rows=rows) if reason is None else _because(reason, rows)
        label = ".".join(str(part) for part in place)
        yield _fault(variant, label if is_point or reason is None else f"{label}, {name}", variant.line_of(*place), why)


def _because(reason: Reason, rows: str) -> Sentence:
    key = f"gate.advice.{reason.kind}"
    advice = say(key, names=", ".join(reason.names))
    return say("fault.V604", rows=rows, node=reason.node, advice=advice)


def _fault(variant: Variant, place: str, line: int, message: Sentence) -> Fault:
    return Fault(message, variant.path.name if variant.path else variant.name, line, 0, place)


def _rows(spoilt: Iterable[int]) -> str:
    """Return "row 3", "rows 1 to 73" or "7 rows, the first of them row 3"; rows count from 1."""
    rows = [int(row) + 1 for row in spoilt]
    if len(rows) == 1:
        return say("gate.row", row=rows[0])
    if rows[-1] - rows[0] == len(rows) - 1:
        return say("gate.rows", first=rows[0], last=rows[-1])
    return say("gate.some_rows", number=len(rows), first=rows[0], last=rows[-1])
