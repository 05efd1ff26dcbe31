"""The cost of accuracy under forces: the error of the energy against slopes, for every scheme at several steps.

Enters: equations of motion, the start, the exact rows.  Leaves: `AccuracyStudy` with errors in J.
Used by `scene/motor_scene.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from coursework.effects.dynamics.dynamics_lesson import Moved, Trial
from coursework.motion.schemes import PRECISE, SCHEMES, SEMI_IMPLICIT, Scheme, title_of
from coursework.results.accuracy.record import AccuracyStudy, StudyRow
from coursework.results.accuracy.trace import orders_of
from coursework.system.arrays import Array
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

PARTS = (1, 2, 4, 8, 16, 32)  # numbers of parts of the step
MOST_SLOPES = 6400  # in one run; if the table's own step needs more, only it and its half are tried
MOST_ROWS = 20_000  # slopes for the table: with more there is no study


def energy_study(moved: Moved, own: Scheme, unit: str, progress: Callable[[str], None] | None = None) -> AccuracyStudy:
    """Return the study; it is never timed, because slopes are the cost here.

    `own` is the scheme of the table, `unit` that of the free rates.
    """
    steps, dear, label = moved.steps, moved.equations.dear, moved.exact.label
    if steps * PRECISE.slopes * dear > MOST_ROWS:
        why = say("study.too_long", rows=steps + 1)
        return AccuracyStudy((), {}, None, 0.0, label, (), (), seconds_shown=False, left_out=(why,))
    energy, kinetic = moved.energy()
    scale = float(kinetic.max(initial=0.0)) or 1.0
    rows, rates = list[StudyRow](), dict[str, float]()
    for scheme in (*SCHEMES.values(), SEMI_IMPLICIT):
        for parts in _parts(scheme, steps, MOST_SLOPES // dear):
            if progress:
                progress(f"{scheme.name}, {parts}")
            tried = moved.tried(scheme, parts)
            rows.append(_row(scheme, tried, energy, steps * parts, scale))
            if parts == 1:
                rates[title_of(scheme)] = tried.error
    floor = 64 * float(np.finfo(float).eps) * max(scale, float(np.abs(energy).max()))
    orders = orders_of(rows, floor / scale, 0.0)
    title = title_of(own)
    mine = next(row for row in rows if row.method == title)
    point = None if mine.failed else (title, mine.evaluations, mine.max_error, None)
    told = tuple(_told(rows, rates, unit, mine, scale))
    return AccuracyStudy(tuple(rows), orders, point, floor, label, told, (), seconds_shown=False)


def _parts(scheme: Scheme, steps: int, most: int) -> list[int]:
    """Return the numbers of parts into which a step is divided: at least 1 and 2."""
    return [parts for parts in PARTS if parts <= PARTS[1] or steps * parts * scheme.slopes <= most]


def _row(scheme: Scheme, tried: Trial, energy: Array, steps: int, scale: float) -> StudyRow:
    title = title_of(scheme)
    if tried.ended:
        return StudyRow(title, str(steps), 0, np.nan, np.nan, None, say("study.cut_off", row=tried.row), "J", "J")
    off = np.abs(tried.energy - energy)
    return StudyRow(title, str(steps), tried.slopes, float(off.max()), float(off[-1]), None, "", "J", "J", None, scale, scale)


def _told(rows: Sequence[StudyRow], rates: dict[str, float], unit: str, own: StudyRow, scale: float) -> Iterator[Sentence]:
    """Yield what the table's own step costs in energy, and what better schemes achieve with it."""
    known = {"steps": own.steps_or_tolerance, "method": own.method}
    if own.failed:
        yield say("study.energy_failed", **known, why=own.failed)
    else:
        share = 100 * own.max_error / scale
        yield say("study.energy_own", **known, energy=own.max_error, share=share, rate=rates[own.method], unit=unit)
    for scheme, key in ((SEMI_IMPLICIT, "study.energy_semi"), (PRECISE, "study.energy_best")):
        row = next(row for row in rows if row.method == title_of(scheme))
        if not row.failed and row.method != own.method:
            given = {"steps": row.steps_or_tolerance, "method": row.method, "energy": row.max_error, "rate": rates[row.method]}
            yield say(key, **given, unit=unit, end=row.end_error)
