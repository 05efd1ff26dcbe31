"""The gate: every number of a run is checked here before anything is written.

Enters: a `SceneRun`.  Leaves: nothing, or `InputError` that names quantity, rows, the line of the file and the reason.
Used by `results.py`, through which everything is written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from coursework.results.checks.result import Finding
from coursework.scene.quantities import ACCURACY, CHECKS, PLOTS
from coursework.scene.scene_run import SceneRun
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.report.output.reason import Reason


@frozen
class Block:
    """Numbers of one kind: `rows` (n, len(names)); `of` names the table, or is empty for rows of the results table."""

    names: Sequence[str]
    rows: Array
    of: str = ""


def pass_gate(run: SceneRun, pages: bool) -> None:
    """Check that every number to be written is finite; with `pages`, also the numbers that only a page shows.

    Raises `InputError` for the first block, stop or check that has other numbers, with a fault for each quantity of a block.
    """
    for block in _blocks(run, pages):
        spoilt = ~np.isfinite(block.rows)
        if spoilt.any():
            raise InputError(list(_faults(run, block, spoilt)))
    if (stop := run.stop) is not None:
        numbers = [
            stop.time,
            stop.row,
            *stop.coordinates.values(),
            *(value for found in stop.branches for value in found.values()),
        ]
        if not np.isfinite(numbers).all():
            raise InputError([_fault(run.variant, "stop", 0, say("fault.V606"))])
    for check in run.checks if run.asks(CHECKS) else ():
        if not np.isfinite(_numbers(check)).all():
            raise InputError([_fault_of_check(run, check)])


def _fault_of_check(run: SceneRun, check: Finding) -> Fault:
    """Return the fault of a check without a number although the table is finite: a formula that only the check reads."""
    what = f"checks.{check.code}"
    for point in ("", *dict(run.variant.points)):
        if reason := _reason(run, point):
            return _because(run.variant, what, reason, say("gate.some"))
    return _fault(run.variant, what, 1, say("fault.V601"))


def _numbers(check: Finding) -> list[float]:
    """Return every number of a finding that is written or shown."""
    listed = (check.value, check.limit, check.first, check.last, check.step, *(value for _, value, _ in check.rows))
    return [number for number in listed if number is not None]


def _blocks(run: SceneRun, pages: bool) -> Iterator[Block]:
    """Yield the blocks to be written, the most basic ones first, so that a fault is reported where it begins."""
    yield Block(run.motion.names, np.asarray(run.motion.rows))
    names, rows = run.columns()
    yield Block(names, np.asarray(rows))
    if pages and run.asks(PLOTS):
        yield Block(run.exact.names, np.asarray(run.exact.rows), say("graphs.exact"))
    for name, table in (run.own_tables | run.section_tables).items():
        rows = np.asarray(table.rows)
        if table.blanks and np.isnan(rows).any() and _lost_force(run) is None:  # empty is what is not unique
            rows = np.where(np.isnan(rows), 0.0, rows)
        yield Block(table.names, rows, name)
    study = run.study if (pages and run.asks(ACCURACY)) or run.timed is not None else None
    if study is not None:
        rows = np.array([[row.max_error, row.end_error] for row in study.rows if not row.failed]).reshape(-1, 2)
        yield Block(("max_error", "end_error"), rows, "accuracy")
    if pages and run.graph_check is not None:
        # A block that turns with its lever has no column in the results table: only the measured values must be finite.
        yield Block(("measured",), np.array([row[1:2] for row in run.graph_check.rows]).reshape(-1, 1), "graph_check")


def _faults(run: SceneRun, block: Block, spoilt: Flags) -> Iterator[Fault]:
    """Yield a fault for each quantity of a block that is not finite; the two components of a point are one quantity."""
    variant = run.variant
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
        reason = _lost_force(run) if block.of else _reason(run, owner if is_point else "")
        if reason is not None:
            yield _because(variant, what, reason, rows)
            if block.of:  # all that follows from the forces is lost with one of them
                return
        elif block.of:
            yield _fault(variant, f"{block.of}, {name}", 0, say("fault.V603", rows=rows))
        else:
            section = "points" if is_point else "coordinates"
            yield _fault(variant, f"{section}.{what}", variant.line_of(section, what), say("fault.V602", rows=rows))


def _lost_force(run: SceneRun) -> Reason | None:
    """Return what has no value in a force, a mass or what else moves the mechanism."""
    from coursework.report.output.reason import Formulas

    return Formulas(run.variant, run.motion, False).of_forces()


def _reason(run: SceneRun, point: str) -> Reason | None:
    """Return why `point` (the motion if "") has no value; if it has one, why it changes at no finite rate; else None."""
    from coursework.report.output.reason import Formulas

    for rates in (False, True):
        formulas = Formulas(run.variant, run.motion, rates)
        if reason := formulas.of_point(point) if point else formulas.of_motion():
            return reason
    return None


def _because(variant: Variant, what: str, reason: Reason, rows: str) -> Fault:
    names = ", ".join(reason.names)
    if reason.of_slope:
        text = say("fault.V605", rows=rows, node=reason.node, advice=say(f"gate.advice.slope.{reason.kind}", names=names))
    else:
        text = say("fault.V604", rows=rows, node=reason.node, advice=say(f"gate.advice.{reason.kind}", names=names))
    label = reason.label if reason.label == f"points.{what}" else f"{reason.label}, {what}"
    return _fault(variant, label, variant.nearest_line(*reason.path), text)


def _fault(variant: Variant, place: str, line: int, message: Sentence) -> Fault:
    return Fault(message, variant.file, line, 0, place)


def _rows(spoilt: Iterable[int]) -> str:
    """Return "row 3", "rows 1 to 73" or "7 rows, the first of them row 3"; rows count from 1."""
    rows = [int(row) + 1 for row in spoilt]
    if len(rows) == 1:
        return say("gate.row", row=rows[0])
    if rows[-1] - rows[0] == len(rows) - 1:
        return say("gate.rows", first=rows[0], last=rows[-1])
    return say("gate.some_rows", number=len(rows), first=rows[0], last=rows[-1])
