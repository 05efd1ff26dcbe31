"""The points of a table: the best of what its cells, its own start, a misconception or own equations give.

Enters: marked cells, what explains them, the rubric.  Leaves: `Earned`.  Used by `grade.py`.
Better work never earns less: each rule also counts right cells, and none depends on what was handed in besides the table.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.causes import misconceptions as causes
from coursework.grading.marking.table.causes.hypotheses import (
    COSINE,
    DEGREE_STEPS,
    NO_VELOCITIES,
    OTHER_STEP,
    PI_ROUNDED,
    RADIAN_MODE,
    ROUNDED_OMEGA,
    SCHEMES_TRIED,
    STEPS_IN_DEGREES,
)
from coursework.grading.marking.table.causes.misconceptions import NAMED, TIE, Found
from coursework.grading.marking.table.causes.other_data import DATA_ROUNDED, DATUM
from coursework.grading.marking.table.causes.own_equations import OWN
from coursework.grading.marking.table.causes.printed_otherwise import COLUMN_SLIPPED, ROW_BELOW, SIGN, SWAPPED_COLUMNS
from coursework.grading.marking.table.cells import Cells, alike
from coursework.grading.marking.table.explained import Fit
from coursework.grading.marking.table.points import Earned, Rule, TablePoints, stands_still, table_points
from coursework.grading.marking.table.untold import ramp
from coursework.system.arrays import Array
from coursework.variant.formula.units import size_of

_SLIPS = ("equation_", "sign_drive", COSINE, "clockwise", NO_VELOCITIES)
# Causes of a table that was worked out with fewer digits: velocities rounded before each step, π as 3.14; the worth of its cells.
_COARSER, ROUNDED = (ROUNDED_OMEGA, PI_ROUNDED), 0.98

# Causes with steps of another length, and with steps made by another rule, from right velocities.
_OTHER_STEPS = (OTHER_STEP, DEGREE_STEPS, STEPS_IN_DEGREES)
_OTHER_RULES = (
    *SCHEMES_TRIED, "trapezoid", "backward", "exact",
    "step_ahead", "step_behind", "row_before", "two_rows", "other_rates", "in_place",
)  # fmt: skip

# A datum that explains no more than this part of a table is worth no more than a wrong method.
_PARTLY = 0.8
# Causes of a table made from other numbers than the task's: one, as found or as the rubric declares it; two that were exchanged.
# Several that were rounded count as one.
_DATA, _SWAPPED = (DATUM, "confusion_"), "swap_"
_DIGITS_OFF = 0.05  # a datum that is off by less has digits wrong: no slip in an equation does the same
# What was printed otherwise, of a column or two, while all that was made from it is right.
_IN_PRINT = (SIGN, SWAPPED_COLUMNS, ROW_BELOW)
_LESS = 0.05  # of a table that a slip explains better by this part, nothing is so in print only
_NO_SLIPS = (_SWAPPED, DATA_ROUNDED, "variant_", OWN, "other_drive")


def best_rule(key: Key, rubric: Rubric, cells: Cells, points: TablePoints, found: Found, others: Mapping[str, Array]) -> Earned:
    """Return the rule that earns most; on a tie the cells, then the first rule.  `others` are other variants' tables by name."""
    by_cells = Earned(points.share, "cells", points.share, 0.0, 1.0, "", points.shut)
    if stands_still(key, cells):
        return by_cells
    rules, own = [by_cells], found.from_own_start
    if own is not None and not any(_is_row(key, cells, table) for table in others.values()):  # else the start is another's
        explained = table_points(key, own.cells, rubric.carried).share
        worth = rubric.start_floor if len(own.names) < 2 else rubric.start_floor_several
        rules.append(_earned("start", points, explained, worth, own.cause))
    best = max(rules, key=lambda earned: earned.share)
    at_best = (replace(fit, beyond_euler=beyond) for fit in found.at_best for beyond in (True, False))
    if all(earned.share <= best.share for fit in at_best for earned in _by_explanation(key, rubric, points, [fit])):
        return best  # no cause can earn more, however much a closer look would find that it explains
    return max([best, *_by_explanation(key, rubric, points, found.fits)], key=lambda earned: earned.share)


def _is_row(key: Key, cells: Cells, table: Array) -> bool:
    """Return whether row 1 agrees with that of another table."""
    if table.shape != key.table.shape:
        return False
    first = cells.student.values[:1]
    return bool(np.all(alike(key, cells.student, table)[:1] | np.isnan(first)))


def _by_explanation(key: Key, rubric: Rubric, points: TablePoints, fits: Sequence[Fit]) -> Iterator[Earned]:
    """Yield what each explanation earns; another variant's table is not the student's work and earns nothing, nor does what
    explains less of it, as other data that are near the variant's do.

    Rounded velocities or a rounded π explain some of any steps, and another origin some of any angles; each counts only if it
    explains nearly all and no other slip or rule explains more: a number read off the table may, as cells are put right.
    What explains no more than Euler's rules do counts as a wrong method, which is worth least: cells put right make these rules
    explain more, and must not take what the cause was worth where the gates let the cells earn less.
    """
    beyond = [fit for fit in fits if fit.beyond_euler]
    most = max((fit.share for fit in beyond if _is_slip(key, fit)), default=0.0)
    copied = max((fit.share for fit in beyond if fit.code.startswith("variant_")), default=0.0)
    least = max((fit.share + TIE for fit in beyond if _is_slip(key, fit)), default=0.0)
    single = [fit.share for fit in beyond if fit.code.startswith(_SLIPS) or (_ratio(key, fit) or 0.0) < 0]
    angles = [f"{DATUM}{one.name}" for one in key.variant.given if one.si == "rad"]  # another angle may be a slip, as pi - alpha
    for fit in fits:
        worth = _worth(rubric, fit)
        ratio = _ratio(key, fit)
        is_number = ratio > 0 if ratio is not None else fit.code.startswith((*_DATA, _SWAPPED, DATA_ROUNDED))
        is_near = fit.code == DATA_ROUNDED or (ratio is not None and abs(ratio - 1) < _DIGITS_OFF)
        if fit.beyond_euler and ((ratio is not None and ratio < 0) or fit.code.startswith(SIGN)):  # one sign is a single slip
            worth = max(worth, rubric.own_equations_floor)
        if fit.in_print and fit.code.startswith(_IN_PRINT):  # where a slip explains more, all was made with it
            worth -= max(worth - rubric.own_equations_floor, 0.0) * ramp(most - fit.share, TIE, _LESS)
        if fit.beyond_euler and fit.code in _OTHER_RULES:
            worth += max(rubric.steps_floor - worth, 0.0) * ramp(fit.share, _PARTLY, NAMED)
        # Some angle makes nearly the table of a slip, as pi - alpha does: its digits are wrong only where it explains more.
        is_copied = is_near and (fit.code not in angles or fit.share >= max(single, default=0.0) + TIE)
        if fit.beyond_euler and (fit.share >= least or is_copied) and fit.share > copied and is_number:
            # A number copied wrongly is as a start copied wrongly, if it explains nearly all: some value undoes many a slip.
            whole = rubric.start_floor_several if fit.code.startswith(_SWAPPED) else rubric.start_floor
            worth = max(worth, _nearly_all(rubric, fit, whole))
        if fit.share < copied or not (fit.beyond_euler or worth <= rubric.misconception_floor):
            continue
        if fit.code == OWN:
            yield _earned("own_equations", points, fit.share, rubric.own_equations_floor, fit.names[0])
        elif not fit.code.startswith("variant_") and (
            fit.share >= max(NAMED, most - TIE) or not fit.code.startswith((*_COARSER, causes.ORIGIN))
        ):
            yield _earned("misconception", points, fit.share, worth, fit.code)


def _ratio(key: Key, fit: Fit) -> float | None:
    """Return the value of a datum by which a fit explains a table, in parts of the task's; None if it is none, or not told."""
    if not fit.code.startswith(_DATA) or not fit.names:
        return None
    name, value = fit.code.partition("_")[2], float(fit.names[0]) * (size_of(fit.names[1]) or 1.0)
    return value / next((one.value for one in key.variant.given if one.name == name), math.nan)


def _is_slip(key: Key, fit: Fit) -> bool:
    """Return whether a fit is one thing done wrong: no number or law read off the table, nor another's work."""
    if fit.code.startswith(_DATA):  # its names are a value and a unit
        ratio = _ratio(key, fit)
        return ratio is not None and not ratio > 0
    return len(fit.names) < 2 and not fit.code.startswith(_NO_SLIPS)


def _nearly_all(rubric: Rubric, fit: Fit, whole: float) -> float:
    """Return the worth of a cell: `whole` if nearly all of the table is explained, that of a wrong method if only a part is."""
    return rubric.misconception_floor + (whole - rubric.misconception_floor) * ramp(fit.share, _PARTLY, NAMED)


def _worth(rubric: Rubric, fit: Fit) -> float:
    """Return the worth of a cell that a misconception explains: for a single slip it is more than for a wrong method.

    An angle counted from another axis is a start that is not the task's, and so are starts (`fit.names`) in degrees from which
    all else was made in radians, whatever the unit in the head of the columns. One column ten times too large costs as much, and
    so do one with the other sign and two exchanged, however many there are besides, if that is so in print only.
    Work with rounded velocities or a rounded π is Euler's, worked out coarser: what a few digits less in print would hide costs
    little.
    """
    if fit.code == causes.ROWS_SHIFTED:
        return 1.0
    if fit.code in _OTHER_STEPS:
        return rubric.steps_floor
    if fit.code.startswith(_COARSER):
        return ROUNDED
    if fit.code == RADIAN_MODE and len(fit.names) > 1:
        return rubric.start_floor_several
    if fit.code.startswith((causes.ORIGIN, COLUMN_SLIPPED)) or (fit.code == RADIAN_MODE and fit.names):
        return rubric.start_floor
    if fit.in_print and fit.beyond_euler and fit.code.startswith(_IN_PRINT):
        return _nearly_all(rubric, fit, rubric.start_floor)
    return rubric.own_equations_floor if fit.code.startswith(_SLIPS) else rubric.misconception_floor


def _earned(rule: Rule, points: TablePoints, explained: float, worth: float, cause: str) -> Earned:
    return Earned(worth * explained, rule, points.share, explained, worth, cause, points.shut)
