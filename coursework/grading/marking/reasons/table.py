"""Why a table has the points it has: its first wrong cell, what seems to have happened, and the sum.

Enters: a `Key`, `TableMarks`, the points.  Leaves: `Reason`s, in order.  Used by `reasons.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict

from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.reasons.reason import Reason, in_sum, misconception_sentence, quoted
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.student_table import lacking
from coursework.grading.marking.table.causes.hypotheses import OTHER_STEP
from coursework.grading.marking.table.causes.misconceptions import ROWS_SHIFTED, Misconception
from coursework.grading.marking.table.causes.odd_rows import displaced_rows, repeated_rows
from coursework.grading.marking.table.causes.other_data import OTHER_SIGN
from coursework.grading.marking.table.points import ENOUGH_ROWS, RUN
from coursework.grading.marking.table_marks import TableMarks
from coursework.grading.marking.verdicts import euler_steps
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, ranges, say, say_count

# From this part of wrong cells on, a table is told that no usual cause explains them.
_MANY = 0.1
# With these causes the table is right if it is read otherwise; the columns as handed in then tell nothing about its steps.
_READ_OTHERWISE = ("swapped_columns", "origin", "clockwise", "sign_drive")
_VELOCITIES_SHIFTED = ("omega_late", "omega_early")
_EXPLAINED = ("misconception", "start")
_EQUATION, _DATUM, _CONFUSION = "equation_", "datum_", "confusion_"
_SEVERAL = ("start_", _EQUATION)
_MOST_RUNS = 6
_RIGHT_LINE = "feedback.misconception.in_right_line"


@frozen
class Counts:
    """How many cells count (all but the start values), and their marks: together all of them.

    `right` are as in the key; `start` counts start values other than the task's.
    """

    cells: int
    wrong: int
    missing: int
    carried: int
    right: int
    start: int


def counts(key: Key, marked: TableMarks) -> Counts:
    """Return the counts of a table."""
    m, cells = key.m, marked.cells
    wrong, missing, carried = (int((found & cells.counted).sum()) for found in (cells.wrong, cells.missing, cells.carried))
    count = marked.points.cells
    return Counts(count, wrong, missing, carried, count - wrong - missing - carried, int(cells.wrong[0, :m].sum()))


def shut(marked: TableMarks) -> Mapping[str, int]:
    """Return by gate how many right cells do not count; empty if the points do not come from the cells."""
    return marked.earned.shut if marked.earned.rule == "cells" else {}


def table_reasons(
    key: Key, marked: TableMarks, rubric: Rubric, points: float, most: float, equations: EquationMarks | None = None
) -> Iterator[Reason]:
    """Yield why a table has less than all points, with the words of the rubric for a confusion; `equations` were handed in."""
    if marked.first:
        yield Reason("table", "first", marked.first.sentence)
    found = counts(key, marked)
    starts = [name for name, is_wrong in zip(key.names, marked.cells.wrong[0], strict=True) if is_wrong][: found.start]
    because = {f"{_CONFUSION}{one.datum}": one.because for one in rubric.confusions if one.because}
    yield from _causes(found, marked, because, tuple(starts), _own_line(marked, equations))
    yield from _odd_rows(key, marked)
    if absent := lacking(key, marked.table):
        yield Reason("table", "finding", say("feedback.columns_missing", names=absent))
    for gate, number in shut(marked).items():
        limits = {"share": round(100 * ENOUGH_ROWS), "run": RUN}
        yield Reason("table", "finding", say_count(f"feedback.shut.{gate}", number, **limits))
    less = say("feedback.carried_worth", worth=rubric.carried) if found.carried and rubric.carried != 1 else ""
    costs = say("feedback.start_costs") if found.start and marked.earned.of_cells else ""
    total = _sum(marked, found.cells, points, most)
    if marked.earned.rule == "cells":
        total = joined([_counted(found), costs, less, total])
    yield Reason("table", "rule", total)


def _own_line(marked: TableMarks, equations: EquationMarks | None) -> Sentence | str:
    """Return what the student's own line has to do with the slip in a table, "" if the table follows from no line of theirs."""
    if not marked.own_line:
        return ""
    is_wrong = equations is None or any(str(mark.line.line) == marked.own_line for mark in equations.wrong)
    return say("feedback.misconception.in_line" if is_wrong else _RIGHT_LINE, line=marked.own_line)


def _causes(
    found: Counts, marked: TableMarks, because: Mapping[str, str], starts: tuple[str, ...] = (), own_line: Sentence | str = ""
) -> Iterator[Reason]:
    """Yield the likely cause and others that explain as much, or, if many cells are wrong, that no usual cause was found.

    `starts` are the coordinates whose start is not the task's; `own_line` says whether the slip is in the student's own line too.
    """
    named, earned = marked.misconception, marked.earned
    if named:
        share = str(int(100 * named.share + 1e-9))  # rounded down: 100 means the whole table
        is_counted = earned.rule == "cells"  # else the sum tells a percentage of its own, of the cells that count
        told = say("feedback.misconception.share", share=share) if is_counted else say("feedback.misconception.most")
        own = own_line if named.code.startswith(_EQUATION) and len(named.names) < 2 else ""
        yield Reason("table", "cause", joined([told, _told(named.code, because, named.names), own]))
        for code in named.ties:
            yield Reason("table", "finding", joined([say("feedback.misconception.ties"), _told(code, because)]))
    if earned.rule in _EXPLAINED and (named is None or not _is_told(earned.cause, named)):
        partly = say(f"feedback.misconception.{'partly' if named is None else 'also'}")
        names = starts if earned.cause.startswith("start_") else ()
        yield Reason("table", "cause", joined([partly, _told(earned.cause, because, names)]))
    elif earned.rule == "cells" and named is None and marked.hidden is not None and found.wrong > _MANY * found.cells:
        if isinstance(own_line, Sentence) and own_line.key == _RIGHT_LINE:
            yield Reason("table", "cause", own_line)
        elif marked.own_line:
            own = say("feedback.misconception.own_equations", line=marked.own_line)
            yield Reason("table", "cause", joined([say("feedback.misconception.partly"), own]))
        else:
            yield Reason("table", "finding", say("feedback.misconception.none"))


def _is_told(cause: str, named: Misconception) -> bool:
    """Return whether a cause is already named, by another name too: a start by its axis, rows by the velocities in them."""
    if cause == ROWS_SHIFTED and named.code in _VELOCITIES_SHIFTED:
        return True
    return cause in (named.code, *named.ties) or named.code == cause.replace("start_", "origin_", 1)


def _told(code: str, because: Mapping[str, str], names: tuple[str, ...] = ()) -> Sentence | str:
    """Return what a code means, with the columns, starts or equations in `names`, and the teacher's reason, by code."""
    if code in because:
        told = {"name": code.removeprefix(_CONFUSION), "because": because[code].strip().rstrip(".。")}
        return say("feedback.misconception.confusion_because", **{name: quoted(text) for name, text in told.items()})
    if code == "swapped_columns" and names:
        return say("feedback.misconception.swapped", names=names)
    if code == ROWS_SHIFTED and names:
        return say("feedback.misconception.positions_shifted", names=names)
    if code.startswith(_DATUM) and names:
        known = {"value": float(names[0]), "unit": names[1]}
        key = "datum_sign" if OTHER_SIGN in names else "datum_value"
        return say(f"feedback.misconception.{key}", name=quoted(code.removeprefix(_DATUM)), **known)
    if code == OTHER_STEP and names:
        return say("feedback.misconception.other_step_value", value=float(names[0]))
    if len(names) > 1 and code.startswith(_SEVERAL):
        return say(f"feedback.misconception.{code.partition('_')[0]}_several", names=names)
    return misconception_sentence(code, for_student=True)


def _odd_rows(key: Key, marked: TableMarks) -> Iterator[Reason]:
    """Yield which rows stand twice, and which stand elsewhere than they belong."""
    if rows := repeated_rows(key, marked.cells):
        yield Reason("table", "finding", say_count("feedback.rows.repeated", len(rows), rows=ranges(rows)))
    for shift in displaced_rows(key, marked.cells)[:_MOST_RUNS]:
        begin, end = shift.first + shift.by, shift.last + shift.by
        told = say("feedback.rows.shifted", first=shift.first, last=shift.last, begin=begin, end=end)
        yield Reason("table", "finding", told)


def _counted(found: Counts) -> Sentence:
    start = say("feedback.counts_start", number=found.start) if found.start else ""
    told = say("feedback.counts", **asdict(found))
    return joined([told, start])


def _sum(marked: TableMarks, cells: int, points: float, most: float) -> Sentence:
    """Return the sum that gives the points; if there are columns of forces, all other columns are one term of it."""
    earned, forces = marked.earned, marked.forces
    if forces is not None:
        own, of_forces = in_sum(earned.share * cells), in_sum(forces.earned)
        return say(
            "forces.earned", points=points, most=most, own=own, cells=cells, of_forces=of_forces,
            count=forces.count, all=cells + forces.count,
        )  # fmt: skip
    known = {"points": points, "most": most, "worth": in_sum(earned.worth), "explained": in_sum(earned.explained)}
    if earned.rule == "cells":
        return say("feedback.earned.cells", counted=in_sum(earned.of_cells * cells), cells=cells, points=points, most=most)
    percent = math.floor(1000 * earned.explained + 1e-6) / 10  # rounded down: 100 means all of them
    return say(
        f"feedback.earned.{earned.rule}", **known, percent=percent, alone=round(earned.of_cells * most, 2), line=earned.cause
    )


def follows_euler(key: Key, marked: TableMarks) -> Sentence | str:
    """Return how many steps of the angles are Euler's; "" if a misconception says that the columns mean something else."""
    named = marked.misconception
    if named and named.code.startswith(_READ_OTHERWISE):
        return ""
    if marked.cells.too_coarse[1:, : key.m].all():  # such cells count as missing: nothing is said about them
        return say("marking.verdict.integration.unknown")
    held, spoken = euler_steps(key, marked.cells)
    verdict = "unknown" if not spoken else "right" if held == spoken else "wrong"
    return say(f"marking.verdict.integration.{verdict}", held=held, steps=spoken)
